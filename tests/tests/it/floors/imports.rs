//! What the modules of a crate import from each other, read from its sources.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::punctuated::Punctuated;
use syn::visit::{self, Visit};
use syn::{Attribute, File, Item, ItemMod, Macro, Meta, Token, UseTree};

/// A module or an item by its names from the root of the crate.
type Names = Vec<String>;

/// A path goes through fewer re-exports; after `use name::name` of a crate it would never end.
const MOST_PASSED: usize = 9;

/// Where something is imported.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    file: PathBuf,
    line: usize,
}

impl Place {
    pub fn new(file: impl Into<PathBuf>, line: usize) -> Self {
        Self { file: file.into(), line }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}:{}", self.file.display(), self.line)
    }
}

/// Which module imports which of its siblings, with the first place of each import.
pub type Arrows = BTreeMap<(String, String), Place>;

struct Import {
    module: Names,
    path: Names,
    place: Place,
}

/// The modules of a crate without its tests, what they import, and the names this gives to them.
///
/// Names that `use module::*` imports are not followed: no module re-exports its own so.
#[derive(Default)]
pub struct Imports {
    modules: BTreeSet<Names>,
    aliases: BTreeMap<Names, Names>,
    imports: Vec<Import>,
}

impl Imports {
    /// Of the crate whose root this file is.
    pub fn from_root(root: &Path) -> Self {
        let mut imports = Self::default();
        imports.read_file(root, &[]);
        imports
    }

    /// A file, and those of the modules declared there.
    fn read_file(&mut self, path: &Path, module: &[String]) {
        let text = fs::read_to_string(path).expect("a source");
        let file = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        for child in self.read_items(&file, path, module) {
            let name = child.last().expect("a name");
            let found = [format!("{name}.rs"), format!("{name}/mod.rs")].map(|end| children(path).join(end));
            let found = found.iter().find(|file| file.exists());
            self.read_file(found.unwrap_or_else(|| panic!("no file of {child:?}")), &child);
        }
    }

    /// The modules declared in a file, whose items are read.
    fn read_items(&mut self, file: &File, path: &Path, module: &[String]) -> Vec<Names> {
        self.modules.insert(module.to_vec());
        let mut reader = Reader { imports: self, file: path, module: module.to_vec(), declared: Vec::new() };
        reader.visit_file(file);
        reader.declared
    }

    /// Names of the modules in a folder that have modules in them, the root among them.
    pub fn folders(&self) -> BTreeSet<&[String]> {
        self.modules.iter().filter_map(|module| module.split_last()).map(|(_, folder)| folder).collect()
    }

    /// Imports between the modules directly in a folder.
    pub fn arrows(&self, folder: &[String]) -> Arrows {
        let mut arrows = Arrows::new();
        for import in &self.imports {
            let Some(from) = self.child(folder, &import.module) else { continue };
            for path in self.passed(&import.module, &import.path) {
                if let Some(to) = self.child(folder, &path).filter(|to| *to != from) {
                    let arrow = (from.to_owned(), to.to_owned());
                    arrows.entry(arrow).or_insert_with(|| import.place.clone());
                }
            }
        }
        arrows
    }

    /// The module directly in a folder in which something is.
    fn child<'a>(&self, folder: &[String], path: &'a [String]) -> Option<&'a str> {
        let is_in = path.starts_with(folder) && path.len() > folder.len();
        let name = is_in.then(|| &path[..=folder.len()]).filter(|module| self.modules.contains(*module))?;
        name.last().map(String::as_str)
    }

    /// What a path names, from the root, and after each re-export that it goes through.
    fn passed(&self, module: &[String], path: &[String]) -> Vec<Names> {
        let mut passed: Vec<Names> = self.absolute(module, path).into_iter().collect();
        while passed.len() < MOST_PASSED
            && let Some(next) = passed.last().and_then(|path| self.followed(path))
        {
            passed.push(next);
        }
        passed
    }

    /// A path with its first imported name replaced by what is imported.
    fn followed(&self, path: &[String]) -> Option<Names> {
        let is_imported = |end: &usize| !self.modules.contains(&path[..*end]);
        let end = (1..=path.len()).find(is_imported)?;
        let (name, rest) = path.split_at(end);
        let mut named = self.absolute(&name[..end - 1], self.aliases.get(name)?)?;
        named.extend_from_slice(rest);
        Some(named)
    }

    /// A path as a module names it, from the root; none of other crates.
    fn absolute(&self, module: &[String], path: &[String]) -> Option<Names> {
        let (first, after) = path.split_first()?;
        let (above, rest) = match first.as_str() {
            "crate" => (&[][..], after),
            "self" => (module, after),
            "super" => (module, path),
            _ => {
                let own = [module, &path[..1]].concat();
                let is_here = self.modules.contains(&own) || self.aliases.contains_key(&own);
                (is_here.then_some(module)?, path)
            }
        };
        let ups = rest.iter().take_while(|name| *name == "super").count();
        Some([&above[..above.len().saturating_sub(ups)], &rest[ups..]].concat())
    }
}

