//! Contacts with linearly dependent rows: coincident walls, parallel threads, rough contacts beside
//! guides, planks on many feet.

use liftoff::prelude::*;

/// A particle between two walls at the same place, pushed to and fro.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[particle(P, mass = m)]
#[slider(P = horizontal(0))]
#[support(left = wall(0), under = P, facing = right, restitution = e)]
#[support(right = wall(0), under = P, facing = left, restitution = e)]
#[force(F = (f * cos(t), 0), at = P)]
#[figure(P = (0, 0))]
struct Slot {
    m: f64,
    e: f64,
    f: f64,
}

/// When the force changes sign, at π/2 and 3π/2, the other wall takes over, and nothing moves.
#[test]
fn walls_at_one_place_take_over_from_each_other() {
    for tolerance in [1e-5, 1e-7, 1e-9, 1e-12] {
        for (e, f) in [(0.0, 1.0), (1.0, 1.0), (0.5, -3e4)] {
            let slot = Slot { m: 2.0, e, f };
            let run = Simulation::new(&slot).unwrap().tolerance(tolerance).limit(7.5).run().unwrap();
            let [x, left, right] = ["x_P", "N(left)", "N(right)"].map(|text| run.output(text).unwrap());
            for t in [0.3, 1.5, 1.7, 3.0, 4.6, 4.8, 7.2] {
                let [pressed, free] = if f * f64::cos(t) > 0.0 { [&right, &left] } else { [&left, &right] };
                assert_eq!(run.value(&x, t), 0.0, "{tolerance} {e} {t}");
                let expected = (f * f64::cos(t)).abs();
                assert!((run.value(pressed, t) - expected).abs() < 1e-12 * f.abs(), "{tolerance} {e} {t}");
                assert!(run.value(free, t).abs() < 1e-12 * f.abs(), "{tolerance} {e} {t}");
            }
        }
    }
}

/// A wheel on a vertical guide beside a rough rack, whose normal the guide bears as well.
#[derive(BarSystem)]
#[gravity(g)]
#[body(wheel, points(C = (0, 0), E = (r, 0)), mass = m, inertia = j, centre = (0, 0))]
#[disc(C, radius = r)]
#[slider(C = vertical(r))]
#[support(rack = wall(0), under = C, facing = right, rough)]
#[figure(C = (r, 0), E = (2 * r, 0))]
#[coordinate(phi = angle(wheel), from = right)]
#[coordinate(y = y(C))]
struct Pinion {
    m: f64,
    j: f64,
    r: f64,
    g: f64,
}

/// ÿ = −g / (1 + J/(m r²)), as it rolls.
#[test]
fn a_rough_rack_beside_a_guide_is_rolled_on() {
    let wheel = Pinion { m: 1.5, j: 0.02, r: 0.1, g: 9.81 };
    let start = Pose::new("y", 0.0).with("phi", 0.0).with("y'", 0.0).with("phi'", 0.0);
    let run = Simulation::new(&wheel).unwrap().start(start).unwrap().limit(1.0).run().unwrap();
    let [y, phi] = ["y", "phi"].map(|text| run.output(text).unwrap());
    let fallen = -0.5 * 9.81 / (1.0 + 0.02 / (1.5 * 0.01));
    assert!((run.value(&y, 1.0) - fallen).abs() < 1e-9, "{}", run.value(&y, 1.0));
    assert!((run.value(&phi, 1.0).abs() - fallen.abs() / 0.1).abs() < 1e-8);
}

/// A plank on five feet, its centre over the middle one, dragged by a growing force.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(9.81)]
#[bar(AB, mass = 1, length = 10)]
#[point(P0 = AB, at = 1)]
#[point(P1 = AB, at = 3)]
#[point(P2 = AB, at = 5)]
#[point(P3 = AB, at = 7)]
#[point(P4 = AB, at = 9)]
#[support(P0 = floor, friction = 0.3, static = 0.4)]
#[support(P1 = floor, friction = 0.3, static = 0.4)]
#[support(P2 = floor, friction = 0.3, static = 0.4)]
#[support(P3 = floor, friction = 0.3, static = 0.4)]
#[support(P4 = floor, friction = 0.3, static = 0.4)]
#[force(B = (f * t, 0))]
#[figure(A = (0, 0), B = (10, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Plank {
    f: f64,
}

