//! All that there is to know of a model on one page that needs nothing beside itself: how it is made, its equations, its contact
//! sets, its default run, error against run time, and whether it can be trusted.

mod equations;
mod index;
mod made;
mod motion;
mod pictures;
mod precision;
mod run;
mod sets;
mod trust;

pub use index::index;

use crate::catalog::{Failure, Model, Record};
use crate::explain;
use crate::html::{escaped, page};
use crate::scene::Setup;
use crate::stability;
use core::ops::ControlFlow;

const STYLE: &str = "iframe { width: 100%; height: 56rem; border: 1px solid var(--rule); border-radius: 6px; }\n\
                     .part h2 { font-size: 1.05rem; border: 0; margin: 1.75rem 0 .5rem; }\n\
                     pre { overflow-x: auto; font-size: .85rem; line-height: 1.6; padding: .9rem; background: var(--card); \
                     border: 1px solid var(--rule); border-radius: 6px; }\n\
                     figure.made svg { max-height: 26rem; width: auto; max-width: 100%; }\n\
                     h3 { font-size: 1rem; margin: 1.5rem 0 .5rem; }\n\
                     @media print { pre { white-space: pre-wrap; } iframe { display: none; } }\n";

/// What the parts of a report are about.
struct Subject {
    model: &'static dyn Model,
    setup: Setup,
    /// The default run, as far as it came.
    record: Option<Box<dyn Record>>,
    /// Why it has no end.
    stopped: Option<String>,
}

/// A part: its name in links, its title, what it says.
type Part = (&'static str, &'static str, fn(&Subject) -> Result<String, Failure>);

const PARTS: [Part; 8] = [
    ("made", "How it is made", made::html),
    ("equations", "Equations", equations::html),
    ("sets", "Contact sets", sets::html),
    ("run", "Default run", run::html),
    ("pictures", "Pictures", pictures::html),
    ("motion", "Motion", motion::html),
    ("time", "Error against run time", precision::html),
    ("trust", "Whether it can be trusted", trust::html),
];

/// How many parts a report has.
pub const LENGTH: usize = PARTS.len();

/// A model's report.
#[derive(Clone, PartialEq, Debug)]
pub struct Report {
    /// The model's name, and that of the file.
    pub name: String,
    /// What the model is.
    pub summary: String,
    /// The page.
    pub html: String,
    /// Its drawing as SVG.
    pub drawing: Option<String>,
    /// What could not be told, and why: `Default run: the run stopped short …`.
    pub gaps: Vec<String>,
}

/// The report of a model; none where `go_on`, which is asked before each part, breaks.
pub fn report(model: &'static dyn Model, go_on: &mut dyn FnMut() -> ControlFlow<()>) -> Option<Report> {
    let subject = Subject::of(model);
    let mut gaps: Vec<String> = subject.stopped.iter().map(|why| format!("default run: {why}")).collect();
    let mut sections = String::new();
    for (anchor, title, part) in PARTS {
        if go_on().is_break() {
            return None;
        }
        let html = part(&subject).unwrap_or_else(|failure| {
            gaps.push(format!("{title}: {failure}"));
            format!("<p>Not told: {}.</p>\n", escaped(&failure.to_string()))
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
        drawing: made::drawn(&subject),
        gaps,
    })
}

fn style() -> String {
    [explain::html::STYLE, stability::STYLE, STYLE].concat()
}

impl Subject {
    fn of(model: &'static dyn Model) -> Self {
        let setup = model.setup();
        let (record, stopped) = match model.run(&setup) {
            Ok(record) => (Some(record), None),
            Err(Failure::Run { reason, record }) => (Some(record), Some(reason)),
            Err(failure) => (None, Some(failure.to_string())),
        };
        Self { model, setup, record, stopped }
    }

    /// The default run, or why there is nothing of it.
    fn record(&self) -> Result<&dyn Record, Failure> {
        let missing = || Failure::Input(self.stopped.clone().unwrap_or_default());
        self.record.as_deref().ok_or_else(missing)
    }
}
