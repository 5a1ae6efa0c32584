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

/// Within the bound of a pose the plank starts below its corners and leaves them so slowly that it
/// never comes above: it falls back on them.
#[test]
fn what_leaves_from_below_its_corners_comes_back_on_them() {
    for (y, speed) in [(-5e-11, 1e-6), (-5e-11, 3e-5), (5e-11, 3e-5), (0.0, 3e-5)] {
        let pose = Pose::new("y", y).with("y'", speed).with("phi", 0.0).with("phi'", 0.0);
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

/// With its end B just at the corner, or a little beyond, the bar is pushed over it and rises by
/// less than the tolerance: it comes down on the corner. Pushed away from it, it falls.
#[test]
fn a_bar_that_is_pushed_over_a_corner_comes_down_on_it() {
    for tolerance in [1e-4, 1e-6, 1e-9] {
        for (beyond, speed, meets) in [(0.0, 10.0, true), (1e-12, 10.0, true), (0.0, -10.0, false)] {
            let pose = Pose::new("x", -1.0 - beyond).with("x'", speed).with("y", 0.0).with("y'", 1e-4);
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
    let refused = plank.start(Pose::new("phi", 0.1)).err();
    assert!(matches!(refused, Some(StartError::Units { .. })), "{refused:?}");
}

/// A plate on its lower edge, which may be very thin.
#[derive(BarSystem)]
#[gravity(g)]
#[body(plate, points(A = (0, 0), B = (w, 0), C = (w, h)), mass = m, inertia = m * (w * w + h * h) / 12, centre = (w / 2, h / 2))]
#[support(A = floor)]
#[support(B = floor)]
#[figure(A = (0, 0), B = (w, 0))]
#[coordinate(phi = angle(plate), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Plate {
    m: f64,
    w: f64,
    h: f64,
    g: f64,
}

/// A corner is below the floor by less than events may leave it there, but since the plate is thin
/// it stands askew by much more than that: to move its edge onto the floor would be to turn what
/// was given.
#[test]
fn a_pose_that_would_be_turned_onto_its_contacts_is_refused() {
    let begun = |w: f64, phi: f64| {
        let pose = Pose::new("phi", phi).with("phi'", 1.0).with("y", 0.0).with("y'", 0.0);
        let plate = Simulation::new(&Plate { m: 1.0, w, h: 1.0, g: 9.81 }).unwrap();
        plate.tolerance(1e-5).limit(0.1).start(pose)
    };
    let error = begun(1e-5, -0.15).err().unwrap();
    assert!(matches!(&error, StartError::Penetrates { support, depth } if support == "B" && *depth < 1.5e-6));
    let run = begun(1.0, -1e-6).unwrap().run().unwrap();
    assert!(run.events()[0].state[0].abs() < 1e-6 && run.audit().is_clean(), "{:?}", run.events());
}

/// A marble in a bowl.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = bowl((0, 0), r))]
#[figure(P = (3 * r / 5, -4 * r / 5))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Bowl {
    m: f64,
    r: f64,
    g: f64,
}

/// Near the bottom the height hardly depends on x, and is that of the bowl all the same.
#[test]
fn a_height_near_the_bottom_of_a_bowl_is_that_of_the_bowl() {
    for x in [1e-9, 1e-5, 1e-4, 5e-4, 1e-3, 1e-2, -1e-4] {
        let run = Simulation::new(&Bowl { m: 1.0, r: 1.0, g: 9.81 }).unwrap();
        let state = run.start(Pose::new("x", x)).unwrap().start_state().unwrap();
        assert!((state[1] + (1.0 - x * x).sqrt()).abs() < 1e-10, "{x}: {}", state[1]);
    }
}

/// Wheels in mesh: one angle is −2 times another, which a third has too, measured from the left.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(QB, mass = 2 * m, length = l)]
#[pin(O = (0, 0))]
#[bar(RC, mass = m, length = l)]
#[pin(Q = (3 * l, 0))]
#[pin(R = (6 * l, 0))]
#[equal(phi, -2 * psi)]
#[equal(angle(RC), angle(QB))]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(psi = angle(QB), from = right)]
#[coordinate(chi = angle(RC), from = left)]
#[figure(A = (l, 0), B = (4 * l, 0), C = (7 * l, 0))]
struct Gears {
    m: f64,
    l: f64,
    g: f64,
}

/// Starts and outputs take the name of an angle that follows another as if it were the coordinate.
#[test]
fn an_angle_that_follows_another_keeps_its_name() {
    let gears = Gears { m: 1.0, l: 1.0, g: 9.81 };
    let run =
        |pose: Pose| Simulation::new(&gears).unwrap().start(pose).unwrap().until("phi = 1").unwrap().run();
    let expected = run(Pose::new("psi", -0.2).with("psi'", 0.1)).unwrap();
    let end = expected.events().last().expect("an end");
    assert!((end["phi"] - 1.0).abs() < 1e-12 && (end["psi"] + 0.5).abs() < 1e-12, "{end}");
    assert!((end["phi'"] + 2.0 * end["psi'"]).abs() < 1e-12, "{end}");
    let starts = [
        Pose::new("phi", 0.4).with("phi'", -0.2),
        Pose::new("phi", 0.4).with("psi", -0.2).with("psi'", 0.1),
        Pose::new(Gears::CHI, core::f64::consts::PI - 0.2).with("chi'", 0.1),
    ];
    for start in starts {
        let found = run(start.clone()).unwrap_or_else(|error| panic!("{start:?}: {error}"));
        assert!((found.end_time() - expected.end_time()).abs() < 1e-12, "{start:?}");
        assert_eq!(found.value(&found.output("phi + 2 * psi").unwrap(), 0.1), 0.0, "{start:?}");
    }
    let start = |pose: Pose| Simulation::new(&gears).unwrap().start(pose).map(|_| ());
    let refused = start(Pose::new("phi", 0.4).with("psi", 0.3));
    assert!(matches!(refused, Err(StartError::Contradicts { .. })), "{refused:?}");
    let refused = start(Pose::new("phi", 0.4).with("phi", 0.4));
    assert!(matches!(refused, Err(StartError::Twice { .. })), "{refused:?}");
}

/// Two pendulums and the angle between them: it alone does not tell where they are.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(QB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[pin(Q = (3 * l, 0))]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(psi = angle(QB), from = right)]
#[coordinate(chi = angle(QB), from = OA)]
#[figure(A = (l, 0), B = (3 * l, l))]
struct Pendulums {
    m: f64,
    l: f64,
    g: f64,
}

#[test]
fn an_angle_between_two_needs_one_of_them() {
    let pendulums = Pendulums { m: 1.0, l: 1.0, g: 9.81 };
    let start = |pose: Pose| Simulation::new(&pendulums).unwrap().start(pose);
    let run = start(Pose::new("chi", 1.0).with("phi", 0.3)).unwrap().limit(0.1).run().unwrap();
    assert!((run.events()[0]["psi"] - 1.3).abs() < 1e-15, "{}", run.events()[0]);
    let refused = start(Pose::new("chi", 1.0)).map(|_| ());
    assert!(matches!(refused, Err(StartError::NotDetermined { .. })), "{refused:?}");
}

/// A point beside a bar on a pin.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(CD, mass = m, length = 2)]
#[pin(C = (0, 0))]
#[particle(P, mass = m)]
#[support(P = bar(CD), facing = left)]
#[figure(C = (0, 0), D = (2, 0), P = (1, 0))]
#[coordinate(phi = angle(CD), from = horizontal)]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Beside {
    m: f64,
    g: f64,
}

/// A point flies round the end of a bar, under it, and through it from below, as it may. From any
/// state on the way the run goes on as it did; where the point is under the bar its coordinates do
/// not tell from where it has come, and `below` does.
#[test]
fn a_state_round_the_end_of_an_edge_is_a_start_once_that_is_said() {
    let rates = [("x'", -1.0), ("y'", -2.0), ("phi'", 0.0)];
    let pose = Pose::new("phi", 0.0).with("x", 2.2).with("y", 0.3);
    let pose = rates.into_iter().fold(pose, |pose, (name, rate)| pose.with(name, rate));
    let simulation = || Simulation::new(&Beside { m: 1.0, g: 1.0 }).unwrap().limit(0.6);
    let run = simulation().start(pose.clone()).unwrap().run().unwrap();
    assert!(run.audit().is_clean() && run.events().len() == 2, "{:?}", run.events());
    let gap = run.output("gap(P)").unwrap();
    let mut below = 0;
    for k in 1..12 {
        let t = 0.05 * f64::from(k);
        let left = Pose::of_state(Beside::LAYOUT, &run.state(t));
        let is_below = run.value(&gap, t) < 0.0;
        let found = run.find_below(&run.state(t), t);
        let begun = match simulation().continued(t, &left) {
            Ok(begun) => {
                assert!(found.is_empty(), "{t}: {found:?}");
                begun
            }
            Err(error) => {
                assert_eq!(found, ["P"], "{t}");
                below += 1;
                assert!(is_below && matches!(error, StartError::BelowEdge { .. }), "{t}: {error}");
                assert!(error.to_string().ends_with("start with `below(P)` = 1"), "{error}");
                simulation().continued(t, &left.with("below(P)", 1.0)).unwrap()
            }
        };
        let rest = begun.run().unwrap();
        assert!(rest.audit().is_clean() && rest.events().len() == 2, "{t}: {:?}", rest.events());
        for (x, y) in rest.final_state().iter().zip(run.final_state()) {
            assert!((x - y).abs() < 1e-10, "{t}: {x} {y}");
        }
    }
    assert!(below > 4, "{below}");
    for (name, value) in [("below(P)", 1.0), ("below(P)", 0.5)] {
        let refused = simulation().start(pose.clone().with(name, value)).err();
        assert!(matches!(refused, Some(StartError::NotBelow { .. })), "{refused:?}");
    }
    let refused = simulation().start(pose.with("below(Q)", 1.0)).err().unwrap();
    assert!(refused.to_string().starts_with("no support `Q`"), "{refused}");
}

/// A cart with a motor.
#[derive(BarSystem)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0))]
#[force(P = (f * cos(t), 0))]
#[figure(P = (1, 0))]
struct Cart {
    m: f64,
    f: f64,
}

/// x = 1 + cos T − cos t − (t − T) sin T from rest at T; without a limit as long as from zero.
#[test]
fn a_run_begins_at_its_time() {
    let cart = || Simulation::new(&Cart { m: 2.0, f: 2.0 }).unwrap();
    let start = || Pose::new("x_P", 1.0).with("x_P'", 0.0);
    let begun = |t: f64| cart().start_at(t, start()).unwrap();
    let run = begun(0.3).limit(2.0).run().unwrap();
    assert_eq!((run.interval(), run.events()[0].t), ([0.3, 2.0], 0.3));
    let x = 1.0 + 0.3_f64.cos() - 2.0_f64.cos() - 1.7 * 0.3_f64.sin();
    assert!((run.final_state()[0] - x).abs() < 1e-11, "{:?}", run.final_state());
    assert_eq!(begun(7.0).time_limit() - 7.0, begun(0.0).time_limit());
    assert!(begun(2.0).limit(2.0).run().is_err());
    assert!(begun(2.0).until("t = 1").is_err());
}

/// A condition that no event of the run has met is told at its end, and none where one is met.
#[test]
fn conditions_that_are_not_met_are_told() {
    let not_met = |conditions: &[&str]| {
        let cart = Simulation::new(&Cart { m: 2.0, f: 2.0 })
            .unwrap()
            .start(Pose::new("x_P", 1.0))
            .unwrap()
            .limit(1.0);
        let run =
            conditions.iter().fold(cart, |cart, condition| cart.until(*condition).unwrap()).run().unwrap();
        run.log().iter().map(|entry| entry.decision.to_string()).collect::<Vec<_>>()
    };
    assert_eq!(not_met(&["x_P = 5"]), ["the run ends here, and `x_P = 5` was not met"]);
    assert_eq!(not_met(&["x_P = 5", "t = 0.5"]), [""; 0]);
    assert_eq!(not_met(&[]), [""; 0]);
}
