//! Names of functions and types, read from the sources.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Ident, ImplItemFn, Item, ItemFn, ItemImpl, Meta, TraitItemFn, Visibility};

/// Names that do not say what a function does.
const VAGUE: [&str; 5] = ["at", "of", "place", "read", "told"];

/// Traits of other crates with a function of such a name.
const FOREIGN: [&str; 1] = ["Read"];

/// The functions with a vague name in a file, and how many functions there are.
#[derive(Default)]
struct Functions {
    count: usize,
    vague: Vec<String>,
}

impl Functions {
    fn check(&mut self, name: &Ident) {
        self.count += 1;
        if VAGUE.iter().any(|vague| name == vague) {
            self.vague.push(name.to_string());
        }
    }
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item_fn(&mut self, function: &'ast ItemFn) {
        self.check(&function.sig.ident);
        visit::visit_item_fn(self, function);
    }

    fn visit_impl_item_fn(&mut self, function: &'ast ImplItemFn) {
        self.check(&function.sig.ident);
        visit::visit_impl_item_fn(self, function);
    }

    fn visit_trait_item_fn(&mut self, function: &'ast TraitItemFn) {
        self.check(&function.sig.ident);
        visit::visit_trait_item_fn(self, function);
    }

    fn visit_item_impl(&mut self, block: &'ast ItemImpl) {
        let of_trait = block.trait_.as_ref().and_then(|(path, _)| path.segments.last());
        if !of_trait.is_some_and(|name| FOREIGN.iter().any(|foreign| name.ident == foreign)) {
            visit::visit_item_impl(self, block);
        }
    }
}

fn parse(file: &Path) -> syn::Result<syn::File> {
    syn::parse_file(&fs::read_to_string(file).expect("a source"))
}

/// The vague names of functions in a folder, each with its file, and how many functions were read.
pub fn find_vague_functions(folder: &Path) -> (Vec<String>, usize) {
    let mut found = Functions::default();
    let mut complaints = Vec::new();
    for file in find_sources(folder) {
        // Sources that are no Rust are mistakes that a test shows.
        let Ok(parsed) = parse(&file) else { continue };
        found.visit_file(&parsed);
        complaints.extend(found.vague.drain(..).map(|name| format!("{}: fn {name}", file.display())));
    }
    (complaints, found.count)
}

/// All Rust files of a folder, but for what is built.
fn find_sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let mut files = Vec::new();
    for path in entries.filter(|path| !path.ends_with("target")) {
        if path.is_dir() {
            files.extend(find_sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

/// Public types of several modules with one name, among these files of a crate.
pub fn find_shared_types(files: &[PathBuf]) -> BTreeSet<String> {
    let mut counts = BTreeMap::<String, usize>::new();
    for file in files {
        let parsed = parse(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        count_public_types(&parsed.items, &mut counts);
    }
    counts.into_iter().filter(|(_, count)| *count > 1).map(|(name, _)| name).collect()
}

fn count_public_types(items: &[Item], counts: &mut BTreeMap<String, usize>) {
    for item in items {
        let (visibility, name) = match item {
            Item::Struct(item) => (&item.vis, &item.ident),
            Item::Enum(item) => (&item.vis, &item.ident),
            Item::Trait(item) => (&item.vis, &item.ident),
            Item::Type(item) => (&item.vis, &item.ident),
            Item::Mod(module) => {
                let is_test = |meta: &Meta| matches!(meta, Meta::List(list) if list.path.is_ident("cfg"));
                let is_plain = !module.attrs.iter().any(|attribute| is_test(&attribute.meta));
                if let Some((_, items)) = module.content.as_ref().filter(|_| is_plain) {
                    count_public_types(items, counts);
                }
                continue;
            }
            _ => continue,
        };
        if matches!(visibility, Visibility::Public(_)) {
            *counts.entry(name.to_string()).or_default() += 1;
        }
    }
}
