//! Options `, name = value` after the head of an attribute.

use std::ops::RangeInclusive;

use proc_macro2::TokenTree;
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Expr, Ident, Lit, Token};

use super::switch::{self, SwitchDeclaration};
use super::{Pair, unknown};

/// What friction is asked for by instead of `friction = mu`.
const FRICTION: [&str; 5] = ["mu", "coulomb", "mu_s", "mu_k", "rough"];

/// What is said of a unit behind a number.
const UNIT: &str = "numbers of a declaration have no unit, an angle of 10° is `10 * pi / 180`; a parameter may have one, `#[value(1, unit = \"kg\")]`";

/// Options that are conditions.
pub(super) const CONDITIONS: [&str; 2] = ["while", "breaks"];

/// What is said of a `while` on what is always there.
const SWITCHED: &str = "`while` is for what can be there or not: supports, threads, the `stops` of a slider, springs, torsions, forces, \
                        couples, drives, pins to the ground and welds";

/// What is said of a `breaks` on what does not.
const BREAKING: &str = "`breaks` is for what bears a reaction: supports, threads, limits, the `stops` of a slider, drives, pins to the ground \
                        and welds; what acts by a law of its own has `while`";

/// What is said of friction where there is no contact force.
const RUBBING: &str = "friction acts at supports, in sliders and in hinges; there is none here";

/// What is said of an option of contacts where there is none.
fn misplaced(name: &str) -> Option<&'static str> {
    match name {
        "while" => Some(SWITCHED),
        "breaks" => Some(BREAKING),
        "friction" | "static" => Some(RUBBING),
        _ => None,
    }
}

/// Refuses options of contacts behind what has none, at their place.
pub(super) fn refuse_contact_options(input: ParseStream) -> syn::Result<()> {
    let ahead = input.fork();
    if ahead.parse::<Token![,]>().is_err() {
        return Ok(());
    }
    let Ok(name) = ahead.call(Ident::parse_any) else { return Ok(()) };
    let is_option = ahead.peek(Token![=]) || ahead.peek(syn::token::Paren) && is_condition(&name);
    match misplaced(&name.to_string()).filter(|_| is_option) {
        Some(text) => Err(syn::Error::new(name.span(), text)),
        None => Ok(()),
    }
}

/// Whether the next option is a condition, or written as one.
pub(super) fn is_condition_ahead(input: ParseStream) -> bool {
    let ahead = input.fork();
    let name = ahead.parse::<Token![,]>().and_then(|_| ahead.call(Ident::parse_any));
    name.is_ok_and(|name| is_condition(&name) || ahead.peek(syn::token::Paren))
}

fn is_condition(name: &Ident) -> bool {
    CONDITIONS.iter().any(|word| name == word)
}

/// Options in the order written; a flag has no value.
pub(super) struct Options(Vec<(Ident, Option<Expr>)>);

impl Options {
    /// Reads options of the given names up to the end of the attribute.
    pub fn parse(input: ParseStream, allowed: &[&str]) -> syn::Result<Self> {
        Self::with_flags(input, allowed, &[])
    }

    /// Reads options and flags of the given names up to the end of the attribute.
    pub fn with_flags(input: ParseStream, allowed: &[&str], flags: &[&str]) -> syn::Result<Self> {
        let mut given: Vec<(Ident, Option<Expr>)> = Vec::new();
        while !input.is_empty() {
            // A name with `=` behind it, or a flag, is the next option: a comma is missing.
            let is_flag =
                flags.iter().any(|flag| input.fork().parse::<Ident>().is_ok_and(|name| name == flag));
            let is_unit = input.peek(Ident) && !input.peek2(Token![=]) && !is_flag;
            if is_unit && given.last().is_some_and(|(_, value)| value.as_ref().is_some_and(ends_in_number)) {
                return Err(input.error(UNIT));
            }
            input.parse::<Token![,]>()?;
            if input.is_empty() {
                break;
            }
            // `static` is a word of the language.
            let name = input.call(Ident::parse_any)?;
            let wrong = |text: String| Err(syn::Error::new(name.span(), text));
            let flag = flags.iter().any(|flag| name == flag);
            if !flag && !allowed.iter().any(|a| name == a) {
                if name == "rough" && allowed.contains(&"friction") && !allowed.contains(&"radius") {
                    return wrong("a point that never slips along its guide is not a slider; hold it by `pin` or by a hinge".to_owned());
                }
                if FRICTION.iter().any(|word| name == word) && allowed.contains(&"friction") {
                    let rough = match flags.contains(&"rough") {
                        true => "; a contact that never slips has the flag `rough`",
                        false => "",
                    };
                    return wrong(format!(
                        "there is no option `{name}`: Coulomb friction is `friction = mu`, with `static = mu_s` where that \
                         differs{rough}"
                    ));
                }
                if let Some(text) = misplaced(&name.to_string()) {
                    return wrong(text.to_owned());
                }
                return wrong(unknown("option", &name, allowed.iter().chain(flags).copied()));
            }
            if given.iter().any(|(other, _)| *other == name) {
                return wrong(format!("`{name}` is given twice"));
            }
            if flag && input.peek(Token![=]) {
                return wrong(format!("`{name}` has no value; write `{name}` alone"));
            }
            let value = match () {
                () if flag => None,
                () if is_condition(&name) => Some(switch::condition(&name.to_string(), input)?),
                () => Some(assigned(input)?),
            };
            given.push((name, value));
        }
        Ok(Self(given))
    }

