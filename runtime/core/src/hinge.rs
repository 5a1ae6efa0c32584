//! Motion with friction in hinges: a journal of radius r rubs where the hinge force F presses it on
//! its bearing, `N = |F|`. The friction forces R of those that slide are loads, which F is affine
//! in,
//!
//! ```text
//! F_j = F⁰_j + Σ_i Gʲ_i s_i,    s_j = |F_j|,    R_i = −σ_i μ_i s_i
//! ```
//!
//! F⁰ without them, G from a unit of each. Where `Σ_i |Gʲ_i| < 1` for each j, s → |F(s)| is a
//! contraction and the solution the only one; friction of a journal that is small against its
//! bodies is far from the border. Beyond it there may be several or none (Painlevé's paradox): the
//! motion is then not a number.

use crate::kernel::slopes;
use crate::model::{Array, BarSystem, ContactSet, Friction, KernelView, Layout};
use crate::scalar::Scalar;

/// The most steps of Newton's method.
const STEPS: usize = 60;

/// A component of a force: a quantity by its place, at accelerations and multipliers.
type Force<'a, S> = dyn Fn(usize, &[S], &[S]) -> S + 'a;

/// Writes the motion of a compiled model as [`KernelView::solve`] does, N and R of its hinges among
/// the multipliers; whether the multipliers are the only ones.
pub fn solution<M: BarSystem, S: Scalar>(
    constants: &M::Constants<S>,
    set: &ContactSet,
    state: &M::State<S>,
    accelerations: &mut [S],
    multipliers: &mut [S],
) -> bool {
    let force = |entry: usize, a: &[S], lambda: &[S]| {
        M::quantity(constants, entry, state, &Array::from_fn(|i| a[i]), &Array::from_fn(|i| lambda[i]))
    };
    solve(M::kernel(constants, state), (M::LAYOUT, set), &force, accelerations, multipliers)
}

/// Time derivative of the full state, `Y` entries, in a contact set.
pub fn derivative<M: BarSystem, S: Scalar, const Y: usize>(
    constants: &M::Constants<S>,
    set: &ContactSet,
    state: &M::State<S>,
) -> [S; Y] {
    let mut accelerations = M::Accelerations::from_fn(|_| S::ZERO);
    let mut multipliers = M::Multipliers::from_fn(|_| S::ZERO);
    solution::<M, S>(constants, set, state, accelerations.as_mut(), multipliers.as_mut());
    slopes(M::LAYOUT, state.as_ref(), accelerations.as_ref())
}

/// Reactions of the contacts, zero where open, then the friction forces.
pub fn reactions<M: BarSystem, S: Scalar>(
    constants: &M::Constants<S>,
    set: &ContactSet,
    state: &M::State<S>,
) -> M::Reactions<S> {
    let mut accelerations = M::Accelerations::from_fn(|_| S::ZERO);
    let mut multipliers = M::Multipliers::from_fn(|_| S::ZERO);
    solution::<M, S>(constants, set, state, accelerations.as_mut(), multipliers.as_mut());
    M::Reactions::from_fn(|entry| multipliers.as_ref()[M::LAYOUT.row_of_reaction(entry)])
}

/// The same for equations of any dimension; `force` gives the quantities of the model.
pub fn solve<S: Scalar, K: KernelView<S>>(
    mut kernel: K,
    (layout, set): (&Layout, &ContactSet),
    force: &Force<'_, S>,
    accelerations: &mut [S],
    multipliers: &mut [S],
) -> bool {
    let mut rubbing =
        SlidingHinges { count: 0, constant: [[S::ZERO; 2]; MOST], gains: [[[S::ZERO; 2]; MOST]; MOST] };
    let slides = |of: &(usize, Friction, [usize; 2])| set.sense(of.1.contact) != 0;
    let sliding = || layout.hinges().filter(slides).take(MOST);
    kernel.solve(layout, set, accelerations, multipliers);
    for (j, (_, _, [x, y])) in sliding().enumerate() {
        rubbing.count = j + 1;
        rubbing.constant[j] = [x, y].map(|part| force(part, accelerations, multipliers));
    }
    for (i, (_, friction, _)) in sliding().enumerate() {
        // A unit of the force that F's own terms would cause keeps its digits.
        let unit = rubbing.size();
        kernel.push(friction.row, unit);
        kernel.solve(layout, set, accelerations, multipliers);
        kernel.push(friction.row, -unit);
        let share = -kernel.friction()[friction.row] / unit;
        for (j, (_, _, [x, y])) in sliding().enumerate() {
            let loaded = [x, y].map(|part| force(part, accelerations, multipliers));
            rubbing.gains[j][i] = [0, 1].map(|axis| (loaded[axis] - rubbing.constant[j][axis]) * share);
        }
    }
    let normals = rubbing.normals();
    let found = normals.unwrap_or([S::from_f64(f64::NAN); MOST]);
    for ((_, friction, _), normal) in sliding().zip(found) {
        kernel.push(friction.row, -kernel.friction()[friction.row] * normal);
    }
    let unique = kernel.solve(layout, set, accelerations, multipliers);
    for (_, friction, [x, y]) in layout.hinges().filter(|of| set.contains(of.1.contact)) {
        let [x, y] = [x, y].map(|part| force(part, accelerations, multipliers));
        multipliers[friction.contact] = length([x, y]);
    }
    for ((_, friction, _), normal) in sliding().zip(found) {
        multipliers[friction.contact] = normal;
        multipliers[friction.row] = -kernel.friction()[friction.row] * normal;
    }
    unique && normals.is_some()
}

