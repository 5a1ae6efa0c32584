//! A sweep as a drawing: curves over one varied name with its categories as bands, a map over two
//! for each observation.

mod curves;
mod maps;

use super::summary::counted;
use super::{Observation, Spread, SweepError, Table, Varied};
use crate::explain::names::printed;
use crate::plot::{Axis, Colour, LegendSquare, Scale};
use curves::curves;
use maps::maps;

/// Width of a drawing, pixels.
const WIDTH: u32 = 760;

const FAILED: &str = "failed";
const NONE: &str = "none";

impl Table {
    /// Curves over one varied name, maps over two: as SVG.
    pub fn svg(&self) -> Result<String, SweepError> {
        svg(self)
    }
}

fn svg(table: &Table) -> Result<String, SweepError> {
    match &table.varied[..] {
        [_] => Ok(curves(table)),
        [_, _] => Ok(maps(table)),
        names => {
            let count = names.len();
            Err(SweepError::Invalid(format!(
                "a drawing shows one varied name or two, not {count}: set the others"
            )))
        }
    }
}

fn description(table: &Table, over: &str) -> String {
    let observed: Vec<_> = table.observations.iter().map(Observation::text).collect();
    format!("{}: {} over {over}", table.model, observed.join(", "))
}

/// A varied name as an axis.
fn axis(table: &Table, varied: usize) -> Axis {
    let Varied { name, spread, .. } = &table.varied[varied];
    let values: Vec<f64> = match spread {
        Spread::Grid(range, _) | Spread::Anywhere(range) => vec![range.low, range.high],
        Spread::Listed(values) => values.clone(),
    };
    let [low, high] = ends(&values);
    let scale = if spread.is_logarithmic() { Scale::Logarithmic } else { Scale::Linear };
    Axis { name: with_unit(table, name), scale, range: [low, high], ticks: Vec::new() }
}

/// The ends of what is to be shown: a little more than nothing.
fn ends(values: &[f64]) -> [f64; 2] {
    let [low, high] =
        values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(*v), b.max(*v)]);
    match low < high {
        true => [low, high],
        false if low == 0.0 || !low.is_finite() => [-0.5, 0.5],
        false => [low - 0.05 * low.abs(), low + 0.05 * low.abs()],
    }
}

fn with_unit(table: &Table, name: &str) -> String {
    let is_angle = table.angles.iter().any(|angle| angle == name);
    let letter = printed(name, 0);
    if is_angle { format!("{letter}, rad") } else { letter }
}

/// An observation with the unit of its output.
fn title(table: &Table, observation: &Observation) -> String {
    let output = observation.output().map(ToString::to_string).unwrap_or_default();
    let is_angle = table.angles.contains(&output);
    if is_angle { format!("{}, rad", observation.text()) } else { observation.text().to_owned() }
}

/// Categories of an observation with their colours.
struct Colours(Vec<(String, Colour)>);

impl Colours {
    /// The most frequent first; all beyond the colours of curves share the last.
    fn from_table(table: &Table, observation: usize) -> Self {
        let mut colours = Colour::CURVES.into_iter();
        let colour = |(name, _): (String, usize)| {
            let colour = if name == NONE { Colour::Grey } else { colours.next().unwrap_or(Colour::Orange) };
            (name, colour)
        };
        let mut colours: Vec<_> = counted(table, observation).into_iter().map(colour).collect();
        if table.failed().next().is_some() {
            colours.push((FAILED.to_owned(), Colour::Black));
        }
        Self(colours)
    }

    fn colour(&self, name: &str) -> Colour {
        self.0.iter().find(|(known, _)| known == name).map_or(Colour::Black, |(_, colour)| *colour)
    }

    fn legend(&self) -> Vec<LegendSquare> {
        self.0.iter().map(|(name, colour)| LegendSquare { name: name.clone(), colour: *colour }).collect()
    }
}

/// The ends of the cells round sorted values: half way to their neighbours, in equal ratios where
/// so spread.
fn edges(values: &[f64], logarithmic: bool) -> Vec<f64> {
    let middle = |pair: &[f64]| match logarithmic {
        true => (pair[0] * pair[1]).sqrt(),
        false => 0.5 * (pair[0] + pair[1]),
    };
    let [first, last] = ends(values);
    let mut edges = vec![first];
    edges.extend(values.windows(2).map(middle));
    edges.push(last);
    edges
}
