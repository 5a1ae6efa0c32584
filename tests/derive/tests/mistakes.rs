//! Mistakes are found at their place, all of a declaration at once, as the compiler prints them of
//! the same files (`ui.rs`, which starts compilers and is run by `.ci/long ui`).

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use liftoff_codegen::analyse;
use quote::ToTokens;

/// A mistake and where it begins, counted from 1.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Mistake {
    line: usize,
    column: usize,
    message: String,
}

#[test]
fn mistakes_are_found_at_their_place() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui");
    let mut seen = 0;
    for entry in fs::read_dir(folder).expect("cases") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|it| it == "rs") {
            let printed = fs::read_to_string(path.with_extension("stderr")).expect("what is printed of it");
            let found = find_mistakes(&fs::read_to_string(&path).expect("a case"));
            assert_eq!(found, parse_printed(&printed), "{}", path.display());
            seen += found.len();
        }
    }
    assert!(seen > 100, "{seen} mistakes");
}

fn find_mistakes(text: &str) -> BTreeSet<Mistake> {
    let file = syn::parse_file(text).expect("Rust");
    let declarations = file.items.iter().filter(|item| match item {
        syn::Item::Struct(it) => is_derived(&it.attrs),
        syn::Item::Enum(it) => is_derived(&it.attrs),
        _ => false,
    });
    let errors = declarations.filter_map(|item| analyse(item.to_token_stream()).err()).flatten();
    errors
        .map(|error| {
            let start = error.span().start();
            Mistake { line: start.line, column: start.column + 1, message: error.to_string() }
        })
        .collect()
}

fn is_derived(attributes: &[syn::Attribute]) -> bool {
    attributes
        .iter()
        .any(|it| it.path().is_ident("derive") && it.to_token_stream().to_string().contains("BarSystem"))
}

/// The mistakes among what the compiler has printed: `error: MESSAGE`, then ` -->
/// FILE:LINE:COLUMN`.
fn parse_printed(text: &str) -> BTreeSet<Mistake> {
    let blocks = text.split("\n\n").filter_map(|block| block.strip_prefix("error: "));
    let parse = |block: &str| {
        let (message, rest) = block.split_once("--> ")?;
        let mut place = rest.lines().next()?.rsplit(':').map_while(|it| it.parse().ok());
        let (column, line) = (place.next()?, place.next()?);
        Some(Mistake { line, column, message: message.trim_end().to_owned() })
    };
    blocks.map(|block| parse(block).expect("a message and its place")).collect()
}
