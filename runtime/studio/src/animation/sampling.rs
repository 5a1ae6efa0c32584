//! A motion as cubics: each interval has the values at its ends and at its thirds, and the cubic
//! through them is as close to the dense output as asked. Between two phases everything may jump,
//! so each has samples of its own at both ends.

use super::quantities::Function;
use liftoff::Segment;

/// Steps of the integrator that are taken together at first.
const TOGETHER: usize = 8;

/// Halvings of an interval at most: at a pole a cubic is never close.
const HALVINGS: u32 = 10;

/// About as many values as a motion may have: where they are used up, or steps are too many, cubics
/// are less close.
const MOST: usize = 2_000_000;

/// A phase as cubics.
pub(super) struct Sampled {
    /// Its index among the record's segments.
    pub segment: usize,
    /// Ends of the intervals.
    pub times: Vec<f64>,
    /// Values of all functions at the start, then at both thirds and the end of each interval.
    pub rows: Vec<Vec<f64>>,
}

/// Samples functions of a motion.
pub(super) struct Sampler<'a, 'b> {
    functions: &'b [Function<'a>],
    /// How far the cubics may be from each function.
    tolerances: Vec<f64>,
    /// How many intervals there may be yet.
    left: usize,
}

/// A time, and the values there.
type Node = (f64, Vec<f64>);

impl<'a, 'b> Sampler<'a, 'b> {
    pub fn new(functions: &'b [Function<'a>], tolerances: Vec<f64>) -> Self {
        let left = MOST / (3 * functions.len().max(1));
        Self { functions, tolerances, left }
    }

    /// The phases that take time, or else the last, as cubics between these steps of the
    /// integrator; the time read at the end of a phase is the last before the next one.
    pub fn phases(&mut self, segments: &[Segment], steps: &[f64]) -> Vec<Sampled> {
        let together = TOGETHER.max(steps.len() / self.left.max(1));
        let last = segments.iter().rposition(lasts).or(segments.len().checked_sub(1));
        let lasting = segments.iter().enumerate().filter(|(i, segment)| lasts(segment) || last == Some(*i));
        let phase = |(i, segment): (usize, &Segment)| {
            let end = if last == Some(i) { segment.t1 } else { segment.t1.next_down() };
            let inner = inside(steps, segment);
            let mut bounds: Vec<Node> = vec![self.node(segment.t0)];
            bounds.extend(inner.chunks_exact(together).map(|chunk| self.node(chunk[together - 1])));
            bounds.push((segment.t1, self.evaluate(end)));
            self.phase(i, &bounds)
        };
        lasting.map(phase).collect()
    }

    /// A phase from its start over these nodes to its end.
    fn phase(&mut self, segment: usize, bounds: &[Node]) -> Sampled {
        let (t0, start) = bounds[0].clone();
        let mut sampled = Sampled { segment, times: vec![t0], rows: vec![start] };
        for pair in bounds.windows(2) {
            self.refine(&mut sampled, &pair[0], &pair[1], HALVINGS);
        }
        sampled
    }

    /// Adds the interval between two nodes, halved until its cubic is close.
    fn refine(&mut self, sampled: &mut Sampled, a: &Node, b: &Node, halvings: u32) {
        let between = |theta: f64| a.0 + theta * (b.0 - a.0);
        let thirds = [1.0, 2.0].map(|i| self.evaluate(between(i / 3.0)));
        let middle = self.node(between(0.5));
        let close =
            |theta: f64, values: &[f64]| self.is_close([&a.1, &thirds[0], &thirds[1], &b.1], theta, values);
        let done = halvings == 0
            || self.left == 0
            || close(0.5, &middle.1)
                && [1.0 / 6.0, 5.0 / 6.0].iter().all(|&theta| close(theta, &self.evaluate(between(theta))));
        if !done {
            self.refine(sampled, a, &middle, halvings - 1);
            return self.refine(sampled, &middle, b, halvings - 1);
        }
        self.left = self.left.saturating_sub(1);
        sampled.times.push(b.0);
        sampled.rows.extend(thirds);
        sampled.rows.push(b.1.clone());
    }

    fn is_close(&self, nodes: [&Vec<f64>; 4], theta: f64, values: &[f64]) -> bool {
        let mut all = values.iter().zip(&self.tolerances).enumerate();
        all.all(|(i, (value, tolerance))| {
            let cubic = cubic(nodes.map(|row| row[i]), theta);
            // Both infinite or undefined is as close as it gets.
            (cubic - value).abs() <= *tolerance || !cubic.is_finite() && !value.is_finite()
        })
    }

    fn node(&self, t: f64) -> Node {
        (t, self.evaluate(t))
    }

    fn evaluate(&self, t: f64) -> Vec<f64> {
        self.functions.iter().map(|function| function(t)).collect()
    }
}

fn lasts(segment: &Segment) -> bool {
    segment.t1 > segment.t0
}

/// The steps that end within a segment.
fn inside<'s>(steps: &'s [f64], segment: &Segment) -> &'s [f64] {
    let from = steps.partition_point(|&t| t <= segment.t0);
    let to = steps.partition_point(|&t| t < segment.t1);
    &steps[from..to.max(from)]
}

/// The cubic through values at 0, ⅓, ⅔ and 1.
pub(super) fn cubic([a, b, c, d]: [f64; 4], theta: f64) -> f64 {
    let [p, q, r, s] = [theta, 3.0 * theta - 1.0, 3.0 * theta - 2.0, theta - 1.0];
    -0.5 * q * r * s * a + 4.5 * p * r * s * b - 4.5 * p * q * s * c + 0.5 * p * q * r * d
}
