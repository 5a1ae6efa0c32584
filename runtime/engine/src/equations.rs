//! The equations of a model as text.

use crate::BarSystem;

/// The equations that were derived of a model, as a book prints them: energies, mass matrix, forces
/// and gaps, and for each contact set in closed form its equation of motion and its reactions. The
/// text changes only when the physics does.
///
/// Needs the feature `equations`. In a test, with the crate `insta`, a change of the mechanics
/// shows as a readable difference:
///
/// ```
/// # use liftoff::prelude::*;
/// # #[derive(BarSystem)]
/// # #[gravity(g)]
/// # #[bar(OA, mass = m, length = l)]
/// # #[pin(O = (0, 0))]
/// # #[figure(A = (0, -l))]
/// # #[coordinate(phi = angle(OA), from = down)]
/// # struct Swing { m: f64, l: f64, g: f64 }
/// let text = liftoff::equations::<Swing>(); // insta::assert_snapshot!(text);
/// assert!(text.contains("⅓ m l² φ̈ = −½ m g l sin φ"));
/// ```
pub fn equations<M: BarSystem>() -> String {
    liftoff_codegen::equations_from_text(M::LAYOUT.declaration).to_string()
}