/// The folder of the modules declared in a file.
fn children(file: &Path) -> PathBuf {
    let is_root = file.file_stem().is_some_and(|stem| stem == "lib" || stem == "mod");
    if is_root { file.with_file_name("") } else { file.with_extension("") }
}

/// Reads one file.
struct Reader<'a> {
    imports: &'a mut Imports,
    file: &'a Path,
    module: Names,
    declared: Vec<Names>,
}

impl Reader<'_> {
    fn add(&mut self, path: Names, at: Span) {
        let place = Place::new(self.file, at.start().line);
        self.imports.imports.push(Import { module: self.module.clone(), path, place });
    }

    /// The paths in a tree of imports, and the names that they get.
    fn add_tree(&mut self, before: &[String], tree: &UseTree) {
        let with = |name: &Ident| match before {
            [_, ..] if name == "self" => before.to_vec(),
            _ => [before, &[name.to_string()]].concat(),
        };
        match tree {
            UseTree::Path(path) => self.add_tree(&with(&path.ident), &path.tree),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.add_tree(before, tree)),
            UseTree::Name(name) => {
                let path = with(&name.ident);
                self.add_alias(path.last().cloned(), &path);
                self.add(path, name.ident.span());
            }
            UseTree::Rename(name) => {
                let path = with(&name.ident);
                self.add_alias(Some(name.rename.to_string()), &path);
                self.add(path, name.ident.span());
            }
            UseTree::Glob(glob) => self.add(before.to_vec(), glob.star_token.spans[0]),
        }
    }

    fn add_alias(&mut self, name: Option<String>, path: &[String]) {
        let alias = self.module.iter().cloned().chain(name).collect();
        self.imports.aliases.entry(alias).or_insert_with(|| path.to_vec());
    }

    /// Paths from the root or the module above among the tokens of a macro.
    fn add_tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut rest = tokens.as_slice();
        while let [token, after @ ..] = rest {
            rest = after;
            match token {
                TokenTree::Group(group) => self.add_tokens(group.stream()),
                TokenTree::Ident(first) if *first == "crate" || *first == "super" => {
                    let mut path = vec![first.to_string()];
                    while let [TokenTree::Punct(colon), _, TokenTree::Ident(name), after @ ..] = rest
                        && colon.as_char() == ':'
                    {
                        path.push(name.to_string());
                        rest = after;
                    }
                    self.add(path, first.span());
                }
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        if !attributes(item).iter().any(is_for_tests) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        self.module.push(item.ident.to_string());
        if item.content.is_some() {
            self.imports.modules.insert(self.module.clone());
            visit::visit_item_mod(self, item);
        } else {
            self.declared.push(self.module.clone());
        }
        self.module.pop();
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        if item.leading_colon.is_none() {
            self.add_tree(&[], &item.tree);
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if let (None, Some(first)) = (path.leading_colon, path.segments.first()) {
            let names = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
            self.add(names, first.ident.span());
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, of: &'ast Macro) {
        self.visit_path(&of.path);
        self.add_tokens(of.tokens.clone());
    }
}

/// Of the items that are kept to builds of tests somewhere.
fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Fn(of) => &of.attrs,
        Item::Impl(of) => &of.attrs,
        Item::Mod(of) => &of.attrs,
        Item::Use(of) => &of.attrs,
        _ => &[],
    }
}

/// Whether an attribute keeps what it is of to builds of tests.
fn is_for_tests(attribute: &Attribute) -> bool {
    attribute.path().is_ident("cfg") && attribute.parse_args().is_ok_and(|meta| asks_tests(&meta))
}

