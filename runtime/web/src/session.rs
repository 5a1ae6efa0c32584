//! The models of the text that is worked on.

use liftoff::Trajectory;
use liftoff_studio::animation::{About, page};
use liftoff_studio::picture::drawing;
use liftoff_studio::registry::{Entry, MotionError, as_far};
use liftoff_studio::run_spec::{RunSpec, Values, overridden};
use liftoff_studio::source;
use std::collections::BTreeMap;

use crate::answers::{Answer, Described, Mistake, Slider};
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
                motion(model, run).unwrap_or_else(|error| Answer::refused(error.to_string()))
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
    let value =
        |values: &Values, name: &str| values.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
    let parameters = layout.parameters.iter().enumerate().map(|(i, name)| Slider {
        name: (*name).to_owned(),
        unit: layout.defaults.unit(i).to_owned(),
        value: value(&spec.parameters, name),
    });
    let named = layout.coordinates.iter().map(|c| (c.name.to_owned(), if c.is_angle { "rad" } else { "" }));
    let rates = layout.coordinates.iter().map(|c| (format!("{}'", c.name), ""));
    let start = named.chain(rates).map(|(name, unit)| Slider {
        value: value(&spec.start, &name),
        unit: unit.to_owned(),
        name,
    });
    Described {
        name: layout.name.to_owned(),
        summary: model.summary().to_owned(),
        parameters: parameters.collect(),
        start: start.collect(),
        until: spec.until.clone(),
        limit: spec.limit,
        drawing: model.configuration(&spec).ok().map(|configuration| drawing(&configuration)),
        models,
    }
}

fn equations(model: &Entry) -> Answer {
    Answer::Equations { html: liftoff_codegen::equations_as_html(&liftoff_studio::equations(model.layout())) }
}

fn motion(model: &Entry, run: Run) -> Result<Answer, MotionError> {
    let spec = spec(model, run);
    let (record, stopped) = as_far(model.run(&spec))?;
    told(model, &spec, &record, stopped)
}

/// The declared run, with what is given in place of its own.
fn spec(model: &Entry, run: Run) -> RunSpec {
    let declared = model.default_run();
    let over = |values: &Values, given: BTreeMap<String, f64>| -> Values {
        overridden(values.clone(), &given.into_iter().collect::<Values>())
    };
    RunSpec {
        parameters: over(&declared.parameters, run.set),
        start: over(&declared.start, run.start),
        until: if run.until.is_empty() { declared.until.clone() } else { run.until },
        limit: run.limit.or(declared.limit),
        tolerance: run.tolerance.unwrap_or(declared.tolerance),
        ..declared
    }
}

fn told(
    model: &Entry,
    spec: &RunSpec,
    record: &Trajectory,
    stopped: Option<String>,
) -> Result<Answer, MotionError> {
    let about = About {
        title: model.layout().name,
        summary: model.summary(),
        parameters: &spec.parameters,
        outputs: &[],
        stopped: stopped.as_deref(),
    };
    let events = record.events().iter().map(ToString::to_string).collect();
    Ok(Answer::Motion { page: page(record, &about)?, events, stopped })
}
