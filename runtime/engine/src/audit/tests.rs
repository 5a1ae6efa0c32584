//! Audits of right motions, and of motions spoilt on purpose.

use std::sync::Arc;

use liftoff_fixtures::Particle;

use super::{Audit, AuditBounds, Quantity};
use crate::context::{RunContext, scales_of};
use crate::event::Note;
use crate::method::MethodId;
use crate::numerics::root_isolation::NODES;
use crate::prelude::*;
use crate::system::Model;
use crate::trajectory::Work;

/// A bar that a constant couple turns.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
#[couple(OA = c)]
pub(super) struct Driven {
    pub(super) m: f64,
    pub(super) l: f64,
    pub(super) g: f64,
    pub(super) c: f64,
}

/// A bar between a floor and a wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct Ladder {
    m: f64,
    l: f64,
    g: f64,
}

/// A rod that strikes a rough floor by Newton's law.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, friction = mu, restitution = 1)]
#[figure(A = (0, 0), B = (0.8, 0.6))]
#[coordinate(theta = angle(AB), from = right)]
struct Rod {
    m: f64,
    l: f64,
    g: f64,
    mu: f64,
}

fn bouncing() -> Trajectory {
    let run = Simulation::new(&Particle { m: 1.0, g: 1.0, e: 0.8 }).unwrap();
    run.start(Pose::new("y", 1.0).with("x'", 1.0)).unwrap().limit(5.0).run().unwrap()
}

fn broken(audit: &Audit) -> Vec<Quantity> {
    audit.violations().map(|finding| finding.quantity).collect()
}

#[test]
fn a_bouncing_ball_is_clean() {
    let audit = bouncing().audit();
    assert!(audit.is_clean(), "{audit}");
    let seen = |quantity| audit.worst().iter().any(|finding| finding.quantity == quantity);
    assert!(
        [Quantity::Jump, Quantity::Energy, Quantity::Impact, Quantity::Penetration].into_iter().all(seen)
    );
}

/// A bar thrown up along a wall leans on it with no force: what rounding leaves of that does not
/// pull.
#[test]
fn contacts_without_a_reaction_do_not_pull() {
    for phi in [0.3, 0.7, 1.0, 1.2, 1.5] {
        let run = Simulation::new(&Ladder { m: 0.7, l: 0.6, g: 9.81 }).unwrap();
        let start = Pose::new("phi", phi).with("phi'", 0.0).with("y", 0.1).with("y'", 2.0);
        let audit = run.start(start).unwrap().limit(0.3).run().unwrap().audit();
        assert!(audit.is_clean(), "{phi}: {audit}");
    }
}

/// The work of a load is the energy that is gained, c (φ − φ₀).
#[test]
fn a_load_does_work() {
    let run = Simulation::new(&Driven { m: 1.0, l: 1.0, g: 1.0, c: 0.1 }).unwrap();
    let run = run.start(Pose::new("phi", 2.0)).unwrap().limit(10.0).run().unwrap();
    let energy = run.output("E").unwrap();
    let gained = run.value(&energy, 10.0) - run.value(&energy, 0.0);
    assert!((gained - 0.1 * (run.final_state()[0] - 2.0)).abs() < 1e-10 && gained.abs() > 1e-3, "{gained}");
    let audit = run.audit();
    assert!(audit.is_clean() && !audit.worst().is_empty(), "{audit}");
}

/// With friction that turns the slip round Newton's law gains energy, which its event tells: only
/// what is told may be gained.
#[test]
fn an_impact_gains_what_its_law_tells() {
    let run = Simulation::new(&Rod { m: 1.0, l: 1.0, g: 9.81, mu: 0.8 }).unwrap();
    let start = Pose::new("theta", 1.0).with("x_A", 0.0).with("y_A", 0.01);
    let start = start.with("x_A'", 0.8).with("y_A'", -1.0).with("theta'", 0.0);
    let mut run = run.start(start).unwrap().limit(0.05).run().unwrap();
    let gains = |event: &&mut Event| matches!(event.note, Some(Note::EnergyGained(energy)) if energy > 1e-3);
    assert!(run.audit().is_clean(), "{}", run.audit());
    run.events.iter_mut().find(gains).expect("an impact that gains").note = None;
    assert!(broken(&run.audit()).contains(&Quantity::Impact), "{}", run.audit());
}

/// At both turns of a pendulum released level T = V = 0: its error is one of the energies in
/// between. A step ends at one.
#[test]
fn energies_are_compared_with_those_on_the_way() {
    let run = Simulation::new(&Driven { m: 1.0, l: 1.0, g: 9.81, c: 0.0 }).unwrap().method(MethodId::Gauss);
    let run = run.start(Pose::new("phi", core::f64::consts::FRAC_PI_2)).unwrap().tolerance(4.699e-8);
    for end in [2.9006, 3.193] {
        let run = run.clone().limit(end).run().unwrap_or_else(|error| panic!("{error}"));
        assert!(run.audit().is_clean(), "{}", run.audit());
    }
}

#[test]
fn a_lost_phase_is_a_jump() {
    let mut run = bouncing();
    run.phases.remove(1);
    assert!(broken(&run.audit()).contains(&Quantity::Jump), "{}", run.audit());
}

/// A ball turns round at each impact, and nowhere else.
#[test]
fn velocities_jump_at_impacts_alone() {
    let mut run = bouncing();
    assert!(run.phases.len() > 2 && run.phases[1].is_struck);
    run.phases[1].is_struck = false;
    assert_eq!(broken(&run.audit()), [Quantity::Kick]);
}

/// So many steps at so coarse a tolerance might each err as they will: more than a tenth of the
/// energy is no error of theirs.
#[test]
fn bounds_of_energies_say_something() {
    let energy = |tolerance: f64, steps: u64| AuditBounds::new(tolerance, steps).energy();
    assert!(energy(1e-3, 80) <= 0.1 && energy(1e-5, 1_000_000) <= 0.1);
    assert!((energy(1e-9, 90) - 1e-5).abs() < 1e-12);
}

#[test]
fn another_gravity_is_an_energy_that_changes() {
    let mut run = bouncing();
    let other = Particle { m: 1.0, g: 1.01, e: 0.8 };
    Arc::make_mut(&mut run.context).model = (&other).into();
    assert!(broken(&run.audit()).contains(&Quantity::Energy), "{}", run.audit());
}

/// ∫ eᶿ dθ by its values at the nodes of a guard; a kink is not told by them, and nothing is added.
#[test]
fn work_follows_from_the_values_at_the_nodes_of_guards() {
    let model = Model::from(&Particle { m: 1.0, g: 1.0, e: 0.5 });
    let scales = scales_of(&model).unwrap();
    let context = RunContext { model, scales };
    let mut work = Work::default();
    assert!(work.add_sampled(&context, &NODES.map(|theta| -(0.5 * theta).exp()), 3.0));
    let expected = -6.0 * (0.5_f64.exp() - 1.0);
    assert!((work.done - expected).abs() < 1e-12 && (work.passed + expected).abs() < 1e-12, "{work:?}");
    assert!(!work.add_sampled(&context, &NODES.map(|theta| (theta - 0.4).abs()), 1.0));
    assert!((work.done - expected).abs() < 1e-12, "{work:?}");
}
