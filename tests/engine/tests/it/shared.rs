//! What may cross threads.

use liftoff::prelude::*;
use liftoff::{Condition, PhaseHandle, RunCause};

fn may_be_shared<T: Send + Sync>() {}

#[test]
fn simulations_and_motions_may_cross_threads() {
    may_be_shared::<Simulation>();
    may_be_shared::<Trajectory>();
    may_be_shared::<RunError>();
    may_be_shared::<RunCause>();
    may_be_shared::<PhaseHandle>();
    may_be_shared::<(Output, Condition, Pose)>();
}
