//! The step divided so that the function is monotone between neighbouring points.

use super::NotFinite;
use super::bracket::{Point, sample};
use super::isolate::turning_points;
use super::polynomial::{COARSE, Polynomial, node};

/// Values at [`NODES`].
pub type Samples = [f64; COARSE + 1];

/// Where a function is sampled first: θⱼ = (1 − cos πj/8)/2.
pub const NODES: Samples = {
    let mut nodes = [0.0; COARSE + 1];
    let mut j = 0;
    while j <= COARSE {
        nodes[j] = node(j, COARSE);
        j += 1;
    }
    nodes
};

/// A function that no fit resolves is divided at most so many times.
const DEEPEST: u32 = 5;

/// A point of the division.
#[derive(Clone, Copy)]
pub(super) struct Node {
    pub(super) point: Point,
    /// Differences below this are those of the fit.
    pub(super) noise: f64,
    /// The end of the step, with an extremum there or so near beyond it that the values agree.
    pub(super) flat: bool,
}

/// What to divide and how finely.
pub(super) struct Division<'a> {
    pub(super) samples: Option<&'a Samples>,
    /// Error bound of the function.
    pub(super) delta: f64,
    /// Whether a piece with these bounds can be passed over.
    pub(super) dull: fn(range: [f64; 2], delta: f64) -> bool,
}

impl Division<'_> {
    /// Visits the points of the division in ascending order, both ends included.
    pub(super) fn visit(
        &self,
        g: &mut dyn FnMut(f64) -> f64,
        visit: &mut dyn FnMut(Node),
    ) -> Result<(), NotFinite> {
        self.piece(g, [0.0, 1.0], 0, visit)
    }

    fn is_dull(&self, fit: &Polynomial) -> bool {
        let ([low, high], margin) = (fit.range(), 2.0 * fit.error);
        (self.dull)([low - margin, high + margin], self.delta)
    }

    fn piece(
        &self,
        g: &mut dyn FnMut(f64) -> f64,
        [start, end]: [f64; 2],
        depth: u32,
        visit: &mut dyn FnMut(Node),
    ) -> Result<(), NotFinite> {
        let samples = self.samples.filter(|_| depth == 0);
        let fit = Polynomial::fit(g, [start, end], samples, self.delta, &|fit| self.is_dull(fit))?;
        let dull = self.is_dull(&fit);
        if !(fit.resolved || dull) && depth < DEEPEST {
            let middle = 0.5 * (start + end);
            self.piece(g, [start, middle], depth + 1, visit)?;
            return self.piece(g, [middle, end], depth + 1, visit);
        }
        let noise = 2.0 * fit.error;
        let mut node = |theta, value, flat| {
            let point = Point { theta, value };
            visit(Node { point, noise, flat });
        };
        if start == 0.0 {
            node(start, fit.ends[0], false);
        }
        let slope = fit.derivative();
        if !dull {
            let mut sample = |x| sample(g, start + (end - start) * x);
            let mut outcome = Ok(());
            turning_points(&slope, &mut |x| match sample(x) {
                Ok(Point { theta, value }) => node(theta, value, false),
                Err(error) => outcome = Err(error),
            });
            outcome?;
        }
        node(end, fit.ends[1], end == 1.0 && flat_at_end(&slope, noise));
        Ok(())
    }
}

/// Whether p′²/2|p″| at the end, the way to the extremum, is within the noise; p′ = 2q, p″ = 4q′.
fn flat_at_end(slope: &Polynomial, noise: f64) -> bool {
    let (q, change) = (slope.at(1.0), slope.derivative().at(1.0));
    q * q <= 2.0 * change.abs() * noise
}
