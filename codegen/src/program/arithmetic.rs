//! Arithmetic that folds numbers, zeros, ones and signs as it is written down.

use super::{Id, Operation, Program};
use crate::algebra::{Rational, Symbol};
use crate::elementary::Elementary;

/// The base of the digits of long numbers.
const DIGIT: i128 = 1 << 42;

/// Whether code holds a number: both parts have 64 bits.
fn is_short(value: Rational) -> bool {
    let parts = [value.numerator(), value.denominator()];
    !value.is_overflow() && parts.iter().all(|part| i64::try_from(*part).is_ok())
}

impl Program {
    /// A number. One of more than 64 bits, which code does not hold, is computed from its digits.
    pub fn ratio(&mut self, value: Rational) -> Id {
        if value.is_overflow() || is_short(value) {
            return self.push(Operation::Ratio(value));
        }
        let numerator = self.whole(value.numerator());
        let denominator = self.whole(value.denominator());
        self.push(Operation::Div(numerator, denominator))
    }

    /// An integer by its digits.
    fn whole(&mut self, value: i128) -> Id {
        if is_short(Rational::integer(value)) {
            return self.integer(value);
        }
        let (above, digit) = (self.whole(value / DIGIT), self.integer(value % DIGIT));
        let base = self.integer(DIGIT);
        self.push(Operation::MulAdd(above.min(base), above.max(base), digit))
    }

    /// The result of an operation on numbers, if code holds it: else that operation stays.
    fn folded(&mut self, [a, b]: [Id; 2], result: fn(Rational, Rational) -> Rational) -> Option<Id> {
        let value = result(self.number(a)?, self.number(b)?);
        is_short(value).then(|| self.ratio(value))
    }

    /// An integer.
    pub fn integer(&mut self, value: i128) -> Id {
        self.ratio(Rational::integer(value))
    }

    /// π.
    pub fn pi(&mut self) -> Id {
        self.push(Operation::Pi)
    }

    /// A parameter, coordinate or rate.
    pub fn input(&mut self, symbol: Symbol) -> Id {
        self.push(Operation::Input(symbol))
    }

    fn number(&self, id: Id) -> Option<Rational> {
        match self.operation(id) {
            Operation::Ratio(value) => Some(value),
            _ => None,
        }
    }

    /// Whether `id` is the number zero.
    pub fn is_zero(&self, id: Id) -> bool {
        self.number(id).is_some_and(Rational::is_zero)
    }

    /// Whether `id` is the number one.
    pub fn is_one(&self, id: Id) -> bool {
        self.number(id) == Some(Rational::ONE)
    }

