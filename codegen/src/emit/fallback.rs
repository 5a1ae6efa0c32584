//! What stands in for the implementation when there are mistakes, so that each gives one message.

use proc_macro2::TokenStream;
use syn::{Ident, Path};

use super::{enclosed, model, names};
use crate::syntax::Description;

/// An implementation that only type-checks.
pub fn fallback(description: &Description) -> TokenStream {
    implemented(&description.runtime, &description.ident, &names::assumed(description))
}

/// The same for a struct of which no more than the name could be read.
pub fn unread(runtime: &Path, ident: &Ident) -> TokenStream {
    implemented(runtime, ident, &TokenStream::new())
}

fn implemented(runtime: &Path, ident: &Ident, names: &TokenStream) -> TokenStream {
    let model = model();
    let items = quote! {
            #names

            impl BarSystem for #model {
                const LAYOUT: &'static Layout = &Layout::new("");
                type Constants<S: Real> = ();
                type State<S: Real> = [S; 0];
                type Reactions<S: Real> = [S; 0];
                type Accelerations<S: Real> = [S; 0];
                type Multipliers<S: Real> = [S; 0];
                type Kernel<S: Real> = Kernel<S, 0, 0, 0>;
                type Points<S: Real> = [S; 0];
                type Feet<S: Real> = [S; 0];
                type Parameters<S: Real> = [S; 0];
                type Measures = [Measure; 0];
                type Numbers = [f64; 0];
                fn parameters(&self) -> [f64; 0] { ::core::unreachable!() }
                fn from_parameters(_: &[f64]) -> Self { ::core::unreachable!() }
                fn measures(&self) -> [Measure; 0] { ::core::unreachable!() }
                fn numbers(&self) -> [f64; 0] { ::core::unreachable!() }
                fn nominal(&self) -> [f64; 0] { ::core::unreachable!() }
                fn constants_of<S: Real>(_: &[S; 0], _: &ContactSet) {}
                fn kernel<S: Real>(_: &(), _: &[S; 0]) -> Kernel<S, 0, 0, 0> { ::core::unreachable!() }
                fn energy<S: Real>(_: &(), _: &[S; 0]) -> Energy<S> { ::core::unreachable!() }
                fn points<S: Real>(_: &(), _: &[S; 0]) -> [S; 0] { [] }
                fn feet<S: Real>(_: &(), _: &[S; 0]) -> [S; 0] { [] }
                fn quantity<S: Real>(_: &(), _: usize, _: &[S; 0], _: &[S; 0], _: &[S; 0]) -> S { ::core::unreachable!() }
                fn phase<S: Scalar, V: PhaseVisitor<Self, S>>(
                    _: ContactSet,
                    _: Form,
                    _: V,
                ) -> V::Output {
                    ::core::unreachable!()
                }
            }
    };
    enclosed(runtime, ident, &items)
}
