//! Resolution of declarations, and the mistakes that are told, where and in which words.

use quote::quote;

use super::{CoordinateKind, OneSided, Reference, System};
use crate::algebra::{Angle, Series, Symbol};
use crate::syntax;

fn resolve(tokens: proc_macro2::TokenStream) -> syn::Result<System> {
    System::resolve(&syntax::parse(tokens)?)
}

/// Each mistake with the text it stands at.
fn mistakes(source: &str) -> Vec<String> {
    let tokens: proc_macro2::TokenStream = source.parse().unwrap();
    let Err(errors) = resolve(tokens) else {
        return Vec::new();
    };
    errors
        .into_iter()
        .map(|e| format!("{}: {e}", e.span().source_text().unwrap_or_default()))
        .collect()
}

fn falling_pair() -> System {
    resolve(quote! {
        #[gravity(g)]
        #[bar(AD, mass = m, length = l)]
        #[bar(DB, mass = m, length = l)]
        #[support(P = corner(-l / 2, 0), under = AD)]
        #[support(Q = corner(l / 2, 0), under = DB)]
        #[figure(D = (0, 0), A = (-l, 0))]
        #[coordinate(phi = angle(DB), from = horizontal)]
        #[mirror(x = 0)]
        pub struct FallingPair { pub m: f64, pub l: f64, pub g: f64 }
    })
    .unwrap()
}

#[test]
fn the_missing_half_of_a_symmetric_figure_is_its_mirror_image() {
    let system = falling_pair();
    let l = Series::symbol(Symbol::parameter(1));
    let names: Vec<&str> = system.points.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names, ["A", "D", "B"]);
    assert_eq!(system.figure[2], [l, Series::zero()]);
    let mirror = system.mirror.unwrap();
    assert_eq!(mirror.points, [2, 1, 0]);
    assert_eq!(mirror.bodies, [(1, true), (0, true)]);
    assert_eq!(mirror.supports, [1, 0]);
}
