//! The main job: the paper reproduced, printed, and written as `results.json`, `index.html` and
//! pictures.

mod border;
mod falling_pair;
mod figure;
mod findings;
mod page;
mod precision;
mod printed;
mod published;
mod quantity;
mod reading;
mod reference;
mod scheme;
mod stiff;
mod strict;
mod strikes;
mod table;
mod table1;

use falling_pair::asymmetry::Asymmetry;
use liftoff::OutputError;
use liftoff_studio::plot::with_theme;
use liftoff_studio::registry::MotionError;
use liftoff_studio::sweep::SweepError;
use liftoff_studio::work_precision::FileError;
use quantity::{Quantity, Row};
use reference::References;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;
use strikes::Strikes;

/// What can go wrong.
#[derive(thiserror::Error, Debug)]
pub enum ReportError {
    /// A run that could not be made.
    #[error(transparent)]
    Run(#[from] MotionError),
    /// Runs over ranges that could not be made.
    #[error(transparent)]
    Sweep(#[from] SweepError),
    /// A border that is not in its range.
    #[error("nothing changes in the range where a border was sought")]
    NoChange,
    /// Rows of another tool that cannot be read.
    #[error(transparent)]
    Peers(#[from] FileError),
    /// Tables that are no JSON.
    #[error("the tables of references cannot be read or written: {0}")]
    Json(#[from] serde_json::Error),
    /// Standard output that takes no text.
    #[error("cannot print: {0}")]
    Print(#[from] std::io::Error),
    /// A file that could not be written.
    #[error("cannot write {path}: {source}")]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

impl From<OutputError> for ReportError {
    fn from(error: OutputError) -> Self {
        Self::Run(error.into())
    }
}

/// `results.json`.
#[derive(Serialize)]
struct Results<'a> {
    tolerance: f64,
    results: &'a [Row],
}

/// Reproduces the paper at `tolerance`, hands the table to `print` and writes the files into
/// `directory`; `peers` are rows of other tools, see
/// [`peers`](liftoff_studio::work_precision::peers).
pub fn report(
    tolerance: f64,
    directory: &Path,
    peers: &[PathBuf],
    print: impl Fn(&str) -> std::io::Result<()>,
) -> Result<(), ReportError> {
    let begun = Instant::now();
    let tables = References::load()?;
    let study = Study::new(tolerance)?;
    let Study { pair, published, strict, .. } = &study;
    let rows: Vec<Row> =
        study.quantities()?.into_iter().map(|quantity| Row::compare(quantity, &tables)).collect();
    print(&table::text(&rows, &tables))?;

    let measured = precision::measure(peers)?;
    let shown = published.iter().find(|runs| runs.is_shown());
    let mut figures = pair.figures()?;
    figures.push(published::figures::reactions(published)?);
    let (mut schemes, mut findings, mut alone) =
        (Vec::new(), Vec::new(), vec![study.strikes.figure()?, strict::map::figure(tolerance)?]);
    let mut difference = None;
    if let Some(shown) = shown {
        schemes.extend(scheme::figures(pair, shown)?);
        findings = findings::findings(&study, shown)?;
        figures.extend(shown.figures()?);
        if let Some(run) = strict.iter().find(|run| run.ratio() == shown.ratio()) {
            difference = run.difference(shown, tolerance)?;
            alone.splice(0..0, run.figure(shown)?);
        }
    }
    alone.extend(strict::asymmetry::figure(tolerance, &strict::RATIOS)?);
    let page = page::Page {
        tolerance,
        rows: &rows,
        tables: &tables,
        schemes: &schemes,
        findings: &findings,
        figures: &figures,
        difference,
        lines: strict::comparison::lines(strict, tolerance)?,
        strict: &alone,
        precision: precision::figures(&measured),
        measured: &measured,
    };

    let files = write(&page, pair.picture()?, directory)?;
    let (summary, seconds) = (table::summary(&rows, &tables), begun.elapsed().as_secs_f64());
    print(&format!("{summary}\n{files} written after {seconds:.1} s\n"))?;
    Ok(())
}

/// Writes `results.json`, the page and its drawings, and tells their names.
fn write(page: &page::Page, picture: Option<String>, directory: &Path) -> Result<String, ReportError> {
    let results = serde_json::to_string_pretty(&Results { tolerance: page.tolerance, results: page.rows })?;
    std::fs::create_dir_all(directory)
        .map_err(|source| ReportError::Write { path: directory.to_owned(), source })?;
    let json = written(directory, "results.json", &(results + "\n"))?;
    let html = written(directory, "index.html", &page.html())?;
    let drawings = pictures(page, picture);
    for (name, svg) in &drawings {
        written(directory, &format!("{name}.svg"), svg)?;
    }
    Ok(format!("{}, {} and {} figures beside it", json.display(), html.display(), drawings.len()))
}

/// The drawings that get a file of their own, by name.
fn pictures(page: &page::Page, picture: Option<String>) -> Vec<(&'static str, String)> {
    let figures = page.schemes.iter().chain(page.figures).chain(page.strict);
    let measured = page.precision.iter().filter(|figure| !figure.anchor.is_empty());
    let figures = figures.chain(measured).map(|figure| (figure.anchor, with_theme(&figure.svg)));
    figures.chain(picture.map(|svg| ("picture", with_theme(&svg)))).collect()
}

/// All runs that are not made for one figure or statement.
struct Study {
    tolerance: f64,
    pair: falling_pair::FallingPairRuns,
    asymmetry: Asymmetry,
    published: Vec<published::PublishedRuns>,
    strict: Vec<strict::Run>,
    strikes: Strikes,
}

impl Study {
    fn new(tolerance: f64) -> Result<Self, ReportError> {
        Ok(Self {
            tolerance,
            pair: falling_pair::FallingPairRuns::new(tolerance)?,
            asymmetry: Asymmetry::new(tolerance)?,
            published: published::PublishedRuns::all(tolerance)?,
            strict: strict::Run::all(tolerance)?,
            strikes: Strikes::new(tolerance)?,
        })
    }

    fn quantities(&self) -> Result<Vec<Quantity>, ReportError> {
        let mut all = self.pair.quantities()?;
        all.push(self.asymmetry.quantity());
        for runs in &self.published {
            all.extend(runs.quantities()?);
        }
        all.extend(self.strict.iter().flat_map(strict::Run::quantities));
        all.extend(self.strikes.quantities());
        Ok(all)
    }
}

fn written(directory: &Path, name: &str, text: &str) -> Result<PathBuf, ReportError> {
    let path = directory.join(name);
    match liftoff_studio::file::write(&path, text) {
        Ok(()) => Ok(path),
        Err(source) => Err(ReportError::Write { path, source }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every reference computed, in its unit, within what issue 2 asks at the tolerance.
    fn assert_reproduces(tolerance: f64, largest: f64) {
        let tables = References::load().expect("both tables are JSON");
        let study = Study::new(tolerance).expect("all runs");
        let all = study.quantities().expect("every output exists");
        let references: serde_json::Value =
            serde_json::from_str(include_str!("../../data/references.json")).expect("JSON");
        for (id, reference) in references.as_object().expect("an object") {
            let quantity = all.iter().find(|quantity| quantity.id == *id);
            let quantity = quantity.unwrap_or_else(|| panic!("{id} is not computed"));
            assert_eq!(reference["unit"], quantity.unit, "{id}");
            let row = Row::compare(quantity.clone(), &tables);
            match row.relative_error {
                Some(error) => assert!(error <= largest, "{id}: {error:e} at tolerance {tolerance:e}"),
                None => assert_eq!(row.computed, row.reference, "{id}"),
            }
        }
    }

    /// The picture of the engine is a copy of what the main job writes.
    #[test]
    fn the_picture_of_the_engine_is_the_one_drawn() {
        let pair = falling_pair::FallingPairRuns::new(1e-12).expect("the pair falls");
        let svg = pair.picture().expect("drawn").expect("the corners let go");
        assert!(
            with_theme(&svg) == include_str!("../../../runtime/engine/src/picture.svg"),
            "copy target/liftoff/picture.svg"
        );
    }

    #[test]
    fn references_are_met() {
        assert_reproduces(1e-12, 1e-9);
        assert_reproduces(1e-14, 1e-11);
    }
}
