//! The first kink within a step, on its dense output.
//!
//! Kinks are functions of the state that the right-hand side is made of, and steps are short enough
//! to follow that; some values in each tell where they turn.

use super::CutAtKinks;
use crate::model::Kink;
use smallvec::smallvec;

use crate::context::Numbers;
use crate::numerics::zero::{SOLVED, roundoff};

/// Where a step is looked at. Near its ends too, so that what turns there is seen to.
const NODES: [f64; 11] =
    [0.0, 1.0 / 64.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0 - 1.0 / 64.0, 1.0];
/// Some of them, which are looked at first: where all values there are of one sign and so near each
/// other, no zero lies between. The square of a distance that vanishes between two of them is less
/// than a sixteenth of its largest value at one.
const FEW: [usize; 5] = [0, 3, 5, 7, 10];
const ALIKE: f64 = 0.75;
const APART: f64 = 0.25;
/// A root whose least value is more than this part of the largest turns smoothly.
const SMOOTH: f64 = 1e-3;
/// Roots are looked for where one of the values is less than this part of the largest.
const SUSPECT: f64 = 0.5;
/// The same beside an end: what turns there has come from so near.
const SUSPECT_END: f64 = 1.0 / 16.0;
/// Evaluations that a root of a function, or a minimum, takes at most.
const MOST: usize = 80;

/// Values of each kink at the nodes, one after the other.
#[derive(Default)]
pub(super) struct KinkSamples(Vec<f64>);

impl CutAtKinks<'_> {
    /// θ of the first kink within the last step, farther from its ends than `resolution`.
    pub(super) fn first_kink(&mut self, resolution: f64) -> Option<f64> {
        let mut values = core::mem::take(&mut self.samples).0;
        let count = self.kinks.len();
        values.resize(NODES.len() * count, 0.0);
        self.sample(FEW.into_iter(), &mut values);
        let least = |kink: Kink| if kink == Kink::Sign { ALIKE } else { APART };
        self.alike = self.are_alike(&values, |_| ALIKE);
        if self.alike || self.are_alike(&values, least) {
            self.samples = KinkSamples(values);
            return None;
        }
        self.sample((0..NODES.len()).filter(|node| !FEW.contains(node)), &mut values);
        let samples = &values[..];
        let firsts = (0..count).filter_map(|j| {
            let own = core::array::from_fn(|i| samples[i * count + j]);
            match self.kinks[j] {
                Kink::Sign => self.first_change(j, &own),
                Kink::Radicand => self.first_touch(j, &own.map(|r| r.max(0.0).sqrt()), resolution),
            }
        });
        let first = firsts.filter(|theta| is_within(*theta, resolution)).min_by(f64::total_cmp);
        self.samples = KinkSamples(values);
        first
    }

    /// Writes the values at some nodes to their places.
    fn sample(&self, nodes: impl Iterator<Item = usize>, values: &mut [f64]) {
        let count = self.kinks.len();
        nodes.for_each(|i| values[i * count..(i + 1) * count].copy_from_slice(&self.evaluate(NODES[i])));
    }

    /// Whether the values at [`FEW`] are of one sign, and no less than a part of the largest.
    fn are_alike(&self, values: &[f64], part: impl Fn(Kink) -> f64) -> bool {
        let count = self.kinks.len();
        self.kinks.iter().enumerate().all(|(j, &kink)| {
            let own = FEW.iter().map(|i| values[i * count + j]);
            let [least, most] = own.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| {
                [least.min(value), most.max(value)]
            });
            let part = part(kink);
            least > part * most && most > 0.0 || most < part * least && least < 0.0
        })
    }

    fn evaluate(&self, theta: f64) -> Numbers {
        let mut values: Numbers = smallvec![0.0; self.kinks.len()];
        let mut y: Numbers = core::mem::take(&mut self.scratch.borrow_mut()[1]);
        y.resize(self.dense.entries(), 0.0);
        self.dense.interpolate(theta, &mut y);
        self.values(&y, &mut values);
        self.scratch.borrow_mut()[1] = y;
        values
    }

    /// Where a kink changes its sign first.
    fn first_change(&self, j: usize, values: &[f64; NODES.len()]) -> Option<f64> {
        let value = |theta: f64| self.evaluate(theta)[j];
        let largest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        // The kink that the step began at.
        let begun = usize::from(values[0].abs() <= SOLVED * largest);
        for i in begun..NODES.len() - 1 {
            let (a, b) = (values[i], values[i + 1]);
            if a * b < 0.0 {
                return Some(root(&value, [NODES[i], NODES[i + 1]], a));
            }
            // Between three values of one sign both changes may lie.
            let turns = i > begun && a.abs() <= b.abs() && a.abs() <= values[i - 1].abs();
            if turns && a.abs() < SUSPECT * largest {
                let lowest = minimum(&|theta| value(theta) * a.signum(), [NODES[i - 1], NODES[i + 1]], 0.0);
                if value(lowest) * a < 0.0 {
                    return Some(root(&value, [NODES[i - 1], lowest], values[i - 1]));
                }
            }
        }
        None
    }

    /// Where a root is all but zero first, at a minimum. What turns beside an end of the step is
    /// least at that end, of all nodes.
    fn first_touch(&self, j: usize, roots: &[f64; NODES.len()], least: f64) -> Option<f64> {
        const LAST: usize = NODES.len() - 1;
        let value = |theta: f64| self.evaluate(theta)[j].max(0.0).sqrt();
        let largest = roots.iter().fold(0.0_f64, |most, x| most.max(*x));
        (0..=LAST).find_map(|i| {
            let [before, after] = [i.saturating_sub(1), (i + 1).min(LAST)];
            let turns = roots[i] <= roots[after] && roots[i] <= roots[before];
            let is_end = before == i || after == i;
            let suspect = if is_end { SUSPECT_END } else { SUSPECT };
            if !turns || roots[i] > suspect * largest || largest == 0.0 {
                return None;
            }
            let lowest = minimum(&value, [NODES[before], NODES[after]], SOLVED * largest);
            // A step that ends as near as this to a smooth turn has no kink before it.
            let stands_out = !is_end || value(lowest) < 0.5 * roots[i];
            (is_within(lowest, least) && stands_out && value(lowest) <= SMOOTH * largest).then_some(lowest)
        })
    }
}

