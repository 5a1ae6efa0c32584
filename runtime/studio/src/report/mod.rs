//! A model on one self-contained page: declaration and drawing, equations, contact sets, default
//! run, error against run time, numerical checks.

mod audit;
mod equations;
mod index;
mod model;
mod modes;
mod motion;
mod pictures;
mod precision;
mod run;
mod verification;

pub use index::index;

use crate::animation::live::{self, Engine};
use crate::checks;
use crate::explain;
use crate::html::{escaped, page};
use crate::registry::{Entry, MotionError, as_far};
use crate::run_spec::RunSpec;
use core::ops::ControlFlow;
use liftoff::Trajectory;

const STYLE: &str = "iframe { width: 100%; height: 56rem; border: 1px solid var(--rule); border-radius: 6px; }\n\
                     .part h2 { font-size: 1.05rem; border: 0; margin: 1.75rem 0 .5rem; }\n\
                     pre { overflow-x: auto; font-size: .85rem; line-height: 1.6; padding: .9rem; background: var(--card); \
                     border: 1px solid var(--rule); border-radius: 6px; }\n\
                     figure.model svg { max-height: 26rem; width: auto; max-width: 100%; }\n\
                     h3 { font-size: 1rem; margin: 1.5rem 0 .5rem; }\n\
                     @media print { pre { white-space: pre-wrap; } iframe { display: none; } }\n";

/// What the parts of a report are about.
struct Subject<'a> {
    model: &'static Entry,
    spec: RunSpec,
    /// The default run, as far as it came.
    record: Option<Trajectory>,
    /// Why it has no end.
    stopped: Option<String>,
    /// The engine that runs the model again within the page.
    engine: Option<Engine<'a>>,
}

/// A part: its name in links, its title, what it says.
type Part = (&'static str, &'static str, fn(&Subject) -> Result<String, MotionError>);

const PARTS: [Part; 9] = [
    ("model", "Model", model::html),
    ("equations", "Equations", equations::html),
    ("modes", "Contact sets", modes::html),
    ("run", "Default run", run::html),
    ("audit", "Audit and judge", audit::html),
    ("pictures", "Pictures", pictures::html),
    ("motion", "Motion", motion::html),
    ("time", "Error against run time", precision::html),
    ("checks", "Numerical checks", verification::html),
];

/// Number of parts of a report, each one step of progress.
pub const LENGTH: usize = PARTS.len();

/// A model's report.
#[derive(Clone, PartialEq, Debug)]
pub struct Report {
    /// The model's name, and that of the file.
    pub name: String,
    /// The model in a line.
    pub summary: String,
    /// The page as HTML, self-contained.
    pub html: String,
    /// Drawing of the model as SVG; none where it cannot be drawn.
    pub drawing: Option<String>,
    /// Parts that could not be made, and why: `Default run: the run stopped short …`.
    pub missing: Vec<String>,
}

/// The report of a model, with sliders where there is an engine; none where `go_on`, which is asked
/// before each part, breaks.
pub fn report(
    model: &'static Entry,
    engine: Option<Engine>,
    go_on: &mut dyn FnMut() -> ControlFlow<()>,
) -> Option<Report> {
    let subject = Subject::new(model, engine);
    let mut missing: Vec<String> = subject.stopped.iter().map(|why| format!("default run: {why}")).collect();
    let mut sections = String::new();
    for (anchor, title, part) in PARTS {
        if go_on().is_break() {
            return None;
        }
        let html = part(&subject).unwrap_or_else(|failure| {
            missing.push(format!("{title}: {failure}"));
            format!("<p>Missing: {}.</p>\n", escaped(&failure.to_string()))
        });
        sections += &format!("<h2 id={anchor}>{title}</h2>\n{html}");
    }
    let links: String =
        PARTS.iter().map(|(anchor, title, _)| format!("<a href=#{anchor}>{title}</a>")).collect();
    let [name, summary] = [model.name(), model.summary()].map(escaped);
    let body = format!("<h1>{name}</h1>\n<p>{summary}</p>\n<nav>{links}</nav>\n{sections}");
    Some(Report {
        name: model.name().to_owned(),
        summary: model.summary().to_owned(),
        html: page(model.name(), &style(), &body),
        drawing: self::model::drawn(&subject),
        missing,
    })
}

fn style() -> String {
    [explain::html::STYLE, checks::STYLE, live::STYLE, STYLE].concat()
}

impl<'a> Subject<'a> {
    fn new(model: &'static Entry, engine: Option<Engine<'a>>) -> Self {
        let spec = model.default_run();
        let (record, stopped) = match as_far(model.run(&spec)) {
            Ok((record, stopped)) => (Some(record), stopped),
            Err(mistake) => (None, Some(mistake.to_string())),
        };
        Self { model, spec, record, stopped, engine }
    }

    /// The default run, or why there is nothing of it.
    fn record(&self) -> Result<&Trajectory, MotionError> {
        let missing = || MotionError::Input(self.stopped.clone().unwrap_or_default());
        self.record.as_ref().ok_or_else(missing)
    }
}
