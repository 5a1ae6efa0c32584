//! Symbolic derivation of planar bar systems, from a declaration to specialised Rust.
//!
//! ```text
//! tokens → Description → System → Kinematics → Motion → Phases → Functions → tokens
//!          syntax        system   kinematics   motion   phases   program     emit
//!                                 System, Kinematics → Geometry → tokens
//! ```
//!
//! - [`algebra`]: exact Poisson series and their quotients; knows no mechanics.
//! - `syntax`: attributes with their spans; `system`: names resolved, mistakes reported, all at
//!   once.
//! - `dimensions`: those of the parameters, and contradictions between them.
//! - [`kinematics`]: generalised coordinates, directions and positions.
//! - [`motion`]: M, h, Q, and the rows of contacts and joints.
//! - [`phases`]: the contact sets that have a closed form, and their reduced equations.
//! - [`program`]: the same as arithmetic, with an interpreter and operation counts; [`functions`]:
//!   what of it a model needs.
//! - [`geometry`]: how the model is drawn; [`numbers`]: what parameters alone determine.
//! - [`limits`]: how long and how deep a declaration may be.
//! - `budget`: operations against what the declaration allows.
//! - `emit`: that arithmetic as Rust.
//! - [`math`]: formulas as they are written, as text, LaTeX and MathML; [`text`]: the equations in
//!   them; `document`: those in a struct's documentation.
//! - [`export`]: the equations as sources of other programs.
//! - [`units`]: values with units, in those of the SI.
//! - `unfold`: the model that has both halves of a mirrored one.

pub mod algebra;
mod budget;
mod dimensions;
mod document;
pub mod elementary;
mod emit;
pub mod export;
pub mod functions;
pub mod geometry;
pub mod kinematics;
pub mod limits;
pub mod math;
pub mod motion;
mod nearest;
pub mod numbers;
pub mod phases;
pub mod program;
pub mod spline;
mod syntax;
pub mod system;
pub mod text;
mod unfold;
pub mod units;

use proc_macro2::TokenStream;

use algebra::{Symbol, work};
use functions::{Functions, Mass, Paths};
use kinematics::Kinematics;
use motion::{Dense, Motion, Scene};
use phases::Phase;
use syntax::Description;
use system::System;
use text::Equations;

pub use dimensions::{Dimension, Dimensions, in_bytes};
pub use document::{document, documented, html as equations_as_html};
pub use syntax::{check_attributes, plain};
pub use unfold::Unfolded;

/// Everything that is derived of a model.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// The declared system, resolved.
    pub system: System,
    /// Dimensions of the parameters.
    pub dimensions: Dimensions,
    /// Coordinates and positions.
    pub kinematics: Kinematics,
    /// Equations of motion.
    pub motion: Motion,
    /// Its matrices, entry by entry; not of long trees.
    pub dense: Option<Dense>,
    /// Contact sets in closed form; not of long trees.
    pub phases: Vec<Phase>,
    /// The arithmetic of all of it.
    pub functions: Functions,
}

impl Analysis {
    /// Values of some outputs of [`Analysis::functions`] by the interpreter; `state` holds the
    /// coordinates, the rates, the accelerations, the multipliers of all rows, the time, the senses
    /// of sliding of all contacts and the switches, as far as they are used; what is missing is not
    /// a number.
    pub fn evaluate(&self, outputs: &[program::Id], parameters: &[f64], state: &[f64]) -> Vec<f64> {
        let n = self.motion.n;
        let at = |i: usize| state.get(i).copied().unwrap_or(f64::NAN);
        self.functions.program.evaluate(outputs, &|symbol| match symbol {
            Symbol::Parameter(i) => parameters[usize::from(i)],
            Symbol::Coordinate { index, order } => at(usize::from(index) + n * usize::from(order)),
            Symbol::Reaction(row) => at(3 * n + usize::from(row)),
            Symbol::Time => at(3 * n + self.motion.rows.len()),
            Symbol::Sense(contact) => at(3 * n + self.motion.rows.len() + 1 + usize::from(contact)),
            Symbol::Switch(i) => {
                at(3 * n + self.motion.rows.len() + 1 + self.motion.contacts.len() + usize::from(i))
            }
            Symbol::Opaque { .. } => f64::NAN,
        })
    }
}