/// It slips at f t = μ_s m g and slides with f t − μ m g; the feet share the weight, each a fifth.
#[test]
fn a_plank_on_many_feet_slides() {
    let run = Simulation::new(&Plank { f: 1.0 }).unwrap().limit(8.0).run().unwrap();
    let kinds: Vec<EventKind> = run.events().iter().map(|event| event.kind).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::Slip, EventKind::End]);
    let (begun, kinetic) = (0.4 * 9.81, 0.3 * 9.81);
    assert!((run.events()[1].t - begun).abs() < 1e-9);
    let span = 8.0 - begun;
    let expected =
        (8.0f64.powi(3) - begun.powi(3)) / 6.0 - 0.5 * begun * begun * span - 0.5 * kinetic * span * span;
    let x = run.output("x").unwrap();
    assert!((run.value(&x, 8.0) - expected).abs() < 1e-8, "{} {expected}", run.value(&x, 8.0));
    for foot in ["N(P0)", "N(P1)", "N(P2)", "N(P3)", "N(P4)"] {
        let reaction = run.output(foot).unwrap();
        for t in [1.0, 5.0, 7.9] {
            assert!((run.value(&reaction, t) - 9.81 / 5.0).abs() < 1e-9, "{foot} {t}");
        }
    }
}

/// A plank on six feet, pulled along and up at s.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[liftoff(sets = 0)]
#[gravity(9.81)]
#[bar(AB, mass = 1, length = 10)]
#[point(S = AB, at = s)]
#[point(P0 = AB, at = 1)]
#[point(P1 = AB, at = 2)]
#[point(P2 = AB, at = 4)]
#[point(P3 = AB, at = 5)]
#[point(P4 = AB, at = 8)]
#[point(P5 = AB, at = 9)]
#[support(P0 = floor, friction = 0.5)]
#[support(P1 = floor, friction = 0.5)]
#[support(P2 = floor, friction = 0.5)]
#[support(P3 = floor, friction = 0.5)]
#[support(P4 = floor, friction = 0.5)]
#[support(P5 = floor, friction = 0.5)]
#[force(S = (c * t, f * t))]
#[figure(A = (0, 0), B = (10, 0), S = (5, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Raised {
    s: f64,
    c: f64,
    f: f64,
}

/// The same plank on the outermost feet only.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[liftoff(sets = 0)]
#[gravity(9.81)]
#[bar(AB, mass = 1, length = 10)]
#[point(S = AB, at = s)]
#[point(P0 = AB, at = 1)]
#[point(P5 = AB, at = 9)]
#[support(P0 = floor, friction = 0.5)]
#[support(P5 = floor, friction = 0.5)]
#[force(S = (c * t, f * t))]
#[figure(A = (0, 0), B = (10, 0), S = (5, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct RaisedByEnds {
    s: f64,
    c: f64,
    f: f64,
}

/// A plank on six feet, which do not slip, pulled along and up at s.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[liftoff(sets = 0)]
#[gravity(9.81)]
#[bar(AB, mass = 1, length = 10)]
#[point(S = AB, at = s)]
#[point(P0 = AB, at = 1)]
#[point(P1 = AB, at = 2)]
#[point(P2 = AB, at = 4)]
#[point(P3 = AB, at = 5)]
#[point(P4 = AB, at = 8)]
#[point(P5 = AB, at = 9)]
#[support(P0 = floor, rough)]
#[support(P1 = floor, rough)]
#[support(P2 = floor, rough)]
#[support(P3 = floor, rough)]
#[support(P4 = floor, rough)]
#[support(P5 = floor, rough)]
#[force(S = (c * t, f * t))]
#[figure(A = (0, 0), B = (10, 0), S = (5, 0))]
#[coordinate(phi = angle(AB), from = right)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Rough {
    s: f64,
    c: f64,
    f: f64,
}

/// The inner feet have no influence: the plank is lifted, or tips about either end and slips on it
/// later.
#[test]
fn a_plank_is_lifted_from_many_feet_as_from_two() {
    for (s, c, f) in [(5.0, 0.0, 6.0), (10.0, 0.0, 6.0), (3.0, 0.0, 6.0), (7.0, 1.0, 6.0), (0.0, -2.0, 5.0)] {
        let run = Simulation::new(&Raised { s, c, f }).unwrap().limit(4.0).run().unwrap();
        let ends = Simulation::new(&RaisedByEnds { s, c, f }).unwrap().limit(4.0).run().unwrap();
        let list_events = |trajectory: &Trajectory| -> Vec<(EventKind, f64)> {
            trajectory.events().iter().map(|event| (event.kind, event.t)).collect()
        };
        let (events, expected) = (list_events(&run), list_events(&ends));
        assert_eq!(events.len(), expected.len(), "{s} {c} {f}: {events:?} {expected:?}");
        for (one, other) in events.iter().zip(&expected) {
            assert!(one.0 == other.0 && (one.1 - other.1).abs() < 1e-8, "{s} {c} {f}: {one:?} {other:?}");
        }
        for text in ["phi", "x", "y"] {
            let [value, expected] = [&run, &ends].map(|run| run.value(&run.output(text).unwrap(), 4.0));
            assert!((value - expected).abs() < 1e-7 * expected.abs().max(1.0), "{s} {c} {f}: {text}");
        }
    }
}

