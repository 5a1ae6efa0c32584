//! Limits of what is read: beyond them an expression would exhaust the stack of whoever reads it.
//!
//! How deep the tree of an expression can be is bounded by the tokens on the way to its deepest
//! part: for each level of brackets those between two commas or semicolons.

use crate::algebra::work;
use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

/// Own code is emitted for at most this many contact sets unless the declaration says otherwise.
pub const CLOSED_FORMS: usize = 64;

/// Levels of brackets.
const LEVELS: usize = 48;

/// Tokens on the way to the deepest part of an expression.
const LENGTH: usize = 480;

/// Tokens of a declaration.
const TOKENS: usize = 100_000;

/// Term operations of a derivation up to the equations of motion.
pub(crate) const WORK: u64 = 5_000_000;

/// Term operations of the text of equations: those of a chain of 512 bars.
pub(crate) const WORK_OF_TEXT: u64 = 4 * WORK;

/// What is told of a declaration that takes more.
pub(crate) const TOO_MUCH: &str = "this takes too much algebra, millions of operations on terms; make parameters of powers of sums \
                                   and of products of sums, or declare less";

/// Mistakes that are told of one declaration.
const MISTAKES: usize = 50;

/// The first mistakes, and how many there are beyond them.
pub(crate) fn first_mistakes(errors: syn::Error) -> syn::Error {
    let more = errors.clone().into_iter().count().saturating_sub(MISTAKES);
    if more == 0 {
        return errors;
    }
    let mut first = errors.into_iter().take(MISTAKES + 1).collect::<Vec<_>>();
    let last = first.pop().map(|next| syn::Error::new(next.span(), format!("and {more} more mistakes")));
    let told = first.into_iter().chain(last).reduce(|mut all, error| {
        all.combine(error);
        all
    });
    told.unwrap_or_else(|| syn::Error::new(Span::call_site(), "mistakes"))
}

/// Runs what derives with a budget of term operations; where it is spent that alone is told, once.
pub(crate) fn within_work<T>(
    most: u64,
    place: Span,
    derive: impl FnOnce() -> syn::Result<T>,
) -> syn::Result<T> {
    work::limited(most, || {
        let result = derive();
        if !work::is_spent() {
            return result;
        }
        let told = result.err().into_iter().flatten().find(|error| error.to_string() == TOO_MUCH);
        Err(told.unwrap_or_else(|| syn::Error::new(place, TOO_MUCH)))
    })
}

/// What is inside a pair of brackets, and what lies on the way to it.
struct Inside {
    tokens: TokenStream,
    levels: usize,
    length: usize,
    /// Whether nobody reads it as expressions: the body of a macro.
    opaque: bool,
}

/// Refuses what is too deep or too long.
///
/// # Errors
/// At the place where a limit is passed.
pub fn check(tokens: &TokenStream) -> syn::Result<()> {
    within(tokens, usize::MAX)
}

/// The same for a single declaration, which has a limit as a whole.
pub(crate) fn check_declaration(tokens: &TokenStream) -> syn::Result<()> {
    within(tokens, TOKENS)
}

fn within(tokens: &TokenStream, most: usize) -> syn::Result<()> {
    let mut waiting = vec![Inside { tokens: tokens.clone(), levels: 0, length: 0, opaque: false }];
    let mut count = 0;
    while let Some(inside) = waiting.pop() {
        let tokens: Vec<TokenTree> = inside.tokens.clone().into_iter().collect();
        count += tokens.len();
        if count > most {
            let text = format!("a declaration has at most {most} tokens");
            return Err(syn::Error::new(span(&tokens), text));
        }
        runs(&tokens, &inside, &mut waiting)?;
    }
    Ok(())
}

/// Checks what stands between commas, and leaves what is in brackets for later.
fn runs(tokens: &[TokenTree], inside: &Inside, waiting: &mut Vec<Inside>) -> syn::Result<()> {
    let mut start = 0;
    for end in 0..=tokens.len() {
        if end < tokens.len() && !ends(tokens, start, end) {
            continue;
        }
        let run = &tokens[start..end];
        start = end;
        let length = inside.length + run.len();
        if length > LENGTH && !inside.opaque {
            let text = format!(
                "this is too long: more than {LENGTH} tokens without a comma; give its parts names by `#[constant(…)]`"
            );
            return Err(syn::Error::new(span(run), text));
        }
        for (i, token) in run.iter().enumerate() {
            let TokenTree::Group(group) = token else { continue };
            let levels = inside.levels + 1;
            if levels > LEVELS {
                return Err(syn::Error::new(
                    group.span_open(),
                    format!("more than {LEVELS} nested brackets"),
                ));
            }
            let opaque = inside.opaque || is_macro(&run[..i]);
            waiting.push(Inside { tokens: group.stream(), levels, length, opaque });
        }
    }
    Ok(())
}

/// Whether what begins at `start` has ended before the token at `end`.
fn ends(tokens: &[TokenTree], start: usize, end: usize) -> bool {
    let Some(last) = tokens[start..end].last() else { return false };
    match last {
        TokenTree::Punct(mark) => matches!(mark.as_char(), ',' | ';'),
        TokenTree::Group(group) => match group.delimiter() {
            Delimiter::Brace => begins_anew(&tokens[end]),
            Delimiter::Bracket => end >= 2 && is_mark(&tokens[end - 2], '#'),
            _ => false,
        },
        _ => false,
    }
}

/// Whether a token after braces begins something else.
fn begins_anew(token: &TokenTree) -> bool {
    match token {
        TokenTree::Ident(name) => name != "else" && name != "as",
        token => is_mark(token, '#'),
    }
}

/// `name!` or `macro_rules! name`.
fn is_macro(before: &[TokenTree]) -> bool {
    match before {
        [.., mark] if is_mark(mark, '!') => true,
        [.., mark, TokenTree::Ident(_)] => is_mark(mark, '!'),
        _ => false,
    }
}

fn is_mark(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

fn span(tokens: &[TokenTree]) -> Span {
    tokens.first().map_or_else(Span::call_site, TokenTree::span)
}

#[cfg(test)]
mod tests;
