//! Reads printed formulas with numbers in place of their symbols, as one would read them aloud:
//! from the left, a power before a product, a product before a sum; below a stroke stands one
//! factor, behind a function one symbol, a multiple of one, or what has brackets.

use std::iter::Peekable;
use std::vec::IntoIter;

/// Symbols as they are printed, and their values.
pub type Values = Vec<(String, f64)>;

#[derive(Clone, Debug)]
enum Token {
    Number(f64),
    /// The value of a symbol.
    Symbol(f64),
    Function(fn(f64) -> f64),
    Raised(i32),
    Sign(char),
    Stroke,
    Open,
    Close,
}

/// The value of a formula in text.
pub fn read_text(text: &str, values: &Values) -> Result<f64, String> {
    evaluate(text_tokens(text, values)?).map_err(|error| format!("{error}: {text}"))
}

/// The value of a formula in LaTeX.
pub fn read_latex(latex: &str, values: &Values) -> Result<f64, String> {
    evaluate(latex_tokens(latex, values)?).map_err(|error| format!("{error}: {latex}"))
}

type Function = fn(f64) -> f64;
const FUNCTIONS: [(&str, Function); 3] = [("sin", f64::sin), ("cos", f64::cos), ("tan", f64::tan)];
const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const LOWERED: &str = "₀₁₂₃₄₅₆₇₈₉";
const FRACTIONS: [(char, f64, f64); 15] = [
    ('½', 1.0, 2.0),
    ('⅓', 1.0, 3.0),
    ('⅔', 2.0, 3.0),
    ('¼', 1.0, 4.0),
    ('¾', 3.0, 4.0),
    ('⅕', 1.0, 5.0),
    ('⅖', 2.0, 5.0),
    ('⅗', 3.0, 5.0),
    ('⅘', 4.0, 5.0),
    ('⅙', 1.0, 6.0),
    ('⅚', 5.0, 6.0),
    ('⅛', 1.0, 8.0),
    ('⅜', 3.0, 8.0),
    ('⅝', 5.0, 8.0),
    ('⅞', 7.0, 8.0),
];

/// The longest symbol that stands here, not in the middle of a longer word.
fn symbol<'a>(rest: &str, values: &'a Values) -> Option<&'a (String, f64)> {
    let ends = |name: &str| {
        let next = rest[name.len()..].chars().next();
        let goes_on = |c: char| c.is_alphanumeric() || "_'\u{307}\u{308}\u{20db}\u{20dc}".contains(c);
        let word = name.ends_with(|c: char| c.is_alphabetic());
        !next.is_some_and(|c| if word { goes_on(c) } else { c == '_' || c == '\'' } && !RAISED.contains(c))
    };
    let found = values.iter().filter(|(name, _)| rest.starts_with(name.as_str()) && ends(name));
    found.max_by_key(|(name, _)| name.len())
}

/// The digits that a text begins with, of which the first is `digits[0]`, and what follows.
fn digits<'a>(text: &'a str, digits: &str) -> Option<(u32, &'a str)> {
    let value = |c: char| digits.chars().position(|digit| digit == c).map(|k| k as u32);
    let length: usize = text.chars().take_while(|&c| value(c).is_some()).map(char::len_utf8).sum();
    let (number, rest) = text.split_at(length);
    (length > 0).then(|| (number.chars().filter_map(value).fold(0, |n, digit| 10 * n + digit), rest))
}

/// A plain number that a text begins with, and what follows.
fn plain(text: &str) -> Option<(f64, &str)> {
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let (number, rest) = text.split_at(end);
    number.parse().ok().map(|number| (number, rest))
}

