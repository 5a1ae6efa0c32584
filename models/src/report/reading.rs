//! Reading numbers off a motion.

use crate::catalog::{Failure, Record};
use liftoff::prelude::*;

/// The first event of `kind`, and the next ones.
pub fn events_of(record: &dyn Record, kind: EventKind) -> impl Iterator<Item = &Event> {
    record.events().iter().filter(move |event| event.kind == kind)
}

/// The coordinate or rate (`phi'`) of this name in a state.
pub fn coordinate(record: &dyn Record, state: &[f64], name: &str) -> Option<f64> {
    let coordinates = record.layout().coordinates;
    let (base, offset) = match name.strip_suffix('\'') {
        Some(base) => (base, coordinates.len()),
        None => (name, 0),
    };
    let index = coordinates.iter().position(|coordinate| coordinate.name == base)?;
    state.get(offset + index).copied()
}

/// The value of an output at a time.
pub fn at(record: &dyn Record, output: &str, t: f64) -> Result<f64, Failure> {
    Ok(record.output(output)?(t))
}

/// Least and largest value of an output over `[from, to]`, ends included.
pub fn range(record: &dyn Record, output: &str, [from, to]: [f64; 2]) -> Result<[f64; 2], Failure> {
    let value = record.output(output)?;
    let inside = record.extrema(output)?.into_iter().filter(|e| from <= e.t && e.t <= to).map(|e| e.value);
    let bounds = [f64::INFINITY, f64::NEG_INFINITY];
    let values = inside.chain([value(from), value(to)]);
    Ok(values.fold(bounds, |[low, high], v| [low.min(v), high.max(v)]))
}

/// Pairs of two outputs at `count` + 1 equally spaced times over `[from, to]`.
pub fn curve(
    record: &dyn Record,
    [x, y]: [&str; 2],
    [from, to]: [f64; 2],
    count: usize,
) -> Result<Vec<[f64; 2]>, Failure> {
    let (x, y) = (record.output(x)?, record.output(y)?);
    let times = (0..=count).map(|i| from + (to - from) * i as f64 / count as f64);
    Ok(times.map(|t| [x(t), y(t)]).collect())
}

/// When an output that changes monotonically over `[from, to]` has this value: by bisection, for drawings.
pub fn time_of(record: &dyn Record, output: &str, value: f64, [from, to]: [f64; 2]) -> Result<f64, Failure> {
    let output = record.output(output)?;
    let rising = output(to) > output(from);
    let (mut early, mut late) = (from, to);
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = f64::midpoint(early, late);
        if (output(middle) < value) == rising {
            early = middle;
        } else {
            late = middle;
        }
    }
    Ok(late)
}

/// Positions of the named points at a time.
pub fn places(record: &dyn Record, points: &[&str], t: f64) -> Result<Vec<[f64; 2]>, Failure> {
    let place = |point: &&str| Ok([at(record, &format!("x({point})"), t)?, at(record, &format!("y({point})"), t)?]);
    points.iter().map(place).collect()
}
