//! Motions on the branch of sin α = ± sin β that is not the one of the nominal figure: the closed
//! form does not hold there. No coordinate may jump and no event may add energy.

use core::f64::consts::PI;

use liftoff::LoggedDecision;
use liftoff::prelude::*;
use liftoff_core::model::Form;
use liftoff_fixtures::BouncingBar;
use liftoff_fixtures::RodOnSupports;
use liftoff_fixtures::Zigzag;
use liftoff_fixtures::breaches;

const ZIGZAG: Zigzag = Zigzag { m1: 0.5, m2: 0.5, l: 1.0, g: 9.81 };

fn run<M: BarSystem>(model: &M, start: Pose, limit: f64) -> Trajectory {
    let run = Simulation::new(model).unwrap().start(start.clone()).unwrap().limit(limit).run().unwrap();
    assert_eq!(breaches(&run), [""; 0], "{start:?}");
    run
}

/// Every entry of the start is that of the pose, which satisfies its contacts to rounding.
fn starts_as_given(run: &Trajectory, pose: &[f64]) {
    for state in [run.state(0.0), run.events()[0].state.clone()] {
        let apart = state.iter().zip(pose).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(apart < 1e-15, "{state:?} for {pose:?}");
    }
}

/// Its end is level with B to the left of A, while the figure has it on the right.
#[test]
fn a_bar_comes_to_rest_on_its_other_side() {
    for (e, phi) in [(0.0, PI), (0.5, 2.9)] {
        let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e };
        let run = run(&bar, Pose::new("phi", phi).with("x", 0.0).with("y", 1.0), 5.0);
        let end = run.final_state();
        assert!((end[0] - PI).abs() < 1e-9, "{end:?}");
        let forms: Vec<_> = run.segments().iter().map(|segment| segment.form).collect();
        assert_eq!(forms.last(), Some(&Form::Multipliers));
        assert!(
            run.log().iter().any(|entry| entry.decision == LoggedDecision::OtherBranch),
            "{:?}",
            run.log()
        );
    }
}

/// φ = 0 is the figure's own branch: nothing changes for it.
#[test]
fn a_bar_comes_to_rest_on_the_side_of_the_figure() {
    let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e: 0.0 };
    let run = run(&bar, Pose::new("phi", 0.3).with("x", 0.0).with("y", 1.0), 2.0);
    let last = run.segments().pop().unwrap();
    assert_eq!((last.form, last.set.len()), (Form::Reduced, 2));
    assert_eq!(run.final_state()[0], 0.0);
    assert!(run.log().iter().all(|entry| entry.decision != LoggedDecision::OtherBranch), "{:?}", run.log());
}

/// C strikes with the outer bars folded over the inner ones.
#[test]
fn feet_close_on_the_other_branch() {
    for (inner, outer) in [(2.0, 1.14), (1.0, 2.3)] {
        run(&ZIGZAG, Pose::new("phi_inner", inner).with("phi_outer", outer).with("y", 0.1), 0.6);
        run(&ZIGZAG, Pose::new("phi_inner", inner).with("phi_outer", outer), 0.6);
    }
}

/// The outer bars lie along the inner ones: sin φ is the same, φ is not.
#[test]
fn a_start_on_the_other_branch_is_kept() {
    for inner in [2.0, 1.0] {
        let pose = Pose::new("phi_inner", inner).with("phi_outer", PI - inner);
        let run = run(&ZIGZAG, pose, 0.3);
        starts_as_given(&run, &[inner, PI - inner, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(run.segments()[0].form, Form::Multipliers);
    }
}

/// Where both branches meet, rates between them satisfy both contacts to first order: one of these
/// opens, unless it is held.
#[test]
fn rates_where_the_branches_meet_are_kept_or_refused() {
    let upright = Pose::new("phi_inner", PI / 2.0).with("phi_outer", PI / 2.0);
    let start = upright.with("phi_inner'", 1.0).with("phi_outer'", 0.5);
    starts_as_given(&run(&ZIGZAG, start.clone(), 0.2), &[PI / 2.0, PI / 2.0, 0.0, 1.0, 0.5, 0.0]);
    let held = Simulation::new(&ZIGZAG).unwrap().start(start).unwrap().hold("A").unwrap().hold("C").unwrap();
    let cause = held.limit(0.2).run().map_err(|error| error.cause().clone()).map(drop);
    assert!(matches!(cause, Err(liftoff::RunCause::Start(liftoff::StartError::Contact(_)))), "{cause:?}");
}

/// A rod turned by half, and by whole turns, is the rod.
#[test]
fn a_turned_rod_stays_turned() {
    let rod = RodOnSupports { m: 1.0, l: 1.0, g: 1.0 };
    for turned in [PI, -PI, 2.0 * PI] {
        let simulation = Simulation::new(&rod).unwrap().start(Pose::new("theta", turned)).unwrap();
        let run = simulation.release("A", 0.1).unwrap().limit(0.4).run().unwrap();
        assert_eq!(breaches(&run), [""; 0]);
        assert!((run.state(0.1)[0] - turned).abs() < 1e-12);
    }
}

/// sin φ_inner = sin φ_outer is flat at π/2: its rounding leaves the angle that was not given
/// unknown by 2e-8, from which the bars would fall long before their time.
#[test]
fn a_start_where_gaps_are_flat_is_on_the_closed_form() {
    let bars = liftoff_fixtures::Zigzag { m1: 1.0, m2: 1.0, l: 1.0, g: 9.81 };
    for angle in [PI / 2.0 - 3e-8, PI / 2.0 - 1e-4, 1.2] {
        let simulation = Simulation::new(&bars).unwrap().start(Pose::new("phi_outer", angle)).unwrap();
        let run = simulation.limit(0.01).run().unwrap();
        let start = &run.events()[0].state;
        assert!(
            (start[0] - angle).abs().max((start[1] - angle).abs()) <= 4.0 * f64::EPSILON,
            "{angle}: {start:?}"
        );
    }
    let upright = Simulation::new(&bars).unwrap().start(Pose::new("phi_outer", PI / 2.0)).unwrap();
    let refused = upright.run().map_err(|error| error.cause().clone()).map(drop);
    assert!(
        matches!(refused, Err(liftoff::RunCause::Start(liftoff::StartError::Equilibrium))),
        "{refused:?}"
    );
}
