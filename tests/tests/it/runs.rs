//! Whole runs: conservation of energy, mirrored against full, long ones.

use crate::common::{kinds, run};
use approx::assert_abs_diff_eq;
use liftoff::prelude::*;
use liftoff::{Condition, LoggedDecision};
use liftoff_compiled::*;
use liftoff_tests::random::Source;

/// At tolerance 1e-13 the energy of a smooth phase drifts by less than 1e-12 of its scale.
#[test]
fn energy_is_kept_in_smooth_phases() {
    fn drift(run: &Trajectory) -> f64 {
        let energy = Output::parse(run.layout(), "E").unwrap();
        let potential = Output::parse(run.layout(), "V").unwrap();
        let first = run.value(&energy, run.start_time());
        let times = run.times();
        let scale = times.iter().map(|&t| run.value(&potential, t).abs()).fold(0.0, f64::max);
        times.iter().map(|&t| (run.value(&energy, t) - first).abs()).fold(0.0, f64::max) / scale
    }
    let g = 9.81;
    let pair = FallingPair { m: 1.0, l: 1.0, g };
    assert!(drift(&run(&pair, Pose::new("phi", 0.1), &["phi = pi/2"])) < 1e-12);
    let chain = DoublePendulum { m: 1.0, l: 1.0, g };
    assert!(drift(&run(&chain, Pose::new("phi_1", 2.0).with("phi_2", 1.0), &["t = 2"])) < 1e-12);
    let zigzag = Zigzag { m1: 0.5, m2: 0.5, l: 1.0, g };
    assert!(drift(&run(&zigzag, Pose::new("phi_inner", 1.5).with("phi_outer", 1.5), &[])) < 1e-12);
}

/// The mirrored model is a substitution into the full one: the same events at the same states.
#[test]
fn mirrored_and_full_agree() {
    let (m1, m2, l, g) = (0.5, 0.5, 1.0, 9.81);
    let half = run(&Zigzag { m1, m2, l, g }, Pose::new("phi_inner", 1.5).with("phi_outer", 1.5), &[]);
    let pose = ["phi_ab", "phi_bc", "phi_cd", "phi_de"]
        .iter()
        .fold(Pose::new("x", 0.0), |p, name| p.with(name, 1.5));
    let full = run(&ZigzagFull { m1, m2, l, g }, pose, &[]);
    assert_eq!(kinds(&half), kinds(&full));
    for (a, b) in half.events().iter().zip(full.events()) {
        // 1.5 rad is near an unstable equilibrium: errors grow by some e^7 until the feet leave.
        assert_abs_diff_eq!(a.t, b.t, epsilon = 1e-10);
        assert_abs_diff_eq!(a.state[0], b.state[2], epsilon = 1e-10);
        assert_abs_diff_eq!(a.state[1], b.state[3], epsilon = 1e-10);
    }
}

/// Far below, a corner's gap is rounding of a large drop at each half turn: the search for its
/// closing must go on.
#[test]
fn a_long_flight_ends() {
    let run = run(&FallingPair { m: 1.0, l: 1.0, g: 9.81 }, Pose::new("phi", 0.01), &["t = 60"]);
    assert_eq!(kinds(&run).last(), Some(&(EventKind::Stop, vec![])));
    assert_eq!(run.end_time(), 60.0);
}

/// Three feet leave a four-bar chain three degrees of freedom, which no energy level settles.
#[test]
fn an_energy_level_needs_one_degree_of_freedom() {
    let model = ZigzagFull { m1: 0.5, m2: 0.5, l: 1.0, g: 1.0 };
    let start = Simulation::new(&model).unwrap().start(Pose::new("phi_ab", 1.5)).unwrap();
    let error = start.on_energy_of(Pose::new("phi_ab", 1.57)).err().unwrap();
    assert!(matches!(error, liftoff::StartError::Degrees { degrees: 3 }), "{error}");
}

/// Thrown from any pose, its bars folded back among them, where feet close on branches that are not
/// the figure's.
#[test]
fn no_event_moves_a_chain_or_gives_it_energy() {
    let model = ZigzagFull { m1: 0.5, m2: 0.5, l: 1.0, g: 9.81 };
    let mut source = Source::new(5);
    let mut branches = 0;
    for _ in 0..60 {
        let place = |c: &liftoff_core::model::Coordinate, source: &mut Source| match c.is_angle {
            true => source.range(-4.0, 4.0),
            false => source.range(0.0, 2.5),
        };
        let coordinates = ZigzagFull::LAYOUT.coordinates;
        let placed = coordinates.iter().fold(Pose::nominal(), |p, c| p.with(c.name, place(c, &mut source)));
        let mut rate = |p: Pose, name: &str| p.with(format!("{name}'"), source.range(-1.5, 1.5));
        let thrown = coordinates.iter().fold(placed, |p, c| rate(p, c.name));
        // Some would start below the floor.
        let Ok(simulation) = Simulation::new(&model).unwrap().start(thrown.clone()) else { continue };
        let run = simulation.limit(2.0).run().unwrap();
        assert_eq!(liftoff_fixtures::breaches(&run), [""; 0], "{thrown:?}");
        branches += run.log().iter().filter(|entry| entry.decision == LoggedDecision::OtherBranch).count();
    }
    assert!(branches > 0);
}

