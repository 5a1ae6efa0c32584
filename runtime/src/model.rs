//! What the derive macro implements: a model's names, its constants, its full equations and its phases.

use crate::kernel;
use crate::scalar::{Real, Scalar};

/// A fixed-length vector of scalars; implemented for arrays only.
pub trait Array<S>: Copy + AsRef<[S]> + AsMut<[S]> {
    /// The vector whose `i`-th entry is `entry(i)`.
    fn from_fn(entry: impl FnMut(usize) -> S) -> Self;
}

impl<S: Copy, const N: usize> Array<S> for [S; N] {
    fn from_fn(entry: impl FnMut(usize) -> S) -> Self {
        core::array::from_fn(entry)
    }
}

/// A set of closed contacts, one bit per entry of [`Layout::contacts`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ContactSet(pub u64);

impl ContactSet {
    /// No contact closed: free motion.
    pub const EMPTY: Self = Self(0);

    /// Whether contact `i` is closed.
    pub const fn contains(self, i: usize) -> bool {
        self.0 >> i & 1 == 1
    }

    /// The set with contact `i` closed.
    #[must_use]
    pub const fn with(self, i: usize) -> Self {
        Self(self.0 | 1 << i)
    }

    /// The set with contact `i` open.
    #[must_use]
    pub const fn without(self, i: usize) -> Self {
        Self(self.0 & !(1 << i))
    }

    /// The closed contacts in ascending order.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..64).filter(move |&i| self.contains(i))
    }

    /// How many contacts are closed.
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// Whether no contact is closed.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }
}

/// How a phase is integrated.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Form {
    /// The closed contacts are eliminated in closed form; the state is reduced and cannot drift.
    Closed,
    /// All coordinates are kept; multipliers hold the contacts and each accepted step is projected.
    Projected,
}

/// A generalised coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    /// Its name; the rate is named with a prime in text (`phi'`).
    pub name: &'static str,
    /// Whether it is an angle (rad) or a length.
    pub is_angle: bool,
}

/// Supports whose gaps are one function of the coordinates: one contact, one reaction.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Its members joined by commas, `A, E`.
    pub label: &'static str,
    /// The supports in declaration order.
    pub supports: &'static [&'static str],
    /// Whether the members bear equal shares (mirror images, or a single support).
    /// Otherwise only their total is determined.
    pub shared: bool,
    /// Index of the contact's foot among [`BarSystem::feet`] when a bar lies on a corner.
    pub foot: Option<usize>,
}

/// A bar, for drawings.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    /// Its name.
    pub name: &'static str,
    /// Index of its first point.
    pub from: usize,
    /// Index of its last point.
    pub to: usize,
}

/// A model's names.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// The struct's name.
    pub name: &'static str,
    /// The declaration that the equations were derived from, as source text.
    pub declaration: &'static str,
    /// Parameters in the order of [`BarSystem::parameters`].
    pub parameters: &'static [&'static str],
    /// Generalised coordinates; a state holds their values, then their rates.
    pub coordinates: &'static [Coordinate],
    /// One-sided contacts; the first rows of the kernel.
    pub contacts: &'static [Contact],
    /// Two-sided constraints kept as multipliers; the rows after the contacts, closed in every phase.
    pub joints: &'static [&'static str],
    /// Points in the order of [`BarSystem::points`].
    pub points: &'static [&'static str],
    /// Bars.
    pub bars: &'static [Bar],
    /// The contact sets that have a closed form.
    pub closed_forms: &'static [ContactSet],
}

/// A physical quantity of a model, to be checked and to derive its natural scales from.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// What it belongs to: `bar AD`, `mass at P`, `gravity`.
    pub of: &'static str,
    /// Its kind, which says what values are admissible.
    pub kind: MeasureKind,
    /// Its value.
    pub value: f64,
}

/// Kinds of [`Measure`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MeasureKind {
    /// A mass, ≥ 0.
    Mass,
    /// A length, > 0.
    Length,
    /// A moment of inertia about the centre of mass, ≥ 0.
    Inertia,
    /// The magnitude of gravity, finite.
    Gravity,
}

/// A fixed thing of the scene, for drawings.
#[derive(Clone, Copy, Debug)]
pub struct Scenery {
    /// The support or point it belongs to.
    pub name: &'static str,
    /// Its shape.
    pub shape: Shape,
    /// A point of it.
    pub at: [f64; 2],
}

/// Shapes of [`Scenery`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shape {
    /// A line at `angle` to the horizontal; the free side is the one its normal, `angle + π/2`, points to.
    Line {
        /// Direction of the line, rad.
        angle: f64,
    },
    /// A corner under a bar.
    Corner,
    /// A pin.
    Pin,
}

/// Kinetic and potential energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy<S> {
    /// T.
    pub kinetic: S,
    /// V.
    pub potential: S,
}

/// The full equations at a state: `M a = f + Jᵀ λ`, and `g`, `J a + b = g̈` for each row.
///
/// `N` coordinates, `C` rows (contacts, then joints), `D = N + C`.
#[derive(Clone, Copy, Debug)]
pub struct Kernel<S, const N: usize, const C: usize, const D: usize> {
    /// M, symmetric.
    pub mass: [[S; N]; N],
    /// f = Q − h: generalised forces less velocity terms.
    pub force: [S; N],
    /// g.
    pub gap: [S; C],
    /// J = ∂g/∂q.
    pub jacobian: [[S; N]; C],
    /// b = J̇ u.
    pub bias: [S; C],
}

