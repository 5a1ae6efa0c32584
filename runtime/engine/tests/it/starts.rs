//! Starts within the bounds of a pose.

use liftoff::StartError;
use liftoff::prelude::*;

/// A plank on two corners.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(P = corner(-l / 4, 0), under = AB)]
#[support(Q = corner(l / 4, 0), under = AB)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(y = y(A))]
struct Plank {
    m: f64,
    l: f64,
    g: f64,
}

/// Within the bound of a pose the plank starts below its corners and leaves them so slowly that it never comes above: it falls
/// back on them.
#[test]
fn what_leaves_from_below_its_corners_comes_back_on_them() {
    for (y, speed) in [(-5e-11, 1e-6), (-5e-11, 3e-5), (5e-11, 3e-5), (0.0, 3e-5)] {
        let pose = Pose::at("y", y).with("y'", speed).with("phi", 0.0).with("phi'", 0.0);
        let run = Simulation::new(&Plank { m: 1.0, l: 1.0, g: 9.81 }).unwrap().start(pose).unwrap();
        let run = run.tolerance(1e-12).limit(1.0).run().unwrap();
        assert!(run.audit().is_clean(), "{y} {speed}: {}", run.audit());
        assert!(run.final_state()[2].abs() < 1e-9, "{y} {speed}: {:?}", run.events());
    }
}

/// A bar over one corner.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(P = corner(0, 0), under = AB)]
#[figure(A = (-l / 2, 0), B = (l / 2, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Slider {
    m: f64,
    l: f64,
    g: f64,
}

/// With its end B just at the corner, or a little beyond, the bar is pushed over it and rises by less than the tolerance: it comes
/// down on the corner. Pushed away from it, it falls.
#[test]
fn a_bar_that_is_pushed_over_a_corner_comes_down_on_it() {
    for tolerance in [1e-4, 1e-6, 1e-9] {
        for (beyond, speed, meets) in [(0.0, 10.0, true), (1e-12, 10.0, true), (0.0, -10.0, false)] {
            let pose = Pose::at("x", -1.0 - beyond).with("x'", speed).with("y", 0.0).with("y'", 1e-4);
            let run = Simulation::new(&Slider { m: 1.0, l: 1.0, g: 9.81 }).unwrap().tolerance(tolerance);
            let run = run.start(pose.with("phi", 0.0).with("phi'", 0.0)).unwrap().limit(0.05).run().unwrap();
            let met = run.events().iter().any(|event| event.kind == EventKind::Impact);
            assert_eq!(met, meets, "{tolerance:e} {beyond} {speed}: {:?}", run.events());
        }
    }
}

/// Squares of such rates are no numbers any more.
#[test]
fn units_in_which_forces_are_lost_are_refused() {
    let plank = Simulation::new(&Plank { m: 1.0, l: 1.0, g: 1e-310 }).unwrap();
    let refused = plank.start(Pose::at("phi", 0.1)).err();
    assert!(matches!(refused, Some(StartError::Units { .. })), "{refused:?}");
}
