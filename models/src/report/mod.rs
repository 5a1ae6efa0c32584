//! The main job: the paper reproduced, printed, and written as `results.json` and `index.html`.

mod falling_pair;
mod figure;
mod page;
mod precision;
mod published;
mod quantity;
mod reading;
mod reference;
mod strict;
mod table;

use crate::catalog::Failure;
use crate::plot::DrawingError;
use quantity::{Quantity, Row};
use reference::References;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What can go wrong.
#[derive(thiserror::Error, Debug)]
pub enum ReportError {
    /// A run that could not be made.
    #[error(transparent)]
    Run(#[from] Failure),
    /// A motion without the flight that a figure shows.
    #[error("there is no flight to draw")]
    NoFlight,
    /// A figure that could not be drawn.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// Tables that are no JSON.
    #[error("the tables of references cannot be read or written: {0}")]
    Json(#[from] serde_json::Error),
    /// A file that could not be written.
    #[error("cannot write {path}: {source}")]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

/// `results.json`.
#[derive(Serialize)]
struct Results<'a> {
    tolerance: f64,
    results: &'a [Row],
}

/// Reproduces the paper at `tolerance`, prints the table and writes the files into `directory`.
pub fn report(tolerance: f64, directory: &Path) -> Result<(), ReportError> {
    let begun = Instant::now();
    let tables = References::load()?;
    let pair = falling_pair::Runs::new(tolerance)?;
    let published = published::Runs::all(tolerance)?;
    let strict = strict::Run::all(tolerance)?;
    let rows: Vec<Row> = quantities(&pair, &published, &strict)?
        .into_iter()
        .map(|quantity| Row::compare(quantity, &tables))
        .collect();
    print!("{}", table::text(&rows));

    let precision = precision::measure(&tables)?;
    let shown = published.iter().find(|runs| runs.is_shown());
    let mut figures = pair.figures()?;
    figures.push(published::figures::reactions(&published)?);
    let mut both = None;
    if let Some(shown) = shown {
        figures.extend(shown.figures()?);
        if let Some(run) = strict.iter().find(|run| run.ratio() == shown.ratio()) {
            both = Some((run.difference(shown, tolerance)?, run.figure(shown)?));
        }
    }
    let (difference, comparison) = both.unwrap_or_default();
    let page = page::Page {
        tolerance,
        rows: &rows,
        tables: &tables,
        figures: &figures,
        difference,
        lines: strict::comparison::lines(&published, &strict),
        comparison,
        precision: precision::figure(&precision)?,
        series: &precision,
    };

    let results = serde_json::to_string_pretty(&Results { tolerance, results: &rows })?;
    std::fs::create_dir_all(directory)
        .map_err(|source| ReportError::Write { path: directory.to_owned(), source })?;
    let json = written(directory, "results.json", &(results + "\n"))?;
    let html = written(directory, "index.html", &page.html())?;
    println!("{}", table::summary(&rows));
    println!("{} and {} written after {:.1} s", json.display(), html.display(), begun.elapsed().as_secs_f64());
    Ok(())
}

fn quantities(
    pair: &falling_pair::Runs,
    published: &[published::Runs],
    strict: &[strict::Run],
) -> Result<Vec<Quantity>, ReportError> {
    let mut all = pair.quantities()?;
    for runs in published {
        all.extend(runs.quantities()?);
    }
    all.extend(strict.iter().flat_map(strict::Run::quantities));
    Ok(all)
}

fn written(directory: &Path, name: &str, text: &str) -> Result<PathBuf, ReportError> {
    let path = directory.join(name);
    match std::fs::write(&path, text) {
        Ok(()) => Ok(path),
        Err(source) => Err(ReportError::Write { path, source }),
    }
}
