//! `liftoff report`.

use crate::CommandError;
use crate::errors::interrupted::{is_interrupted, unless_interrupted};
use crate::options::sliders::Sliders;
use crate::output::file::{check_folder, unwritable, write};
use crate::output::print::print;
use crate::output::progress::Progress;
use clap::Args;
use core::ops::ControlFlow;
use liftoff_studio::animation::live::Engine;
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::report::{self, LENGTH, index, report};
use std::path::PathBuf;

/// The script that the pages have their engine in.
const ENGINE: &str = "engine.js";

/// The report of a model, telling each part before it is made.
fn made(model: &'static Entry, sliders: bool, tell: &dyn Fn(usize)) -> Option<report::Report> {
    let mut part = 0;
    report(model, sliders.then_some(Engine::Beside(ENGINE)), &mut || {
        tell(part);
        part += 1;
        if is_interrupted() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
}

#[derive(Args, Debug)]
pub struct Report {
    /// Names of models, as in `list` [default: all]
    pub models: Vec<String>,
    /// Folder for a page for each model, and index.html
    #[arg(long, value_name = "DIRECTORY", default_value = "target/liftoff/report")]
    out: PathBuf,
    #[command(flatten)]
    sliders: Sliders,
}

impl Report {
    /// Writes page after page, then the index of those that are written.
    pub fn execute(&self, models: &'static Models) -> Result<(), CommandError> {
        let selected = self.selected(models)?;
        check_folder(&self.out)?;
        std::fs::create_dir_all(&self.out).map_err(|error| unwritable(&self.out, &error))?;
        let engine = self.sliders.engine()?;
        if let Some(engine) = &engine {
            write(&self.out.join(ENGINE), engine.script())?;
        }
        let sliders = engine.is_some();
        let progress = Progress::new(selected.len() * LENGTH, "parts");
        let mut done = 0;
        let mut reports = Vec::new();
        for &model in &selected {
            progress.doing(model.name());
            let begun = done;
            let Some(report) = unless_interrupted(
                move |tell| made(model, sliders, tell),
                |part| progress.reach(begun + part),
            ) else {
                break;
            };
            done += LENGTH;
            self.write(&report.name, &report.html)?;
            reports.push(report);
        }
        drop(progress);
        self.write("index", &index("Bar systems", &reports))?;
        self.print_summary(&reports, selected.len())
    }

    fn selected(&self, models: &'static Models) -> Result<Vec<&'static Entry>, CommandError> {
        let named: Result<Vec<_>, _> = self.models.iter().map(|name| models.find(name)).collect();
        Ok(match self.models.is_empty() {
            true => models.iter().collect(),
            false => named?,
        })
    }

    fn write(&self, name: &str, html: &str) -> Result<(), CommandError> {
        let path = self.out.join(format!("{name}.html"));
        write(&path, html)
    }

    fn print_summary(&self, reports: &[report::Report], selected: usize) -> Result<(), CommandError> {
        for report in reports {
            let path = self.out.join(format!("{}.html", report.name));
            print(&format!("{}\n", path.display()))?;
            report.missing.iter().try_for_each(|part| print(&format!("  missing: {part}\n")))?;
        }
        print(&format!("{} written\n", self.out.join("index.html").display()))?;
        match reports.len() {
            done if done < selected => {
                Err(CommandError::Interrupted(format!("interrupted after {done} of {selected} pages")))
            }
            _ => Ok(()),
        }
    }
}
