//! Where a long formula may be broken: before the signs of its sums, those in brackets too where
//! the brackets hold much.

use super::{Equation, Math};

/// Brackets that hold less than this are not broken.
pub(super) const WHOLE: usize = 24;

/// A part of a formula in order of writing.
#[derive(Debug)]
pub(super) enum Token<'a> {
    /// A line may end here.
    Break,
    /// `=`, `+` or `−`.
    Sign(char),
    /// A sign that belongs to what follows.
    Minus,
    /// An opening bracket around what is so high.
    Open(Height),
    /// A closing bracket.
    Close(Height),
    /// A factor.
    Factor(&'a Math),
}

/// How high a formula is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Height {
    /// A line.
    Line,
    /// A small fraction, a root, brackets within.
    More,
    /// A fraction in two storeys.
    Two,
}

impl Token<'_> {
    pub(super) fn width(&self) -> usize {
        match self {
            Self::Break => 0,
            Self::Sign(_) => 3,
            Self::Minus | Self::Open(_) | Self::Close(_) => 1,
            Self::Factor(math) => math.width(),
        }
    }
}

/// What stands between breaks.
pub(super) fn chunks<'a, 'b>(tokens: &'b [Token<'a>]) -> impl Iterator<Item = &'b [Token<'a>]> {
    tokens.split(|token| matches!(token, Token::Break))
}

impl Math {
    /// Its parts in order.
    pub(super) fn tokens(&self) -> Vec<Token<'_>> {
        let mut tokens = Vec::new();
        parts(self, &mut tokens);
        tokens
    }

    /// Letters that it is about as wide as.
    pub(super) fn width(&self) -> usize {
        let all = |parts: &[Self], between: usize| {
            parts.iter().map(|part| part.width() + between).sum::<usize>().saturating_sub(between)
        };
        match self {
            Self::Fraction { parts, .. } => parts.iter().map(Self::width).max().unwrap_or(0),
            Self::Sum(terms) => all(terms, 3),
            Self::Product(factors) => all(factors, 0),
            Self::Minus(inner) => 2 + inner.width(),
            Self::Group(inner) | Self::Root(inner) => 2 + inner.width(),
            Self::Power(base, _) => 1 + base.width(),
            Self::Apply { argument, .. } => 4 + argument.width(),
            Self::Number { denominator: 2.., .. } => 2,
            other => other.to_string().chars().count(),
        }
    }

    /// What brackets around it have to hold.
    pub(super) fn height(&self) -> Height {
        let highest = |parts: &[Self]| parts.iter().map(Self::height).max().unwrap_or(Height::Line);
        match self {
            Self::Fraction { .. } => Height::Two,
            Self::Root(inner) | Self::Group(inner) => inner.height().max(Height::More),
            Self::Number { denominator: 2.., .. } => Height::More,
            Self::Number { .. } | Self::Symbol(..) | Self::Of(..) | Self::Words(_) => Height::Line,
            Self::Entry(_, parts) | Self::Sum(parts) | Self::Product(parts) => highest(parts),
            Self::Minus(inner) | Self::Power(inner, _) | Self::Apply { argument: inner, .. } => {
                inner.height()
            }
            Self::Multiple(number, _) => number.height(),
        }
    }
}

impl Equation {
    pub(super) fn tokens(&self) -> Vec<Token<'_>> {
        let mut tokens = self.left.tokens();
        tokens.push(Token::Break);
        tokens.push(Token::Sign('='));
        tokens.extend(self.right.tokens());
        tokens
    }
}

fn parts<'a>(math: &'a Math, tokens: &mut Vec<Token<'a>>) {
    match math {
        Math::Sum(terms) => sum(terms, tokens),
        Math::Minus(inner) => {
            tokens.push(Token::Minus);
            parts(inner, tokens);
        }
        Math::Product(factors) => factors.iter().for_each(|factor| parts(factor, tokens)),
        Math::Group(inner) if inner.width() > WHOLE => {
            tokens.push(Token::Open(inner.height()));
            parts(inner, tokens);
            tokens.push(Token::Close(inner.height()));
        }
        other => tokens.push(Token::Factor(other)),
    }
}

fn sum<'a>(terms: &'a [Math], tokens: &mut Vec<Token<'a>>) {
    for (i, term) in terms.iter().enumerate() {
        let (sign, term) = match term {
            Math::Minus(inner) if i > 0 => ('−', &**inner),
            term => ('+', term),
        };
        if i > 0 {
            tokens.push(Token::Break);
            tokens.push(Token::Sign(sign));
        }
        parts(term, tokens);
    }
}
