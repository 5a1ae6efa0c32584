//! Starts within the bounds of a pose.

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
