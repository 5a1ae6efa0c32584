//! Impacts, blows and what ends in rest.

use super::{CLOSE, evaluate_output, pose};
use crate::common::{kinds, prepared, run};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{bouncing_ball, falling_bar, rocking_block, struck_chain};

fn impacts(run: &Trajectory) -> Vec<&Event> {
    run.events().iter().filter(|event| event.kind == EventKind::Impact).collect()
}

/// Two thirds of a metre above the floor at φ, the lower end strikes after a free fall.
#[test]
fn a_falling_bar_gets_its_impulse() {
    let (m, l, g, y): (f64, f64, f64, f64) = (1.7, 0.8, 9.81, 2.0 / 3.0);
    let speed = (2.0 * g * y).sqrt();
    for (e, phi) in [(0.0, 0.5_f64), (0.4, 1.1), (1.0, 0.2)] {
        let start = pose(&[("phi", phi), ("x", 0.0), ("y", y)]);
        let run = run(&BouncingBar { m, l, g, e }, start, &["t = 0.4"]);
        let first = impacts(&run)[0];
        assert_eq!(first.supports, ["A"]);
        assert_abs_diff_eq!(first.t, (2.0 * y / g).sqrt(), epsilon = CLOSE);
        let expected = falling_bar::impulse(e, m, speed, phi);
        assert_relative_eq!(first.impulses[0].value, expected, max_relative = CLOSE);
        let spin = falling_bar::spin(expected, m, l, phi);
        assert_relative_eq!(first.state[3], spin, max_relative = CLOSE);
        assert_abs_diff_eq!(first.state[5], e * speed, epsilon = CLOSE);
    }
}

/// Level, both ends strike at once and get half each, without spin.
#[test]
fn a_level_bar_rebounds_level() {
    let (m, l, g, e): (f64, f64, f64, f64) = (1.7, 0.8, 9.81, 0.4);
    let start = pose(&[("phi", 0.0), ("x", 0.0), ("y", 1.0)]);
    let run = run(&BouncingBar { m, l, g, e }, start, &["t = 0.6"]);
    let first = impacts(&run)[0];
    assert_eq!(first.supports, ["A", "B"]);
    let half = 0.5 * (1.0 + e) * m * (2.0 * g).sqrt();
    for impulse in &first.impulses {
        assert_relative_eq!(impulse.value, half, max_relative = CLOSE);
    }
    assert_abs_diff_eq!(first.state[3], 0.0, epsilon = CLOSE);
}

/// Infinitely many impacts end at a time known in closed form.
#[test]
fn a_bouncing_ball_comes_to_rest() {
    for (e, height) in [(0.8, 1.0), (0.5, 2.0), (0.1, 0.3)] {
        let rest = bouncing_ball::rest(e, height, 1.0);
        let start = pose(&[("x", 0.0), ("y", height)]);
        let until = format!("t = {}", rest + 1.0);
        let run = run(&BouncingBall { m: 3.0, g: 1.0, e }, start, &[&until]);
        let settle = run.events().iter().find(|event| event.kind == EventKind::Settle).unwrap();
        assert_abs_diff_eq!(settle.t, rest, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "N(P)", rest + 0.5), 3.0, epsilon = CLOSE);
        assert_eq!(evaluate_output(&run, "y", rest + 0.5), 0.0);
    }
}

/// Each change of corner leaves the same part of the rate, and the block rocks on the other.
#[test]
fn a_rocking_block_loses_the_rate_of_housner() {
    let (m, g): (f64, f64) = (2.0, 9.81);
    for (b, h, start) in [(0.2, 1.0, 0.1), (0.5, 1.0, 0.2), (1.0, 1.1, 0.3)] {
        let run = run(&RockingBlock { m, b, h, g }, Pose::new("phi", start), &["t = 1"]);
        let first = impacts(&run)[0];
        assert_eq!(first.supports, ["B"]);
        let before = rocking_block::rate_squared(b, h, g, start, 0.0).sqrt();
        assert_abs_diff_eq!(evaluate_output(&run, "phi'", first.t * (1.0 - 1e-15)), -before, epsilon = CLOSE);
        let after = -before * rocking_block::rate_kept(b, h);
        assert_abs_diff_eq!(first.state[3], after, epsilon = CLOSE);
        let open = first.state[3] < 0.0;
        assert!(open && evaluate_output(&run, "gap(A)", first.t + 0.05) > 0.0, "it rocks on B");
        assert_abs_diff_eq!(evaluate_output(&run, "gap(B)", first.t + 0.05), 0.0, epsilon = CLOSE);
    }
}

/// A squat block keeps nothing of it.
#[test]
fn a_squat_block_lies_down() {
    let model = RockingBlock { m: 1.0, b: 1.5, h: 1.0, g: 9.81 };
    let run = run(&model, Pose::new("phi", 0.1), &["t = 1"]);
    assert_eq!(impacts(&run).len(), 1);
    for output in ["phi", "phi'", "phi''"] {
        assert_abs_diff_eq!(evaluate_output(&run, output, 1.0), 0.0, epsilon = 1e-14);
    }
}

#[test]
fn a_struck_chain_whips() {
    let (m, l, blow) = (1.3, 0.7, 0.9);
    let model = StruckChain { m, l };
    let simulation = prepared(&model, Pose::nominal(), &["t = 1"]).impulse("C", [0.0, blow], 0.5).unwrap();
    let run = simulation.run().unwrap();
    let [far, struck] = struck_chain::rates(blow, m, l);
    let after = 0.5 + 1e-15;
    assert_eq!(kinds(&run)[1], (EventKind::Impulse, vec![]));
    assert_abs_diff_eq!(
        evaluate_output(&run, "vy(C)", after),
        struck_chain::struck_end(blow, m),
        epsilon = CLOSE
    );
    assert_abs_diff_eq!(evaluate_output(&run, "alpha'", after), far, epsilon = CLOSE);
    assert_abs_diff_eq!(evaluate_output(&run, "beta'", after), struck, epsilon = CLOSE);
    // the far bar has its momentum from the hinge alone
    let momentum = 0.5 * m * (evaluate_output(&run, "vy(A)", after) + evaluate_output(&run, "vy(B)", after));
    assert_abs_diff_eq!(momentum, -struck_chain::inner_impulse(blow), epsilon = CLOSE);
    for t in [0.6, 1.0] {
        assert_abs_diff_eq!(evaluate_output(&run, "py", t), blow, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "px", t), 0.0, epsilon = CLOSE);
        assert_abs_diff_eq!(evaluate_output(&run, "Lz", t), 2.0 * l * blow, epsilon = CLOSE);
    }
}
