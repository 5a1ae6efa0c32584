//! The full equations along a motion, as Taylor series in time:
//! `M(t) a(t) = f(t) + Jᵀ(t) λ(t)` and `g̈(t) = J(t) a(t) + b(t)`.

use nalgebra::{DMatrix, DVector};

use crate::model::Layout;
use crate::scalar::Jet;
use crate::system::{self, Model, TIME_ORDERS};

/// Taylor coefficients of M, f, J and b, by order.
pub(crate) struct SeriesEquations {
    pub(crate) mass: Vec<DMatrix<f64>>,
    pub(crate) force: Vec<DVector<f64>>,
    pub(crate) jacobian: Vec<DMatrix<f64>>,
    pub(crate) bias: Vec<DVector<f64>>,
}

impl SeriesEquations {
    /// Along the motion that starts at `state` with the Taylor coefficients `accelerations`; right
    /// up to the order of their number. Without contacts, whose decisions alone ask for more, of
    /// order 0.
    pub(crate) fn along(model: &Model, state: &[f64], accelerations: &[DVector<f64>]) -> Self {
        let (layout, series) = (model.layout(), &model.series);
        let found = if accelerations.len() < TIME_ORDERS {
            Self::expanded(model, series.equations(&motion(layout, state, accelerations)))
        } else {
            Self::expanded(model, series.long_equations(&motion(layout, state, accelerations)))
        };
        found.unwrap_or_else(|| Self::from_equations(model, &model.system.equations(state), (1, |x, _| *x)))
    }

    fn expanded<const ORDERS: usize>(
        model: &Model,
        equations: Option<system::Equations<Jet<f64, ORDERS>>>,
    ) -> Option<Self> {
        equations.map(|equations| Self::from_equations(model, &equations, (ORDERS, |x, k| x.coefficient(k))))
    }

    fn from_equations<S: Copy>(
        model: &Model,
        equations: &system::Equations<S>,
        (orders, coefficient): (usize, impl Fn(&S, usize) -> f64),
    ) -> Self {
        let (n, rows) = (model.layout().coordinates.len(), model.layout().rows());
        let of = &coefficient;
        let all = 0..orders;
        Self {
            mass: all.clone().map(|k| DMatrix::from_fn(n, n, |i, j| of(&equations.mass(i)[j], k))).collect(),
            force: all.clone().map(|k| DVector::from_fn(n, |i, _| of(&equations.force()[i], k))).collect(),
            jacobian: all
                .clone()
                .map(|k| DMatrix::from_fn(rows, n, |i, j| of(&equations.jacobian(i)[j], k)))
                .collect(),
            bias: all.map(|k| DVector::from_fn(rows, |i, _| of(&equations.bias()[i], k))).collect(),
        }
    }

    /// With zeros for the rows that take no part: a thread whose points meet has a row that grows
    /// without bounds, and its rounding would be taken for that of the others.
    pub(super) fn acting(mut self, acts: impl Fn(usize) -> bool) -> Self {
        for row in (0..self.bias[0].len()).filter(|&row| !acts(row)) {
            self.jacobian.iter_mut().for_each(|jacobian| jacobian.row_mut(row).fill(0.0));
            self.bias.iter_mut().for_each(|bias| bias[row] = 0.0);
        }
        self
    }

    /// Whether order 0 has neither infinities nor what is no number.
    pub(crate) fn are_finite(&self) -> bool {
        let matrices = self.mass[0].iter().chain(&self.jacobian[0]);
        matrices.chain(&self.force[0]).chain(&self.bias[0]).all(|x| x.is_finite())
    }
}

/// q(t) = q + u t + Σ aₖ tᵏ⁺² / (k+1)(k+2), u(t) = u + Σ aₖ tᵏ⁺¹ / (k+1), and the time goes on.
fn motion<const ORDERS: usize>(
    layout: &Layout,
    state: &[f64],
    accelerations: &[DVector<f64>],
) -> Vec<Jet<f64, ORDERS>> {
    let n = layout.coordinates.len();
    let mut series = vec![[0.0; ORDERS]; state.len()];
    for (entry, series) in series.iter_mut().enumerate().skip(2 * n) {
        (series[0], series[1]) = (state[entry], layout.slope(entry) as f64);
    }
    for i in 0..n {
        (series[i][0], series[i][1], series[n + i][0]) = (state[i], state[n + i], state[n + i]);
        for (k, a) in accelerations.iter().enumerate() {
            let order = k + 1;
            if order < ORDERS {
                series[n + i][order] = a[i] / order as f64;
            }
            if order + 1 < ORDERS {
                series[i][order + 1] = a[i] / (order * (order + 1)) as f64;
            }
        }
    }
    series.into_iter().map(Jet::new).collect()
}

#[cfg(test)]
mod tests;
