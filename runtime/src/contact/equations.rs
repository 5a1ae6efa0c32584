//! The full equations along a motion, as Taylor series in time:
//! `M(t) a(t) = f(t) + Jᵀ(t) λ(t)` and `g̈(t) = J(t) a(t) + b(t)`.

use nalgebra::{DMatrix, DVector};

use crate::model::{Array, BarSystem, KernelView};
use crate::scalar::Jet;

/// Coefficients kept: orders 0 to 3, so that reactions are known to their third derivative.
pub(crate) const ORDERS: usize = 4;

/// Taylor series in time.
pub(crate) type Series = Jet<f64, ORDERS>;

/// Taylor coefficients of M, f, J and b, by order.
pub(crate) struct Equations {
    pub(crate) mass: [DMatrix<f64>; ORDERS],
    pub(crate) force: [DVector<f64>; ORDERS],
    pub(crate) jacobian: [DMatrix<f64>; ORDERS],
    pub(crate) bias: [DVector<f64>; ORDERS],
}

impl Equations {
    /// Along the motion that starts at `state` with the Taylor coefficients `accelerations`;
    /// right up to the order of their number.
    pub(crate) fn along<M: BarSystem>(
        constants: &M::Constants<Series>,
        state: &M::State<f64>,
        accelerations: &[DVector<f64>],
    ) -> Self {
        let kernel = M::kernel(constants, &motion::<M>(state, accelerations));
        let n = M::LAYOUT.coordinates.len();
        let rows = M::LAYOUT.rows();
        Self {
            mass: order(|k| DMatrix::from_fn(n, n, |i, j| kernel.mass(i)[j].coefficient(k))),
            force: order(|k| DVector::from_fn(n, |i, _| kernel.force()[i].coefficient(k))),
            jacobian: order(|k| DMatrix::from_fn(rows, n, |i, j| kernel.jacobian(i)[j].coefficient(k))),
            bias: order(|k| DVector::from_fn(rows, |i, _| kernel.bias()[i].coefficient(k))),
        }
    }

    /// Whether order 0 has neither infinities nor what is no number.
    pub(crate) fn are_finite(&self) -> bool {
        let matrices = self.mass[0].iter().chain(&self.jacobian[0]);
        matrices.chain(&self.force[0]).chain(&self.bias[0]).all(|x| x.is_finite())
    }
}

fn order<T>(coefficient: impl FnMut(usize) -> T) -> [T; ORDERS] {
    core::array::from_fn(coefficient)
}

/// q(t) = q + u t + Σ aₖ tᵏ⁺² / (k+1)(k+2), u(t) = u + Σ aₖ tᵏ⁺¹ / (k+1), and the time goes on.
fn motion<M: BarSystem>(state: &M::State<f64>, accelerations: &[DVector<f64>]) -> M::State<Series> {
    let state = state.as_ref();
    let n = M::LAYOUT.coordinates.len();
    let mut series = vec![[0.0; ORDERS]; state.len()];
    for (time, now) in series[2 * n..].iter_mut().zip(&state[2 * n..]) {
        (time[0], time[1]) = (*now, 1.0);
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
    M::State::<Series>::from_fn(|i| Series::new(series[i]))
}