fn text_tokens(text: &str, values: &Values) -> Result<Vec<Token>, String> {
    let (mut tokens, mut rest) = (Vec::new(), text);
    while let Some(c) = rest.chars().next() {
        let after = &rest[c.len_utf8()..];
        let function = FUNCTIONS.iter().find(|(name, _)| {
            let word: String =
                rest.chars().take_while(|c| c.is_alphanumeric() && !RAISED.contains(*c)).collect();
            word == *name
        });
        if let Some((name, value)) = symbol(rest, values) {
            tokens.push(Token::Symbol(*value));
            rest = &rest[name.len()..];
        } else if let Some((name, function)) = function {
            tokens.push(Token::Function(*function));
            rest = &rest[name.len()..];
        } else if let Some((number, after)) = plain(rest) {
            let (sign, power) = after
                .strip_prefix("·10")
                .map_or((1, ""), |power| power.strip_prefix('⁻').map_or((1, power), |power| (-1, power)));
            let (exponent, after) = digits(power, RAISED).map_or((0, after), |(k, after)| (k as i32, after));
            tokens.push(Token::Number(number * 10f64.powi(sign * exponent)));
            rest = after;
        } else if let Some((number, after)) = digits(rest, RAISED) {
            // ¹⁄₁₂, or a power.
            let below = after.strip_prefix('⁄').and_then(|below| digits(below, LOWERED));
            tokens.push(match below {
                Some((below, _)) => Token::Number(f64::from(number) / f64::from(below)),
                None => Token::Raised(number as i32),
            });
            rest = below.map_or(after, |(_, after)| after);
        } else {
            let fraction = FRACTIONS.iter().find(|(sign, ..)| *sign == c);
            match (c, fraction) {
                (_, Some((_, above, below))) => tokens.push(Token::Number(above / below)),
                (' ' | '√', _) => {}
                ('+' | '−', _) => tokens.push(Token::Sign(c)),
                ('/', _) => tokens.push(Token::Stroke),
                ('(', _) => {
                    let root = rest.len() < text.len() && text[..text.len() - rest.len()].ends_with('√');
                    tokens.extend(root.then_some(Token::Function(f64::sqrt)));
                    tokens.push(Token::Open);
                }
                (')', _) => tokens.push(Token::Close),
                _ => return Err(format!("what is `{rest}` in {text}")),
            }
            rest = after;
        }
    }
    Ok(tokens)
}

/// What stands in braces here, and what follows.
fn braces(text: &str) -> Option<(&str, &str)> {
    let mut depth = 0;
    for (i, c) in text.char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 {
            return text.strip_prefix('{').map(|_| (&text[1..i], &text[i + 1..]));
        }
    }
    None
}

fn latex_tokens(latex: &str, values: &Values) -> Result<Vec<Token>, String> {
    let (mut tokens, mut rest) = (Vec::new(), latex);
    let unknown = |rest: &str| format!("what is `{rest}` in {latex}");
    while let Some(c) = rest.chars().next() {
        let skipped = [" ", "\\,", "\\bigl", "\\bigr", "\\Bigl", "\\Bigr"].iter();
        let command = |name: &str| rest.strip_prefix('\\').and_then(|rest| rest.strip_prefix(name));
        let function = FUNCTIONS.iter().find_map(|(name, function)| Some((command(name)?, function)));
        if let Some((name, value)) = symbol(rest, values) {
            tokens.push(Token::Symbol(*value));
            rest = &rest[name.len()..];
        } else if let Some(after) = skipped.filter_map(|skip| rest.strip_prefix(skip)).next() {
            rest = after;
        } else if let Some(after) = command("tfrac") {
            let (above, after) = braces(after).ok_or_else(|| unknown(rest))?;
            let (below, after) = braces(after).ok_or_else(|| unknown(rest))?;
            let number = |text: &str| text.parse::<f64>().map_err(|_| unknown(rest));
            tokens.push(Token::Number(number(above)? / number(below)?));
            rest = after;
        } else if let Some(after) = command("dfrac") {
            let (above, after) = braces(after).ok_or_else(|| unknown(rest))?;
            let (below, after) = braces(after).ok_or_else(|| unknown(rest))?;
            let parts = [latex_tokens(above, values)?, latex_tokens(below, values)?];
            let [above, below] = parts.map(|part| [vec![Token::Open], part, vec![Token::Close]].concat());
            tokens
                .extend([vec![Token::Open], above, vec![Token::Stroke], below, vec![Token::Close]].concat());
            rest = after;
        } else if let Some(after) = command("sqrt") {
            tokens.push(Token::Function(f64::sqrt));
            rest = after;
        } else if let Some(after) = command("cdot 10^") {
            let (exponent, after) = braces(after).ok_or_else(|| unknown(rest))?;
            let exponent: i32 = exponent.parse().map_err(|_| unknown(rest))?;
            let Some(Token::Number(number)) = tokens.last_mut() else { return Err(unknown(rest)) };
            *number *= 10f64.powi(exponent);
            rest = after;
        } else if let Some((after, function)) = function {
            tokens.push(Token::Function(*function));
            rest = after;
        } else if let Some(after) = rest.strip_prefix('^') {
            let (power, after) = braces(after).ok_or_else(|| unknown(rest))?;
            tokens.push(Token::Raised(power.parse().map_err(|_| unknown(rest))?));
            rest = after;
        } else if let Some((number, after)) = plain(rest) {
            tokens.push(Token::Number(number));
            rest = after;
        } else {
            tokens.push(match c {
                '+' => Token::Sign('+'),
                '-' => Token::Sign('−'),
                '(' | '{' => Token::Open,
                ')' | '}' => Token::Close,
                _ => return Err(unknown(rest)),
            });
            rest = &rest[c.len_utf8()..];
        }
    }
    Ok(tokens)
}

