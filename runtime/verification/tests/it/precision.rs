//! Error against run time of a system, as a program asks for it.

use core::time::Duration;
use liftoff::method::Dop853;
use liftoff::prelude::*;
use liftoff::system::precise;
use liftoff_fixtures::Ladder;
use liftoff_verification::{Precision, PrecisionError, ReferenceError, ReplayError};

type Outcome = Result<(), Box<dyn std::error::Error>>;

const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];

#[test]
fn errors_fall_with_the_tolerance() -> Outcome {
    let ladder = Ladder { m: 1.0, l: 2.0, g: 9.81 };
    let simulation = Simulation::new(&ladder)?.start(Pose::at("theta", 1.3))?.until("theta = 0")?;
    let mut precision = Precision::new(simulation, precise::<Ladder>).measuring(Duration::from_millis(1));
    assert!(precision.reference().is_ok_and(|reference| reference.bound() < 1e-20));
    let rows = precision.measure(Dop853, &TOLERANCES);
    for (row, tolerance) in rows.iter().zip(TOLERANCES) {
        assert_eq!((row.method, row.tolerance, &row.reason), ("dop853", tolerance, &None));
        // Some twenty steps each at their tolerance, on a motion that does not part from its neighbours.
        assert!(row.state_error.is_some_and(|error| error < 100.0 * tolerance), "{row:?}");
        assert!(row.event_error.is_some_and(|error| error < 100.0 * tolerance), "{row:?}");
        assert!(0.0 < row.least && row.least <= row.median);
    }
    let work: Vec<_> = rows.iter().map(|row| row.statistics.evaluations).collect();
    assert!(work.is_sorted() && rows[2].state_error < rows[0].state_error, "{rows:?}");
    Ok(())
}

#[test]
fn what_cannot_be_compared_says_why() -> Outcome {
    let ladder = Ladder { m: 1.0, l: 2.0, g: 9.81 };
    // Upright at the wall nothing moves.
    let still = Simulation::new(&ladder)?.start(Pose::at("theta", core::f64::consts::FRAC_PI_2))?;
    let mut precision = Precision::new(still, precise::<Ladder>).measuring(Duration::from_millis(1));
    assert!(matches!(precision.reference(), Err(PrecisionError::Run(_))));
    let row = &precision.measure(Dop853, &[1e-6])[0];
    assert!(
        row.state_error.is_none() && row.reason.as_ref().is_some_and(|reason| reason.contains("equilib"))
    );
    let error = PrecisionError::from(ReferenceError::from(ReplayError::Settles { t: 1.0 }));
    assert_eq!(error.to_string(), "no reference: the impacts that end at t = 1 are infinitely many");
    Ok(())
}
