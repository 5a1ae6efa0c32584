//! Where the equations are not analytic in the state: at the zeros of what they take roots of.
//!
//! `√(a a)` is `|a|`, which has a kink where `a` changes its sign; another radicand is zero at a
//! minimum, as `ẋ² + ẏ²` where a point comes to rest, or at the edge of the domain of the
//! equations.

use super::Kernel;
use crate::program::{Id, Operation, Program};

/// What is zero where the equations are not analytic.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kink {
    /// a of `√(a a)`.
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
pub(super) fn kinks(program: &Program, kernel: &Kernel) -> Vec<Kink> {
    let mut kinks = Vec::new();
    for id in program.reachable(&kernel.outputs()) {
        let Operation::Sqrt(radicand) = program.operation(id) else { continue };
        if program.is_constant(radicand) {
            continue;
        }
        let kink = match program.operation(radicand) {
            Operation::Mul(a, b) if a == b => Kink::Sign(a),
            _ => Kink::Radicand(radicand),
        };
        if !kinks.contains(&kink) {
            kinks.push(kink);
        }
    }
    kinks
}