type Tokens = Peekable<IntoIter<Token>>;

fn evaluate(tokens: Vec<Token>) -> Result<f64, String> {
    let mut tokens = tokens.into_iter().peekable();
    let value = sum(&mut tokens)?;
    tokens.next().map_or(Ok(value), |left| Err(format!("{left:?} is left")))
}

fn sum(tokens: &mut Tokens) -> Result<f64, String> {
    let mut value = 0.0;
    let mut first = true;
    loop {
        let mut sign = 1.0;
        let mut signed = first;
        while let Some(Token::Sign(c)) = tokens.peek() {
            sign *= if *c == '−' { -1.0 } else { 1.0 };
            signed = true;
            tokens.next();
        }
        if !signed {
            return Ok(value);
        }
        value += sign * product(tokens)?;
        first = false;
    }
}

fn product(tokens: &mut Tokens) -> Result<f64, String> {
    let mut value = factor(tokens)?;
    loop {
        match tokens.peek() {
            Some(Token::Stroke) => {
                tokens.next();
                value /= factor(tokens)?;
            }
            Some(Token::Number(_) | Token::Symbol(_) | Token::Function(_) | Token::Open) => {
                value *= factor(tokens)?
            }
            _ => return Ok(value),
        }
    }
}

fn factor(tokens: &mut Tokens) -> Result<f64, String> {
    let value = match tokens.next() {
        Some(Token::Number(number) | Token::Symbol(number)) => number,
        Some(Token::Open) => inside(tokens)?,
        Some(Token::Function(function)) => {
            let power = power(tokens);
            let argument = match tokens.next() {
                Some(Token::Open) => inside(tokens)?,
                Some(Token::Symbol(value)) => value,
                Some(Token::Number(number)) => match tokens.next() {
                    Some(Token::Symbol(value)) => number * value,
                    other => return Err(format!("{other:?} behind {number}")),
                },
                other => return Err(format!("{other:?} behind a function")),
            };
            // A power behind is one of a root.
            return Ok(function(argument).powi(power * self::power(tokens)));
        }
        other => return Err(format!("{other:?} for a factor")),
    };
    Ok(value.powi(power(tokens)))
}

fn power(tokens: &mut Tokens) -> i32 {
    match tokens.next_if(|token| matches!(token, Token::Raised(_))) {
        Some(Token::Raised(power)) => power,
        _ => 1,
    }
}

fn inside(tokens: &mut Tokens) -> Result<f64, String> {
    let value = sum(tokens)?;
    match tokens.next() {
        Some(Token::Close) => Ok(value),
        other => Err(format!("{other:?} for a bracket")),
    }
}
