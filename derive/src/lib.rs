//! `#[derive(BarSystem)]` of the crate `liftoff`, which documents it; everything it does is in
//! [`liftoff_codegen`].

use proc_macro::TokenStream;

/// Derives the equations of every contact phase of a declared planar bar system.
#[proc_macro_derive(
    BarSystem,
    attributes(
        liftoff, budget, constant, gravity, bar, chain, body, particle, mass, pin, ground, point, weld,
        slider, drive, spring, torsion, force, couple, section, support, thread, equal, figure, coordinate,
        mirror, disc, value, run, hinge, limit
    )
)]
pub fn bar_system(input: TokenStream) -> TokenStream {
    liftoff_codegen::expand(input.into()).into()
}

/// Appends the equations of a model to its documentation; documented by the crate `liftoff`.
#[proc_macro_attribute]
pub fn document(runtime: TokenStream, item: TokenStream) -> TokenStream {
    liftoff_codegen::document(runtime.into(), item.into()).into()
}

/// What `document` leaves for `cargo doc` to do.
#[doc(hidden)]
#[proc_macro_attribute]
pub fn documented(_: TokenStream, item: TokenStream) -> TokenStream {
    liftoff_codegen::documented(item.into()).into()
}
