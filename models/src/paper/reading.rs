//! Reading numbers off a motion.

use liftoff::Extremum;
use liftoff::prelude::*;
use liftoff_studio::registry::MotionError;

/// The first event of `kind`, and the next ones.
pub fn events_of(record: &Trajectory, kind: EventKind) -> impl Iterator<Item = &Event> {
    record.events().iter().filter(move |event| event.kind == kind)
}

/// The coordinate or rate (`phi'`) of this name in a state.
pub fn coordinate(record: &Trajectory, state: &[f64], name: &str) -> Option<f64> {
    let coordinates = record.layout().coordinates;
    let (base, offset) = match name.strip_suffix('\'') {
        Some(base) => (base, coordinates.len()),
        None => (name, 0),
    };
    let index = coordinates.iter().position(|coordinate| coordinate.name == base)?;
    state.get(offset + index).copied()
}

/// The value of an output at a time.
pub fn evaluate_output(record: &Trajectory, output: &str, t: f64) -> Result<f64, MotionError> {
    Ok(record.function(output)?(t))
}

/// Where an output turns.
pub fn extrema(record: &Trajectory, output: &str) -> Result<Vec<Extremum>, MotionError> {
    Ok(record.extrema(&record.output(output)?))
}

/// Least and largest value of an output over `[from, to]`, ends included. Turning points that stand
/// out by less than the error bound do not count as such, so the ends of the steps are looked at
/// too.
pub fn range(record: &Trajectory, output: &str, [from, to]: [f64; 2]) -> Result<[f64; 2], MotionError> {
    let value = record.function(output)?;
    let inside = |t: &f64| from <= *t && *t <= to;
    let extrema = extrema(record, output)?.into_iter().filter(|extremum| inside(&extremum.t));
    let steps = record.times().into_iter().filter(inside).chain([from, to]).map(&value);
    let bounds = [f64::INFINITY, f64::NEG_INFINITY];
    let values = extrema.map(|extremum| extremum.value).chain(steps);
    Ok(values.fold(bounds, |[low, high], v| [low.min(v), high.max(v)]))
}

/// When an output that changes monotonically over an interval has this value: by bisection, for
/// drawings.
pub fn time_of(
    record: &Trajectory,
    output: &str,
    value: f64,
    [from, to]: [f64; 2],
) -> Result<f64, MotionError> {
    let output = record.function(output)?;
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

/// Times from one end of an interval to the other between which a monotonic output makes `count`
/// equal steps.
pub fn equal_steps(
    record: &Trajectory,
    output: &str,
    interval: [f64; 2],
    count: u32,
) -> Result<Vec<f64>, MotionError> {
    let [from, to] = interval;
    let [first, last] = [evaluate_output(record, output, from)?, evaluate_output(record, output, to)?];
    let value = |i| first + (last - first) * f64::from(i) / f64::from(count);
    let inner: Result<Vec<f64>, _> =
        (1..count).map(|i| time_of(record, output, value(i), interval)).collect();
    Ok([vec![from], inner?, vec![to]].concat())
}

/// Positions of the named points at a time.
pub fn places(record: &Trajectory, points: &[&str], t: f64) -> Result<Vec<[f64; 2]>, MotionError> {
    let place = |point: &&str| {
        Ok([
            evaluate_output(record, &format!("x({point})"), t)?,
            evaluate_output(record, &format!("y({point})"), t)?,
        ])
    };
    points.iter().map(place).collect()
}
