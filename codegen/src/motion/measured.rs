//! What a one-sided constraint contributes: its gap, its foot, its slip and its forces.

use super::action::{Action, Scene};
use super::dot;
use super::expression::{Expression, OpaqueTerms};
use super::row::{Row, bias};
use crate::algebra::{Series, Symbol};
use crate::system::Support;

/// Where a corner touches its bar.
#[derive(Clone, Debug)]
pub struct Foot {
    /// Distance from the bar's first point.
    pub from_first: Series,
    /// Distance from the bar's last point.
    pub from_last: Series,
}

impl Foot {
    /// Whether both lie under their bars together; a bar may be named from either end.
    pub(super) fn equals(&self, other: &Self) -> bool {
        let straight = self.from_first == other.from_first && self.from_last == other.from_last;
        straight || self.from_first == other.from_last && self.from_last == other.from_first
    }
}

/// What a support contributes.
pub(super) struct Measured {
    pub row: Row,
    pub foot: Option<Foot>,
    /// The tangential row of a support that is rough or has friction.
    pub tangent: Option<Row>,
    /// The forces of a unit reaction, and of a unit tangential one.
    pub actions: [Vec<Action>; 2],
}

pub(super) fn slips(support: &Support) -> bool {
    support.rough || support.friction.is_some()
}

/// What slips along a tangent: `t · ẋ + Σ c ω`, and what its rate is without accelerations beside
/// `t · ẍ`.
pub(super) struct TangentSlip<'a> {
    pub span: &'a [Series; 2],
    pub tangent: &'a [Series; 2],
    pub spins: &'a [(usize, Series)],
    pub bias: Series,
}

impl<'a> TangentSlip<'a> {
    /// Along a tangent that does not turn, or turns with what slips alone: `ṫ · ẋ = 0`.
    pub fn new(span: &'a [Series; 2], tangent: &'a [Series; 2]) -> Self {
        Self { span, tangent, spins: &[], bias: Series::zero() }
    }

    pub fn row(&self, scene: &Scene) -> Row {
        let n = scene.n();
        let entry = |i: usize| {
            let slope = self.span.each_ref().map(|part| part.derivative(Symbol::coordinate(i)));
            let spins = self.spins.iter().map(|(body, factor)| factor * &scene.turn(*body, i));
            &dot(self.tangent, &slope) + &spins.sum()
        };
        let bias = &dot(self.tangent, &self.span.each_ref().map(|part| bias(part, n))) + &self.bias;
        Row::tangential((0..n).map(entry).collect(), bias)
    }
}

/// 1/x of a length given by parameters.
pub(super) fn inverse(opaque_terms: &mut OpaqueTerms, x: &Series) -> Series {
    x.recip_monomial().unwrap_or_else(|| {
        let one = Expression::series(Series::one());
        opaque_terms.symbol("inverse", one.over(Expression::series(x.clone())))
    })
}

/// Whether nothing that moves occurs in a row.
pub(super) fn is_fixed(row: &Row) -> bool {
    let moves = |series: &Series| series.symbols().iter().any(|s| matches!(s, Symbol::Coordinate { .. }));
    !moves(&row.gap) && row.jacobian.iter().all(Series::is_zero)
}
