//! Loads by tables against SciPy 1.17 (`CubicSpline`, its antiderivatives, and `solve_ivp` from
//! knot to knot), by every method.

use liftoff::method::MethodId;
use liftoff::prelude::*;

/// A force by a table of time, constant after its end.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
#[force(P = (f * table(t / s, [0, 1, 2.5, 3, 4.2, 6], [0, 1, 0.5, -1, 2, 2.5]), 0))]
struct Timed {
    m: f64,
    f: f64,
    s: f64,
}

/// A spring by a table of its length.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
#[figure(P = (0, 0))]
#[force(P = (-f * table(x(P) / l, [-3, -1, 0, 0.5, 2, 3], [-4, -2, 0, 1, 1.5, 4]), 0))]
struct Bumper {
    m: f64,
    f: f64,
    l: f64,
}

fn each<M: BarSystem>(model: &M, start: Pose, limit: f64, expected: &[(f64, [f64; 2])]) {
    for method in MethodId::ALL {
        let simulation = Simulation::new(model).unwrap().tolerance(1e-12).method(method);
        let run = simulation.start(start.clone()).unwrap().limit(limit).run();
        let run = run.unwrap_or_else(|error| panic!("{method:?}: {error}"));
        assert!(run.audit().is_clean(), "{method:?}: {:?}", run.audit());
        assert_eq!(run.events().len(), 2, "{method:?}: {:?}", run.events());
        for &(t, [x, rate]) in expected {
            let found = ["x", "x'"].map(|text| run.function(text).unwrap()(t));
            let off = (found[0] - x).abs().max((found[1] - rate).abs());
            assert!(off < 1e-10, "{method:?} at {t}: {found:?}, off by {off:e}");
        }
    }
}

#[test]
fn a_table_of_time_is_integrated_to_ten_digits() {
    let expected = [
        (0.5, [0.011373951606917536, 0.07786429340161803]),
        (2.7, [2.7308570203072815, 2.3758964495657975]),
        (6.0, [15.737055778223109, 9.677822311289242]),
        (7.0, [26.66487808951235, 12.177822311289242]),
    ];
    each(&Timed { m: 1.0, f: 1.0, s: 1.0 }, Pose::new("x", 0.0).with("y", 0.0), 7.0, &expected);
}

#[test]
fn a_table_of_the_motion_is_integrated_to_ten_digits() {
    let expected =
        [(1.0, [1.5342580890160324, -1.761669209316385]), (5.0, [1.9991391254781878, 1.3370915423474863])];
    each(&Bumper { m: 1.0, f: 1.0, l: 1.0 }, Pose::new("x", 2.5).with("y", 0.0), 5.0, &expected);
}
