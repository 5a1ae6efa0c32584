//! Curves read off the dense output of a motion: as many points as a drawing needs, a gap where
//! nothing is finite, and both values where an event makes one jump.

use crate::registry::MotionError;
use liftoff::Trajectory;

/// An output as a function of time.
pub(super) type Value<'a> = &'a dyn Fn(f64) -> f64;

/// Departure from the straight line between two points, over the range, that is not seen.
const SEEN: f64 = 1.0 / 1500.0;
/// Times at first, over all of the run.
const FIRST: usize = 240;
/// Halvings of an interval at most.
const DEEPEST: u32 = 7;
/// Points of one curve beyond which no interval is halved any more.
const MOST: usize = 20_000;
/// Values so many times larger than most are beyond the drawing, near a pole.
const POLE: f64 = 25.0;

/// How much smaller the neighbours of a value near a pole are at least.
const ALONE: f64 = 2.5;

/// A curve in smooth pieces, one for each phase that lasts.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Traced {
    pub pieces: Vec<Piece>,
}

/// Points with their times.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Piece {
    pub times: Vec<f64>,
    pub points: Vec<[f64; 2]>,
}

/// Spans of time without an event inside.
fn spans(record: &Trajectory) -> Vec<[f64; 2]> {
    let segments = record.segments();
    segments.iter().map(|segment| [segment.t0, segment.t1]).filter(|[t0, t1]| t0 < t1).collect()
}

/// One output against another over the whole run.
pub(super) fn traced(record: &Trajectory, x: Value, y: Value) -> Traced {
    over(record, x, y, record.interval())
}

/// Points of one output against another over an interval, dense enough for a drawing; a point that
/// is not a number breaks the line where it jumps.
///
/// # Errors
/// An output that the model does not have.
pub fn curve(
    record: &Trajectory,
    [x, y]: [&str; 2],
    interval: [f64; 2],
) -> Result<Vec<[f64; 2]>, MotionError> {
    Ok(over(record, &record.function(x)?, &record.function(y)?, interval).joined())
}

fn over(record: &Trajectory, x: Value, y: Value, [start, end]: [f64; 2]) -> Traced {
    let steps = record.times();
    let longest = (end - start) / FIRST as f64;
    let inside = |[t0, t1]: [f64; 2]| [t0.max(start), t1.min(end)];
    let spans: Vec<[f64; 2]> = spans(record).into_iter().map(inside).filter(|[t0, t1]| t0 < t1).collect();
    let rough: Vec<Piece> = spans
        .iter()
        .map(|&span| {
            let times = times(&steps, span, longest);
            let points = times.iter().map(|&t| evaluate(x, y, t, span)).collect();
            Piece { times, points }
        })
        .collect();
    let ranges = [0, 1].map(|axis| bounded(&rough, axis));
    let pieces = spans.iter().zip(&rough).map(|(&span, piece)| {
        let mut fine = Refined { x, y, span, ranges, piece: Piece::default() };
        fine.all(piece);
        fine.piece.within(ranges)
    });
    Traced { pieces: pieces.collect() }
}

/// At the end of a span before the event there, not after it.
fn evaluate(x: Value, y: Value, t: f64, [_, end]: [f64; 2]) -> [f64; 2] {
    let t = if t < end { t } else { end.next_down() };
    [x(t), y(t)]
}

/// The ends of a span and of the steps inside, none further from the next than `longest`.
fn times(steps: &[f64], [from, to]: [f64; 2], longest: f64) -> Vec<f64> {
    let inner = steps.iter().copied().filter(|t| from < *t && *t < to);
    let ends: Vec<f64> = [from].into_iter().chain(inner).chain([to]).collect();
    let mut times = vec![from];
    for pair in ends.windows(2) {
        let parts = ((pair[1] - pair[0]) / longest).ceil().clamp(1.0, FIRST as f64);
        let part = |i: u32| pair[0] + (pair[1] - pair[0]) * f64::from(i) / parts;
        times.extend((1..parts as u32).map(part));
        times.push(pair[1]);
    }
    times
}

/// Least and greatest of the values that are finite; of none, zero.
pub(super) fn seen(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let finite = values.filter(|value| value.is_finite());
    let ends = finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
    if ends[0] <= ends[1] { ends } else { [0.0, 0.0] }
}

