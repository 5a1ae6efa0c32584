//! Gauss's method as a method.

use super::{Begun, Method, Problem};
use crate::integrate;
use crate::model::BarSystem;

/// Gauss collocation of order 12 with a constant step, for long smooth runs without drift of the energy:
/// [`integrate::Gauss`].
#[derive(Debug, Clone, Copy, Default)]
pub struct Gauss;

impl Method for Gauss {
    fn name(&self) -> &'static str {
        "gauss"
    }

    fn begin<'a, M: BarSystem, const N: usize>(&self, problem: Problem<'a, M, N>) -> Begun<'a, N> {
        let pairs = pairs(&problem);
        Begun::asked(self, integrate::Gauss::new(problem.rates, problem.progress).with_pairs(pairs))
    }
}

/// How many coordinates have the entries that follow as their rates: all or none, as f says where those are 1, 2, ….
fn pairs<M: BarSystem, const N: usize>(problem: &Problem<M, N>) -> usize {
    let n = problem.phase.coordinates;
    if n != problem.phase.rates || 2 * n > N {
        return 0;
    }
    let mut probe = *problem.progress.state();
    for (i, rate) in probe[n..2 * n].iter_mut().enumerate() {
        *rate = (i + 1) as f64;
    }
    if (problem.rates)(&probe)[..n] == probe[n..2 * n] { n } else { 0 }
}
