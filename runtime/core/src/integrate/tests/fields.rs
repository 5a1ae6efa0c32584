//! Right-hand sides for any scalar, so that their Jacobians follow.

use crate::scalar::{DoubleDouble, Dual, Real, Scalar};

/// f of y′ = f(y).
pub(in crate::integrate) trait Field<const N: usize> {
    fn rates<S: Scalar>(&self, y: &[S; N]) -> [S; N];

    fn jacobian(&self, y: &[f64; N]) -> [[f64; N]; N] {
        let seed = |i: usize| Dual::<f64, N>::variable(y[i], i);
        self.rates(&core::array::from_fn(seed)).map(|f| *f.gradient())
    }
}

/// Kepler's problem with semi-major axis 1: x, y, x′, y′; period 2π.
pub(in crate::integrate) struct Kepler;

impl Field<4> for Kepler {
    fn rates<S: Scalar>(&self, s: &[S; 4]) -> [S; 4] {
        let square = s[0] * s[0] + s[1] * s[1];
        let cube = square * square.sqrt();
        [s[2], s[3], -(s[0] / cube), -(s[1] / cube)]
    }
}

/// [`Kepler`] as a function.
pub(in crate::integrate) fn kepler<S: Scalar>(s: &[S; 4]) -> [S; 4] {
    Kepler.rates(s)
}

const ECCENTRICITY: f64 = 0.5;

/// The orbit by Kepler's equation E − e sin E = t, solved in double-double.
pub(in crate::integrate) fn orbit(t: f64) -> [f64; 4] {
    let e = DoubleDouble::new(ECCENTRICITY, 0.0);
    let one = DoubleDouble::new(1.0, 0.0);
    let t = DoubleDouble::new(t, 0.0);
    let anomaly = (0..20).fold(t, |x, _| {
        let (sin, cos) = x.sin_cos();
        x - (x - e * sin - t) / (one - e * cos)
    });
    let (sin, cos) = anomaly.sin_cos();
    let (minor, rate) = ((one - e * e).sqrt(), one / (one - e * cos));
    [cos - e, minor * sin, -(sin * rate), minor * cos * rate].map(Scalar::to_f64)
}

/// A pendulum with its time in units of its own: θ′ = ω/unit, ω′ = −sin θ/unit.
pub(super) struct Pendulum {
    pub(super) unit: f64,
}

impl Field<2> for Pendulum {
    fn rates<S: Scalar>(&self, s: &[S; 2]) -> [S; 2] {
        let unit = S::from_f64(self.unit);
        [s[1] / unit, -s[0].sin_cos().0 / unit]
    }
}

/// y′ = y², whose solution 1/(1 − t) from 1 has a pole.
pub(super) struct Pole;

impl Field<1> for Pole {
    fn rates<S: Scalar>(&self, y: &[S; 1]) -> [S; 1] {
        [y[0] * y[0]]
    }
}

/// y′ = −√(y − ½) − 0.1, which reaches the edge of its domain in finite time.
pub(super) struct Edge;

impl Field<1> for Edge {
    fn rates<S: Scalar>(&self, y: &[S; 1]) -> [S; 1] {
        [-(y[0] - S::ratio(1, 2)).sqrt() - S::ratio(1, 10)]
    }
}

/// y′ = −y.
pub(super) struct Decay;

impl Field<1> for Decay {
    fn rates<S: Scalar>(&self, y: &[S; 1]) -> [S; 1] {
        [-y[0]]
    }
}

/// The largest difference.
pub(in crate::integrate) fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
