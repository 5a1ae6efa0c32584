//! Error against run time of a system, as a program asks for it.

use core::time::Duration;
use liftoff::Scales;
use liftoff::method::Dop853;
use liftoff::prelude::*;
use liftoff_core::system::precise;
use liftoff_fixtures::Ladder;
use liftoff_verification::{Precision, PrecisionError, Reference, ReferenceError, ReplayError};

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// A point on a spring above a floor that it does not lose speed at.
#[derive(BarSystem, Clone, Debug)]
#[particle(P, mass = m)]
#[ground(O = (0, 0))]
#[spring(OP, stiffness = k)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, 1))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Oscillator {
    m: f64,
    k: f64,
    e: f64,
}

const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];

#[test]
fn errors_fall_with_the_tolerance() -> Outcome {
    let ladder = Ladder { m: 1.0, l: 2.0, g: 9.81 };
    let simulation = Simulation::new(&ladder)?.start(Pose::new("theta", 1.3))?.until("theta = 0")?;
    let precision = Precision::new(simulation, precise::<Ladder>).measuring(Duration::from_millis(1));
    assert!(precision.reference().is_ok_and(|reference| reference.bound() < 1e-20));
    let rows = precision.measure(Dop853, &TOLERANCES);
    for (row, tolerance) in rows.iter().zip(TOLERANCES) {
        assert_eq!((row.method, row.tolerance, &row.reason), ("dop853", tolerance, &None));
        // Some twenty steps each at their tolerance, on a motion that does not part from its
        // neighbours.
        assert!(row.state_error.is_some_and(|error| error < 100.0 * tolerance), "{row:?}");
        assert!(row.event_error.is_some_and(|error| error < 100.0 * tolerance), "{row:?}");
        assert!(0.0 < row.least && row.least <= row.median);
    }
    let work: Vec<_> = rows.iter().map(|row| row.statistics.evaluations).collect();
    assert!(work.is_sorted() && rows[2].state_error < rows[0].state_error, "{rows:?}");
    Ok(())
}

/// y = |cos t| from rest at 1: against it in the middles of 32 parts, the speed's jumps left aside.
#[test]
fn the_error_over_the_run_is_that_against_a_closed_form() -> Outcome {
    let oscillator = Oscillator { m: 1.0, k: 1.0, e: 1.0 };
    let simulation = Simulation::new(&oscillator)?.start(Pose::new("y", 1.0))?.until("t = 6")?;
    let run = simulation.clone().method(Dop853).tolerance(1e-5).run()?;
    let Scales { length, time, .. } = run.scales();
    let mut largest = 0.0_f64;
    for t in (0..32).map(|k| 6.0 * (f64::from(k) + 0.5) / 32.0).chain([6.0]) {
        let (state, sign) = (run.state(t), t.cos().signum());
        let errors = [(state[1] - t.cos().abs()) / length, (state[3] + sign * t.sin()) / (length / time)];
        largest = errors.into_iter().fold(largest, |most, error| most.max(error.abs()));
    }
    for reference in [
        Reference::compute(&run, &[], precise::<Oscillator>),
        Reference::replayed(&run, precise::<Oscillator>),
    ] {
        let error = reference?.run_error(&run).expect("the same events");
        assert!((error / largest - 1.0).abs() < 1e-6, "{error:e}, not {largest:e}");
    }
    let precision = Precision::new(simulation, precise::<Oscillator>).measuring(Duration::ZERO);
    let row = &precision.measure(Dop853, &[1e-5])[0];
    assert!(row.run_error > row.state_error.map(|error| 1.1 * error), "{row:?}");
    Ok(())
}

#[test]
fn what_cannot_be_compared_says_why() -> Outcome {
    let ladder = Ladder { m: 1.0, l: 2.0, g: 9.81 };
    // Upright at the wall nothing moves.
    let still = Simulation::new(&ladder)?.start(Pose::new("theta", core::f64::consts::FRAC_PI_2))?;
    let precision = Precision::new(still, precise::<Ladder>).measuring(Duration::from_millis(1));
    assert!(matches!(precision.reference(), Err(PrecisionError::Run(_))));
    let row = &precision.measure(Dop853, &[1e-6])[0];
    assert!(
        row.state_error.is_none() && row.reason.as_ref().is_some_and(|reason| reason.contains("equilib"))
    );
    let error = PrecisionError::from(ReferenceError::from(ReplayError::Settles { t: 1.0 }));
    assert_eq!(error.to_string(), "no reference: the impacts that end at t = 1 are infinitely many");
    Ok(())
}
