//! Where a body lies. With complex numbers, w = w₀ + u (z − z₀), z along and across the body, u its
//! direction.

use super::{Place, Scope};
use crate::algebra::Series;

/// Where a body lies.
pub(super) struct Frame {
    /// The place of one of its points.
    pub w: Place,
    /// That point on the body.
    pub z: Place,
    /// The direction of the body.
    pub turn: Place,
}

impl Frame {
    /// The frame of a body of which two points are known; `None` if they are one on the body.
    pub fn through(scope: &mut Scope, known: &[(Place, Place)]) -> Option<Self> {
        let (w0, z0) = known.first()?;
        let (w1, z1) = known.iter().find(|(_, z)| z != z0)?;
        let turn = quotient(scope, &minus(w1, w0), &minus(z1, z0))?;
        Some(Self { w: w0.clone(), z: z0.clone(), turn })
    }

    /// The direction of a body in which its point `to` lies from `from` along a unit vector; `None`
    /// if they are one.
    pub fn pointing(scope: &mut Scope, from: &Place, to: &Place, along: Place) -> Option<Place> {
        let z = minus(to, from);
        let norm = scope.norm(&z);
        let [x, y] = along.map(|c| scope.constants.multiply(&norm, &c));
        quotient(scope, &[x, y], &z)
    }

    /// The place of a point of the body.
    pub fn transform(&self, scope: &Scope, z: &Place) -> Place {
        let [a, b] = minus(z, &self.z);
        let [c, s] = &self.turn;
        let times = |x: &Series, y: &Series| scope.constants.multiply(x, y);
        let [x, y] = &self.w;
        [&(x + &times(&a, c)) - &times(&b, s), &(y + &times(&a, s)) + &times(&b, c)]
    }
}

fn minus(a: &Place, b: &Place) -> Place {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

/// Complex a / b = a b* / |b|².
fn quotient(scope: &mut Scope, a: &Place, b: &Place) -> Option<Place> {
    let constants = &mut scope.constants;
    if b[1].is_zero() {
        return Some([constants.divide(&a[0], &b[0])?, constants.divide(&a[1], &b[0])?]);
    }
    let times = |x: &Series, y: &Series| constants.multiply(x, y);
    let real = &times(&a[0], &b[0]) + &times(&a[1], &b[1]);
    let imaginary = &times(&a[1], &b[0]) - &times(&a[0], &b[1]);
    let square = &times(&b[0], &b[0]) + &times(&b[1], &b[1]);
    Some([constants.divide(&real, &square)?, constants.divide(&imaginary, &square)?])
}
