//! A thread goes slack, becomes taut with a jerk, and is cut.

use liftoff::prelude::*;
use liftoff_fixtures::Bob;

fn bob() -> Simulation {
    Simulation::new(&Bob { m: 2.0, l: 1.0, g: 1.0 }).unwrap()
}

/// From (l/2, 0) at rest the bob falls √3/2 until the thread is taut; of its velocity the part across stays.
#[test]
fn a_falling_bob_is_caught() {
    let run = bob().start(Pose::at("x", 0.5).with("y", 0.0)).unwrap().until("x = 0").unwrap().run().unwrap();
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

/// From below with v² = 3.5 g l the thread goes slack at sin ε = (v² − 2gl)/3gl = ½ above the horizontal.
#[test]
fn a_fast_bob_goes_slack() {
    let run = bob().start(Pose::at("x'", 3.5f64.sqrt())).unwrap().limit(5.0).run().unwrap();
    let [_, slack, taut, ..] = run.events() else { panic!("{:?}", run.events()) };
    assert_eq!((slack.kind, taut.kind), (EventKind::Slack, EventKind::Taut));
    assert!((slack.state[1] - 0.5).abs() < 1e-10, "{slack}");
    // The parabola from the circle at ε meets it again at −3ε, at an angle of 2ε·2 to the vertical: y = −sin 3ε.
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

/// A swinging bob is cut loose at its lowest point, by a condition: from N = 3 m g it flies off level.
#[test]
fn a_cut_waits_for_its_condition() {
    let run = bob().start(Pose::at("x", -1.0).with("y", 0.0)).unwrap();
    let run = run.cut("rope", "x = 0").unwrap().until("y = -3").unwrap().run().unwrap();
    let [_, cut, stop] = run.events() else { panic!("{:?}", run.events()) };
    assert!((cut.state[2] - 2f64.sqrt()).abs() < 1e-11 && cut.reactions[0].value == 0.0, "{cut}");
    let tension = Output::parse(Bob::LAYOUT, "N(rope)").unwrap();
    assert!((run.value(&tension, cut.t - 1e-9) - 6.0).abs() < 1e-6);
    assert!((stop.state[0] - 8f64.sqrt()).abs() < 1e-10, "{stop}");
}
