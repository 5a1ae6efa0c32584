//! Options `, name = value` after the head of an attribute.

use syn::parse::ParseStream;
use syn::{Expr, Ident, Token};

use super::{Pair, unknown};

/// Options in the order written.
pub(super) struct Options(Vec<(Ident, Expr)>);

impl Options {
    /// Reads options of the given names up to the end of the attribute.
    pub fn read(input: ParseStream, allowed: &[&str]) -> syn::Result<Self> {
        let mut given: Vec<(Ident, Expr)> = Vec::new();
        while !input.is_empty() {
            input.parse::<Token![,]>()?;
            if input.is_empty() {
                break;
            }
            let name: Ident = input.parse()?;
            if !allowed.iter().any(|a| name == a) {
                return Err(syn::Error::new(name.span(), unknown("option", &name, allowed.iter().copied())));
            }
            if given.iter().any(|(other, _)| *other == name) {
                return Err(syn::Error::new(name.span(), format!("`{name}` is given twice")));
            }
            input.parse::<Token![=]>()?;
            given.push((name, input.parse()?));
        }
        Ok(Self(given))
    }

    /// Takes the value of an option.
    pub fn take(&mut self, name: &str) -> Option<Expr> {
        let index = self.0.iter().position(|(given, _)| given == name)?;
        Some(self.0.remove(index).1)
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

/// The expression as a plain name.
pub(super) fn identifier(value: &Expr) -> syn::Result<Ident> {
    match value {
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
