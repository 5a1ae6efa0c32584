//! The `liftoff` command.

use clap::Parser;
use liftoff_models::cli::Cli;
use std::process::ExitCode;

fn main() -> ExitCode {
    Cli::parse().execute()
}
