//! Recursive descent: sum → product → sign → power → primary.

use super::clause::{Clause, Relation};
use super::resolve::{DRIVE, RATE, Vocabulary};
use super::token::{Token, tokens, unexpected};
use super::tree::{Expression, Function, Operator};
use crate::error::{LONGEST, MOST_OPERATORS, OutputError};

const DEEPEST: usize = 64;

/// Refuses text that is too long to be an expression.
pub(super) fn check_length(text: &str) -> Result<(), OutputError> {
    match text.chars().count() {
        ..=LONGEST => Ok(()),
        characters => Err(OutputError::Length { characters }),
    }
}

pub(super) struct Parser<'a> {
    tokens: Vec<(Token, usize)>,
    at: usize,
    depth: usize,
    operators: usize,
    names: Vocabulary<'a>,
}

impl<'a> Parser<'a> {
    pub(super) fn new(text: &str, names: Vocabulary<'a>) -> Result<Self, OutputError> {
        check_length(text)?;
        Ok(Self { tokens: tokens(text)?, at: 0, depth: 0, operators: 0, names })
    }

    /// Nothing may follow.
    pub(super) fn end(&self) -> Result<(), OutputError> {
        match self.token() {
            Token::End => Ok(()),
            _ => Err(self.expected("an operator or the end")),
        }
    }

    /// Takes the symbol if it is next.
    pub(super) fn take(&mut self, symbol: char) -> bool {
        let next = *self.token() == Token::Symbol(symbol);
        self.at += usize::from(next);
        next
    }

    /// Takes the name if it is next.
    pub(super) fn take_word(&mut self, word: &str) -> bool {
        let next = matches!(self.token(), Token::Name(name, 0) if name == word);
        self.at += usize::from(next);
        next
    }

    /// Takes `(` if it is next and has a comparison up to its `)`: an expression has none.
    fn take_clause(&mut self) -> bool {
        let mut open = 0;
        let inside = self.tokens[self.at..].iter().map(|(token, _)| token).take_while(|token| {
            open += match token {
                Token::Symbol('(') => 1,
                Token::Symbol(')') => -1,
                _ => 0,
            };
            open > 0
        });
        let is_comparison = |token: &Token| matches!(token, Token::Symbol('<' | '>' | '='));
        inside.into_iter().any(is_comparison) && self.take('(')
    }

    /// `a < b or c > d`: holds where one of them does. `text` is what an error names.
    pub(super) fn parse_any(&mut self, text: &str) -> Result<Clause, OutputError> {
        let mut any = self.parse_all(text)?;
        while self.take_word("or") {
            any = any.combine(self.parse_all(text)?, 1.0, text)?;
        }
        Ok(any)
    }

    /// `a < b and c > d`: holds where both do.
    pub(super) fn parse_all(&mut self, text: &str) -> Result<Clause, OutputError> {
        let mut all = self.parse_clause(text)?;
        while self.take_word("and") {
            all = all.combine(self.parse_clause(text)?, -1.0, text)?;
        }
        Ok(all)
    }

    fn parse_clause(&mut self, text: &str) -> Result<Clause, OutputError> {
        if self.take_clause() {
            self.enter()?;
            let inner = self.parse_any(text)?;
            self.close()?;
            self.leave();
            return Ok(inner);
        }
        let left = self.sum()?;
        let relation = if self.take('<') {
            Some(Relation::Less)
        } else if self.take('>') {
            Some(Relation::Greater)
        } else {
            self.take('=').then_some(Relation::Equal)
        };
        let right = if relation.is_some() { self.sum()? } else { Expression::Number(0.0) };
        Ok(Clause { relation: relation.unwrap_or(Relation::Equal), sides: [left, right], count: 1 })
    }

    pub(super) fn sum(&mut self) -> Result<Expression, OutputError> {
        let mut sum = self.product()?;
        loop {
            let operator = if self.take('+') {
                Operator::Add
            } else if self.take('-') {
                Operator::Subtract
            } else {
                return Ok(sum);
            };
            self.count_operator()?;
            sum = Expression::join(operator, sum, self.product()?);
        }
    }

    fn product(&mut self) -> Result<Expression, OutputError> {
        let mut product = self.sign()?;
        loop {
            let operator = if self.take('*') {
                Operator::Multiply
            } else if self.take('/') {
                Operator::Divide
            } else {
                return Ok(product);
            };
            self.count_operator()?;
            product = Expression::join(operator, product, self.sign()?);
        }
    }

    /// Also the exponent of a power, so that `2^-1` and `-x^2` read as usual.
    fn sign(&mut self) -> Result<Expression, OutputError> {
        self.enter()?;
        let signed =
            if self.take('-') { Expression::apply(Function::Negate, self.sign()?) } else { self.power()? };
        self.leave();
        Ok(signed)
    }

    fn enter(&mut self) -> Result<(), OutputError> {
        self.depth += 1;
        if self.depth > DEEPEST { Err(OutputError::Depth { column: self.column() }) } else { Ok(()) }
    }

    fn leave(&mut self) {
        self.depth -= 1;
    }

