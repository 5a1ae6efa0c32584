//! Equations in a struct's documentation.

use super::PAIR;
use quote::ToTokens;

fn documented(item: &str) -> String {
    crate::documented(item.parse().unwrap()).to_string()
}

#[test]
fn equations_end_the_documentation() {
    let item = format!("/// Two bars.\n{PAIR}");
    let code: syn::DeriveInput = syn::parse2(crate::documented(item.parse().unwrap())).unwrap();
    let last = code.attrs.last().unwrap().to_token_stream().to_string();
    for part in [
        "# Equations",
        "<ul><li>",
        "<mi>T</mi>",
        "<summary>on P, Q</summary>",
        "Right-hand side: ",
        "<details open>",
    ] {
        assert!(last.contains(part), "{part} is not in {last}");
    }
    assert_eq!(code.attrs.len(), 10 + 1);
    // An empty line would end the HTML.
    assert!(!last.split("<div>").nth(1).unwrap().contains("\\n\\n"), "{last}");
}

/// The derive macro tells mistakes; only documentation has the equations.
#[test]
fn mistakes_and_other_items_are_left_alone() {
    let broken = PAIR.replace("under = AD", "under = AX");
    assert_eq!(documented(&broken), broken.parse::<proc_macro2::TokenStream>().unwrap().to_string());
    assert_eq!(documented("fn f() {}"), "fn f () { }");
}

#[test]
fn only_documentation_asks_for_equations() {
    let document =
        |runtime: &str| crate::document(runtime.parse().unwrap(), "struct S;".parse().unwrap()).to_string();
    assert_eq!(document(""), "# [cfg_attr (doc , :: liftoff :: documented)] struct S ;");
    assert_eq!(document("crate::own"), "# [cfg_attr (doc , crate :: own :: documented)] struct S ;");
}
