//! Rows of constraints: `g`, `ġ = J u + ∂g/∂t` and `g̈ = J a + b`.

use crate::algebra::{Series, Symbol};

/// One row of constraints: a gap and its derivatives.
#[derive(Clone, Debug)]
pub struct Row {
    /// g; zero for a tangential row, which has velocities only.
    pub gap: Series,
    /// J = ∂g/∂q.
    pub jacobian: Vec<Series>,
    /// b, what g̈ is without accelerations.
    pub bias: Series,
    /// ∂g/∂t, of prescribed motions.
    pub prescribed_gap_rate: Series,
}

impl Row {
    /// The row of a gap that is a series of the coordinates and of opaque terms that depend on time
    /// alone.
    pub(super) fn from_gap(gap: &Series, n: usize) -> Self {
        let jacobian = (0..n).map(|i| gap.derivative(Symbol::coordinate(i))).collect();
        Self {
            gap: gap.clone(),
            jacobian,
            bias: bias(gap, n),
            prescribed_gap_rate: derive_prescribed_rate(gap),
        }
    }

    /// The same of its gap times a constant.
    pub(super) fn scaled(&self, factor: &Series) -> Self {
        Self {
            gap: &self.gap * factor,
            jacobian: self.jacobian.iter().map(|slope| slope * factor).collect(),
            bias: &self.bias * factor,
            prescribed_gap_rate: &self.prescribed_gap_rate * factor,
        }
    }

    /// A row of velocities alone.
    pub(super) fn tangential(jacobian: Vec<Series>, bias: Series) -> Self {
        Self { gap: Series::zero(), jacobian, bias, prescribed_gap_rate: Series::zero() }
    }

    /// J u + ∂g/∂t.
    pub(crate) fn velocity(&self) -> Series {
        let along =
            self.jacobian.iter().enumerate().map(|(i, slope)| slope * &Series::symbol(Symbol::rate(i)));
        along.sum::<Series>() + self.prescribed_gap_rate.clone()
    }

    /// The same relative to a surface with this velocity along the tangent.
    pub(super) fn move_with(&mut self, velocity: &Series) {
        self.prescribed_gap_rate -= velocity;
        self.bias -= &velocity.rate();
    }

    pub(super) fn is_overflow(&self) -> bool {
        self.jacobian.iter().chain([&self.gap, &self.bias]).any(Series::is_overflow)
    }
}

/// The second time derivative at zero accelerations: `Σ uᵢ ∂ẋ/∂qᵢ + ∂ẋ/∂t`.
pub(crate) fn bias(x: &Series, n: usize) -> Series {
    let rate = x.rate();
    let mut sum = derive_prescribed_rate(&rate);
    for i in 0..n {
        let slope = rate.derivative(Symbol::coordinate(i));
        if !slope.is_zero() {
            sum += &slope * &Series::symbol(Symbol::rate(i));
        }
    }
    sum
}

/// ∂x/∂t through the opaque terms.
fn derive_prescribed_rate(x: &Series) -> Series {
    let opaque_terms = x.symbols().into_iter().filter(|symbol| matches!(symbol, Symbol::Opaque { .. }));
    opaque_terms
        .filter_map(|opaque_term| {
            Some(&x.derivative(opaque_term) * &Series::symbol(opaque_term.derivative()?))
        })
        .sum()
}