const MOST: usize = Layout::HINGES;

/// The hinges that slide: F⁰, and what a unit of each s adds to each F.
struct SlidingHinges<S> {
    count: usize,
    constant: [[S; 2]; MOST],
    gains: [[[S; 2]; MOST]; MOST],
}

impl<S: Scalar> SlidingHinges<S> {
    /// The size of the forces; one where there are none.
    fn size(&self) -> S {
        let most = self.constant.iter().flatten().fold(S::ZERO, |most, x| largest(most, x.abs()));
        // A number without derivatives.
        if most > S::ZERO { S::from_f64(most.to_f64()) } else { S::ratio(1, 1) }
    }

    /// s of `s = |F(s)|` where it is the only one.
    fn normals(&self) -> Option<[S; MOST]> {
        let one = S::ratio(1, 1);
        let row = |j: usize| (0..self.count).fold(S::ZERO, |sum, i| sum + length(self.gains[j][i]));
        if !(0..self.count).all(|j| row(j) < one) {
            return None;
        }
        let mut s: [S; MOST] = core::array::from_fn(|j| length(self.constant[j]));
        let mut is_last = self.count == 0;
        for _ in 0..STEPS {
            if is_last {
                break;
            }
            let step = self.step(&s);
            let (most, change) = (0..self.count).fold((S::ZERO, S::ZERO), |(most, change), j| {
                s[j] = s[j] + step[j];
                (largest(most, s[j].abs()), largest(change, step[j].abs()))
            });
            // The step after it that changes nothing is for the derivatives.
            is_last = change <= S::EPSILON * S::ratio(4, 1) * most;
        }
        let step = self.step(&s);
        Some(core::array::from_fn(|j| s[j] + step[j]))
    }

    /// Newton's step `(1 − D) δ = |F| − s`, D = ∂|F|/∂s, by elimination: its diagonal dominates.
    fn step(&self, s: &[S; MOST]) -> [S; MOST] {
        let count = self.count;
        let (mut matrix, mut right) = ([[S::ZERO; MOST]; MOST], [S::ZERO; MOST]);
        for j in 0..count {
            let sum = |axis: usize| {
                (0..count).fold(self.constant[j][axis], |sum, i| self.gains[j][i][axis].mul_add(s[i], sum))
            };
            let force = [sum(0), sum(1)];
            let size = length(force);
            right[j] = size - s[j];
            for i in 0..count {
                let along = force[0] * self.gains[j][i][0] + force[1] * self.gains[j][i][1];
                let slope = if size > S::ZERO { along / size } else { S::ZERO };
                matrix[j][i] = S::ratio(i64::from(i == j), 1) - slope;
            }
        }
        for k in 0..count {
            for j in k + 1..count {
                let factor = matrix[j][k] / matrix[k][k];
                for i in k..count {
                    matrix[j][i] = matrix[j][i] - factor * matrix[k][i];
                }
                right[j] = right[j] - factor * right[k];
            }
        }
        for k in (0..count).rev() {
            let rest = (k + 1..count).fold(right[k], |rest, i| rest - matrix[k][i] * right[i]);
            right[k] = rest / matrix[k][k];
        }
        right
    }
}

/// |F|; without derivatives where it is zero.
fn length<S: Scalar>([x, y]: [S; 2]) -> S {
    let square = x * x + y * y;
    if square == S::ZERO { S::ZERO } else { square.sqrt() }
}

fn largest<S: Scalar>(a: S, b: S) -> S {
    if b > a { b } else { a }
}
