//! Where the equations are not analytic in the state: at the zeros of what they take roots of, and
//! at the places of tables.
//!
//! `√(a a)` is `|a|`, which has a kink where `a` changes its sign; another radicand is zero at a
//! minimum, as `ẋ² + ẏ²` where a point comes to rest, or at the edge of the domain of the
//! equations.

use super::Kernel;
use crate::elementary::Elementary;
use crate::program::{Id, Operation, Program};

/// What is zero where the equations are not analytic.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kink {
    /// a of `√(a a)`, or of a table of `a + c` with the place c.
    Sign(Id),
    /// Another radicand.
    Radicand(Id),
}

impl Kink {
    /// Its value.
    pub fn value(self) -> Id {
        match self {
            Self::Sign(value) | Self::Radicand(value) => value,
        }
    }
}

/// The kinks of the full equations, each once, in the order of the program.
pub(super) fn kinks(program: &mut Program, kernel: &Kernel) -> Vec<Kink> {
    let mut kinks = Vec::new();
    for id in program.reachable(&kernel.outputs()) {
        let found = match program.operation(id) {
            _ if program.is_constant(id) => continue,
            Operation::Sqrt(radicand) => match program.operation(radicand) {
                Operation::Mul(a, b) if a == b => vec![Kink::Sign(a)],
                _ => vec![Kink::Radicand(radicand)],
            },
            Operation::Elementary(Elementary::Table(table), a) => {
                let places: Vec<Id> = table.kinks().map(|place| program.ratio(place)).collect();
                places.into_iter().map(|place| Kink::Sign(program.sub(a, place))).collect()
            }
            _ => continue,
        };
        for kink in found {
            if !kinks.contains(&kink) {
                kinks.push(kink);
            }
        }
    }
    kinks
}