impl Analysis {
    /// M by the interpreter; parameters and state as in [`Analysis::evaluate`].
    pub fn mass(&self, parameters: &[f64], state: &[f64]) -> Vec<Vec<f64>> {
        let n = self.motion.n;
        let values = |ids: &[program::Id]| self.evaluate(ids, parameters, state);
        let Paths { parents, reach, moments, own } = match &self.functions.kernel.mass {
            Mass::Paths(paths) => paths,
            Mass::Entries(rows) => {
                let rows: Vec<Vec<f64>> = rows.iter().map(|row| values(row)).collect();
                return (0..n).map(|i| (0..n).map(|j| rows[i.max(j)][i.min(j)]).collect()).collect();
            }
        };
        let vectors = |v: &[[program::Id; 2]]| v.iter().map(|ids| values(ids)).collect::<Vec<_>>();
        let (reach, moments, own) = (vectors(reach), vectors(moments), values(own));
        let mut mass = vec![vec![0.0; n]; n];
        for j in 0..n {
            mass[j][j] = own[j];
            let above = core::iter::successors(Some(j), |&child| parents[child]);
            for (child, i) in above.filter_map(|child| Some((child, parents[child]?))) {
                let entry = reach[child][0] * moments[j][0] + reach[child][1] * moments[j][1];
                (mass[i][j], mass[j][i]) = (entry, entry);
            }
        }
        mass
    }
}

/// Derives the equations of a declaration.
///
/// # Errors
/// Every mistake of the declaration, each at its span.
pub fn analyse(input: TokenStream) -> syn::Result<Analysis> {
    derive(&parse(input)?)
}

fn parse(input: TokenStream) -> syn::Result<Description> {
    syntax::parse(input).map_err(limits::first_mistakes)
}

/// The system of a declaration, without its equations: what a drawing needs.
///
/// # Errors
/// Every mistake of the declaration, each at its span.
pub fn resolve(input: TokenStream) -> syn::Result<System> {
    let description = parse(input)?;
    limits::within_work(limits::WORK, description.ident.span(), || System::resolve(&description))
        .map_err(limits::first_mistakes)
}

fn derive(description: &Description) -> syn::Result<Analysis> {
    limits::within_work(limits::WORK, description.ident.span(), || {
        let analysis = derived(description)?;
        budget::check(&description.budgets, &analysis)?;
        Ok(analysis)
    })
    .map_err(limits::first_mistakes)
}

fn derived(description: &Description) -> syn::Result<Analysis> {
    let system = System::resolve(description)?;
    if work::is_spent() {
        return Err(syn::Error::new(system.ident.span(), limits::TOO_MUCH));
    }
    let dimensions = Dimensions::infer(description)?;
    let kinematics = Kinematics::derive(&system)?;
    kinematics.check_start(&system)?;
    let motion = Motion::derive(&system, &kinematics)?;
    if let Some(tree) = motion.long_tree() {
        let functions = Functions::of_tree(&system, &kinematics, &motion, tree);
        return Ok(Analysis {
            system,
            dimensions,
            kinematics,
            motion,
            dense: None,
            phases: Vec::new(),
            functions,
        });
    }
    let dense = Dense::derive(&Scene { system: &system, kinematics: &kinematics }, &motion)?;
    let phases = phases::closed_forms(&system, &kinematics, &motion, &dense);
    let functions = Functions::lower(&system, &kinematics, &motion, &dense, &phases);
    Ok(Analysis { system, dimensions, kinematics, motion, dense: Some(dense), phases, functions })
}

/// The implementation of `BarSystem` for a declaration, or its mistakes as compile errors beside
/// one that does nothing, so that uses of the model are no mistakes too.
pub fn expand(input: TokenStream) -> TokenStream {
    let named = syntax::name_and_runtime(&input);
    let description = match parse(input) {
        Ok(description) => description,
        Err(errors) => {
            let mut tokens = errors.into_compile_error();
            tokens.extend(named.map(|(ident, runtime)| emit::unread(&runtime, &ident)));
            return tokens;
        }
    };
    match derive(&description) {
        Ok(analysis) => emit::implementation(&analysis),
        Err(errors) => {
            let mut tokens = errors.into_compile_error();
            tokens.extend(emit::fallback(&description));
            tokens
        }
    }
}

/// The equations of a declaration in textbook notation, for people and for snapshots.
///
/// # Errors
/// As [`analyse`].
pub fn equations(input: TokenStream) -> syn::Result<Equations> {
    let analysis = analyse(input)?;
    limits::within_work(limits::WORK_OF_TEXT, analysis.system.ident.span(), || text::equations(&analysis))
}

/// The equations of the declaration that a model carries; in their place its mistakes, if it has
/// any.
pub fn equations_from_text(declaration: &str) -> Equations {
    let derived = || -> syn::Result<Equations> { equations(declaration.parse()?) };
    derived().unwrap_or_else(|mistakes| Equations::missing(&mistakes.to_string()))
}

#[cfg(test)]
mod tests;
