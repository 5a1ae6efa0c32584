//! Operations per call: what parameters alone determine is computed once and not counted.

use core::fmt;

use super::{Id, Operation, Program};

/// Operation counts.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub struct Cost {
    /// Additions and subtractions; a change of sign folds into its use.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Multiplications with an addition.
    pub fused: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub roots: usize,
    /// Angles whose sine and cosine are taken.
    pub angles: usize,
    /// Exponentials, logarithms and hyperbolic tangents.
    pub elementary: usize,
}

impl Program {
    /// Operations per call that `outputs` need.
    pub fn cost(&self, outputs: &[Id]) -> Cost {
        let mut cost = Cost::default();
        let mut angles = Vec::new();
        for id in self.reachable(outputs).into_iter().filter(|&id| !self.is_constant(id)) {
            match self.operation(id) {
                Operation::Ratio(_) | Operation::Pi | Operation::Input(_) | Operation::Neg(_) => {}
                Operation::Add(..) | Operation::Sub(..) => cost.additions += 1,
                Operation::Mul(..) => cost.multiplications += 1,
                Operation::MulAdd(..) => cost.fused += 1,
                Operation::Div(..) => cost.divisions += 1,
                Operation::Sqrt(_) => cost.roots += 1,
                Operation::Sin(a) | Operation::Cos(a) => angles.push(a),
                Operation::Elementary(..) => cost.elementary += 1,
            }
        }
        angles.sort();
        angles.dedup();
        cost.angles = angles.len();
        cost
    }
}

/// Instructions of other evaluations that a current processor works on meanwhile.
const WINDOW: usize = 512;

impl Program {
    /// Cycles per call on a current processor, independent calls overlapping: two operations a
    /// cycle, but no faster than the longest chain of dependent ones in as many calls as fit in its
    /// window.
    pub fn cycles(&self, outputs: &[Id]) -> usize {
        let cost = self.cost(outputs);
        let Cost { additions, multiplications, fused, divisions, roots, angles, elementary } = cost;
        let work = additions + multiplications + fused + 10 * (divisions + roots + angles + elementary);
        (work / 2).max(self.latency(outputs) * work / (work + WINDOW))
    }

    /// Cycles of the longest chain of dependent operations.
    fn latency(&self, outputs: &[Id]) -> usize {
        let mut ready = vec![0; self.operations.len()];
        for id in self.reachable(outputs).into_iter().filter(|&id| !self.is_constant(id)) {
            let own = match self.operation(id) {
                Operation::Ratio(_) | Operation::Pi | Operation::Input(_) | Operation::Neg(_) => 0,
                Operation::Add(..) | Operation::Sub(..) | Operation::Mul(..) | Operation::MulAdd(..) => 4,
                Operation::Div(..) => 14,
                Operation::Sqrt(_) => 18,
                Operation::Sin(_) | Operation::Cos(_) | Operation::Elementary(..) => 40,
            };
            let before = self.operation(id).operands().map(|a| ready[a.index()]).max();
            ready[id.index()] = own + before.unwrap_or(0);
        }
        outputs.iter().map(|id| ready[id.index()]).max().unwrap_or(0)
    }
}

impl Cost {
    /// Additions, multiplications, divisions and roots one by one, two in a multiplication with an
    /// addition; a sine and its cosine are one each.
    pub fn flops(self) -> usize {
        let Self { additions, multiplications, fused, divisions, roots, angles, elementary } = self;
        additions + multiplications + 2 * fused + divisions + roots + 2 * angles + elementary
    }

    /// What they take on current processors: every operation once; a sine with its cosine as forty,
    /// an exponential too, a division or root as ten.
    pub fn weight(self) -> usize {
        let Self { additions, multiplications, fused, divisions, roots, angles, elementary } = self;
        additions + multiplications + fused + 10 * (divisions + roots) + 40 * (angles + elementary)
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { additions, multiplications, fused, divisions, roots, angles, elementary } = self;
        write!(f, "{additions} +, {multiplications} ×, {fused} ×+, {divisions} ÷")?;
        if *roots > 0 {
            write!(f, ", {roots} √")?;
        }
        if *elementary > 0 {
            write!(f, ", {elementary} exp log tanh atan")?;
        }
        write!(f, ", {angles} sin cos")
    }
}