/// The same without what is near a pole: far from nearly all other values, and from those next to
/// it too.
fn bounded(pieces: &[Piece], axis: usize) -> [f64; 2] {
    let all = pieces.iter().flat_map(|piece| &piece.points).map(|point| point[axis]);
    let mut finite: Vec<f64> = all.filter(|value| value.is_finite()).collect();
    finite.sort_by(f64::total_cmp);
    let ends = seen(finite.iter().copied());
    let quantile = |share: f64| finite[(share * (finite.len() - 1) as f64).round() as usize];
    if finite.len() < 8 {
        return ends;
    }
    let (low, high) = (quantile(0.1), quantile(0.9));
    let is_far = |value: f64| (value - low).abs().min((value - high).abs()) > POLE * (high - low);
    let is_pole = |end: f64| is_far(end) && pieces.iter().any(|piece| piece.is_alone(axis, end));
    let room = 2.0 * (high - low);
    let cut = |end: f64, near: f64| if is_pole(end) { near } else { end };
    [cut(ends[0], low - room), cut(ends[1], high + room)]
}

/// A piece in the making.
struct Refined<'a> {
    x: Value<'a>,
    y: Value<'a>,
    span: [f64; 2],
    ranges: [[f64; 2]; 2],
    piece: Piece,
}

impl Refined<'_> {
    fn all(&mut self, rough: &Piece) {
        let samples: Vec<(f64, [f64; 2])> =
            rough.times.iter().copied().zip(rough.points.iter().copied()).collect();
        samples.first().into_iter().for_each(|&(t, point)| self.piece.push(t, point));
        for pair in samples.windows(2) {
            self.between(pair[0], pair[1], DEEPEST);
            self.piece.push(pair[1].0, pair[1].1);
        }
    }

    /// Halves an interval until the curve is straight in it.
    fn between(&mut self, a: (f64, [f64; 2]), b: (f64, [f64; 2]), depth: u32) {
        let t = f64::midpoint(a.0, b.0);
        if depth == 0 || t <= a.0 || t >= b.0 || self.piece.times.len() > MOST {
            return;
        }
        let point = evaluate(self.x, self.y, t, self.span);
        if !self.is_straight([a.1, point, b.1]) {
            self.between(a, (t, point), depth - 1);
            self.piece.push(t, point);
            self.between((t, point), b, depth - 1);
        }
    }

    /// Where only some of the values are finite the end of the gap is looked for.
    fn is_straight(&self, [a, middle, b]: [[f64; 2]; 3]) -> bool {
        let finite = [a, middle, b].map(|point| point.iter().all(|x| x.is_finite()));
        if !finite.iter().all(|finite| *finite) {
            return finite.iter().all(|finite| !*finite);
        }
        (0..2).all(|i| {
            let [low, high] = self.ranges[i];
            (f64::midpoint(a[i], b[i]) - middle[i]).abs() <= SEEN * (high - low).max(f64::MIN_POSITIVE)
        })
    }
}

impl Piece {
    /// Whether the neighbours of a value are much smaller.
    fn is_alone(&self, axis: usize, value: f64) -> bool {
        let values: Vec<f64> = self.points.iter().map(|point| point[axis]).collect();
        let Some(at) = values.iter().position(|v| *v == value) else { return false };
        let near = [at.checked_sub(1), Some(at + 1)].into_iter().flatten().filter_map(|i| values.get(i));
        !near.copied().any(|neighbour| neighbour.abs() * ALONE > value.abs() && neighbour * value >= 0.0)
    }

    fn push(&mut self, t: f64, point: [f64; 2]) {
        self.times.push(t);
        self.points.push(point);
    }

    /// Gaps where values are beyond what is seen.
    fn within(mut self, ranges: [[f64; 2]; 2]) -> Self {
        for point in &mut self.points {
            let room = |i: usize| (ranges[i][1] - ranges[i][0]) * 0.1;
            let is_beyond = |i: usize| point[i] < ranges[i][0] - room(i) || point[i] > ranges[i][1] + room(i);
            if (0..2).any(is_beyond) {
                *point = [f64::NAN; 2];
            }
        }
        self
    }
}

impl Traced {
    /// All points in one line, broken where the curve jumps by what is seen.
    pub fn joined(&self) -> Vec<[f64; 2]> {
        let mut line: Vec<[f64; 2]> = Vec::new();
        let jumps = self.jumps();
        for (i, piece) in self.pieces.iter().enumerate() {
            if i > 0 && jumps.iter().any(|(before, _)| *before == i - 1) {
                line.push([f64::NAN; 2]);
            }
            line.extend(&piece.points);
        }
        line
    }

    /// Where the curve jumps by what is seen: the piece before, and the values before and after.
    pub fn jumps(&self) -> Vec<(usize, [[f64; 2]; 2])> {
        let [low, high] = seen(self.pieces.iter().flat_map(|piece| &piece.points).map(|p| p[1]));
        let pairs = self.pieces.windows(2).enumerate();
        let ends =
            pairs.filter_map(|(i, pair)| Some((i, [*pair[0].points.last()?, *pair[1].points.first()?])));
        ends.filter(|(_, [before, after])| (after[1] - before[1]).abs() > 0.004 * (high - low)).collect()
    }
}
