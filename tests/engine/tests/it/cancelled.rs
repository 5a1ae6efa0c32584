//! Runs that are asked to stop.

use liftoff::prelude::*;
use liftoff::{Observer, RunCause, Step};
use liftoff_fixtures::Particle;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Raises a flag in the first step after a time.
struct Impatient {
    flag: Arc<AtomicBool>,
    after: f64,
    keeps: bool,
}

impl Observer for Impatient {
    fn records(&self) -> bool {
        self.keeps
    }

    fn step(&mut self, step: &dyn Step) {
        if step.times()[1] > self.after {
            self.flag.store(true, Ordering::Relaxed);
        }
    }
}

/// An elastic ball would bounce on for ever.
fn bouncing(flag: &Arc<AtomicBool>) -> Simulation {
    Simulation::new(&Particle { m: 1.0, g: 1.0, e: 1.0 }).unwrap().limit(1e6).cancel(Arc::clone(flag))
}

#[test]
fn a_run_that_is_cancelled_keeps_its_motion_so_far() {
    let flag = Arc::new(AtomicBool::new(false));
    let mut observer = Impatient { flag: Arc::clone(&flag), after: 10.0, keeps: true };
    let error = bouncing(&flag).observe(&mut observer).unwrap_err();
    let &RunCause::Cancelled { t } = error.cause() else { panic!("{error}") };
    let run = error.trajectory();
    assert!(t > 10.0 && t == run.end_time() && t < 20.0, "{t}");
    // The first impact at √2, the others 2 √2 apart.
    let impacts = run.events().iter().filter(|event| event.kind == EventKind::Impact);
    assert_eq!(impacts.count(), ((t / 2f64.sqrt() + 1.0) / 2.0) as usize);
    // Every top is as high as the drop.
    assert!((run.state(2.0 * 2f64.sqrt())[1] - 1.0).abs() < 1e-10);
}

#[test]
fn a_run_that_is_cancelled_before_it_begins_has_its_start() {
    let flag = Arc::new(AtomicBool::new(true));
    let error = bouncing(&flag).run().unwrap_err();
    assert_eq!(*error.cause(), RunCause::Cancelled { t: 0.0 });
    assert_eq!(error.trajectory().events().len(), 1);
}
