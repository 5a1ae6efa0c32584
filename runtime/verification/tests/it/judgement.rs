//! Runs before the judge: right ones agree, wrong ones do not.

use liftoff::prelude::*;
use liftoff_fixtures::{BouncingBar, DoublePendulum, Ladder, PairOnCorners, StruckChain, Zigzag};
use liftoff_verification::judgement::{Verdict, judge};

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Of runs at 1e-12.
const NEAR: f64 = 1e-9;
/// To this the engine knows the ends of infinitely many impacts, and so what comes after them.
const SETTLED: f64 = 1e-7;

fn assert_agrees_within(run: &Trajectory, most: f64) {
    let verdict = judge(run, &[]);
    assert!(matches!(verdict, Verdict::Agrees { error } if error < most), "{verdict}");
}

fn assert_agrees(run: &Trajectory) {
    assert_agrees_within(run, NEAR);
}

#[test]
fn a_double_pendulum() -> Outcome {
    let model = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };
    assert_agrees(
        &Simulation::new(&model)?.start(Pose::new("a", 2.0).with("b", 1.0))?.until("t = 5")?.run()?,
    );
    Ok(())
}

#[test]
fn a_falling_pair() -> Outcome {
    let model = PairOnCorners { m: 1.0, l: 1.0, g: 9.81 };
    for form in [Form::Reduced, Form::Multipliers] {
        let run = Simulation::new(&model)?.start(Pose::new("phi", 0.1))?.until("phi = pi/2")?;
        assert_agrees(&run.form(form).run()?);
    }
    Ok(())
}

#[test]
fn a_ladder() -> Outcome {
    let ladder = Ladder { m: 1.0, l: 2.0, g: 9.81 };
    assert_agrees(&Simulation::new(&ladder)?.start(Pose::new("theta", 1.3))?.until("theta = 0")?.run()?);
    Ok(())
}

#[test]
fn a_struck_chain() -> Outcome {
    let run = Simulation::new(&StruckChain { m: 1.0, l: 1.0 })?.impulse("C", [0.0, 1.0], 0.5)?;
    assert_agrees(&run.until("t = 0.9")?.run()?);
    Ok(())
}

/// A bar that comes down turned by half, beyond the branch of its figure; one that bounces to rest.
#[test]
fn a_bouncing_bar() -> Outcome {
    let pi = core::f64::consts::PI;
    for (e, phi, until, most) in [(0.0, pi, 1.0, NEAR), (0.5, 0.3, 4.0, SETTLED), (0.0, 2.9, 5.0, NEAR)] {
        let bar = BouncingBar { m: 1.0, l: 1.0, g: 9.81, e };
        let start = Pose::new("phi", phi).with("x", 0.0).with("y", 1.0).with("x'", 1.0);
        let run = Simulation::new(&bar)?.start(start)?.limit(until).run()?;
        assert_agrees_within(&run, most);
    }
    Ok(())
}

/// Feet that open one after the other, of which one model has three and an energy level of its own.
#[test]
fn a_zigzag() -> Outcome {
    for (m1, m2) in [(0.5, 0.5), (0.75, 0.25), (0.25, 0.75)] {
        let model = Zigzag { m1, m2, l: 1.0, g: 1.0 };
        let start = Pose::new("phi_inner", 1.2).with("phi_outer", 1.2);
        assert_agrees(&Simulation::new(&model)?.start(start)?.until("phi_outer = 0.1")?.run()?);
    }
    Ok(())
}
