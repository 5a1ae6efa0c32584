//! The `liftoff` command: the models of this crate, and the paper that they come from.

use liftoff_models::{command, models};

/// Runs by the thousand make and leave many small lists on every thread.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() {
    liftoff_cli::run_with::<command::Command>(models())
}