    /// a + b.
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded([a, b], |a, b| a + b) {
            return number;
        }
        match (self.number(a), self.number(b)) {
            (Some(zero), _) if zero.is_zero() => return b,
            (_, Some(zero)) if zero.is_zero() => return a,
            _ => {}
        }
        match (self.operation(a), self.operation(b)) {
            (_, Operation::Neg(b)) => self.sub(a, b),
            (Operation::Neg(a), _) => self.sub(b, a),
            _ => self.push(Operation::Add(a.min(b), a.max(b))),
        }
    }

    /// a − b.
    pub fn sub(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded([a, b], |a, b| a - b) {
            return number;
        }
        match (self.number(a), self.number(b)) {
            (Some(zero), _) if zero.is_zero() => return self.neg(b),
            (_, Some(zero)) if zero.is_zero() => return a,
            _ => {}
        }
        match self.operation(b) {
            _ if a == b => self.integer(0),
            Operation::Neg(b) => self.add(a, b),
            _ => self.push(Operation::Sub(a, b)),
        }
    }

    /// a · b.
    pub fn mul(&mut self, a: Id, b: Id) -> Id {
        if let Some(number) = self.folded([a, b], |a, b| a * b) {
            return number;
        }
        match (self.number(a), self.number(b)) {
            (Some(k), _) => return self.scale(k, b),
            (_, Some(k)) => return self.scale(k, a),
            _ => {}
        }
        match (self.operation(a), self.operation(b)) {
            (Operation::Neg(a), Operation::Neg(b)) => self.mul(a, b),
            (Operation::Neg(a), _) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (_, Operation::Neg(b)) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (Operation::Mul(x, y), _) if self.is_constant(b) && self.is_scaled(a) => self.scaled([x, y], b),
            (_, Operation::Mul(x, y)) if self.is_constant(a) && self.is_scaled(b) => self.scaled([x, y], a),
            _ if self.is_constant(a) && self.is_constant(b) => self.constant_quotient(&[a, b], &[]),
            _ => self.push(Operation::Mul(a.min(b), a.max(b))),
        }
    }

    /// Whether it is a constant times what varies; a versed sine stays one.
    fn is_scaled(&self, id: Id) -> bool {
        match self.operation(id) {
            Operation::Mul(x, y) => self.is_constant(x) != self.is_constant(y) && self.wave(id).is_none(),
            _ => false,
        }
    }

    /// The constants of (x y) factor, one of x and y a constant, multiplied once.
    fn scaled(&mut self, [x, y]: [Id; 2], factor: Id) -> Id {
        let (constant, varying) = if self.is_constant(x) { (x, y) } else { (y, x) };
        let constant = self.mul(constant, factor);
        self.mul(constant, varying)
    }

    /// Π above / Π below of what parameters determine: factors that both have cancel, those left
    /// stand in one order: the number, the parameters as declared, the rest.
    fn constant_quotient(&mut self, above: &[Id], below: &[Id]) -> Id {
        let mut open: Vec<(Id, bool)> = above.iter().map(|&id| (id, true)).collect();
        open.extend(below.iter().map(|&id| (id, false)));
        let (mut numbers, mut sides) = ([self.integer(1); 2], [Vec::new(), Vec::new()]);
        let mut negative = false;
        while let Some((id, is_above)) = open.pop() {
            match self.operation(id) {
                Operation::Mul(x, y) => open.extend([(x, is_above), (y, is_above)]),
                Operation::Div(x, y) => open.extend([(x, is_above), (y, !is_above)]),
                Operation::Neg(x) => {
                    negative = !negative;
                    open.push((x, is_above));
                }
                Operation::Ratio(value) => {
                    negative ^= value.signum() < 0;
                    let (size, side) = (self.ratio(value.abs()), usize::from(!is_above));
                    match self.folded([numbers[side], size], |a, b| a * b) {
                        Some(number) => numbers[side] = number,
                        None => sides[side].push(size),
                    }
                }
                _ => match sides[usize::from(is_above)].iter().position(|&other| other == id) {
                    Some(place) => _ = sides[usize::from(is_above)].remove(place),
                    None => sides[usize::from(!is_above)].push(id),
                },
            }
        }
        if let Some(number) = self.folded(numbers, |a, b| a * b.recip()) {
            numbers = [number, self.integer(1)];
        }
        let [above, below] = [0, 1].map(|side| {
            sides[side].sort_by_key(|&id| match self.operation(id) {
                Operation::Input(Symbol::Parameter(i)) => (0, usize::from(i)),
                _ => (1, id.index()),
            });
            let symbols = core::mem::take(&mut sides[side]).into_iter();
            let product = symbols.reduce(|a, b| self.push(Operation::Mul(a, b)));
            match product {
                Some(product) if self.is_one(numbers[side]) => product,
                Some(product) => self.push(Operation::Mul(numbers[side], product)),
                None => numbers[side],
            }
        });
        let quotient = if self.is_one(below) { above } else { self.push(Operation::Div(above, below)) };
        if negative { self.neg(quotient) } else { quotient }
    }

    fn scale(&mut self, k: Rational, a: Id) -> Id {
        if k.is_zero() {
            return self.integer(0);
        } else if k == Rational::ONE {
            return a;
        } else if k == -Rational::ONE {
            return self.neg(a);
        }
        match self.operation(a) {
            Operation::Neg(a) => self.scale(-k, a),
            Operation::Mul(x, y) if self.is_scaled(a) => {
                let k = self.ratio(k);
                self.scaled([x, y], k)
            }
            _ => {
                let k = self.ratio(k);
                if self.is_constant(a) {
                    self.constant_quotient(&[k, a], &[])
                } else {
                    self.push(Operation::Mul(k.min(a), k.max(a)))
                }
            }
        }
    }

    /// aᵏ by repeated squaring.
    pub fn power(&mut self, a: Id, k: u32) -> Id {
        match k {
            0 => self.integer(1),
            1 => a,
            _ => {
                let half = self.power(a, k / 2);
                let square = self.mul(half, half);
                if k.is_multiple_of(2) { square } else { self.mul(square, a) }
            }
        }
    }

    /// a / b.
    pub fn div(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) || self.is_one(b) {
            return a;
        }
        match (self.operation(a), self.operation(b)) {
            (Operation::Neg(a), Operation::Neg(b)) => self.div(a, b),
            (Operation::Neg(a), _) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            (_, Operation::Neg(b)) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            _ if self.is_constant(b) && !self.is_constant(a) => {
                let one = self.integer(1);
                let inverse = self.div(one, b);
                self.mul(a, inverse)
            }
            _ if self.is_constant(a) && self.is_constant(b) => self.constant_quotient(&[a], &[b]),
            _ => self.push(Operation::Div(a, b)),
        }
    }

    /// −a.
    pub fn neg(&mut self, a: Id) -> Id {
        match self.operation(a) {
            Operation::Ratio(value) => self.ratio(-value),
            Operation::Neg(a) => a,
            Operation::Sub(x, y) if !self.is_constant(a) => self.sub(y, x),
            _ => self.push(Operation::Neg(a)),
        }
    }

    /// a · b + c, as one operation where neither factor is ±1 and both matter.
    pub fn mul_add(&mut self, a: Id, b: Id, c: Id) -> Id {
        let unit = |id: Id| self.number(id).is_some_and(|k| k.abs() == Rational::ONE || k.is_zero());
        let constant = self.is_constant(a) && self.is_constant(b);
        if unit(a) || unit(b) || self.is_zero(c) || constant {
            let product = self.mul(a, b);
            return self.add(product, c);
        }
        match (self.operation(a), self.operation(b)) {
            (Operation::Neg(a), Operation::Neg(b)) => return self.mul_add(a, b, c),
            (Operation::Mul(x, y), _) if self.is_constant(b) && self.is_scaled(a) => {
                return self.scaled_add([x, y], b, c);
            }
            (_, Operation::Mul(x, y)) if self.is_constant(a) && self.is_scaled(b) => {
                return self.scaled_add([x, y], a, c);
            }
            _ => {}
        }
        self.push(Operation::MulAdd(a.min(b), a.max(b), c))
    }

    /// (x y) factor + c, with one product at run time.
    fn scaled_add(&mut self, [x, y]: [Id; 2], factor: Id, c: Id) -> Id {
        let (constant, varying) = if self.is_constant(x) { (x, y) } else { (y, x) };
        let constant = self.mul(constant, factor);
        self.mul_add(constant, varying, c)
    }

    /// √a.
    pub fn sqrt(&mut self, a: Id) -> Id {
        self.push(Operation::Sqrt(a))
    }

    /// eᵃ, log a, tanh a, atan a.
    pub fn elementary(&mut self, function: Elementary, a: Id) -> Id {
        self.push(Operation::Elementary(function, a))
    }

    /// (sin a, cos a).
    pub fn sin_cos(&mut self, a: Id) -> (Id, Id) {
        (self.push(Operation::Sin(a)), self.push(Operation::Cos(a)))
    }

    /// Σ aᵢ bᵢ, as a chain of [`Operation::MulAdd`].
    pub fn dot(&mut self, products: impl IntoIterator<Item = (Id, Id)>) -> Id {
        let zero = self.integer(0);
        products.into_iter().fold(zero, |sum, (a, b)| self.mul_add(a, b, sum))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1.0000000001 to high powers, of which 128 bits hold the first three.
    #[test]
    fn long_numbers_keep_their_digits() {
        let mut program = Program::new(Vec::new());
        let length = Rational::new(10_000_000_001, 10_000_000_000);
        let number = program.ratio(length);
        let powers: Vec<Id> = (1..9).map(|k| program.power(number, k)).collect();
        let square = program.ratio(length * length);
        let found = program.evaluate(&[powers, vec![square]].concat(), &|_| f64::NAN);
        for (k, found) in (1..9).chain([2]).zip(found) {
            let expected = (f64::from(k) * 1e-10f64.ln_1p()).exp();
            assert!((found - expected).abs() < 1e-15, "{k}: {found} for {expected}");
        }
    }
}
