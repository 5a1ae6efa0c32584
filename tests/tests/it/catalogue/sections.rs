//! Forces inside a falling chimney and in the hinge of a pendulum.

use super::{CLOSE, evaluate_output};
use crate::common::run;
use approx::assert_abs_diff_eq;
use core::f64::consts::FRAC_PI_2;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::catalogue::{chimney, hinged_bar};

#[test]
fn forces_inside_a_falling_chimney() {
    for part in [0.0, 0.1, 1.0 / 3.0, 0.5, 0.9, 1.0] {
        let model = Chimney { m: 1.0, l: 1.0, s: part, g: 1.0 };
        let run = run(&model, Pose::new("phi", 0.1), &["phi = pi/2"]);
        for tenth in 0..=10 {
            let t = run.end_time() * f64::from(tenth) / 10.0;
            let (phi, rate) = (evaluate_output(&run, "phi", t), evaluate_output(&run, "phi'", t));
            let tension = chimney::tension(phi, rate, part);
            assert_abs_diff_eq!(evaluate_output(&run, "normal(S)", t), tension, epsilon = CLOSE);
            assert_abs_diff_eq!(
                evaluate_output(&run, "shear(S)", t),
                chimney::shear(phi, part),
                epsilon = CLOSE
            );
            // it falls clockwise
            assert_abs_diff_eq!(
                evaluate_output(&run, "moment(S)", t),
                chimney::moment(phi, part),
                epsilon = CLOSE
            );
        }
    }
}

/// Of sections a hundredth apart, that at a third of the height bears the largest moment.
#[test]
fn a_chimney_breaks_at_a_third_of_its_height() {
    let moment = |s: f64| {
        let model = Chimney { m: 1.0, l: 3.0, s, g: 1.0 };
        let run = run(&model, Pose::new("phi", 1.0), &["phi = 1.2"]);
        evaluate_output(&run, "moment(S)", run.end_time()).abs()
    };
    let largest = (1..=29).map(|k| 0.1 * f64::from(k)).max_by(|a, b| moment(*a).total_cmp(&moment(*b)));
    assert_abs_diff_eq!(largest.unwrap(), 1.0, epsilon = 1e-12);
}

/// The hinge bears what the centre's acceleration leaves of the weight.
#[test]
fn released_level_the_hinge_force_follows() {
    let run = run(&Pendulum { m: 1.0, l: 1.0, g: 1.0 }, Pose::new("phi", FRAC_PI_2), &["phi = 0"]);
    for part in 0..=8 {
        let t = run.end_time() * f64::from(part) / 8.0;
        let below = FRAC_PI_2 - evaluate_output(&run, "phi", t);
        let (sin, cos) = below.sin_cos();
        // the bar points to the right and down: along it towards the hinge is (−cos, sin)
        let force = [evaluate_output(&run, "fx(O)", t), evaluate_output(&run, "fy(O)", t)];
        let (along, across) = (force[1] * sin - force[0] * cos, force[0] * sin + force[1] * cos);
        assert_abs_diff_eq!(along, hinged_bar::force_along(below), epsilon = CLOSE);
        assert_abs_diff_eq!(across, hinged_bar::force_across(below), epsilon = CLOSE);
    }
}

#[test]
fn pendulum_has_its_period() {
    let run = run(&Pendulum { m: 1.0, l: 1.0, g: 1.0 }, Pose::new("phi", FRAC_PI_2), &["phi = 0"]);
    assert_abs_diff_eq!(4.0 * run.end_time(), hinged_bar::period(FRAC_PI_2), epsilon = CLOSE);
}
