//! The Jacobian of a phase against central differences of the same phase in double-double.

use crate::common::block::Block;
use crate::common::falling_pair::FallingPair;
use crate::common::spring_pendulum::SpringPendulum;
use crate::common::zigzag::Zigzag;
use liftoff::BarSystem;
use liftoff::model::{Array, ContactSet, Form, Phase, PhaseVisitor, jacobian};
use liftoff::scalar::{DoubleDouble, Real, Scalar};

/// Compares the Jacobian at a full state with differences over ±1e-10, whose error is some 1e-20 by truncation and
/// 1e-32/1e-10 by rounding; how many entries the phase has.
struct Compare<'a, M> {
    model: &'a M,
    state: &'a [f64],
}

impl<M: BarSystem> PhaseVisitor<M, DoubleDouble> for Compare<'_, M> {
    type Output = usize;

    fn visit<const N: usize>(self, phase: Phase<M, DoubleDouble, N>) -> usize {
        let constants = self.model.constants::<DoubleDouble>();
        let y = (phase.restrict)(&M::State::from_fn(|i| DoubleDouble::from_f64(self.state[i])));
        let exact = jacobian::<M, N>(&self.model.constants(), phase.set, phase.form, &y.map(Scalar::to_f64));
        let step = DoubleDouble::from_f64(1e-10);
        for j in 0..N {
            let f = |h: DoubleDouble| {
                let mut moved = y;
                moved[j] = moved[j] + h;
                (phase.derivative)(&constants, phase.set, &moved)
            };
            let (plus, minus) = (f(step), f(-step));
            let slope = |i: usize| ((plus[i] - minus[i]) / (step + step)).to_f64();
            let size = (0..N).fold(1.0, |most: f64, i| most.max(slope(i).abs()));
            for i in 0..N {
                // Some hundred roundings of an elimination whose pivots are of order 1e-2 and larger.
                let error = (exact[i][j] - slope(i)).abs();
                assert!(error < 1e-12 * size, "{:?} {:?} [{i}][{j}]: {error:e}", phase.set, phase.form);
            }
        }
        N
    }
}

fn compare<M: BarSystem>(model: &M, labels: &[&str], form: Form, state: &[f64]) -> usize {
    let contacts = M::LAYOUT.contacts.iter().enumerate();
    let closed = contacts.filter(|(_, c)| labels.contains(&c.label));
    let set = closed.fold(ContactSet::EMPTY, |set, (i, _)| set.with(i));
    assert_eq!(set.len(), labels.len());
    M::phase(set, form, Compare { model, state })
}

#[test]
fn of_closed_and_projected_forms() {
    let pair = FallingPair { m: 2.0, l: 0.5, g: 9.81 };
    let state = [0.6, -0.17, 1.7, -0.6];
    assert_eq!(compare(&pair, &["P, Q"], Form::Closed, &state), 2);
    assert_eq!(compare(&pair, &["P, Q"], Form::Projected, &state), 4);
    assert_eq!(compare(&pair, &[], Form::Projected, &state), 4);
    let block = Block { m: 2.0, b: 0.3, h: 0.5, g: 9.81 };
    assert_eq!(compare(&block, &["A"], Form::Projected, &[0.1, 0.5, 0.2, -0.3, 0.4, 1.1]), 6);
}

/// Without mass in the outer bars M is singular, and definite only on what the closed contacts leave free.
#[test]
fn of_massless_bars() {
    let zigzag = Zigzag { m1: 1.0, m2: 0.0, l: 1.0, g: 9.81 };
    let state = [0.7, 0.5, 0.1, 0.4, -0.3, 0.2];
    for labels in [&["C", "A, E"][..], &["A, E"]] {
        assert_eq!(compare(&zigzag, labels, Form::Projected, &state), 6);
        compare(&zigzag, labels, Form::Closed, &state);
    }
}

#[test]
fn of_springs() {
    let pendulum = SpringPendulum { m: 2.0, k: 1e6, l: 1.0, c: 2e3, g: 9.81 };
    assert_eq!(compare(&pendulum, &[], Form::Closed, &[0.8, 0.6001, 1.2, -1.6]), 4);
}
