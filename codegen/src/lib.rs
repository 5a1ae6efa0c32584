//! Symbolic derivation of planar bar systems, from a declaration to specialised Rust.
//!
//! ```text
//! tokens → Description → System → Kinematics → Motion → Phases → Functions → tokens
//!          syntax        system   kinematics   motion   phases   program     emit
//! ```
//!
//! - [`algebra`]: exact Poisson series and their quotients; knows no mechanics.
//! - `syntax`: attributes with their spans; `system`: names resolved, mistakes reported, all at once.
//! - [`kinematics`]: generalised coordinates, directions and positions.
//! - [`motion`]: M, h, Q, and the rows of contacts and joints.
//! - [`phases`]: the contact sets that have a closed form, and their reduced equations.
//! - [`program`]: the same as arithmetic, with an interpreter and operation counts; [`functions`]: what of it
//!   a model needs.
//! - `emit`: that arithmetic as Rust; `text`: the equations in textbook notation.

pub mod algebra;
mod emit;
pub mod functions;
pub mod kinematics;
pub mod motion;
pub mod phases;
pub mod program;
mod syntax;
pub mod system;
mod text;

use proc_macro2::TokenStream;

use algebra::Symbol;
use functions::Functions;
use kinematics::Kinematics;
use motion::Motion;
use phases::Phase;
use syntax::Description;
use system::System;
pub use text::Equations;

/// Everything that is derived of a model.
#[derive(Debug)]
pub struct Analysis {
    /// The declared system, resolved.
    pub system: System,
    /// Coordinates and positions.
    pub kinematics: Kinematics,
    /// Equations of motion.
    pub motion: Motion,
    /// Contact sets in closed form.
    pub phases: Vec<Phase>,
    /// The arithmetic of all of it.
    pub functions: Functions,
}

impl Analysis {
    /// Values of some outputs of [`Analysis::functions`] by the interpreter; `state` holds the coordinates, the rates, the
    /// accelerations, the multipliers of all rows and the time, as far as they are used; what is missing is not a number.
    pub fn evaluate(&self, outputs: &[program::Id], parameters: &[f64], state: &[f64]) -> Vec<f64> {
        let n = self.motion.n;
        let at = |i: usize| state.get(i).copied().unwrap_or(f64::NAN);
        self.functions.program.evaluate(outputs, &|symbol| match symbol {
            Symbol::Parameter(i) => parameters[usize::from(i)],
            Symbol::Coordinate { index, order } => at(usize::from(index) + n * usize::from(order)),
            Symbol::Reaction(row) => at(3 * n + usize::from(row)),
            Symbol::Time => at(3 * n + self.motion.rows.len()),
            Symbol::Atom { .. } => f64::NAN,
        })
    }
}

/// Derives the equations of a declaration.
///
/// # Errors
/// Every mistake of the declaration, each at its span.
pub fn analyse(input: TokenStream) -> syn::Result<Analysis> {
    derive(&syntax::parse(input)?)
}

fn derive(description: &Description) -> syn::Result<Analysis> {
    let system = System::resolve(description)?;
    let kinematics = Kinematics::of(&system)?;
    let motion = Motion::of(&system, &kinematics)?;
    let phases = phases::closed_forms(&system, &kinematics, &motion);
    let functions = Functions::of(&system, &kinematics, &motion, &phases);
    Ok(Analysis { system, kinematics, motion, phases, functions })
}

/// The implementation of `BarSystem` for a declaration, or its mistakes as compile errors.
pub fn expand(input: TokenStream) -> TokenStream {
    let description = match syntax::parse(input) {
        Ok(description) => description,
        Err(errors) => return errors.into_compile_error(),
    };
    match derive(&description) {
        Ok(analysis) => emit::implementation(&analysis),
        Err(errors) => {
            let mut tokens = errors.into_compile_error();
            tokens.extend(emit::fallback(&description.ident, &description.runtime));
            tokens
        }
    }
}

/// The equations of a declaration in textbook notation, for people and for snapshots.
///
/// # Errors
/// As [`analyse`].
pub fn equations(input: TokenStream) -> syn::Result<Equations> {
    Ok(text::equations(&analyse(input)?))
}