/// Six rough feet hold and lift as the outermost two: the plank tips about P0 or P5, φ̈ by the
/// moments about it, or rises with the surplus of the force.
#[test]
fn a_plank_is_lifted_from_many_rough_feet() {
    let inertia = |r: f64| 100.0 / 12.0 + r * r;
    // The levers of the force and of the weight about the foot that stays closed.
    for (s, f, foot) in [(10.0, 6.0, Some(1.0)), (3.0, 6.0, Some(9.0)), (5.0, 6.0, None), (5.0, 10.0, None)] {
        let begun = 9.81 / f * foot.map_or(1.0, |foot| (5.0 - foot) / (s - foot));
        let plank = Rough { s, c: 0.0, f };
        let run = Simulation::new(&plank).unwrap().limit(begun + 0.1).run().unwrap();
        let [_, opened @ .., _] = run.events() else { unreachable!("a start and an end") };
        let opens = |event: &Event| event.kind == EventKind::Open && (event.t - begun).abs() < 1e-9;
        assert!(!opened.is_empty() && opened.iter().all(opens), "{s}");
        let t = begun + 1e-3;
        let (text, rate) = match foot {
            Some(foot) => ("phi''", f * (s - foot) / inertia(5.0 - foot)),
            None => ("y''", f),
        };
        let found = run.value(&run.output(text).unwrap(), t);
        assert!((found - rate * 1e-3).abs() < 1e-8, "{s}: {found} {}", rate * 1e-3);
    }
}

/// A smooth body on four feet in a line, lifted by a growing force at 1.3 of 2.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(9.81)]
#[body(b, points(P0 = (0, 0), P2 = (0.4, 0), P3 = (0.8, 0), P1 = (2, 0), F = (1.3, 0.02)), mass = 1, inertia = 0.4, centre = (1, 0.01))]
#[support(P0 = floor)]
#[support(P1 = floor)]
#[support(P2 = floor)]
#[support(P3 = floor)]
#[force(lift = (0, f * t), at = F)]
#[figure(F = (1.3, 0.02), P0 = (0, 0), P1 = (2, 0), P2 = (0.4, 0), P3 = (0.8, 0))]
#[coordinate(phi = angle(b), from = right)]
#[coordinate(x = x(P0))]
#[coordinate(y = y(P0))]
struct Lifted {
    f: f64,
}

/// The least-norm reactions of inner feet vanish long before the body tips about the outer foot at
/// m g = 1.3 f t. No other foot opens then.
#[test]
fn a_foot_without_load_opens_no_other() {
    for tolerance in [1e-5, 1e-9, 1e-13] {
        let lifted = Lifted { f: 6.0 };
        let start = Pose::new("phi", 0.0).with("x", 0.0).with("y", 0.0);
        let simulation = Simulation::new(&lifted).unwrap().start(start).unwrap();
        let run = simulation.tolerance(tolerance).limit(1.5).run().unwrap();
        let opened: Vec<&Event> =
            run.events().iter().filter(|event| event.kind != EventKind::Start).collect();
        assert_eq!(opened.len(), 2, "{tolerance}");
        assert!((opened[0].t - 9.81 / 7.8).abs() < 1e-6, "{tolerance} {}", opened[0].t);
        assert_eq!(opened[0].supports, ["P1", "P2", "P3"]);
    }
}

/// A body on three rough feet in a line, lifted ever more at its middle, and a block that slides
/// beside it.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(9.81)]
#[body(b, points(P0 = (0, 0), P1 = (1, 0), P2 = (2, 0)), mass = 1, inertia = 0.4, centre = (1, 0.01))]
#[particle(Q, mass = 1)]
#[support(P0 = floor, rough)]
#[support(P1 = floor, rough)]
#[support(P2 = floor, rough)]
#[support(Q = floor, friction = mu)]
#[force(lift = (0, 4 * t), at = P1)]
#[coordinate(phi = angle(b), from = right)]
#[coordinate(x = x(P0))]
#[coordinate(y = y(P0))]
#[figure(P0 = (0, 0), P1 = (1, 0), P2 = (2, 0), Q = (5, 0))]
struct Unloaded {
    mu: f64,
}

/// Feet bear while their shares fall, whatever rubs elsewhere: the middle one as much as the mean
/// of the outer ones, which bear alike.
#[test]
fn rough_feet_bear_falling_shares_beside_friction() {
    let start = Pose::new("phi", 0.0).with("x", 0.0).with("y", 0.0).with("x_Q", 5.0).with("x_Q'", 1.0);
    let simulation = Simulation::new(&Unloaded { mu: 0.3 }).unwrap().start(start).unwrap();
    let run = simulation.limit(2.0).run().unwrap();
    for t in [0.0, 1e-3, 0.1, 1.0, 1.9] {
        let load = (9.81 - 4.0 * t) / 3.0;
        for foot in ["N(P0)", "N(P1)", "N(P2)"] {
            let found = run.value(&run.output(foot).unwrap(), t);
            assert!((found - load).abs() < 1e-12, "{foot} at {t}: {found}, not {load}");
        }
    }
}

