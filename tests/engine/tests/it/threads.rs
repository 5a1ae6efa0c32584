//! A thread goes slack, becomes taut with a jerk, and is cut.

use liftoff::prelude::*;
use liftoff_fixtures::Bob;

fn bob() -> Simulation {
    Simulation::new(&Bob { m: 2.0, l: 1.0, g: 1.0 }).unwrap()
}

/// From (l/2, 0) at rest the bob falls √3/2 until the thread is taut; of its velocity the part
/// across stays.
#[test]
fn a_falling_bob_is_caught() {
    let run = bob().start(Pose::new("x", 0.5).with("y", 0.0)).unwrap().until("x = 0").unwrap().run().unwrap();
    let [_, taut, _] = run.events() else { panic!("{:?}", run.events()) };
    let v = 3f64.sqrt().sqrt();
    assert_eq!((taut.kind, &taut.supports[..]), (EventKind::Taut, &["rope"][..]));
    assert!((taut.t - v).abs() < 1e-12);
    // The thread is at 60° to the horizontal: v sin 60° along it is lost.
    assert!((taut.impulses[0].value - 2.0 * v * 3f64.sqrt() / 2.0).abs() < 1e-12, "{taut:?}");
    assert!((taut.state[2] + 0.25 * 3f64.sqrt() * v).abs() < 1e-12, "{taut}");
    assert!((taut.state[3] + 0.25 * v).abs() < 1e-12, "{taut}");
    // N = m (g sin 60° + (v cos 60°)²/l).
    assert!((taut.reactions[0].value - 2.0 * (0.75f64.sqrt() + 0.25 * v * v)).abs() < 1e-11, "{taut:?}");
}

/// From below with v² = 3.5 g l the thread goes slack at sin ε = (v² − 2gl)/3gl = ½ above the
/// horizontal.
#[test]
fn a_fast_bob_goes_slack() {
    let run = bob().start(Pose::new("x'", 3.5f64.sqrt())).unwrap().limit(5.0).run().unwrap();
    let [_, slack, taut, ..] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!((slack.kind, taut.kind), (EventKind::Slack, EventKind::Taut));
    assert!((slack.state[1] - 0.5).abs() < 1e-10, "{slack}");
    // The parabola from the circle at ε meets it again at −3ε, at an angle of 2ε·2 to the vertical:
    // y = −sin 3ε.
    assert!((taut.state[1] + 1.0).abs() < 1e-9, "{taut}");
}

/// Cut at rest, at t = 0 and later: the tension mg jumps to zero and the bob falls.
#[test]
fn a_cut_ends_an_equilibrium() {
    assert!(bob().run().is_err());
    for at in [0.0, 0.25] {
        let run = bob().cut("rope", &format!("t = {at}")).unwrap().until("y = -1.5").unwrap().run().unwrap();
        let [start, cut, stop] = run.events() else { panic!("{:?}", run.events()) };
        assert_eq!((cut.kind, &cut.supports[..], cut.t), (EventKind::Cut, &["rope"][..], at));
        assert!((start.reactions[0].value - 2.0).abs() < 1e-15);
        assert_eq!(cut.reactions[0].value, 0.0);
        assert!((stop.t - at - 1.0).abs() < 1e-13, "{stop}");
    }
}

/// A swinging bob is cut loose at its lowest point, by a condition: from N = 3 m g it flies off
/// level.
#[test]
fn a_cut_waits_for_its_condition() {
    let run = bob().start(Pose::new("x", -1.0).with("y", 0.0)).unwrap();
    let run = run.cut("rope", "x = 0").unwrap().until("y = -3").unwrap().run().unwrap();
    let [_, cut, stop] = run.events() else { panic!("{:?}", run.events()) };
    assert!((cut.state[2] - 2f64.sqrt()).abs() < 1e-11 && cut.reactions[0].value == 0.0, "{cut}");
    let tension = Output::parse(Bob::LAYOUT, "N(rope)").unwrap();
    assert!((run.value(&tension, cut.t - 1e-9) - 6.0).abs() < 1e-6);
    assert!((stop.state[0] - 8f64.sqrt()).abs() < 1e-10, "{stop}");
}

