//! `liftoff boundary`.

use crate::CommandError;
use crate::commands::sweep::options::Options;
use crate::errors::interrupted::interrupted;
use crate::options::length::{Length, thin};
use crate::options::run_args::EventArgs;
use crate::options::values::width;
use crate::output::json::pretty;
use crate::output::print::print;
use clap::Args;
use core::fmt::Write;
use liftoff::__private::expression::significant;
use liftoff_studio::registry::Models;
use liftoff_studio::sweep::Boundary as Curve;
use serde_json::json;

/// How closely a curve is known, in parts of the ranges.
const WIDTH: f64 = 1e-10;
/// Digits of what is printed.
const DIGITS: usize = 10;

#[derive(Args, Debug)]
pub struct Boundary {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    pub model: String,
    /// Twice: a parameter, a coordinate or rate at the start, or a name that settings use, with its
    /// range; COUNT is the size of the grid on which curves are found
    #[arg(long, value_name = "NAME=LOW:HIGH[:COUNT]", required = true)]
    vary: Vec<String>,
    /// A parameter, as an expression of the varied names
    #[arg(long, value_name = "NAME=EXPR")]
    set: Vec<String>,
    /// A coordinate or rate (`phi'`) at the start, as an expression of the varied names; replaces the default start
    #[arg(long, value_name = "NAME=EXPR")]
    start: Vec<String>,
    /// A coordinate of a pose: start with the energy of this pose at rest
    #[arg(long, value_name = "NAME=EXPR")]
    energy_of: Vec<String>,
    /// What changes: `first open`, `last impact`, `end`, or a number that reaches a value, `first open phi = 0.4`
    #[arg(long, value_name = "WHAT", default_value = "first open")]
    observe: String,
    #[command(flatten)]
    events: EventArgs,
    /// Accuracy of the curves, as a fraction of the ranges
    #[arg(long, value_name = "WIDTH", value_parser = width, default_value_t = WIDTH, allow_negative_numbers = true)]
    to: f64,
    #[command(flatten)]
    length: Length,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Boundary {
    /// Prints the curves, point by point, with what is observed at both sides.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let model = models.find(&self.model)?;
        let options = Options {
            vary: self.vary.clone(),
            set: self.set.clone(),
            start: self.start.clone(),
            energy_of: self.energy_of.clone(),
            observe: vec![self.observe.clone()],
            events: self.events.clone(),
            ..Options::default()
        };
        let curves = options.sweep(model)?.cancel(interrupted()).boundaries(self.to)?;
        let names = self.vary.iter().map(|text| text.split_once('=').map_or("", |(name, _)| name.trim()));
        let names: Vec<&str> = names.collect();
        Ok(print(&match self.json {
            true => format_json(&names, &curves)?,
            false => self.length.fit(describe_curves(&names, &curves, usize::MAX), |lines| {
                let points = (lines / curves.len().max(1)).saturating_sub(1);
                let text = describe_curves(&names, &curves, points);
                text.lines().take(lines).map(|line| format!("{line}\n")).collect()
            }),
        })?)
    }
}

/// The curves, each with at most so many of its points, its ends among them.
fn describe_curves(names: &[&str], curves: &[Curve], most: usize) -> String {
    let mut text = String::new();
    for (k, curve) in curves.iter().enumerate() {
        let Curve { left, right, points, ends } = curve;
        let head =
            format!("{}: {left} | {right}, {} points along ({})", k + 1, points.len(), names.join(", "));
        let _ = writeln!(text, "{head}, from {} to {}", ends[0], ends[1]);
        for point in thin(points, most) {
            let [x, y] = point.map(|x| significant(x, DIGITS));
            let _ = writeln!(text, "  {x}  {y}");
        }
    }
    if curves.is_empty() {
        text += "nothing changes on the grid: give other ranges, or a finer grid by NAME=LOW:HIGH:COUNT\n";
    }
    text
}

fn format_json(names: &[&str], curves: &[Curve]) -> Result<String, CommandError> {
    let each = curves.iter().map(|curve| {
        json!({
            "left": curve.left,
            "right": curve.right,
            "names": names,
            "points": curve.points,
            "ends": [curve.ends[0].to_string(), curve.ends[1].to_string()],
        })
    });
    pretty(&each.collect::<Vec<_>>())
}
