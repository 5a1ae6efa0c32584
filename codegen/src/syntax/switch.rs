//! `while("phi > 0")`: a contact that is there while a condition holds.

use syn::parse::ParseStream;
use syn::{Expr, ExprLit, Lit, LitStr, parenthesized};

/// What a condition compares, the greater side first, as expressions of the declaration; none of what only a run can read.
pub(super) fn sides(quoted: &LitStr) -> Option<[Expr; 2]> {
    let text = quoted.value();
    let (greater, less) = match text.split_once('>') {
        Some(sides) => sides,
        None => text.split_once('<').map(|(less, greater)| (greater, less))?,
    };
    let side = |text: &str| LitStr::new(&with_rates(text), quoted.span()).parse::<Expr>().ok();
    side(greater).zip(side(less)).map(Into::into)
}

/// `phi'` of runs is `rate(phi)` of declarations.
fn with_rates(text: &str) -> String {
    let mut parts = text.split('\'').peekable();
    let mut written = String::new();
    while let Some(part) = parts.next() {
        if parts.peek().is_none() {
            return written + part;
        }
        let named = |letter: char| letter.is_alphanumeric() || letter == '_';
        let start = part.trim_end_matches(named).len();
        written += &format!("{}rate({})", &part[..start], &part[start..]);
    }
    written
}

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
