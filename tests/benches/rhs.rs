//! Generated right-hand sides beside the ones an expert would write by hand, on independent states.
//!
//! `cargo bench -p liftoff-tests --bench rhs`; compare the medians of each pair in one run.

use divan::{Bencher, black_box};
use liftoff_compiled::{DoublePendulum, FallingPair};
use liftoff_core::model::{BarSystem, ContactSet, Form, Phase, PhaseVisitor};

const STATES: usize = 256;

fn main() {
    divan::main();
}

fn states<const N: usize>() -> Vec<[f64; N]> {
    let value = |i: usize, j: usize| 0.2 + 0.6 * ((1 + i * N + j) as f64 * 0.618).fract();
    (0..STATES).map(|i| core::array::from_fn(|j| value(i, j))).collect()
}

struct Generated<'a, 'b, M: BarSystem> {
    bencher: Bencher<'a, 'b>,
    model: &'a M,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Generated<'_, '_, M> {
    type Output = ();

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) {
        let (constants, states) = (self.model.constants::<f64>(), states::<N>());
        self.bencher.counter(STATES).bench_local(|| {
            for state in &states {
                black_box((phase.derivative)(&constants, &phase.set, black_box(state)));
            }
        });
    }
}

fn generated<M: BarSystem>(bencher: Bencher, model: &M, set: ContactSet) {
    M::phase(set, Form::Reduced, Generated { bencher, model });
}

fn by_hand<const N: usize>(bencher: Bencher, rhs: fn(&[f64; N]) -> [f64; N]) {
    let (states, rhs) = (states::<N>(), black_box(rhs));
    bencher.counter(STATES).bench_local(|| {
        for state in &states {
            black_box(rhs(black_box(state)));
        }
    });
}

#[divan::bench_group]
mod falling_pair {
    use super::*;

    #[divan::bench]
    fn generated(bencher: Bencher) {
        super::generated(bencher, &FallingPair { m: 1.0, l: 1.0, g: 9.81 }, ContactSet::EMPTY.with(0));
    }

    /// `(4/3 + sec⁴φ − 2 sec φ) φ̈ + sin φ sec²φ (2 sec³φ − 1) φ̇² = (2g/l)(sec²φ − cos φ)`, l = 1.
    #[divan::bench]
    fn by_hand(bencher: Bencher) {
        super::by_hand(bencher, |&[phi, omega]| {
            let (sin, cos) = phi.sin_cos();
            let sec = 1.0 / cos;
            let sec2 = sec * sec;
            let inertia = 4.0 / 3.0 + sec2 * sec2 - 2.0 * sec;
            let velocity = sin * sec2 * (2.0 * sec2 * sec - 1.0) * omega * omega;
            [omega, (2.0 * 9.81 * (sec2 - cos) - velocity) / inertia]
        });
    }
}

#[divan::bench_group]
mod double_pendulum {
    use super::*;

    #[divan::bench]
    fn generated(bencher: Bencher) {
        super::generated(bencher, &DoublePendulum { m: 1.0, l: 1.0, g: 9.81 }, ContactSet::EMPTY);
    }

    /// Two uniform bars, m = l = 1, absolute angles from the downward vertical.
    #[divan::bench]
    fn by_hand(bencher: Bencher) {
        super::by_hand(bencher, |&[a, b, u, v]| {
            let ((sin_a, cos_a), (sin_b, cos_b)) = (a.sin_cos(), b.sin_cos());
            let sin = sin_a * cos_b - cos_a * sin_b;
            let cos = cos_a * cos_b + sin_a * sin_b;
            let coupling = 0.5 * cos;
            let first = -0.5 * sin * v * v - 1.5 * 9.81 * sin_a;
            let second = 0.5 * sin * u * u - 0.5 * 9.81 * sin_b;
            let inverse = 1.0 / (4.0 / 9.0 - coupling * coupling);
            let (p, q) = (first / 3.0 - coupling * second, 4.0 / 3.0 * second - coupling * first);
            [u, v, p * inverse, q * inverse]
        });
    }
}
