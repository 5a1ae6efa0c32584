//! Two and more bars without a loop.

use super::{CLOSE, evaluate_output, pose};
use crate::common::run;
use approx::assert_abs_diff_eq;
use core::f64::consts::{FRAC_PI_2, PI};
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{a_frame, double_pendulum, folded_chain};

#[test]
fn a_frame_reaches_the_floor() {
    let start = 80.0_f64.to_radians();
    let run = run(&AFrame { m: 1.0, l: 1.0, g: 1.0 }, Pose::new("phi", start), &["phi = 0"]);
    assert_abs_diff_eq!(run.end_time(), a_frame::time(start, 0.0), epsilon = CLOSE);
    assert_abs_diff_eq!(
        evaluate_output(&run, "y'", run.end_time()).abs(),
        a_frame::landing_speed(start),
        epsilon = CLOSE
    );
    let least = run.extrema(&Output::parse(AFrame::LAYOUT, "N(A)").unwrap());
    let least = least.iter().find(|e| e.minimum).unwrap();
    assert_abs_diff_eq!(least.value, a_frame::least_reaction(start), epsilon = CLOSE);
    assert_abs_diff_eq!(evaluate_output(&run, "sin(phi)", least.t), start.sin() / 3.0, epsilon = CLOSE);
}

/// The table has eight digits.
#[test]
fn double_pendulum_follows_the_table() {
    let model = DoublePendulum { m: 0.5, l: 0.5, g: 1.0 };
    let run = run(&model, Pose::new("phi_1", 0.0).with("phi_2", PI - 0.1), &["t = 10"]);
    for (t, expected) in double_pendulum::TABLE {
        for (value, expected) in run.state(t).iter().zip(expected) {
            assert_abs_diff_eq!(*value, expected, epsilon = 6e-9);
        }
    }
}

/// Small swings in each mode return after its period.
#[test]
fn double_pendulum_has_its_modes() {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 1.0 };
    for square in double_pendulum::modes(1.0, 1.0) {
        // (3/2 − 4/3 ω²) α = ½ ω² β; the error of small angles is of their square
        let ratio = (1.5 - 4.0 / 3.0 * square) / (0.5 * square);
        let amplitude = 1e-6;
        let start = pose(&[("phi_1", amplitude), ("phi_2", ratio * amplitude)]);
        let quarter = FRAC_PI_2 / square.sqrt();
        let run = run(&model, start, &[&format!("t = {quarter}")]);
        for name in ["phi_1", "phi_2"] {
            assert_abs_diff_eq!(evaluate_output(&run, name, quarter) / amplitude, 0.0, epsilon = CLOSE);
        }
    }
}

/// Three lengths of folded chain: with more bars the fall tends to the one-dimensional limit.
mod folded {
    use super::*;

    macro_rules! chain {
        ($name:ident, $links:tt) => {
            #[derive(BarSystem, Clone, Debug)]
            #[gravity(g)]
            #[chain(bar, links = $links, from = O, to = P, mass = m, length = l)]
            #[pin(O = (0, 0))]
            pub struct $name {
                pub m: f64,
                pub l: f64,
                pub g: f64,
            }
        };
    }

    chain!(Five, 5);
    chain!(Nine, 9);
    chain!(Seventeen, 17);

    /// Time until P is lowest, in √(2L/g).
    fn fall<M: BarSystem>(links: usize, model: &M) -> f64 {
        let down = links / 2;
        let angle = |k: usize| match k.cmp(&down) {
            core::cmp::Ordering::Less => -FRAC_PI_2,
            core::cmp::Ordering::Equal => 0.0,
            core::cmp::Ordering::Greater => FRAC_PI_2,
        };
        let start = M::LAYOUT.coordinates.iter().enumerate();
        let start = start.fold(Pose::nominal(), |pose, (k, c)| pose.with(c.name, angle(k)));
        let run = run(model, start, &["t = 2"]);
        let extrema = run.extrema(&Output::parse(run.layout(), "y(P)").unwrap());
        extrema.iter().find(|e| e.minimum).unwrap().t / 2.0_f64.sqrt()
    }

    #[test]
    fn the_fall_time_tends_to_its_limit() {
        let limit = folded_chain::fall_time();
        let piece = |links: u8| (1.0 / f64::from(links), 1.0 / f64::from(links), 1.0);
        let ((m5, l5, g), (m9, l9, _), (m17, l17, _)) = (piece(5), piece(9), piece(17));
        let five = fall(5, &Five { m: m5, l: l5, g }) - limit;
        let nine = fall(9, &Nine { m: m9, l: l9, g }) - limit;
        let seventeen = fall(17, &Seventeen { m: m17, l: l17, g }) - limit;
        assert!(seventeen.abs() < nine.abs() && nine.abs() < five.abs());
        assert!(seventeen.abs() < 1e-3, "{five} {nine} {seventeen}");
    }
}