/// A bar that a pin and a slider hold, and a taut thread besides, in a frame that is turned. The
/// bar's angle is measured from another, which falls.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(-3.7, -p0)]
#[bar(b0 = P1 -> P0, mass = 0.43, length = 0.65)]
#[bar(b1 = P0 -> P2, mass = 1.89, length = 0.72)]
#[bar(b2 = P0 -> P3, mass = 0.76, length = 1.54, inertia = 0.2320606582441927, centre = (p4, 0.18))]
#[mass(P3, 0.76)]
#[pin(P0 = (-p5, -p6))]
#[ground(P4 = (-p7, p8))]
#[ground(P5 = (-p9, p10))]
#[slider(P3 = line(-1 * pi / 2, (-p11, -p12)))]
#[thread(thread0 = P5 -> P4 -> P3, length = 1.5763589070636788, restitution = 0.5)]
#[coordinate(q0 = angle(b0), from = left)]
#[coordinate(q1 = angle(b1), from = right)]
#[coordinate(q2 = angle(b2), from = b0)]
#[figure(P1 = (-0.97, -1.84), P2 = (-1.37, -2.12), P3 = (-p11, -p12))]
struct Fastened {
    p0: f64,
    p4: f64,
    p5: f64,
    p6: f64,
    p7: f64,
    p8: f64,
    p9: f64,
    p10: f64,
    p11: f64,
    p12: f64,
}

/// The thread's gap is held by the joints: what is left of its second derivatives is rounding, and
/// says of no motion that it falls.
#[test]
fn a_thread_to_what_is_held_is_no_jam() {
    let fastened = Fastened {
        p0: 2.2655965784226036e-16,
        p4: 0.6020470424905908,
        p5: 1.4615437335354524,
        p6: 1.4069232269842673,
        p7: 2.231093142563807,
        p8: 0.7640936199766375,
        p9: 2.5310931425638072,
        p10: 1.3640936199766376,
        p11: 2.331093142563807,
        p12: 0.13590638002336264,
    };
    let angles = [("q0", -0.7192036732051035), ("q1", -1.4492036732051035), ("q2", -0.251592653589793)];
    let start = angles.iter().fold(Pose::default(), |pose, (name, value)| pose.with(name, *value));
    let run = Simulation::new(&fastened).unwrap().start(start).unwrap().limit(1.0).run().unwrap();
    let held = run.output("q0 + q2").unwrap();
    assert!((run.value(&held, 1.0) - (angles[0].1 + angles[2].1)).abs() < 1e-12);
    assert!(run.final_state()[0] < -2.0);
}

/// Two bars hang by threads that just let one end of each touch the floor, one the image of the
/// other but not declared as such.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(9.81)]
#[bar(AB, mass = 0.86, length = 0.87)]
#[bar(CD, mass = 0.86, length = 0.87)]
#[ground(E = (0.82, 1.3))]
#[ground(F = (-0.82, 1.3))]
#[support(A = floor(h))]
#[support(C = floor(h))]
#[thread(AE, length = 1.3 - h)]
#[thread(CF, length = 1.3 - h)]
#[coordinate(alpha = angle(AB), from = right)]
#[coordinate(gamma = angle(CD), from = right)]
#[figure(A = (0.82, h), B = (0.1, h + 0.48), C = (-0.82, h), D = (-0.1, h + 0.48))]
struct Hung {
    h: f64,
}

/// Where the disc that a thread allows touches the floor from above, the thread bears and the floor
/// is left, by both at once.
#[test]
fn threads_lift_both_ends_off_the_floor() {
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        let start = Pose::new("alpha", 2.56).with("gamma", core::f64::consts::PI - 2.56);
        let simulation = Simulation::new(&Hung { h: 0.5 }).unwrap().tolerance(tolerance);
        let run = simulation.start(start).unwrap().limit(0.1).run().unwrap();
        let opened: Vec<_> = run.events().iter().filter(|event| event.kind == EventKind::Open).collect();
        assert!(opened.len() == 1 && opened[0].supports.len() == 2 && opened[0].t == 0.0, "{opened:?}");
        let [gap, image] = ["gap(A)", "gap(C)"].map(|text| run.value(&run.output(text).unwrap(), 0.1));
        assert!(gap > 1e-5 && (gap - image).abs() < 1e-6 * gap.max(1e-3), "{gap} {image}");
        let slack = run.value(&run.output("gap(AE)").unwrap(), 0.1);
        assert!(slack.abs() < 1e-8, "{slack}");
    }
}
