//! `#[run(start = "phi = 0.1, phi' = 2", until = "phi = pi/2", limit =
//! 10)]`: the run that is made where nothing else is said.

use proc_macro2::Span;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, ExprLit, Ident, Lit, LitStr, Token};

use super::value;

/// The run without options; what is asked for is read when it is run.
#[derive(Clone, Debug, Default)]
pub struct RunDeclaration {
    /// Where the start is written.
    pub span: Option<Span>,
    /// Coordinates and rates (`phi'`) at the start; none for the nominal figure.
    pub start: Vec<StartValue>,
    /// Conditions to stop at, whichever comes first.
    pub until: Vec<String>,
    /// The latest end.
    pub limit: Option<f64>,
}

/// The value of a coordinate or rate at the start.
#[derive(Clone, Debug)]
pub struct StartValue {
    /// Its name.
    pub name: String,
    /// Its value in the coherent unit.
    pub value: f64,
    /// Powers of length, time, mass and angle of the unit behind it.
    pub(crate) powers: Option<[i8; 4]>,
}

impl RunDeclaration {
    /// Whether it says nothing.
    pub fn is_empty(&self) -> bool {
        self.start.is_empty() && self.until.is_empty() && self.limit.is_none()
    }
}

/// Reads it.
pub(super) fn parse(input: ParseStream, known: &mut Option<RunDeclaration>) -> syn::Result<()> {
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
                let limit = read_time(&given)?;
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

/// `10`, `"500 ms"`.
fn read_time(given: &Expr) -> syn::Result<f64> {
    let Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) = given else { return value::number(given) };
    let wrong = || syn::Error::new(text.span(), "the latest end is a time: `10` or `500 ms`");
    match value::parse_measured(&text.value(), text.span(), wrong)? {
        (_, Some(powers)) if powers != [0, 1, 0, 0] => Err(wrong()),
        (limit, _) => Ok(limit),
    }
}

/// `phi = 80 deg, phi' = 2`.
fn start(text: &LitStr) -> syn::Result<Vec<StartValue>> {
    let wrong = |what: String| syn::Error::new(text.span(), what);
    let given = text.value();
    let parts = given.split(',').filter(|part| !part.trim().is_empty());
    let mut known = Vec::new();
    let read = parts.map(|part| {
        let example =
            || wrong(format!("`{}` should be a coordinate or rate with its value: `phi = 0.1`", part.trim()));
        let (name, value) = part.split_once('=').ok_or_else(example)?;
        let name = name.trim().to_owned();
        if known.contains(&name) {
            return Err(wrong(format!("`{name}` is given twice; remove one")));
        }
        known.push(name.clone());
        let (value, powers) = value::parse_measured(value, text.span(), example)?;
        Ok(StartValue { name, value, powers })
    });
    read.collect()
}
