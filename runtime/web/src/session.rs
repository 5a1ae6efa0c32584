//! The models of the text that is worked on.

use liftoff_studio::animation::live::Sliders;
use liftoff_studio::animation::{About, played};
use liftoff_studio::picture::drawing;
use liftoff_studio::registry::{Entry, MotionError, Units, as_far, motion_columns};
use liftoff_studio::run_spec::{RunSpec, Values, overridden};
use liftoff_studio::source;
use std::collections::BTreeMap;

use crate::answers::{Answer, Described, Mistake};
use crate::requests::{Request, Run};

/// The model that has been derived last.
#[derive(Default)]
pub struct Session {
    model: Option<Entry>,
}

impl Session {
    /// What comes of a request.
    pub fn answer(&mut self, request: Request) -> Answer {
        let nothing = || Answer::refused("nothing has been derived yet".to_owned());
        match request {
            Request::Derive { text, model } => self.derive(&text, model.as_deref()),
            Request::Equations => self.model.as_ref().map_or_else(nothing, equations),
            Request::Run(run) => self.model.as_ref().map_or_else(nothing, |model| {
                motion(model, *run).unwrap_or_else(|error| Answer::refused(error.to_string()))
            }),
            Request::Table(run) => self.model.as_ref().map_or_else(nothing, |model| {
                table(model, *run).unwrap_or_else(|error| Answer::refused(error.to_string()))
            }),
        }
    }

    fn derive(&mut self, text: &str, chosen: Option<&str>) -> Answer {
        let mut models = match source::models(text) {
            Ok(models) => models,
            Err(mistakes) => {
                let mistakes = mistakes.into_iter().map(|mistake| placed(text, mistake)).collect();
                return Answer::Mistakes { mistakes };
            }
        };
        let names: Vec<String> = models.iter().map(|model| model.layout().name.to_owned()).collect();
        let index = chosen.and_then(|chosen| names.iter().position(|name| name == chosen)).unwrap_or(0);
        if models.is_empty() {
            return Answer::refused("nothing in the text derives `BarSystem`".to_owned());
        }
        let model = models.swap_remove(index);
        let told = described(&model, names);
        self.model = Some(model);
        Answer::Model(Box::new(told))
    }
}

/// A mistake where a browser finds it.
fn placed(text: &str, mistake: source::Mistake) -> Mistake {
    let units = |bytes: usize| text.get(..bytes).map_or(0, |before| before.encode_utf16().count());
    Mistake { from: units(mistake.at.start), to: units(mistake.at.end), text: mistake.text }
}

fn described(model: &Entry, models: Vec<String>) -> Described {
    let (layout, spec) = (model.layout(), model.default_run());
    Described {
        name: layout.name.to_owned(),
        summary: model.summary().to_owned(),
        sliders: Sliders::new(model, &spec),
        drawing: model.configuration(&spec).ok().map(|configuration| drawing(&configuration)),
        models,
    }
}

fn equations(model: &Entry) -> Answer {
    Answer::Equations { html: liftoff_codegen::equations_as_html(&liftoff_studio::equations(model.layout())) }
}

fn motion(model: &Entry, run: Run) -> Result<Answer, MotionError> {
    let outputs = run.outputs.clone();
    outputs.iter().try_for_each(|output| model.check(output))?;
    let spec = spec(model, run);
    let (record, stopped) = as_far(model.run(&spec))?;
    let about = About {
        title: model.layout().name,
        summary: model.summary(),
        parameters: &spec.parameters,
        outputs: &outputs,
        stopped: stopped.as_deref(),
    };
    let events = record.events().iter().map(ToString::to_string).collect();
    Ok(Answer::Motion { played: Box::new(played(&record, &about)?), events, stopped })
}

/// The rows of a motion, as far as it came; both sides of a jump.
fn table(model: &Entry, run: Run) -> Result<Answer, MotionError> {
    let (layout, units) = (model.layout(), Units::from_layout(model.layout()));
    let (record, _) = as_far(model.run(&spec(model, run)))?;
    let columns = motion_columns(layout);
    let outputs = columns.iter().map(|column| record.output(column)).collect::<Result<Vec<_>, _>>()?;
    let heads: Vec<_> = columns.iter().map(|column| units.head(column)).collect();
    let rows = record.instants().into_iter().map(|instant| {
        let values = outputs.iter().map(|output| record.value_at(output, instant).to_string());
        values.collect::<Vec<_>>().join(",")
    });
    let lines = [heads.join(",")].into_iter().chain(rows).map(|line| line + "\n");
    Ok(Answer::Table { csv: lines.collect() })
}

/// The given run, or the declared one, with what is chosen in place of its own.
fn spec(model: &Entry, run: Run) -> RunSpec {
    let given = run.spec.unwrap_or_else(|| model.default_run());
    let over = |values: &Values, chosen: BTreeMap<String, f64>| -> Values {
        overridden(values.clone(), &chosen.into_iter().collect::<Values>())
    };
    RunSpec {
        parameters: over(&given.parameters, run.set),
        start: over(&given.start, run.start),
        until: if run.until.is_empty() { given.until.clone() } else { run.until },
        limit: run.limit.or(given.limit),
        tolerance: run.tolerance.unwrap_or(given.tolerance),
        ..given
    }
}
