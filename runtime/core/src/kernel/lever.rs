//! Where reactions are not unique the shortest are taken, `Σ λ² + Σ (c/ℓ)² → min` of forces λ and
//! couples c. The length ℓ is that at which the rows of forces act,
//!
//! ```text
//! ℓ² = Σ J_λ² / Σ J_c²
//! ```
//!
//! over the coordinates that are angles, or where the couples act on none of these over those that
//! are lengths: both J are of one unit there but for a length, so that the shares are the same in
//! every unit. Arms of forces that all but vanish are rounding: ℓ is no less than √ε of the radius
//! of gyration, ℓ² ≥ ε Σ M_φφ / Σ M_xx.

use crate::model::Layout;
use crate::scalar::Scalar;

/// ℓ of closed rows, given entries of J by row and coordinate, and those of the diagonal of M; one
/// where there are no couples, or none that acts beside a force.
pub fn lever<S: Scalar>(
    layout: &Layout,
    closed: &[usize],
    entry: impl Fn(usize, usize) -> S,
    mass: impl Fn(usize) -> S,
) -> S {
    let one = S::ratio(1, 1);
    if !closed.iter().any(|&row| layout.is_turned(row)) {
        return one;
    }
    let square = |turned: bool, is_angle: bool| {
        let rows = closed.iter().filter(|&&row| layout.is_turned(row) == turned);
        rows.fold(S::ZERO, |sum, &row| {
            let coordinates = layout.coordinates.iter().enumerate().filter(|(_, c)| c.is_angle == is_angle);
            coordinates.fold(sum, |sum, (j, _)| entry(row, j).mul_add(entry(row, j), sum))
        })
    };
    let squares = [true, false].map(|is_angle| [false, true].map(|turned| square(turned, is_angle)));
    match squares.into_iter().find(|[force, couple]| *force > S::ZERO && *couple > S::ZERO) {
        Some([force, couple]) => {
            let sum = |is_angle: bool| {
                let coordinates =
                    layout.coordinates.iter().enumerate().filter(|(_, c)| c.is_angle == is_angle);
                coordinates.fold(S::ZERO, |sum, (j, _)| sum + mass(j))
            };
            let [angles, lengths] = [sum(true), sum(false)];
            let square = force / couple;
            let least = if lengths > S::ZERO { S::EPSILON * angles / lengths } else { S::ZERO };
            if square < least { least.sqrt() } else { square.sqrt() }
        }
        None => one,
    }
}
