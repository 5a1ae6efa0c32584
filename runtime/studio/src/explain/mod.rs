//! The equations of a model for people, derived again from the declaration that it carries: as
//! text, as LaTeX and, with feature `report`, as a page.

pub mod conditions;
pub mod export;
pub(crate) mod html;
mod latex;

pub use html::{Drawings, page, phase_page};
pub use latex::{latex, latex_display, phase_latex};
use liftoff_codegen::Analysis;
pub(crate) use liftoff_codegen::Unfolded as Halves;
pub use liftoff_codegen::equations_as_html as part;
pub(crate) use liftoff_codegen::system::describe_crossing;
pub use liftoff_codegen::text::Equations;
pub use liftoff_codegen::{math, text};
use liftoff_core::model::Layout;
use liftoff_interpreter::Interpreted;
use proc_macro2::TokenStream;
use quote::ToTokens;
use std::sync::Arc;

/// Names in print: Greek letters, indices, dots.
pub mod names {
    pub use liftoff_codegen::algebra::{lettered, printed};
}

/// What is made of the equations of a model.
fn derived<T>(layout: &Layout, make: impl Fn(&Analysis) -> syn::Result<T>) -> Result<T, String> {
    declared(layout, |tokens| make(&liftoff_codegen::analyse(tokens)?))
}

/// What is made of the declaration of a model.
fn declared<T>(layout: &Layout, make: impl Fn(TokenStream) -> syn::Result<T>) -> Result<T, String> {
    let tokens = layout.declaration.parse().map_err(|mistake| format!("{mistake}"))?;
    make(tokens).map_err(|error| error.to_string())
}

/// Both halves of a mirrored model.
pub(crate) fn halves(layout: &Layout) -> Result<Halves, String> {
    declared(layout, Halves::from_tokens)
}

/// A compiled model once more, interpreted.
pub(crate) fn interpreted(layout: &Layout) -> Result<Arc<Interpreted>, String> {
    derived(layout, |analysis| Ok(Interpreted::from_analysis(analysis)))
}

/// The declaration of a model as one would write it: comments, attributes and fields one a line.
/// The compiler keeps it so; of what was derived while a program runs only the tokens are left.
pub fn written(layout: &Layout) -> String {
    let parsed = || syn::parse_str::<syn::ItemStruct>(layout.declaration).ok();
    match layout.declaration.starts_with("# [").then(parsed).flatten() {
        None => layout.declaration.to_owned(),
        Some(item) => {
            let fields = item.fields.iter().flat_map(|field| {
                let name = field.ident.as_ref().map_or_else(String::new, |name| format!("{name}: f64,"));
                field.attrs.iter().map(attribute).chain([name]).map(|line| format!("    {line}"))
            });
            let head = format!("struct {} {{", item.ident);
            let lines = item.attrs.iter().map(attribute).chain([head]).chain(fields).chain(["}".to_owned()]);
            lines.collect::<Vec<_>>().join("\n")
        }
    }
}

/// An attribute, or the line of documentation that it stands for.
fn attribute(attribute: &syn::Attribute) -> String {
    if let syn::Meta::NameValue(doc) = &attribute.meta
        && doc.path.is_ident("doc")
        && let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &doc.value
    {
        return format!("///{}", text.value());
    }
    let tokens = attribute.meta.to_token_stream().to_string();
    let closer = [
        (" (", "("),
        ("( ", "("),
        (" )", ")"),
        (" ,", ","),
        ("=(", "= ("),
        (",(", ", ("),
        ("(- ", "(-"),
        (", - ", ", -"),
        ("= - ", "= -"),
    ];
    let text = closer.iter().fold(tokens, |text, (wide, narrow)| text.replace(wide, narrow));
    format!("#[{text}]")
}

/// What each coordinate of a model measures, in the order of [`Layout::names_of_positions`]:
/// `angle of AB from the right`.
///
/// # Errors
/// The mistakes of a declaration that has any.
pub fn meanings(layout: &Layout) -> Result<Vec<String>, String> {
    let coordinates = derived(layout, |analysis| Ok(text::TextWriter::new(analysis).coordinates()))?;
    Ok(coordinates.into_iter().map(|coordinate| coordinate.meaning).collect())
}

/// The equations of motion of a model and of its phases in textbook notation: those of the whole
/// system and those of each phase in closed form. As text they are stable, fit for snapshots. In
/// place of a declaration's equations stand its mistakes, if it has any.
pub fn equations(layout: &Layout) -> Equations {
    liftoff_codegen::equations_from_text(layout.declaration)
}
