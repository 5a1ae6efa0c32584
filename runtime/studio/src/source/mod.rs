//! What a source file declares, before anything compiles it: its equations, and its models to be
//! run.

mod declaration;
mod diagnostics;

pub use declaration::{Declaration, declarations};
pub use diagnostics::rendered;

use crate::registry::Entry;
use crate::run_spec::RunSpec;
use core::ops::Range;
use liftoff_codegen::text::Equations;
use liftoff_interpreter::Interpreted;
use proc_macro2::{LexError, TokenStream};
use quote::ToTokens;
use std::sync::Arc;
use syn::{Attribute, DeriveInput, File, Item, Meta, Path, Stmt, Token, punctuated::Punctuated};

/// A mistake, and where it is: bytes of the file.
#[derive(Debug)]
pub struct Mistake {
    /// Message of the compiler.
    pub text: String,
    /// Byte range in the source.
    pub at: Range<usize>,
}

/// The equations of every item that derives `BarSystem`, in order.
///
/// # Errors
/// All mistakes of all of them.
pub fn equations(source: &str) -> Result<Vec<Equations>, Vec<Mistake>> {
    each(source, liftoff_codegen::equations)
}

/// The models of a file, interpreted.
///
/// # Errors
/// All mistakes of all of them.
pub fn models(source: &str) -> Result<Vec<Entry>, Vec<Mistake>> {
    Ok(derived(source)?.into_iter().map(Entry::interpreted).collect())
}

/// A model that a program carries as text. It is derived when its equations are first needed.
///
/// # Panics
/// At that time, if the text does not declare exactly one model.
pub fn embedded(name: &'static str, source: &'static str, default_run: RunSpec) -> Entry {
    let entry = Entry::deferred(name.to_owned(), default_run, move || match derived(source).as_deref() {
        Ok([model]) => Arc::clone(model),
        Ok(models) => panic!("the text of `{name}` declares {} models", models.len()),
        Err(mistakes) => panic!("{name}: {mistakes:?}"),
    });
    entry.with_source(source)
}

/// The models of a text, derived for the interpreter.
fn derived(source: &str) -> Result<Vec<Arc<Interpreted>>, Vec<Mistake>> {
    each(source, |item| Ok(Interpreted::from_analysis(&liftoff_codegen::analyse(item)?)))
}

/// What is made of every item that derives `BarSystem`, in order.
fn each<T>(source: &str, make: impl Fn(TokenStream) -> syn::Result<T>) -> Result<Vec<T>, Vec<Mistake>> {
    let file = parse_file(source)?;
    let (mut found, mut wrong) = (Vec::new(), Vec::new());
    for item in file.items.into_iter().flat_map(declared) {
        let unknown = liftoff_codegen::check_attributes(&item);
        wrong.extend(unknown.err().into_iter().flat_map(mistakes));
        match make(without_derives(item).into_token_stream()) {
            Ok(made) => found.push(made),
            Err(errors) => wrong.extend(mistakes(errors)),
        }
    }
    if wrong.is_empty() { Ok(found) } else { Err(wrong) }
}

/// The file, unless something in it is too deep to be read.
fn parse_file(source: &str) -> Result<File, Vec<Mistake>> {
    let tokens: TokenStream = without_head(source).parse().map_err(|error: LexError| {
        let text = "this cannot be read as Rust: a bracket, quote or comment that is never closed, a bracket that was \
                    never opened, or a character that has no meaning";
        mistakes(syn::Error::new(error.span(), text))
    })?;
    liftoff_codegen::limits::check(&tokens).map_err(mistakes)?;
    let placed = |mistake| at_end(mistake, source.trim_end().len());
    syn::parse2(tokens).map_err(|errors| mistakes(errors).into_iter().map(placed).collect())
}

/// Blanks in place of a byte order mark and of a line `#!/usr/bin/…`, so that all else stays where
/// it is.
fn without_head(source: &str) -> String {
    const MARK: &str = "\u{feff}";
    let marked = if source.starts_with(MARK) { MARK.len() } else { 0 };
    let rest = &source[marked..];
    let script = rest.strip_prefix("#!").is_some_and(|line| !line.trim_start().starts_with('['));
    let line = if script { rest.find('\n').unwrap_or(rest.len()) } else { 0 };
    " ".repeat(marked + line) + &rest[line..]
}

fn mistakes(errors: syn::Error) -> Vec<Mistake> {
    let mistake = |error: syn::Error| Mistake { text: error.to_string(), at: error.span().byte_range() };
    errors.into_iter().map(mistake).collect()
}

/// What is missing behind the last token has no place of its own.
fn at_end(mistake: Mistake, end: usize) -> Mistake {
    let at = if mistake.at.is_empty() { end..end } else { mistake.at };
    Mistake { at, ..mistake }
}

/// Items that derive `BarSystem`, at any depth.
fn declared(item: Item) -> Vec<DeriveInput> {
    let inside = |items: Vec<Item>| items.into_iter().flat_map(declared).collect();
    let own =
        |item: DeriveInput| Some(item).filter(|item| item.attrs.iter().any(derives)).into_iter().collect();
    match item {
        Item::Mod(module) => inside(module.content.map_or_else(Vec::new, |(_, items)| items)),
        Item::Fn(function) => inside(function.block.stmts.into_iter().filter_map(item_of).collect()),
        Item::Struct(item) => own(item.into()),
        Item::Enum(item) => own(item.into()),
        Item::Union(item) => own(item.into()),
        _ => Vec::new(),
    }
}

