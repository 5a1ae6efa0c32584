//! Sines and cosines of integer combinations: one evaluation per angle, the rest by addition
//! theorems.
//!
//! An angle whose versed sine is wanted is evaluated at its half, `sin α = 2 sin ½α cos ½α`,
//! `cos α = 1 − vers α`, `vers α = 2 sin² ½α`.

use super::wave::{Argument, Part, WaveStep};
use super::{Id, Lowering, Operation};
use crate::algebra::{Rational, Symbol};

impl Lowering<'_> {
    /// (sin, cos) of an argument.
    pub(super) fn wave(&mut self, argument: &[(Symbol, i16)]) -> (Id, Id) {
        self.turned(argument, false)
    }

    /// vers = 2 sin² of half the argument, all of whose angles are evaluated at their halves.
    pub(super) fn versed(&mut self, argument: &[(Symbol, i16)]) -> Id {
        let (sin, _) = self.turned(argument, true);
        let square = self.program.mul(sin, sin);
        let two = self.program.integer(2);
        let versed = self.program.mul(two, square);
        self.entitle(versed, "vers", argument);
        let sin_cos = self.turned(argument, false);
        self.note(versed, Part::Versed, argument, sin_cos);
        versed
    }

    fn turned(&mut self, argument: &[(Symbol, i16)], half: bool) -> (Id, Id) {
        let key = (half, argument.to_vec());
        if let Some(&known) = self.waves.known.get(&key) {
            return known;
        }
        let wave = match *argument {
            [] => (self.program.integer(0), self.program.integer(1)),
            [(symbol, 1)] => self.base(symbol, half),
            [(symbol, k)] if k < 0 => {
                let (sin, cos) = self.turned(&[(symbol, -k)], half);
                (self.program.neg(sin), cos)
            }
            [(symbol, k)] if k % 2 == 0 => {
                let single = self.turned(&[(symbol, k / 2)], half);
                self.doubled(single)
            }
            [(symbol, k)] => {
                let (rest, single) =
                    (self.turned(&[(symbol, k - 1)], half), self.turned(&[(symbol, 1)], half));
                self.sum(rest, single)
            }
            _ if self.is_shifted(argument) => self.shifted(argument, half),
            [ref rest @ .., last] => {
                let (rest, last) = (self.turned(rest, half), self.turned(&[last], half));
                self.sum(rest, last)
            }
        };
        let prefixes = if half { ["half_sin", "half_cos"] } else { ["sin", "cos"] };
        self.entitle(wave.0, prefixes[0], argument);
        self.entitle(wave.1, prefixes[1], argument);
        if !half {
            self.note(wave.0, Part::Sine, argument, wave);
            self.note(wave.1, Part::Cosine, argument, wave);
        }
        self.waves.known.insert(key, wave);
        wave
    }

    /// Notes what `id` is, unless it is that by its own operation or linear in the waves of a
    /// lesser angle.
    fn note(&mut self, id: Id, part: Part, argument: &[(Symbol, i16)], sin_cos: (Id, Id)) {
        let direct =
            matches!(self.program.operation(id), Operation::Sin(_) | Operation::Cos(_) | Operation::Neg(_));
        if direct || self.program.is_constant(id) || self.program.waves.contains_key(&id) {
            return;
        }
        if self.is_shifted(argument) {
            return;
        }
        let angle = argument.iter().map(|&(symbol, k)| (self.symbol(symbol), k)).collect();
        self.program.waves.insert(id, WaveStep { part, angle, sin_cos });
    }

    /// Whether a part of an angle that varies does not.
    fn is_shifted(&mut self, argument: &[(Symbol, i16)]) -> bool {
        let fixed = argument.iter().filter(|&&(symbol, _)| self.is_fixed(symbol)).count();
        0 < fixed && fixed < argument.len()
    }

    fn is_fixed(&mut self, symbol: Symbol) -> bool {
        let value = self.symbol(symbol);
        self.program.is_constant(value)
    }

    /// Linear in the sine and the cosine of the part that varies.
    fn shifted(&mut self, argument: &[(Symbol, i16)], half: bool) -> (Id, Id) {
        let (fixed, varying): (Argument, Argument) =
            argument.iter().partition(|&&(symbol, _)| self.is_fixed(symbol));
        let (fixed, varying) = (self.turned(&fixed, half), self.turned(&varying, half));
        self.sum(fixed, varying)
    }

    /// Names a value `cos_a_minus_b` after its argument, where that is a sum of coordinates.
    fn entitle(&mut self, id: Id, prefix: &str, argument: &[(Symbol, i16)]) {
        let mut name = prefix.to_owned();
        for (place, &(symbol, k)) in argument.iter().enumerate() {
            let Some(coordinate) = self.program.coordinate(symbol) else { return };
            let sign = match (place, k < 0) {
                (0, false) => "",
                (_, true) => "minus_",
                (_, false) => "plus_",
            };
            let multiple = if k.abs() == 1 { String::new() } else { format!("{}_", k.abs()) };
            name = format!("{name}_{sign}{multiple}{coordinate}");
        }
        self.program.set_name(id, || name);
    }

    fn base(&mut self, symbol: Symbol, half: bool) -> (Id, Id) {
        let angle = self.symbol(symbol);
        if half {
            let one_half = self.program.ratio(Rational::new(1, 2));
            let angle = self.program.mul(one_half, angle);
            return self.program.sin_cos(angle);
        }
        if self.waves.half.contains(&symbol) {
            let half = self.turned(&[(symbol, 1)], true);
            return self.doubled(half);
        }
        self.program.sin_cos(angle)
    }

    /// `sin 2α = 2 s c`, `cos 2α = 1 − 2 s²`.
    fn doubled(&mut self, (sin, cos): (Id, Id)) -> (Id, Id) {
        let two = self.program.integer(2);
        let one = self.program.integer(1);
        let product = self.program.mul(sin, cos);
        let square = self.program.mul(sin, sin);
        let twice = self.program.mul(two, square);
        (self.program.mul(two, product), self.program.sub(one, twice))
    }

    fn sum(&mut self, (s1, c1): (Id, Id), (s2, c2): (Id, Id)) -> (Id, Id) {
        let sin = self.program.mul(c1, s2);
        let sin = self.program.mul_add(s1, c2, sin);
        let cos = self.program.mul(s1, s2);
        let cos = self.program.neg(cos);
        (sin, self.program.mul_add(c1, c2, cos))
    }
}
