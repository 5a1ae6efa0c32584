//! Against the work of a constant couple, c (φ₁ − φ₀).

use super::*;
use crate::audit::tests::Driven;
use crate::method::MethodId;
use crate::prelude::*;

const TURNED: Driven = Driven { m: 2.0, l: 1.5, g: 9.81, c: 7.0 };

/// Steps of a run, with what tells their work and the equations they are of.
fn steps(
    method: MethodId,
    look: impl Fn(&dyn Fn(&DenseOutput, f64) -> Option<f64>, &dyn PhaseEquations, &DenseOutput),
) {
    let start = Pose::new("phi", 0.4).with("phi'", -1.0);
    let run =
        Simulation::new(&TURNED).unwrap().start(start).unwrap().limit(3.0).tolerance(1e-9).method(method);
    let run = run.run().unwrap();
    let recorded = &run.phases[0];
    assert!(recorded.steps.len() > 2);
    let work = |step: &DenseOutput, end: f64| work_of(&run.context, &*recorded.phase, (step, end), 1e-9);
    recorded.steps.iter().for_each(|step| look(&work, &*recorded.phase, step));
}

#[test]
fn work_equals_load_work() {
    for method in [MethodId::Taylor, MethodId::Dop853, MethodId::Tsit5, MethodId::Radau, MethodId::Gauss] {
        steps(method, |work, _, step| {
            for end in [1.0, 0.3] {
                let (mut from, mut to) = ([0.0; 2], [0.0; 2]);
                step.interpolate(0.0, &mut from);
                step.interpolate(end, &mut to);
                let (found, expected) = (work(step, end).unwrap(), TURNED.c * (to[0] - from[0]));
                // Weight times length is 29 J; a step may be off by 1e-9 of that, and by some more
                // within it.
                assert!((found - expected).abs() < 3e-7, "{method:?} to {end}: {found} for {expected}");
            }
        });
    }
}

/// Rates with 1e-4 θ² rad/s too much, and the angles that follow from them.
#[test]
fn defect_is_not_counted_as_work() {
    steps(MethodId::Taylor, |work, phase, step| {
        let mut terms = [[0.0; 64]; 2];
        for (entry, terms) in terms.iter_mut().enumerate() {
            step.polynomial(entry, terms).unwrap();
        }
        let added = 1e-4;
        terms[1][2] += added;
        terms[0][3] += added * step.h / 3.0;
        let length = step.degree() + 1;
        let at = |theta: f64| terms.map(|terms| terms.iter().rev().fold(0.0, |sum, c| sum * theta + c));
        let coefficients = (0..length).flat_map(|k| [terms[0][k], terms[1][k]]);
        let spoilt = DenseOutput::series([step.t0, step.t1], &at(1.0), coefficients);
        let [from, to] = [at(0.0), at(1.0)];
        let expected = TURNED.c * (to[0] - from[0]);
        let [before, after] = [from, to].map(|y| phase.energy(&y));
        // Of the second order, and what Simpson's rule leaves out.
        let (work, wrong) = (work(&spoilt, 1.0).unwrap(), after.gained_since(&before) - expected);
        assert!(
            (work - expected).abs() < 0.1 * wrong.abs() + 1e-6,
            "{work} for {expected}, not {wrong} more"
        );
        assert!(wrong.abs() > 2e-6, "{wrong}");
    });
}

/// A step backwards through the equations is no step of theirs.
#[test]
fn a_large_defect_tells_nothing() {
    steps(MethodId::Dop853, |work, _, step| {
        let mut end = [0.0; 2];
        step.interpolate(1.0, &mut end);
        let turned = step.start().into_iter().chain([end[0], -end[1]]);
        assert_eq!(work(&DenseOutput::series([step.t0, step.t1], &end, turned), 1.0), None);
    });
}
