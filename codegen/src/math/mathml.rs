//! Formulas as MathML, which browsers set by themselves: a `<math>` for each part between which a
//! line may end.

use super::line_breaks::{Token, chunks};
use super::name::DOTS;
use super::numbers::{Decimal, decimal, is_long};
use super::{Equation, Math, Name};

impl Math {
    /// In MathML.
    pub fn mathml(&self) -> String {
        lines(&self.normalise().tokens())
    }
}

impl Equation {
    /// In MathML.
    pub fn mathml(&self) -> String {
        lines(&self.normalise().tokens())
    }
}

fn lines(tokens: &[Token]) -> String {
    let parts = chunks(tokens).map(|chunk| format!("<math displaystyle=\"true\">{}</math>", row(chunk)));
    parts.collect::<Vec<_>>().join(" ")
}

fn row(tokens: &[Token]) -> String {
    let mut text = String::new();
    let mut factor = false;
    for token in tokens {
        if factor && matches!(token, Token::Factor(_) | Token::Open(_)) {
            text += "<mo lspace=\"0\" rspace=\".17em\">\u{2062}</mo>";
        }
        text += &match token {
            Token::Break => String::new(),
            Token::Sign(sign) => format!("<mo form=\"infix\">{sign}</mo>"),
            Token::Minus => "<mo form=\"prefix\">−</mo>".to_owned(),
            Token::Open(_) => bracket('('),
            Token::Close(_) => bracket(')'),
            Token::Factor(math) => one(math),
        };
        factor = matches!(token, Token::Factor(_) | Token::Close(_));
    }
    text
}

fn bracket(bracket: char) -> String {
    let form = if bracket == '(' { "prefix" } else { "postfix" };
    format!("<mo form=\"{form}\" stretchy=\"false\">{bracket}</mo>")
}

fn one(math: &Math) -> String {
    match math {
        Math::Number { numerator, denominator: 1 } => format!("<mn>{numerator}</mn>"),
        Math::Number { numerator, denominator } if is_long(*numerator, *denominator) => {
            let Decimal { digits, exponent } = decimal(*numerator, *denominator);
            let power = format!("<mo>·</mo><msup><mn>10</mn><mn>{exponent}</mn></msup>");
            format!("<mn>{digits}</mn>{}", if exponent == 0 { "" } else { &power })
        }
        Math::Number { numerator, denominator } => {
            format!("<mfrac displaystyle=\"false\"><mn>{numerator}</mn><mn>{denominator}</mn></mfrac>")
        }
        Math::Symbol(name, dots) => symbol(name, *dots),
        Math::Of("gap", name) => format!("<mi>gap</mi>{}<mtext>{name}</mtext>{}", bracket('('), bracket(')')),
        Math::Of(what, name) => format!("<msub><mi>{what}</mi><mtext>{name}</mtext></msub>"),
        Math::Entry(matrix, indices) => {
            let indices: Vec<String> = indices.iter().map(grouped).collect();
            format!(
                "<msub><mi>{matrix}</mi><mrow>{}</mrow></msub>",
                indices.join("<mspace width=\".2em\" />")
            )
        }
        Math::Words(words) => format!("<mtext>{words}</mtext>"),
        Math::Multiple(number, symbol) => format!("{}{}", one(number), one(symbol)),
        Math::Power(base, exponent) => format!("<msup>{}<mn>{exponent}</mn></msup>", grouped(base)),
        Math::Fraction { parts, .. } => {
            format!("<mfrac>{}{}</mfrac>", grouped(&parts[0]), grouped(&parts[1]))
        }
        Math::Apply { function, power, argument } => {
            let name = format!("<mi>{function}</mi>");
            let raised = if *power == 1 { name } else { format!("<msup>{name}<mn>{power}</mn></msup>") };
            format!("{raised}<mo rspace=\".17em\">\u{2061}</mo>{}", one(argument))
        }
        Math::Root(inner) => format!("<msqrt>{}</msqrt>", row(&inner.tokens())),
        Math::Group(inner) => {
            format!(
                "<mrow><mo form=\"prefix\">(</mo>{}<mo form=\"postfix\">)</mo></mrow>",
                row(&inner.tokens())
            )
        }
        Math::Minus(_) | Math::Sum(_) | Math::Product(_) => grouped(math),
    }
}

fn grouped(math: &Math) -> String {
    format!("<mrow>{}</mrow>", row(&math.tokens()))
}

fn symbol(name: &Name, dots: u8) -> String {
    let (stem, own) = name.stem();
    let stem = dotted(stem, dots + own);
    match name.indices().join(" ") {
        none if none.is_empty() => stem,
        digits if digits.parse::<u32>().is_ok() => format!("<msub>{stem}<mn>{digits}</mn></msub>"),
        words => format!("<msub>{stem}<mtext>{words}</mtext></msub>"),
    }
}

/// Letters with combining dots, which fonts without a table for mathematics place well too; words
/// with dots above them.
fn dotted(stem: &str, order: u8) -> String {
    let Some(place) = usize::from(order).checked_sub(1) else { return format!("<mi>{stem}</mi>") };
    let mut letters = stem.chars();
    match (letters.next().and_then(italic), letters.next()) {
        (Some(letter), None) => format!("<mi>{letter}{}</mi>", DOTS[place.min(DOTS.len() - 1)]),
        _ => {
            let dots = ".".repeat(order.into());
            format!("<mover><mi>{stem}</mi><mo lspace=\"0\" rspace=\"0\">{dots}</mo></mover>")
        }
    }
}

/// A letter among those that Unicode has for mathematics: `<mi>` slants single characters only.
fn italic(letter: char) -> Option<char> {
    let from = |first: char, slanted: u32| char::from_u32(slanted + letter as u32 - first as u32);
    match letter {
        'h' => Some('ℎ'),
        'a'..='z' => from('a', 0x1d44e),
        'A'..='Z' => from('A', 0x1d434),
        'α'..='ω' => from('α', 0x1d6fc),
        _ => None,
    }
}
