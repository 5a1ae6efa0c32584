//! `while("phi > 0")`: a contact that is there while a condition holds.

use syn::parse::ParseStream;
use syn::{Expr, ExprLit, Lit, LitStr, parenthesized};

/// The condition's text between the parentheses, written as conditions of runs are.
pub(super) fn switch(input: ParseStream) -> syn::Result<Expr> {
    let content;
    parenthesized!(content in input);
    let quoted: LitStr = content.parse().map_err(|error| {
        syn::Error::new(error.span(), "write the condition in quotes: `while(\"phi > 0\")`")
    })?;
    if !content.is_empty() {
        return Err(content.error("a contact has one condition"));
    }
    let text = quoted.value();
    if text.matches(['<', '>']).count() != 1 || text.contains('=') {
        let text = "a contact is there while one side is less than the other: `while(\"phi > 0\")`";
        return Err(syn::Error::new(quoted.span(), text));
    }
    Ok(Expr::Lit(ExprLit { attrs: Vec::new(), lit: Lit::Str(quoted) }))
}
