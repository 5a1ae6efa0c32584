//! Formulas as LaTeX; needs `amsmath`, which KaTeX has.

use super::line_breaks::{Height, Token, chunks};
use super::name::spelled;
use super::numbers::{Decimal, decimal, is_long};
use super::{Equation, Math, Name};

/// Letters that fit into a line of a page.
const LINE: usize = 74;
/// How many of them a line that goes on is shifted by.
const INDENT: usize = 4;

impl Math {
    /// In LaTeX, on one line; to be set within `$…$`.
    pub fn latex(&self) -> String {
        tokens(&self.normalise().tokens())
    }
}

impl Equation {
    /// In LaTeX, on one line.
    pub fn latex(&self) -> String {
        tokens(&self.normalise().tokens())
    }

    /// A row of an `align*`, or several: broken before signs where it is too long for a page.
    pub fn aligned(&self) -> String {
        let normalised = self.normalise();
        let (mut text, mut filled) = ("& ".to_owned(), 0);
        for chunk in chunks(&normalised.tokens()) {
            let width: usize = chunk.iter().map(Token::width).sum();
            if filled > INDENT && filled + width > LINE {
                text += "\\\\\n  &\\quad {}";
                filled = INDENT;
            }
            text += &tokens(chunk);
            text += " ";
            filled += width;
        }
        text.trim_end().to_owned()
    }
}

fn tokens(tokens: &[Token]) -> String {
    let mut text = String::new();
    let mut before = None;
    for token in tokens {
        let factor = if let Token::Factor(math) = token { Some(*math) } else { None };
        if let Some((before, factor)) = before.zip(factor) {
            text += gap(before, factor);
        }
        text += &match token {
            Token::Break => " ".to_owned(),
            Token::Sign('−') => "- ".to_owned(),
            Token::Sign(sign) => format!("{sign} "),
            Token::Minus => "-".to_owned(),
            Token::Open(height) => bracket(*height, "l", '('),
            Token::Close(height) => bracket(*height, "r", ')'),
            Token::Factor(math) => factor_text(math),
        };
        before = factor;
    }
    text
}

/// Words and fractions keep a distance.
fn gap(before: &Math, after: &Math) -> &'static str {
    let needs = |math: &Math| match math {
        Math::Symbol(name, _) => !name.is_letter(),
        Math::Power(base, _) => matches!(&**base, Math::Symbol(name, _) if !name.is_letter()),
        Math::Fraction { .. } | Math::Words(_) => true,
        _ => false,
    };
    match after {
        Math::Apply { .. } | Math::Group(_) => " ",
        _ if needs(before) || needs(after) => "\\,",
        _ => " ",
    }
}

fn bracket(height: Height, side: &str, bracket: char) -> String {
    match height {
        Height::Line => bracket.to_string(),
        Height::More => format!("\\big{side}{bracket}"),
        Height::Two => format!("\\Big{side}{bracket}"),
    }
}

fn factor_text(math: &Math) -> String {
    match math {
        Math::Number { numerator, denominator: 1 } => numerator.to_string(),
        Math::Number { numerator, denominator } if is_long(*numerator, *denominator) => {
            let Decimal { digits, exponent } = decimal(*numerator, *denominator);
            let power = if exponent == 0 { String::new() } else { format!(" \\cdot 10^{{{exponent}}}") };
            digits + &power
        }
        Math::Number { numerator, denominator } => format!("\\tfrac{{{numerator}}}{{{denominator}}}"),
        Math::Symbol(name, dots) => symbol(name, *dots),
        Math::Of("gap", name) => format!("\\operatorname{{gap}}(\\mathrm{{{}}})", escaped(name)),
        Math::Of("λ", name) => format!("\\lambda_{{\\mathrm{{{}}}}}", escaped(name)),
        Math::Of("sgn v", name) => format!("\\operatorname{{sgn}} v_{{\\mathrm{{{}}}}}", escaped(name)),
        Math::Of(what, name) => format!("{what}_{{\\mathrm{{{}}}}}", escaped(name)),
        Math::Entry(matrix, indices) => {
            let indices: Vec<String> = indices.iter().map(inner).collect();
            format!("{matrix}_{{{}}}", indices.join("\\,"))
        }
        Math::Words(words) => format!("\\text{{{}}}", escaped(words)),
        Math::Multiple(number, symbol) => {
            format!("{}{}{}", inner(number), gap(number, symbol), inner(symbol))
        }
        Math::Power(base, exponent) => format!("{}^{{{exponent}}}", inner(base)),
        Math::Fraction { parts, .. } => format!("\\dfrac{{{}}}{{{}}}", inner(&parts[0]), inner(&parts[1])),
        Math::Apply { function, power, argument } => {
            let raised = if *power == 1 { String::new() } else { format!("^{{{power}}}") };
            format!("\\{function}{raised} {}", inner(argument))
        }
        Math::Root(root) => format!("\\sqrt{{{}}}", inner(root)),
        Math::Group(group) => {
            let height = group.height();
            // Braces keep it on one line.
            format!("{}{{{}}}{}", bracket(height, "l", '('), inner(group), bracket(height, "r", ')'))
        }
        Math::Minus(_) | Math::Sum(_) | Math::Product(_) => inner(math),
    }
}

fn inner(math: &Math) -> String {
    tokens(&math.tokens())
}

fn symbol(name: &Name, dots: u8) -> String {
    let (stem, own) = name.stem();
    let accent = match dots + own {
        0 => "",
        1 => "\\dot",
        2 => "\\ddot",
        3 => "\\dddot",
        _ => "\\ddddot",
    };
    let stem = if accent.is_empty() { letter(stem) } else { format!("{accent}{{{}}}", letter(stem)) };
    let indices: Vec<String> = name.indices().iter().map(|index| letter(index)).collect();
    if indices.is_empty() { stem } else { format!("{stem}_{{{}}}", indices.join("\\,")) }
}

/// A letter as a command where it is Greek, words upright.
fn letter(stem: &str) -> String {
    let mut letters = stem.chars();
    match (letters.next(), letters.next()) {
        (Some('ο'), None) => "o".to_owned(),
        (Some(greek), None) if spelled(greek).is_some() => {
            let name = spelled(greek).unwrap_or_default();
            let variant = if matches!(name, "phi" | "epsilon") { "var" } else { "" };
            format!("\\{variant}{name}")
        }
        (Some(latin), None) => escaped(&latin.to_string()),
        _ => format!("\\mathrm{{{}}}", escaped(stem)),
    }
}

/// Names have letters, digits and underscores; labels commas and brackets.
fn escaped(text: &str) -> String {
    text.replace('_', "\\_")
}
