//! Whole runs: conservation of energy, mirrored against full, long ones.

use approx::assert_abs_diff_eq;
use common::{kinds, run};
use liftoff::LoggedDecision;
use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_tests::random::Source;

mod common;

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

/// Far below, a corner's gap is rounding of a large drop at each half turn: the search for its closing must go on.
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

/// Thrown from any pose, its bars folded back among them, where feet close on branches that are not the figure's.
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

/// Two bars on their corners fall through level, where x does not follow from the angles any more: near it reactions of the closed
/// form are the error of the state by 1/p³, of which no event is read.
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
