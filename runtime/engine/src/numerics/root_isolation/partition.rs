//! Divides a step so that the function is monotone between neighbouring points.

use super::GuardError;
use super::bernstein::Bernstein;
use super::bracket::{Point, sample};
use super::isolate::turning_points;
use super::nonsmooth::{PieceFunction, approaches};
use super::polynomial::{CHECK, COARSE, Polynomial, node};
use crate::numerics::zero::roundoff;

/// First sample nodes of a function, θⱼ = (1 − cos πj/8)/2, and the nodes at which their fit is
/// checked.
pub const NODES: [f64; COARSE + 2] = {
    let mut nodes = [CHECK; COARSE + 2];
    let mut j = 0;
    while j <= COARSE {
        nodes[j] = node(j, COARSE);
        j += 1;
    }
    nodes
};

/// Accuracy of a function's values.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Accuracy {
    /// Error bound, at least zero.
    pub delta: f64,
    /// Whether unresolved pieces are followed through their samples, however often they turn;
    /// otherwise only a few poles and kinks are.
    pub is_noisy: bool,
}

impl From<f64> for Accuracy {
    fn from(delta: f64) -> Self {
        Self { delta, is_noisy: false }
    }
}

/// Maximum number of divisions of a function that no fit resolves.
const DEEPEST: u32 = 5;

/// With more unresolved pieces than this a function counts as oscillating too fast rather than as
/// having kinks or poles.
const ROUGH: usize = 8;

/// A point of the division.
#[derive(Clone, Copy)]
pub(super) struct Node {
    pub(super) point: Point,
    /// Differences below this may be errors of the fit.
    pub(super) noise: f64,
    /// At the end of the step: difference between the value and the extremum there or just beyond
    /// the step; else infinite.
    pub(super) beyond: f64,
    /// Whether a polynomial fits the function since the point before.
    pub(super) smooth: bool,
}

/// The function to divide, and how finely.
pub(super) struct Division {
    pub(super) accuracy: Accuracy,
    /// Whether a piece with these bounds can be skipped.
    pub(super) dull: fn(range: [f64; 2], delta: f64) -> bool,
}

impl Division {
    /// Visits the points of the division in ascending order, both ends included.
    pub(super) fn visit(
        &self,
        g: &mut dyn FnMut(f64) -> f64,
        visit: &mut dyn FnMut(Node),
    ) -> Result<(), GuardError> {
        self.piece(g, [0.0, 1.0], 0, visit).map(|_| ())
    }

    /// Whether bounds of the function prove that the piece can be skipped.
    fn is_dull(&self, fit: &Polynomial) -> bool {
        let margin = if self.accuracy.is_noisy { fit.scatter } else { fit.margin };
        let [low, high] = fit.range();
        (self.dull)([low - margin, high + margin], self.accuracy.delta)
    }

    /// Divides a piece; returns the number of pieces that no fit resolves.
    fn piece(
        &self,
        g: &mut dyn FnMut(f64) -> f64,
        [start, end]: [f64; 2],
        depth: u32,
        visit: &mut dyn FnMut(Node),
    ) -> Result<usize, GuardError> {
        // A function too fast for the whole step may be resolved on a piece.
        let enough = |fit: &Polynomial| depth == 0 && self.is_dull(fit);
        let fit = Polynomial::fit(g, [start, end], self.accuracy.delta, &enough)?;
        let dull = self.is_dull(&fit);
        if !(fit.resolved || dull) && depth < DEEPEST {
            let middle = 0.5 * (start + end);
            let most = if self.accuracy.is_noisy { usize::MAX } else { ROUGH };
            let mut rough = self.piece(g, [start, middle], depth + 1, visit)?;
            if rough <= most {
                rough += self.piece(g, [middle, end], depth + 1, visit)?;
            }
            return if rough > most { Err(GuardError::Unresolved { theta: start }) } else { Ok(rough) };
        }
        let noise = 2.0 * fit.error;
        let smooth = fit.resolved;
        let mut node = |point, beyond| visit(Node { point, noise, beyond, smooth });
        if start == 0.0 {
            node(Point { theta: start, value: fit.ends[0] }, f64::INFINITY);
        }
        if !dull {
            let mut sample = |x: f64| sample(g, start + (end - start) * x);
            let mut node = |point| node(point, f64::INFINITY);
            if fit.resolved {
                turns(&fit, &mut sample, &mut node)?
            } else {
                approaches(&mut sample, &mut node)?
            }
        }
        let last = if end == 1.0 && !dull { beyond_end(&fit) } else { f64::INFINITY };
        node(Point { theta: end, value: fit.ends[1] }, last);
        Ok(usize::from(!(fit.resolved || dull)))
    }
}

fn turns(
    fit: &Polynomial,
    sample: &mut PieceFunction,
    visit: &mut dyn FnMut(Point),
) -> Result<(), GuardError> {
    let slope = fit.derivative();
    let [low, high] = slope.range();
    if low > 0.0 || high < 0.0 {
        return Ok(());
    }
    let mut outcome = Ok(());
    let rounding = roundoff(slope.degree as f64) * high.max(-low);
    let mut turn = |x| match sample(x) {
        Ok(point) => visit(point),
        Err(error) => outcome = Err(error),
    };
    turning_points(Bernstein::from_chebyshev(&slope), rounding, &|x| slope.evaluate(x), &mut turn);
    outcome
}

/// p′ = 2q, p″ = 4q′.
fn beyond_end(fit: &Polynomial) -> f64 {
    let q = fit.derivative();
    beyond(2.0 * q.evaluate(1.0), 4.0 * q.derivative().evaluate(1.0))
}

/// p′²/2|p″|, the difference to the extremum of a parabola with these derivatives.
pub(super) fn beyond(rate: f64, bend: f64) -> f64 {
    if rate == 0.0 { 0.0 } else { rate * rate / (2.0 * bend.abs()) }
}
