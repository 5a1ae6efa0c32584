//! What emitted code costs: tables on standard output, `target/liftoff/speed.json`, charts beside
//! it.
//!
//! `cargo bench --bench speed`, or with names of sections:
//! `cargo bench --bench speed -- chain models`. Times are minima over many short repeats, the
//! variants that are compared taking turns, so that ratios hold on a busy machine too.

mod batch;
mod chain;
mod charts;
mod compiler;
mod ensemble;
mod expansion;
mod friction;
mod interpreted;
mod models;
mod output;
mod scenes;
mod stick_slip;
mod symbols;
mod timing;

use std::error::Error;

type Result<T> = core::result::Result<T, Box<dyn Error>>;

/// A section's name and its rows.
type Section = (&'static str, fn() -> Result<Vec<serde_json::Value>>);

const SECTIONS: [Section; 7] = [
    ("chain", chain::rows),
    ("batch", batch::rows),
    ("ensemble", ensemble::rows),
    ("models", models::rows),
    ("scenes", scenes::rows),
    ("friction", friction::rows),
    ("interpreted", interpreted::rows),
];

fn main() -> Result<()> {
    let asked: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    for (name, rows) in SECTIONS {
        if asked.is_empty() || asked.iter().any(|word| word == name) {
            let rows = rows()?;
            output::print(name, &rows);
            output::keep(name, rows)?;
        }
    }
    charts::draw(&output::kept()?)
}