/// Two bars on their corners fall through level, where x does not follow from the angles any more:
/// near it reactions of the closed form are the error of the state by 1/p³, of which no event is
/// read.
#[test]
fn bars_fall_through_level_without_an_event() {
    use liftoff::method::MethodId;
    let model = FallingPairFull { m: 1.0, l: 1.0, g: 9.81 };
    let fall = |method: MethodId, tolerance: f64| {
        let start = Pose::new("phi_left", 0.2).with("phi_right", 0.100_000_01).with("phi_left'", 0.0);
        let run = Simulation::new(&model).unwrap().start(start).unwrap();
        run.method(method).tolerance(tolerance).limit(0.63).run().unwrap()
    };
    let known = fall(MethodId::Dop853, 1e-13);
    for tolerance in [1e-3, 1e-4, 5.109e-5, 1e-5, 1e-6, 1e-8] {
        let run = fall(MethodId::Taylor, tolerance);
        assert_eq!(run.events().len(), 2, "{tolerance}: {:?}", run.events());
        let off = (run.final_state()[0] - known.final_state()[0]).abs();
        assert!(off < 10.0 * tolerance && run.audit().is_clean(), "{tolerance}: {off:e}");
    }
}

/// What `serde` writes of an event is what its fields say, its kind and note as text.
#[test]
fn events_are_serialised_by_their_fields() {
    let ball = BouncingBall { m: 1.0, g: 9.81, e: 0.5 };
    let run = run(&ball, Pose::new("y", 1.0).with("x", 0.0), &["t = 0.5"]);
    let impact = run.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    let json = serde_json::to_value(impact).unwrap();
    let names: Vec<&String> = json.as_object().unwrap().keys().collect();
    let all = ["before", "energy", "impulses", "kind", "note", "reactions", "state", "supports", "t"];
    assert_eq!(names, all);
    assert_eq!((&json["kind"], &json["t"]), (&"impact".into(), &impact.t.into()));
    assert_eq!(json["state"], serde_json::json!(impact.state));
    assert_eq!(json["impulses"][0]["value"], impact.impulses[0].value);
    assert_eq!(json["before"]["energy"]["kinetic"], impact.before.as_ref().unwrap().energy.kinetic);
    assert_eq!(json["note"].as_str(), impact.note.as_ref().map(ToString::to_string).as_deref());
}

/// Samples are the values of outputs at times; states those at the ends of steps, both sides of an
/// impact.
#[test]
fn samples_and_states_are_values_of_the_motion() {
    let ball = BouncingBall { m: 1.0, g: 9.81, e: 0.5 };
    let run = run(&ball, Pose::new("y", 1.0).with("x", 0.0), &["t = 0.8"]);
    let outputs = ["y", "y'", "E"].map(|text| run.output(text).unwrap());
    let rows = run.sample([0.1, 0.3, 0.7], &outputs);
    for (t, row) in [0.1_f64, 0.3].into_iter().zip(&rows) {
        let closed = [1.0 - 9.81 * t * t / 2.0, -9.81 * t, 9.81];
        row.iter().zip(closed).for_each(|(value, exact)| assert_abs_diff_eq!(*value, exact, epsilon = 1e-11));
    }
    assert_eq!(rows[2], outputs.each_ref().map(|output| run.value(output, 0.7)));
    let impact = run.events().iter().find(|event| event.kind == EventKind::Impact).unwrap();
    let sides: Vec<Vec<f64>> =
        run.states().filter(|(instant, _)| instant.t == impact.t).map(|(_, state)| state).collect();
    assert_eq!(sides.len(), 2);
    assert_abs_diff_eq!(sides[1][3], -0.5 * sides[0][3], epsilon = 1e-12);
}

/// A condition ends a run as its text does.
#[test]
fn until_takes_text_or_a_condition() {
    let pair = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
    let prepared = || Simulation::new(&pair).unwrap().start(Pose::new("phi", 0.1)).unwrap();
    let condition = Condition::parse(prepared().layout(), "phi = 1").unwrap();
    let typed = prepared().until(condition).unwrap().run().unwrap();
    let text = prepared().until("phi = 1").unwrap().run().unwrap();
    assert_eq!((typed.end_time(), typed.final_state()), (text.end_time(), text.final_state()));
    assert_abs_diff_eq!(typed.final_state()[0], 1.0, epsilon = 1e-12);
}