fn asks_tests(meta: &Meta) -> bool {
    match meta {
        Meta::Path(path) => path.is_ident("test"),
        Meta::List(list) if list.path.is_ident("all") => list
            .parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated)
            .is_ok_and(|all| all.iter().any(asks_tests)),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Imports between modules in a folder of such files, `a/c.rs` being the module `a::c`.
    fn between(folder: &str, files: &[(&str, &str)]) -> Vec<String> {
        let mut imports = Imports::default();
        for (file, text) in files {
            let names = file.trim_end_matches(".rs").split('/').filter(|name| !["lib", "mod"].contains(name));
            let module: Names = names.map(str::to_owned).collect();
            imports.read_items(&syn::parse_str(text).unwrap(), Path::new(file), &module);
        }
        let folder: Names = folder.split_terminator('/').map(str::to_owned).collect();
        let arrows = imports.arrows(&folder);
        arrows.iter().map(|((from, to), place)| format!("{from} {to} {place}")).collect()
    }

    #[test]
    fn a_tree_of_imports_is_of_each_module_in_it() {
        let b = "\nuse crate::{a::{self, X as Y},\n c::{d::Z, *}};\nuse std::a;";
        let files = [("lib.rs", ""), ("a.rs", ""), ("b.rs", b), ("c/mod.rs", ""), ("c/d.rs", "")];
        assert_eq!(between("", &files), ["b a b.rs:2", "b c b.rs:3"]);
    }

    #[test]
    fn super_is_the_module_above() {
        let d = "use super::e::X;\nfn f() -> super::super::b::Y { self::g() }";
        let files = [("lib.rs", ""), ("a/mod.rs", ""), ("a/d.rs", d), ("a/e.rs", ""), ("b.rs", "")];
        assert_eq!(between("", &files), ["a b a/d.rs:2"]);
        assert_eq!(between("a", &files), ["d e a/d.rs:1"]);
    }

    #[test]
    fn a_module_in_a_file_is_below_that_of_the_file() {
        let a = "mod inner { use super::super::b::X; use super::own; }\nmod own {}";
        let files = [("lib.rs", ""), ("a.rs", a), ("b.rs", "")];
        assert_eq!(between("", &files), ["a b a.rs:1"]);
        assert_eq!(between("a", &files), ["inner own a.rs:1"]);
    }

    #[test]
    fn what_is_exported_again_is_of_its_module() {
        let lib = "mod a; mod b;\npub use a::{X, Y as Z};\nuse b::work as done;\npub struct Own;";
        let uses = "use crate::Z;\nfn f(_: crate::Own) { crate::done() }";
        let files = [("lib.rs", lib), ("a.rs", ""), ("b.rs", ""), ("c.rs", uses)];
        assert_eq!(between("", &files), ["c a c.rs:1", "c b c.rs:2"]);
    }

    #[test]
    fn an_export_can_be_of_another_export() {
        let files = [
            ("lib.rs", "mod a; mod b; mod c;\npub use a::X;"),
            ("a/mod.rs", "mod d; mod e;\npub use d::X;"),
            ("a/d.rs", ""),
            ("a/e.rs", "fn f(x: crate::X) {}"),
            ("c.rs", "use crate::X;"),
        ];
        assert_eq!(between("", &files), ["c a c.rs:1"]);
        assert_eq!(between("a", &files), ["e d a/e.rs:1"]);
    }

    #[test]
    fn a_name_of_a_crate_can_be_imported_under_itself() {
        let files = [("lib.rs", "use other::other;"), ("a.rs", "use other::other; use crate::other as b;")];
        assert_eq!(between("", &files), [""; 0]);
    }

    #[test]
    fn macros_are_searched() {
        let a = "fn f() { assert!(x == [\ncrate::b::y], super::c::z) }";
        let files = [("lib.rs", ""), ("a.rs", a), ("b.rs", ""), ("c.rs", "")];
        assert_eq!(between("", &files), ["a b a.rs:2", "a c a.rs:2"]);
    }

    #[test]
    fn tests_are_left_out() {
        let a = "#[cfg(test)] use crate::b;\n#[cfg(all(test, unix))] mod tests { use crate::b; }";
        let built = "#[cfg(any(test, unix))] use crate::b;\n#[cfg(not(test))] use crate::a;";
        let files = [("lib.rs", ""), ("a.rs", a), ("b.rs", ""), ("c.rs", built)];
        assert_eq!(between("", &files), ["c a c.rs:2", "c b c.rs:1"]);
    }
}
