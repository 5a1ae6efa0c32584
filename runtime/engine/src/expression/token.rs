//! Text to tokens.

use core::fmt;

use super::OutputError;

/// A word of the expression language.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token {
    Number(f64),
    /// A name with the number of its primes.
    Name(String, usize),
    Symbol(char),
    End,
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::End => f.write_str("the end"),
            token => write!(f, "`{}`", token.text()),
        }
    }
}

impl Token {
    /// As it is written.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Number(x) => x.to_string(),
            Self::Name(name, primes) => format!("{name}{}", "'".repeat(*primes)),
            Self::Symbol(c) => c.to_string(),
            Self::End => String::new(),
        }
    }
}

/// Tokens with their columns; the last is [`Token::End`].
pub(super) fn tokens(text: &str) -> Result<Vec<(Token, usize)>, OutputError> {
    let characters: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < characters.len() {
        let column = at + 1;
        let token = match characters[at] {
            c if c.is_whitespace() => {
                at += 1;
                continue;
            }
            '.' if matches!(tokens.last(), Some((Token::Name(..), _))) => {
                return Err(unexpected(
                    "a name without a prefix, as `sin(x)` or `pi`",
                    "`.`".to_owned(),
                    column,
                ));
            }
            c if c.is_ascii_digit() || c == '.' => number(&characters, &mut at)?,
            c if c.is_alphabetic() || c == '_' => name(&characters, &mut at),
            '°' => {
                at += 1;
                Token::Name("deg".to_owned(), 0)
            }
            // `==`, `<=` and `>=`: equality makes no difference to when a condition becomes true.
            c @ ('=' | '<' | '>') if characters.get(at + 1) == Some(&'=') => {
                at += 2;
                Token::Symbol(c)
            }
            '*' if characters.get(at + 1) == Some(&'*') => {
                at += 2;
                Token::Symbol('^')
            }
            '!' => {
                let expected = "`=`, `<` or `>`: a condition is met when it becomes true";
                return Err(unexpected(expected, "`!`".to_owned(), column));
            }
            c @ ('&' | '|') if characters.get(at + 1) == Some(&c) => {
                at += 2;
                Token::Name(if c == '&' { "and" } else { "or" }.to_owned(), 0)
            }
            c @ ('+' | '-' | '*' | '/' | '^' | '(' | ')' | ',' | '=' | '<' | '>') => {
                at += 1;
                Token::Symbol(c)
            }
            c => return Err(unexpected("an expression", format!("`{c}`"), column)),
        };
        tokens.push((token, column));
    }
    tokens.push((Token::End, characters.len() + 1));
    Ok(tokens)
}

pub(super) fn unexpected(expected: &'static str, found: String, column: usize) -> OutputError {
    OutputError::Unexpected { expected, found, column }
}

fn number(characters: &[char], at: &mut usize) -> Result<Token, OutputError> {
    let start = *at;
    let digits = |at: &mut usize| {
        while characters.get(*at).is_some_and(|c| c.is_ascii_digit() || *c == '.') {
            *at += 1;
        }
    };
    digits(at);
    if matches!(characters.get(*at), Some('e' | 'E')) {
        let sign = usize::from(matches!(characters.get(*at + 1), Some('+' | '-')));
        if characters.get(*at + 1 + sign).is_some_and(char::is_ascii_digit) {
            *at += 1 + sign;
            digits(at);
        }
    }
    let text: String = characters[start..*at].iter().collect();
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(Token::Number(value)),
        _ => Err(unexpected("a number", format!("`{text}`"), start + 1)),
    }
}

fn name(characters: &[char], at: &mut usize) -> Token {
    let start = *at;
    while characters.get(*at).is_some_and(|c| c.is_alphanumeric() || *c == '_') {
        *at += 1;
    }
    let name = characters[start..*at].iter().collect();
    let primes = characters[*at..].iter().take_while(|c| **c == '\'').count();
    *at += primes;
    Token::Name(name, primes)
}