    /// Whether a flag is given.
    pub fn flag(&self, name: &str) -> bool {
        self.0.iter().any(|(given, _)| given == name)
    }

    /// Where an option or a flag is given.
    pub fn written(&self, name: &str) -> Option<&Ident> {
        self.0.iter().map(|(given, _)| given).find(|given| *given == name)
    }

    /// Takes the value of an option.
    pub fn take(&mut self, name: &str) -> Option<Expr> {
        let index = self.0.iter().position(|(given, _)| given == name)?;
        self.0.remove(index).1
    }

    /// Takes the condition that something is there on.
    pub fn take_switch(&mut self) -> Option<SwitchDeclaration> {
        self.take("while").and_then(SwitchDeclaration::from_value)
    }

    /// Takes the condition that something breaks on.
    pub fn take_break(&mut self) -> Option<SwitchDeclaration> {
        self.take("breaks").and_then(SwitchDeclaration::from_value)
    }

    /// Takes the value of an option that `owner` cannot do without.
    pub fn require(&mut self, name: &str, owner: &Ident) -> syn::Result<Expr> {
        let missing = || syn::Error::new(owner.span(), format!("`{owner}` has no {name}; add `{name} = …`"));
        self.take(name).ok_or_else(missing)
    }

    /// Takes the value of an option that is a name.
    pub fn take_name(&mut self, name: &str) -> syn::Result<Option<Ident>> {
        self.take(name).map(|value| identifier(&value)).transpose()
    }
}

fn ends_in_number(value: &Expr) -> bool {
    matches!(value.to_token_stream().into_iter().last(), Some(TokenTree::Literal(_)))
}

/// `= value`.
pub(super) fn assigned(input: ParseStream) -> syn::Result<Expr> {
    input.parse::<Token![=]>()?;
    input.parse()
}

/// What follows a word in parentheses; nothing without them.
pub(super) fn arguments(input: ParseStream) -> syn::Result<Vec<Expr>> {
    if !input.peek(syn::token::Paren) {
        return Ok(Vec::new());
    }
    let content;
    syn::parenthesized!(content in input);
    Ok(content.parse_terminated(Expr::parse, Token![,])?.into_iter().collect())
}

/// `AB` or `AB, CD`, then perhaps options.
pub(super) fn one_or_two_names(input: ParseStream) -> syn::Result<(Ident, Option<Ident>)> {
    let first = input.parse()?;
    let option = input.peek3(Token![=]) || input.peek3(syn::token::Paren);
    if !input.peek(Token![,]) || !input.peek2(Ident) || option {
        return Ok((first, None));
    }
    input.parse::<Token![,]>()?;
    Ok((first, Some(input.parse()?)))
}

/// An expression out of the invisible group that a macro by example puts it in.
fn bare(value: &Expr) -> &Expr {
    match value {
        Expr::Group(group) => bare(&group.expr),
        other => other,
    }
}

/// A whole number.
pub(super) fn whole(name: &str, value: &Expr, range: RangeInclusive<usize>) -> syn::Result<usize> {
    let literal = match bare(value) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(int) => int.base10_parse().ok(),
            _ => None,
        },
        _ => None,
    };
    let text = format!("`{name}` must be a whole number from {} to {}", range.start(), range.end());
    literal.filter(|n| range.contains(n)).ok_or_else(|| syn::Error::new_spanned(value, text))
}

/// The expression as a plain name.
pub(super) fn identifier(value: &Expr) -> syn::Result<Ident> {
    match bare(value) {
        Expr::Path(path) if path.path.get_ident().is_some() => path.path.require_ident().cloned(),
        other => Err(syn::Error::new_spanned(other, "expected a name")),
    }
}

/// The expression as a position `(x, y)`.
pub(super) fn pair(value: Expr) -> syn::Result<Pair> {
    let wrong = |other: &Expr| syn::Error::new_spanned(other, "expected a position `(x, y)`");
    match value {
        Expr::Tuple(tuple) if tuple.elems.len() == 2 => {
            let elements: Vec<Expr> = tuple.elems.iter().cloned().collect();
            elements.try_into().map_err(|_| wrong(&Expr::Tuple(tuple)))
        }
        other => Err(wrong(&other)),
    }
}

/// One number, or two in parentheses.
pub(super) fn one_or_two(value: Expr) -> syn::Result<Vec<Expr>> {
    match value {
        Expr::Tuple(_) => Ok(pair(value)?.into()),
        other => Ok(vec![other]),
    }
}
