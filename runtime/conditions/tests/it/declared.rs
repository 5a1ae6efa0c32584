//! Models of the workspace, derived from their sources.

use liftoff_codegen::{Analysis, analyse};
use quote::ToTokens;
use std::fs;
use std::path::Path;
use syn::Item;

/// The text of a file of `models/systems/src`.
pub fn source(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../models/systems/src")
        .join(file)
        .with_extension("rs");
    fs::read_to_string(path).expect("a model")
}

/// The declaration in a source.
pub fn declared(source: &str) -> Analysis {
    let file = syn::parse_file(source).expect("Rust");
    let item = file.items.into_iter().find_map(|item| match item {
        Item::Struct(item) => Some(item),
        _ => None,
    });
    let mut item = item.expect("a struct");
    item.attrs
        .retain(|attribute| !attribute.path().is_ident("derive") && attribute.path().segments.len() == 1);
    analyse(item.into_token_stream()).expect("a model")
}

/// The same frame by its mass ratio λ, the paper's parameter: inner bars `(1 − λ) m`, outer ones
/// `λ m`.
pub fn by_ratio(file: &str) -> Analysis {
    let text = source(file)
        .replace("mass = m1", "mass = (1 - lambda) * m")
        .replace("mass = m2", "mass = lambda * m");
    declared(&text.replace("pub m1: f64", "pub m: f64").replace("pub m2: f64", "pub lambda: f64"))
}