    fn power(&mut self) -> Result<Expression, OutputError> {
        let base = self.primary()?;
        if self.take('^') {
            return Ok(Expression::join(Operator::Power, base, self.sign()?));
        }
        Ok(base)
    }

    fn primary(&mut self) -> Result<Expression, OutputError> {
        match self.token().clone() {
            Token::Number(x) => {
                self.at += 1;
                if self.take_word("deg") {
                    return Ok(Expression::Number(x.to_radians()));
                }
                let has_unit = self.take_word("rad") || self.take_word("s");
                match self.token() {
                    Token::Name(name, _) if !has_unit && !matches!(&**name, "and" | "or") => {
                        Err(self.expected("an operator, or one of the units `deg`, `rad` and `s` (else numbers are in SI units)"))
                    }
                    _ => Ok(Expression::Number(x)),
                }
            }
            Token::Name(name, primes) => {
                self.at += 1;
                if primes == 0 && self.take('(') { self.call(&name) } else { self.names.value(&name, primes) }
            }
            Token::Symbol('(') => {
                self.at += 1;
                let inner = self.sum()?;
                self.close()?;
                Ok(inner)
            }
            _ => Err(self.expected("a number, a name or `(`")),
        }
    }

    fn call(&mut self, name: &str) -> Result<Expression, OutputError> {
        if let Some((_, function)) = Function::NAMED.into_iter().find(|(known, _)| *known == name) {
            let argument = self.sum()?;
            self.close()?;
            return Ok(Expression::apply(function, argument));
        }
        if Function::OF_SEVERAL.contains(&name) {
            return self.several(name);
        }
        let names = self.names.of_model(name)?;
        if name == RATE {
            let column = self.column();
            let rate = self.sum()?.rate();
            self.close()?;
            return rate.ok_or_else(|| {
                unexpected("a coordinate, or `x` or `y` of a point", "something else".to_owned(), column)
            });
        }
        if names.is_quantity(name) {
            let arguments = self.raw()?;
            return names.quantity(name, &arguments);
        }
        names.check_function(name)?;
        let mut arguments = vec![self.name()?];
        if arguments == [DRIVE] && names.has_drives() {
            return names.call(name, &[names.drive(&self.raw()?)]);
        }
        while self.take(',') {
            arguments.push(self.name()?);
        }
        self.close()?;
        names.call(name, &arguments)
    }

    /// `min(a, b)`, `max(a, b)`, and `clamp(x, low, high)`, which is `max(low, min(x, high))`;
    /// `atan2(y, x)`, and `if(a > b, x, y)`.
    fn several(&mut self, name: &str) -> Result<Expression, OutputError> {
        if name == "if" {
            let column = self.column();
            let margin = self.parse_any(name)?.into_margin();
            let margin =
                margin.ok_or_else(|| unexpected("`<` or `>`", "no comparison".to_owned(), column))?;
            self.comma()?;
            let value = self.sum()?;
            self.comma()?;
            let chosen = Expression::choice(margin, value, self.sum()?);
            self.close()?;
            return Ok(chosen);
        }
        let first = self.sum()?;
        self.comma()?;
        let second = self.sum()?;
        let value = match name {
            "min" => Expression::extreme(-1.0, first, second),
            "max" => Expression::extreme(1.0, first, second),
            "atan2" => Expression::join(Operator::Atan2, first, second),
            _ => {
                self.comma()?;
                Expression::extreme(1.0, second, Expression::extreme(-1.0, first, self.sum()?))
            }
        };
        self.close()?;
        Ok(value)
    }

    fn comma(&mut self) -> Result<(), OutputError> {
        if self.take(',') { Ok(()) } else { Err(self.expected("`,`")) }
    }

    fn count_operator(&mut self) -> Result<(), OutputError> {
        self.operators += 1;
        match self.operators {
            ..=MOST_OPERATORS => Ok(()),
            _ => Err(OutputError::Operators { column: self.column() }),
        }
    }

    /// The text up to the closing parenthesis, without spaces.
    fn raw(&mut self) -> Result<String, OutputError> {
        let mut text = String::new();
        let mut open = 1;
        loop {
            match self.token() {
                Token::End => return Err(self.expected("`)`")),
                Token::Symbol('(') => open += 1,
                Token::Symbol(')') => open -= 1,
                _ => {}
            }
            let token = self.token().text();
            self.at += 1;
            if open == 0 {
                return Ok(text);
            }
            text.push_str(&token);
        }
    }

    fn name(&mut self) -> Result<String, OutputError> {
        match self.token().clone() {
            Token::Name(name, 0) => {
                self.at += 1;
                Ok(name)
            }
            _ => Err(self.expected("a point or a support")),
        }
    }

    fn close(&mut self) -> Result<(), OutputError> {
        if self.take(')') { Ok(()) } else { Err(self.expected("`)`")) }
    }

    fn token(&self) -> &Token {
        &self.tokens[self.at].0
    }

    pub(super) fn column(&self) -> usize {
        self.tokens[self.at].1
    }

    fn expected(&self, expected: &'static str) -> OutputError {
        unexpected(expected, self.token().to_string(), self.column())
    }
}
