//! `while("phi > 0")`: a contact, a spring or a load that is there while a condition holds;
//! `breaks("N(O) > f")`: a contact that is gone for good once one does.

use syn::parse::ParseStream;
use syn::{Expr, ExprLit, Lit, LitStr, parenthesized};

/// The condition that something is there on, or breaks on.
#[derive(Clone, Debug)]
pub struct SwitchDeclaration {
    /// As conditions of runs are written.
    pub condition: String,
    /// What it compares, where both are expressions of a declaration too.
    pub sides: Option<[Expr; 2]>,
}

impl SwitchDeclaration {
    /// From the value that the option has been parsed to.
    pub(super) fn from_value(value: Expr) -> Option<Self> {
        match value {
            Expr::Lit(ExprLit { lit: Lit::Str(quoted), .. }) => {
                Some(Self { sides: sides(&quoted), condition: quoted.value() })
            }
            _ => None,
        }
    }
}

/// What a condition compares, the greater side first, as expressions of the declaration; none of
/// what only a run can read.
fn sides(quoted: &LitStr) -> Option<[Expr; 2]> {
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
pub(super) fn condition(name: &str, input: ParseStream) -> syn::Result<Expr> {
    let quoted = |error: syn::Error| {
        syn::Error::new(error.span(), format!("write the condition in quotes: `{name}(\"phi > 0\")`"))
    };
    if !input.peek(syn::token::Paren) {
        return Err(quoted(input.error("")));
    }
    let content;
    parenthesized!(content in input);
    let quoted: LitStr = content.parse().map_err(quoted)?;
    if !content.is_empty() {
        return Err(content.error("there is one condition"));
    }
    let text = quoted.value();
    if text.matches(['<', '>']).count() != 1 || text.contains('=') {
        let text = format!("a switch compares two sides by `<` or `>`: `{name}(\"phi > 0\")`");
        return Err(syn::Error::new(quoted.span(), text));
    }
    Ok(Expr::Lit(ExprLit { attrs: Vec::new(), lit: Lit::Str(quoted) }))
}