/// A weight on a smooth ring: the thread passes it from a fixed point to a peg, from which another
/// weight hangs.
#[derive(BarSystem)]
#[gravity(g)]
#[ground(A = (-d, 0))]
#[ground(O = (d, 0))]
#[particle(P, mass = p)]
#[particle(Q, mass = q)]
#[thread(rope = A -> P -> O -> Q, length = s)]
#[figure(P = (0, -d), Q = (d, -2 * d))]
#[coordinate(x = x(P))]
#[coordinate(y = -y(P))]
#[coordinate(u = x(Q))]
#[coordinate(z = -y(Q))]
struct Pulley {
    p: f64,
    q: f64,
    d: f64,
    s: f64,
    g: f64,
}

/// 2 √(d² + y²) + z = s, so that ż = −2 y ẏ/√(d² + y²); what the ring falls less what the other
/// rises is the motion's energy.
#[test]
fn a_thread_runs_over_a_ring_that_moves() {
    let (p, q, d, g) = (3.0, 1.2, 0.8_f64, 9.81);
    let part = |y: f64| (d * d + y * y).sqrt();
    let (from, to) = (d, 1.4 * d);
    let s = 2.0 * part(from) + 3.0 * d;
    let start = Pose::new("x", 0.0).with("y", from).with("u", d).with("z", 3.0 * d);
    let simulation =
        Simulation::new(&Pulley { p, q, d, s, g }).unwrap().tolerance(1e-12).start(start).unwrap();
    let run = simulation.until(&format!("y = {to}")).unwrap().run().unwrap();
    let end = run.events().last().unwrap();
    let rise = 2.0 * (part(to) - part(from));
    let ratio = 2.0 * to / part(to);
    let rate = (2.0 * g * (p * (to - from) - q * rise) / (p + q * ratio * ratio)).sqrt();
    assert!((end["y'"] - rate).abs() < 1e-10, "{end}");
    assert!((end["z'"] + ratio * rate).abs() < 1e-10 && (end["z"] - 3.0 * d + rise).abs() < 1e-10);
    // At rest at the start: q (g + 2 ÿ sin) = T, p ÿ = p g − 2 T sin, sin = y/√(d² + y²).
    let sin = from / part(from);
    let tension = 3.0 * q * p * g / (p + 4.0 * q * sin * sin);
    let weight = tension * (1.0 + 2.0 * sin) / 3.0;
    let found = run.value(&Output::parse(Pulley::LAYOUT, "N(rope)").unwrap(), 0.0);
    assert!((found - weight).abs() < 1e-10, "{found} {weight}");
}

/// A bead on a thread between two pegs goes along an ellipse; from rest on the level of its end it
/// is fastest below the middle.
#[derive(BarSystem)]
#[gravity(g)]
#[ground(A = (-d, 0))]
#[ground(B = (d, 0))]
#[particle(P, mass = m)]
#[thread(rope = A -> P -> B, length = 2 * s)]
#[figure(P = (0, -d))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Bead {
    m: f64,
    d: f64,
    s: f64,
    g: f64,
}

#[test]
fn a_bead_goes_along_an_ellipse() {
    let (m, d, s, g) = (0.3, 0.6_f64, 1.0_f64, 9.81);
    // Half axes s and √(s² − d²).
    let low = (s * s - d * d).sqrt();
    let [x, y] = [s * 1.2_f64.cos(), -low * 1.2_f64.sin()];
    let simulation = Simulation::new(&Bead { m, d, s, g }).unwrap().tolerance(1e-12);
    let run =
        simulation.start(Pose::new("x", x).with("y", y)).unwrap().until("x = 0").unwrap().run().unwrap();
    let end = run.events().last().unwrap();
    assert!((end["y"] + low).abs() < 1e-10 && end["y'"].abs() < 1e-10, "{end}");
    let square = 2.0 * g * (y + low);
    assert!((end["x'"].powi(2) - square).abs() < 1e-9, "{end}");
    // Two parts of the thread bear m (g + v²/ϱ), ϱ = s²/low below the middle, at the angle of sine
    // low/s.
    let tension = m * (g + square * low / (s * s)) / (2.0 * low / s);
    let found = run.value(&Output::parse(Bead::LAYOUT, "N(rope)").unwrap(), end.t);
    assert!((found - tension).abs() < 1e-9, "{found} {tension}");
}
