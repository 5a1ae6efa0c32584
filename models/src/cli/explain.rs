//! `liftoff explain`.

use super::CommandError;
use crate::catalog::find;
use clap::Args;

#[derive(Args, Debug)]
pub struct Explain {
    /// Name of the model, see `liftoff list`
    model: String,
    /// Only the phase with these supports closed, `A, E`, or `free`
    #[arg(long, value_name = "SUPPORTS")]
    phase: Option<String>,
}

impl Explain {
    /// Prints the equations.
    pub fn execute(&self) -> Result<(), CommandError> {
        let equations = find(&self.model)?.equations();
        print!("{equations}");
        Ok(())
    }
}