/// Whether a place of a step is farther from its ends than `least`.
fn is_within(theta: f64, least: f64) -> bool {
    theta > least && 1.0 - theta > least
}

/// A zero between two places, at the first of which the function has the sign of `first`: halved,
/// as many times as numbers have digits.
fn root(value: &impl Fn(f64) -> f64, [mut a, mut b]: [f64; 2], first: f64) -> f64 {
    let (mut at_a, mut at_b) = (first, value(b));
    for k in 0..MOST {
        // Every other time along the chord.
        let chord = (a * at_b - b * at_a) / (at_b - at_a);
        let inside = k % 2 == 0 && chord > a && chord < b;
        let middle = if inside { chord } else { 0.5 * (a + b) };
        let at = value(middle);
        if at == 0.0 || middle <= a || middle >= b {
            return middle;
        }
        if at * first > 0.0 { (a, at_a) = (middle, at) } else { (b, at_b) = (middle, at) }
    }
    0.5 * (a + b)
}

/// The place of the least value between two places, by the golden section; any where it is below
/// `enough`.
fn minimum(value: &impl Fn(f64) -> f64, [mut a, mut b]: [f64; 2], enough: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut at_c, mut at_d) = (value(c), value(d));
    for _ in 0..MOST {
        if at_c.min(at_d) < enough || b - a <= roundoff(4.0) {
            break;
        }
        if at_c < at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - GOLDEN * (b - a);
            at_c = value(c);
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + GOLDEN * (b - a);
            at_d = value(d);
        }
    }
    if at_c < at_d { c } else { d }
}
