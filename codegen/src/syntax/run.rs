//! `#[run(start = "phi = 0.1, phi' = 2", until = "phi = pi/2", limit = 10)]`: the run that is made where nothing else is said.

use proc_macro2::Span;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, Ident, LitStr, Token, parse_str};

use super::value;

/// The run without options; what is asked for is read when it is run.
#[derive(Clone, Debug, Default)]
pub struct RunDeclaration {
    /// Where the start is written.
    pub span: Option<Span>,
    /// Coordinates and rates (`phi'`) at the start; none for the nominal figure.
    pub start: Vec<(String, f64)>,
    /// Conditions to stop at, whichever comes first.
    pub until: Vec<String>,
    /// The latest end.
    pub limit: Option<f64>,
}

impl RunDeclaration {
    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.start.is_empty() && self.until.is_empty() && self.limit.is_none()
    }
}

/// Reads it.
pub(super) fn read(input: ParseStream, known: &mut Option<RunDeclaration>) -> syn::Result<()> {
    if known.is_some() {
        return Err(input.error("a model has one default run; join the two attributes `run`"));
    }
    let mut run = RunDeclaration::default();
    while !input.is_empty() {
        let name = input.call(Ident::parse_any)?;
        input.parse::<Token![=]>()?;
        match name.to_string().as_str() {
            "start" => {
                let text: LitStr = input.parse()?;
                once(&name, run.span.is_none())?;
                (run.span, run.start) = (Some(text.span()), start(&text)?);
            }
            "until" => run.until.push(input.parse::<LitStr>()?.value()),
            "limit" => {
                let given: Expr = input.parse()?;
                once(&name, run.limit.is_none())?;
                let limit = value::number(&given)?;
                if !(limit > 0.0 && limit.is_finite()) {
                    return Err(syn::Error::new_spanned(given, "the latest end is a positive time"));
                }
                run.limit = Some(limit);
            }
            _ => {
                let text = "expected `start = \"phi = 0.1\"`, `until = \"phi = pi/2\"` or `limit = 10`";
                return Err(syn::Error::new(name.span(), text));
            }
        }
        if !input.is_empty() {
            input.parse::<Token![,]>()?;
        }
    }
    *known = Some(run);
    Ok(())
}

/// Refuses what would replace what was said before.
fn once(name: &Ident, first: bool) -> syn::Result<()> {
    let text = || format!("`{name}` is given twice; remove one");
    if first { Ok(()) } else { Err(syn::Error::new(name.span(), text())) }
}

/// `phi = 0.1, phi' = 2`; an angle also in degrees.
fn start(text: &LitStr) -> syn::Result<Vec<(String, f64)>> {
    let wrong = |what: String| syn::Error::new(text.span(), what);
    let given = text.value();
    let parts = given.split(',').filter(|part| !part.trim().is_empty());
    let mut known = Vec::new();
    let read = parts.map(|part| {
        let example =
            || wrong(format!("`{}` should be a coordinate or rate with its value: `phi = 0.1`", part.trim()));
        let (name, value) = part.split_once('=').ok_or_else(example)?;
        let (name, value) = (name.trim().to_owned(), value.trim());
        if known.contains(&name) {
            return Err(wrong(format!("`{name}` is given twice; remove one")));
        }
        known.push(name.clone());
        let (digits, factor) = match value.strip_suffix("deg").or_else(|| value.strip_suffix('°')) {
            Some(digits) => (digits, core::f64::consts::PI / 180.0),
            None => (value, 1.0),
        };
        let expression: Expr = parse_str(digits).map_err(|_| example())?;
        let value = factor * value::number(&expression).map_err(|_| example())?;
        if value.is_finite() { Ok((name, value)) } else { Err(example()) }
    });
    read.collect()
}
