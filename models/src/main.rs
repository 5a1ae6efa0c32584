//! The `liftoff` command: the models of this crate, and the paper that they come from.

use liftoff_models::{command, models};

fn main() {
    liftoff_cli::run_with::<command::Command>(models())
}