fn item_of(statement: Stmt) -> Option<Item> {
    if let Stmt::Item(item) = statement { Some(item) } else { None }
}

/// The item as the macro sees it.
fn without_derives(mut item: DeriveInput) -> DeriveInput {
    item.attrs.retain(|attribute| !attribute.path().is_ident("derive"));
    item
}

fn derives(attribute: &Attribute) -> bool {
    let Meta::List(list) = &attribute.meta else { return false };
    let named = |path: &Path| path.segments.last().is_some_and(|last| last.ident == "BarSystem");
    let paths = list.parse_args_with(Punctuated::<Path, Token![,]>::parse_terminated);
    list.path.is_ident("derive") && paths.is_ok_and(|paths| paths.iter().any(named))
}

#[cfg(test)]
mod tests {
    use super::equations;

    /// What is told, and the text that it is about.
    fn find_mistakes(source: &str) -> Vec<(String, &str)> {
        let mistakes = equations(source).err().unwrap_or_default();
        mistakes.into_iter().map(|mistake| (mistake.text, &source[mistake.at])).collect()
    }

    const ROD: &str = "#[derive(BarSystem)] #[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[figure(A = (0, -l))] \
                       struct Rod { m: f64, l: f64 }";

    #[test]
    fn misspelt_attributes_are_reported() {
        let told_of = |attribute: &str| {
            find_mistakes(&format!("{attribute} {ROD}")).into_iter().map(|(text, _)| text).collect::<Vec<_>>()
        };
        assert_eq!(
            told_of("#[suport(A = floor)]"),
            ["there is no attribute `suport`; did you mean `support`?"]
        );
        assert_eq!(told_of("#[inline] #[doc = \"x\"] #[liftoff::document] #[rustfmt::skip]"), [""; 0]);
        assert_eq!(told_of("#[derive(Serialize)] #[serde(x)] #[derive(clap::Args)] #[clap(y)]"), [""; 0]);
        let hint = ["there is no attribute `collision`; did you mean `#[support(A = floor)]`?"];
        assert_eq!(told_of("#[collision(A = floor)]"), hint);
        let condition = ["conditions are not evaluated here; write the attribute without `cfg_attr`"];
        assert_eq!(told_of("#[cfg_attr(feature = \"a\", support(A = floor))]"), condition);
        assert_eq!(told_of("#[cfg_attr(docsrs, allow(x))]"), [""; 0]);
    }

    #[test]
    fn unknown_attributes_are_reported_at_their_place() {
        let source = ROD.replace("#[pin(", "#[revolute(").replace("l: f64", "#[valeu(2)] l: f64");
        let all = find_mistakes(&source);
        assert!(all.contains(&(
            "there is no attribute `revolute`; did you mean `#[pin(O = (0, 0))]`?".into(),
            "revolute"
        )));
        assert!(all.contains(&("there is no attribute `valeu`; did you mean `value`?".into(), "valeu")));
    }

    #[test]
    fn places_are_those_of_the_file() {
        for head in ["", "\u{feff}", "#!/usr/bin/x\n", "\u{feff}#!/usr/bin/é\n"] {
            let source = format!("{head}{}", ROD.replace("length = l", "length = é"));
            let all = find_mistakes(&source);
            assert!(all.iter().any(|(_, at)| *at == "é"), "{all:?}");
        }
    }

    #[test]
    fn what_is_missing_is_reported_where_it_would_stand() {
        for (whole, broken) in
            [("length = l)", "length = )"), ("= (0, 0))", "= )"), ("length = l)", "length = l +)")]
        {
            let source = ROD.replacen(whole, broken, 1);
            let all = find_mistakes(&source);
            assert!(matches!(all[..], [(ref text, ")")] if text.contains("end of input")), "{all:?}");
        }
        let source = ROD.replace("{ m", "{ #[value()] m");
        let all = find_mistakes(&source);
        assert!(matches!(all[..], [(_, ")")]), "{all:?}");
        for end in ["struct", "struct Other", "#[doc]", "mod a; use"] {
            let source = format!("{ROD} {end}");
            let mistakes = equations(&format!("{source}\n")).unwrap_err();
            assert_eq!(mistakes[0].at.clone(), source.len()..source.len(), "{mistakes:?}");
        }
    }

    #[test]
    fn brackets_quotes_and_comments_that_stay_open_are_reported() {
        for open in ["(", "/* ", "\"", "]"] {
            let source = format!("{ROD} {open}");
            let all = find_mistakes(&source);
            assert!(matches!(&all[..], [(text, _)] if text.contains("never closed")), "{all:?}");
        }
    }

    #[test]
    fn deep_nesting_is_refused() {
        for part in [
            "(".repeat(10_000) + &")".repeat(10_000),
            "- ".repeat(1_000_000),
            "if a {} else ".repeat(100_000),
        ] {
            assert_eq!(find_mistakes(&format!("fn f() {{ {part} }} {ROD}")).len(), 1);
        }
    }
}
