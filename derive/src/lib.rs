//! `#[derive(BarSystem)]` of the crate `liftoff`, which documents it; everything it does is in [`liftoff_codegen`].

use proc_macro::TokenStream;

/// Derives the equations of every contact phase of a declared planar bar system.
#[proc_macro_derive(
    BarSystem,
    attributes(
        liftoff, budget, constant, gravity, bar, chain, body, particle, mass, pin, ground, point, weld,
        slider, drive, spring, torsion, force, couple, section, support, thread, equal, figure, coordinate,
        mirror
    )
)]
pub fn bar_system(input: TokenStream) -> TokenStream {
    liftoff_codegen::expand(input.into()).into()
}
