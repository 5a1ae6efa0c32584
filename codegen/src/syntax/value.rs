//! `#[value = 9.81]`, `#[value(75, unit = "deg")]` on a field: what a run takes where nothing else
//! is said.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::spanned::Spanned;
use syn::{Attribute, BinOp, Expr, ExprBinary, ExprUnary, Field, Ident, Lit, LitStr, Meta, Token, UnOp};

use super::Description;
use crate::units::{self, Unit};

/// The default value of a parameter in the coherent unit, and what it is measured in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DefaultValue {
    /// None where the declaration gives none.
    pub value: Option<f64>,
    /// The coherent unit, as written where that is one; empty where none is given.
    pub unit: String,
    /// The parameter where its unit is written, and powers of length, time and mass.
    pub(crate) measured: Option<(Expr, [i8; 3])>,
}

pub(super) const NAME: &str = "value";
const EXAMPLE: &str = "(for example `#[value = 9.81]` or `#[value(9.81, unit = \"m/s²\")]`)";

/// Reads that of a field.
pub(super) fn parse(field: &Field, description: &mut Description) {
    let mut given = field.attrs.iter().filter(|attribute| attribute.path().is_ident(NAME));
    let read = given.next().map(|attribute| value(attribute, field)).transpose();
    if let Some(second) = given.next() {
        description.report.over(second, "a parameter has one value");
    }
    let found = read.unwrap_or_else(|error| {
        description.report.add_message(error.span(), format!("{error} {EXAMPLE}"));
        None
    });
    description.values.push(found.unwrap_or_default());
}

/// Reports it on the struct.
pub(super) fn misplaced(attribute: &Attribute, description: &mut Description) {
    if attribute.path().is_ident(NAME) {
        description.report.over(attribute.path(), "`value` belongs to one parameter; put it on its field");
    }
}

fn value(attribute: &Attribute, field: &Field) -> syn::Result<DefaultValue> {
    match &attribute.meta {
        Meta::NameValue(meta) => {
            Ok(DefaultValue { value: Some(finite(&meta.value)?), ..DefaultValue::default() })
        }
        Meta::List(list) => list.parse_args_with(|input: ParseStream| parenthesised(input, field)),
        Meta::Path(path) => Err(syn::Error::new_spanned(path, "the value is missing")),
    }
}

fn parenthesised(input: ParseStream, field: &Field) -> syn::Result<DefaultValue> {
    let mut found = DefaultValue { value: Some(finite(&input.parse()?)?), ..DefaultValue::default() };
    if input.parse::<Option<Token![,]>>()?.is_some() && !input.is_empty() {
        let name: Ident = input.parse()?;
        if name != "unit" {
            return Err(syn::Error::new(name.span(), "expected `unit = \"…\"`"));
        }
        input.parse::<Token![=]>()?;
        found.measure(&input.parse()?, field)?;
        input.parse::<Option<Token![,]>>()?;
    }
    match input.is_empty() {
        true => Ok(found),
        false => Err(input.error("expected nothing more")),
    }
}

impl DefaultValue {
    /// Converts the value from a unit.
    fn measure(&mut self, text: &LitStr, field: &Field) -> syn::Result<()> {
        let unit = Unit::parse(&text.value()).map_err(|wrong| syn::Error::new(text.span(), wrong))?;
        self.value = self.value.map(|value| unit.convert(value));
        self.unit = if unit.is_coherent() { text.value() } else { unit.coherent() };
        let [length, time, mass, _] = unit.powers();
        self.measured = field.ident.clone().map(|mut name| {
            name.set_span(text.span());
            (syn::parse_quote!(#name), [length, time, mass])
        });
        Ok(())
    }
}

fn finite(expression: &Expr) -> syn::Result<f64> {
    let value = number(expression)?;
    let what = || syn::Error::new_spanned(expression, format!("the value is {value}, which is no number"));
    if value.is_finite() { Ok(value) } else { Err(what()) }
}

/// Refuses `500mm`: a number is in the units of the model, and what stands behind it would be lost.
pub(crate) fn without_unit(literal: &Lit) -> syn::Result<()> {
    let suffix = match literal {
        Lit::Int(x) => x.suffix(),
        Lit::Float(x) => x.suffix(),
        _ => "",
    };
    let text = || format!("`{suffix}` after a number has no meaning; write the number alone");
    if matches!(suffix, "" | "f64") { Ok(()) } else { Err(syn::Error::new(literal.span(), text())) }
}

/// The value of a text, in the coherent unit, and the powers of length, time, mass and angle of the
/// unit behind it.
///
/// # Errors
/// `wrong` where it is no number, or what is wrong with its unit.
pub(super) fn parse_measured(
    text: &str,
    span: Span,
    wrong: impl Fn() -> syn::Error,
) -> syn::Result<(f64, Option<[i8; 4]>)> {
    let unknown = |what: String| syn::Error::new(span, format!("`{}`: {what}", text.trim()));
    let (digits, unit) = units::split(text).map_err(unknown)?;
    let value = syn::parse_str(digits).and_then(|expression| number(&expression)).map_err(|_| wrong())?;
    let value = unit.as_ref().map_or(value, |unit| unit.convert(value));
    if value.is_finite() { Ok((value, unit.map(|unit| unit.powers()))) } else { Err(wrong()) }
}

/// The value of an expression of numbers and π.
pub(super) fn number(expression: &Expr) -> syn::Result<f64> {
    let wrong =
        |span: Span| syn::Error::new(span, "a value is a number, or an expression of numbers and `pi`");
    match expression {
        Expr::Lit(literal) => {
            without_unit(&literal.lit)?;
            match &literal.lit {
                Lit::Float(x) => x.base10_parse(),
                Lit::Int(x) => x.base10_parse(),
                _ => Err(wrong(literal.span())),
            }
        }
        Expr::Paren(inner) => number(&inner.expr),
        Expr::Group(inner) => number(&inner.expr),
        Expr::Path(path) if path.path.is_ident("pi") => Ok(core::f64::consts::PI),
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => Ok(-number(expr)?),
        Expr::Binary(ExprBinary { left, op, right, .. }) => {
            let (a, b) = (number(left)?, number(right)?);
            match op {
                BinOp::Add(_) => Ok(a + b),
                BinOp::Sub(_) => Ok(a - b),
                BinOp::Mul(_) => Ok(a * b),
                BinOp::Div(_) => Ok(a / b),
                _ => Err(wrong(op.span())),
            }
        }
        other => Err(wrong(other.span())),
    }
}
