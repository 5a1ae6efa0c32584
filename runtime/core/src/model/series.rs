//! The Taylor series of a closed form, and of the full equations.

use super::{BarSystem, ClosedForm};
use crate::scalar::Real;
use crate::series::{SeriesOps, TaylorTape};

/// One coefficient of everything that varies along a motion: of the derivative, and of what tells
/// when a contact opens or closes.
#[derive(Clone, Copy, Debug)]
pub struct Terms<Y, C, F> {
    /// Of the reduced state's time derivative.
    pub rates: Y,
    /// Of the reaction of each contact, zero where open.
    pub reactions: C,
    /// Of the gap of each contact, zero where closed.
    pub gaps: C,
    /// Of the distances of each foot from the ends of its bar.
    pub feet: F,
}

/// The terms of a phase of `M` whose reduced state has `N` entries.
pub type TermsOf<M, S, const N: usize> =
    Terms<[S; N], <M as BarSystem>::Reactions<S>, <M as BarSystem>::Feet<S>>;

/// The equations of a closed form on Taylor series; implemented by the derive macro, one type for
/// each closed form.
pub trait PhaseSeries<M: BarSystem, const N: usize>: ClosedForm<M, N> {
    /// A tape with a column for each convolution, for one motion.
    type Tape<S: Real>: TaylorTape<S>;
    /// The same for many motions side by side.
    type Columns<S: Real>: TaylorTape<S>;
    /// Coefficient n of all terms from coefficient n of the state, once those below n have been
    /// computed.
    fn order<S: Real, O: SeriesOps<S>>(
        constants: &M::Constants<S>,
        order: &mut O,
        state: &[S; N],
    ) -> TermsOf<M, S, N>;
}

/// The entries of M and of J that vary along a motion: row, column.
#[derive(Clone, Copy, Debug)]
pub struct Varying<'a> {
    /// Of M.
    pub mass: &'a [[usize; 2]],
    /// Of J.
    pub jacobian: &'a [[usize; 2]],
}

/// The full equations on Taylor series, for the phases that keep all coordinates; implemented by
/// the derive macro, where there are such.
pub trait KernelSeries<M: BarSystem, const Y: usize>: 'static {
    /// What varies of their matrices.
    const VARYING: Varying<'static>;
    /// A tape with a column for each convolution.
    type Tape<S: Real>: TaylorTape<S>;
    /// Coefficient n of the equations and of the distances of the feet from coefficient n of the
    /// full state, once those below n have been computed.
    fn order<S: Real, O: SeriesOps<S>>(
        constants: &M::Constants<S>,
        order: &mut O,
        state: &[S; Y],
    ) -> (M::Kernel<S>, M::Feet<S>);
}
