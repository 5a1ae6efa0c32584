//! Tokens as texts, brackets among them.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// All tokens in a row.
pub(super) fn flat(stream: TokenStream) -> Vec<String> {
    let mut tokens = Vec::new();
    for token in stream {
        match token {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                tokens.push(open.to_owned());
                tokens.extend(flat(group.stream()));
                tokens.push(close.to_owned());
            }
            other => tokens.push(other.to_string()),
        }
    }
    tokens
}

/// The tokens with every bracket closed, and none that was not open.
pub(super) fn balanced(tokens: Vec<String>) -> Vec<String> {
    let (mut open, mut kept) = (Vec::new(), Vec::with_capacity(tokens.len()));
    for token in tokens {
        match token.as_str() {
            "(" => open.push(")"),
            "[" => open.push("]"),
            "{" => open.push("}"),
            ")" | "]" | "}" => {
                if open.last() != Some(&token.as_str()) {
                    continue;
                }
                open.pop();
            }
            _ => {}
        }
        kept.push(token);
    }
    kept.extend(open.into_iter().rev().map(str::to_owned));
    kept
}
