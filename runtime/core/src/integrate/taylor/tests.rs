use super::Taylor;
use crate::integrate::Stepper;
use crate::integrate::tests::fields::{Field, Kepler, distance, orbit};
use crate::integrate::tests::from;
use crate::integrate::tests::jets::Jets;
use crate::scalar::Scalar;

/// A turn of the orbit; steps, and the error at the end.
fn turn(tol: f64) -> (u64, usize, f64) {
    let mut solver = Taylor::new(Jets::new(&Kepler), from(tol, orbit(0.0)).with_end(7.0));
    while solver.step_state().time() < 7.0 {
        solver.step().expect("a smooth orbit");
    }
    (
        solver.step_state().counts().accepted,
        solver.order(),
        distance(*solver.step_state().state(), orbit(7.0)),
    )
}

/// The order grows with the digits, the number of steps does not; no step is rejected.
#[test]
fn digits_cost_orders_rather_than_steps() {
    let tolerances = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16];
    let turns = tolerances.map(turn);
    for (tol, (_, _, error)) in tolerances.into_iter().zip(turns) {
        // As for every method: the tolerance in each of some tens of steps, stretched along the
        // orbit; and their rounding.
        assert!(error < 1e2 * tol + 1e-13, "{error:e} at {tol:e}");
    }
    assert!(turns.windows(2).all(|w| w[1].1 >= w[0].1), "{turns:?}");
    assert!(turns[6].0 < 2 * turns[0].0, "{turns:?}");
}

/// y′ = (1, t, t²/2): a polynomial of degree 3, exact over any step.
struct Cubic;

impl Field<3> for Cubic {
    fn rates<S: Scalar>(&self, y: &[S; 3]) -> [S; 3] {
        [S::ratio(1, 1), y[0], y[1]]
    }
}

#[test]
fn a_polynomial_is_one_step() {
    let mut solver = Taylor::new(Jets::new(&Cubic), from(1e-12, [0.0; 3]).with_end(3.0));
    while solver.step_state().time() < 3.0 {
        solver.step().expect("a polynomial");
    }
    // The first step's unit is a guess that may be some hundred times too short.
    assert!(solver.step_state().counts().accepted <= 2);
    // Its coefficients and no zeros behind them.
    assert_eq!(solver.dense().coefficients().len(), 4);
    // A few roundings of the largest.
    assert!(distance(*solver.step_state().state(), [3.0, 4.5, 4.5]) < 4.0 * 4.5 * f64::EPSILON);
}

/// One step from rest at the turning point of an oscillator, whose odd coefficients vanish in one
/// component and whose even ones in the other: its length belongs to the tolerance at every order.
#[test]
fn a_step_is_as_long_as_the_tolerance_allows() {
    struct Oscillator;
    impl Field<2> for Oscillator {
        fn rates<S: Scalar>(&self, y: &[S; 2]) -> [S; 2] {
            [y[1], -y[0]]
        }
    }
    for tol in [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
        let mut solver = Taylor::new(Jets::new(&Oscillator), from(tol, [1.0, 0.0]));
        solver.step().expect("an oscillator");
        let (t, y) = (solver.step_state().time(), *solver.step_state().state());
        let error = distance(y, [t.cos(), -t.sin()]);
        // The last term is a hundredth of the tolerance; the next falls by t/p.
        assert!(error < 0.01 * tol, "{error:e} after {t} at {tol:e}");
        // tᵖ/p! = tol/100 has t > p/e (tol/100)^(1/p): above 1 here.
        assert!(t > 1.0, "{t} at {tol:e}");
    }
}

/// A field that is followed to t = 1 at a tolerance of 1e-10; its first entry there, and how many
/// steps were refused.
fn followed<F: Field<2>>(field: &F, start: [f64; 2]) -> (f64, u64) {
    let mut solver = Taylor::new(Jets::new(field), from(1e-10, start).with_end(1.0));
    while solver.step_state().time() < 1.0 {
        solver.step().expect("shorter steps");
    }
    (solver.step_state().state()[0], solver.step_state().counts().rejected)
}

/// y = 1/(1 − (t/2)⁸), of whose coefficients near t = 0 only every eighth is there: the last six
/// say nothing of the pole.
#[test]
fn sparse_series_do_not_reach_beyond_their_radius() {
    struct Pole;
    impl Field<2> for Pole {
        fn rates<S: Scalar>(&self, &[y, t]: &[S; 2]) -> [S; 2] {
            let half = t * S::ratio(1, 2);
            let cube = half * half * half;
            [S::ratio(4, 1) * cube * cube * half * y * y, S::ratio(1, 1)]
        }
    }
    let (y, _) = followed(&Pole, [1.0, 0.0]);
    // A few steps of the tolerance; dy/dy₀ < 1.01 up to there.
    assert!((y - 256.0 / 255.0).abs() < 1e-9, "{y}");
}

/// y = |t − 0.3| integrated: a series knows nothing of the kink, which only the equations at the
/// end of a step tell.
#[test]
fn a_step_over_a_kink_is_refused() {
    struct Kinked;
    impl Field<2> for Kinked {
        fn rates<S: Scalar>(&self, &[_, t]: &[S; 2]) -> [S; 2] {
            let left = t - S::ratio(3, 10);
            [(left * left).sqrt(), S::ratio(1, 1)]
        }
    }
    let (y, refused) = followed(&Kinked, [0.0, 0.0]);
    assert!(refused > 0);
    // ½ 0.3² + ½ 0.7²; a step passes the kink by so little that the defect is less than p + 1
    // tolerances.
    assert!((y - 0.29).abs() < 2e-9, "{y}");
}

/// y₁″ = y₁ y₂, y₂ = 1, at rest but for 1e-80: the time in which it would change by its size has
/// powers beyond all numbers, the step that is allowed has not.
struct Still;

impl Field<3> for Still {
    fn rates<S: Scalar>(&self, y: &[S; 3]) -> [S; 3] {
        [y[1], y[0] * y[2], S::ZERO]
    }
}

#[test]
fn near_rest_takes_one_step_to_the_end() {
    for speed in [1e-300, 1e-80, 1e-60, 1e-40] {
        let mut solver = Taylor::new(Jets::new(&Still), from(1e-9, [0.0, speed, 1.0]).with_end(3.0));
        while solver.step_state().time() < 3.0 {
            solver.step().expect("a motion all but at rest");
        }
        let [y, rate, _] = *solver.step_state().state();
        let expected = [speed * 3.0_f64.sinh(), speed * 3.0_f64.cosh()];
        assert!((y - expected[0]).abs() < 1e-9 && (rate - expected[1]).abs() < 1e-9, "{speed:e}");
    }
}