/// Reads a [`Kernel`] without naming its dimensions.
pub trait KernelView<S> {
    /// Row `i` of M.
    fn mass(&self, i: usize) -> &[S];
    /// f.
    fn force(&self) -> &[S];
    /// g.
    fn gap(&self) -> &[S];
    /// Row `i` of J.
    fn jacobian(&self, i: usize) -> &[S];
    /// b.
    fn bias(&self) -> &[S];
    /// a of `M a = f + Jᵀ λ`, `J a = −b` over the rows of `set` and the joints, the rows from `contacts` on.
    fn accelerations(&self, contacts: usize, set: ContactSet, accelerations: &mut [S])
    where
        S: Scalar;
    /// The least change d in the mass metric with `J d = −r` over the same rows: `M d = Jᵀ μ`.
    fn correction(&self, contacts: usize, set: ContactSet, residual: impl Fn(usize) -> S, change: &mut [S])
    where
        S: Scalar;
}

impl<S: Copy, const N: usize, const C: usize, const D: usize> KernelView<S> for Kernel<S, N, C, D> {
    fn mass(&self, i: usize) -> &[S] {
        &self.mass[i]
    }
    fn force(&self) -> &[S] {
        &self.force
    }
    fn gap(&self) -> &[S] {
        &self.gap
    }
    fn jacobian(&self, i: usize) -> &[S] {
        &self.jacobian[i]
    }
    fn bias(&self) -> &[S] {
        &self.bias
    }
    fn accelerations(&self, contacts: usize, set: ContactSet, accelerations: &mut [S])
    where
        S: Scalar,
    {
        accelerations.copy_from_slice(&kernel::accelerations(self, contacts, set));
    }
    fn correction(&self, contacts: usize, set: ContactSet, residual: impl Fn(usize) -> S, change: &mut [S])
    where
        S: Scalar,
    {
        let system = Self { force: [S::ZERO; N], bias: core::array::from_fn(residual), ..*self };
        change.copy_from_slice(&kernel::accelerations(&system, contacts, set));
    }
}

/// A function of a reduced state in a contact set.
pub type InSet<M, S, State, Result> = fn(&<M as BarSystem>::Constants<S>, ContactSet, &State) -> Result;

/// A function of a reduced state.
pub type OfState<M, S, State, Result> = fn(&<M as BarSystem>::Constants<S>, &State) -> Result;

/// The equations of one contact set: a first-order system in the reduced state `[S; N]`,
/// coordinates then rates.
pub struct Phase<M: BarSystem, S: Real, const N: usize> {
    /// The closed contacts.
    pub set: ContactSet,
    /// Closed form or projected.
    pub form: Form,
    /// Time derivative of the reduced state.
    pub derivative: InSet<M, S, [S; N], [S; N]>,
    /// Reaction of every contact, zero where open.
    pub reactions: InSet<M, S, [S; N], M::Reactions<S>>,
    /// The full state of a reduced one.
    pub embed: OfState<M, S, [S; N], M::State<S>>,
    /// The reduced state of a full one that satisfies the closed contacts.
    pub restrict: fn(&M::State<S>) -> [S; N],
    /// The least pivot of the elimination, relative to its natural size; 1 when there is none.
    pub pivot: OfState<M, S, [S; N], S>,
    /// T and V with the eliminated coordinates substituted, so that no digits cancel.
    pub energy: OfState<M, S, [S; N], Energy<S>>,
}

/// Receives the phase that [`BarSystem::phase`] selects, with its dimension as a constant.
pub trait PhaseVisitor<M: BarSystem, S: Scalar> {
    /// What the visit returns.
    type Output;
    /// Called once with the selected phase.
    fn visit<const N: usize>(self, phase: Phase<M, S, N>) -> Self::Output;
}

/// A planar bar system; implemented by `#[derive(BarSystem)]`.
pub trait BarSystem: Sized + 'static {
    /// Names of everything.
    const LAYOUT: &'static Layout;
    /// Parameters and their products, computed once.
    type Constants<S: Real>: Clone;
    /// Coordinates, then rates.
    type State<S: Real>: Array<S>;
    /// One entry per contact.
    type Reactions<S: Real>: Array<S>;
    /// The full equations; a [`Kernel`].
    type Kernel<S: Real>: KernelView<S>;
    /// Positions of the points, x then y of each.
    type Points<S: Real>: Array<S>;
    /// For each foot its distance from the bar's first and last point, both ≥ 0 while it lies under the bar.
    type Feet<S: Real>: Array<S>;

    /// Values of the parameters in the order of the layout.
    fn parameters(&self) -> Vec<f64>;
    /// The model with these values of the parameters.
    fn from_parameters(values: &[f64]) -> Self;
    /// Masses, lengths, inertias and gravity.
    fn measures(&self) -> Vec<Measure>;
    /// Lines, corners and pins.
    fn scenery(&self) -> Vec<Scenery>;
    /// The coordinates of the nominal figure.
    fn nominal(&self) -> Vec<f64>;
    /// Parameters and their products as `S`.
    fn constants<S: Real>(&self) -> Self::Constants<S>;
    /// The full equations at a state.
    fn kernel<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Self::Kernel<S>;
    /// Energies at a full state.
    fn energy<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Energy<S>;
    /// Positions of the points.
    fn points<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Self::Points<S>;
    /// Positions of the feet along their bars.
    fn feet<S: Real>(constants: &Self::Constants<S>, state: &Self::State<S>) -> Self::Feet<S>;
    /// Hands the phase of `set` to `visitor`: closed form where there is one and `form` asks for it,
    /// otherwise projected.
    fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(set: ContactSet, form: Form, visitor: V) -> V::Output;
}

/// The least magnitude among pivots relative to their natural sizes; 1 without pivots.
pub fn least<S: Scalar, const P: usize>(pivots: [S; P]) -> S {
    pivots.into_iter().map(S::abs).fold(S::ratio(1, 1), |least, p| if p < least { p } else { least })
}
