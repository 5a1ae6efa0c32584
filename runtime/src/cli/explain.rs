//! `liftoff explain`.

use super::CommandError;
use super::print::print;
use crate::catalog::Models;
use clap::Args;

#[derive(Args, Debug)]
pub struct Explain {
    /// Name of the model, as `list` has it
    model: String,
    /// Only the phase with these supports closed (`A, E`), or `free`
    #[arg(long, value_name = "SUPPORTS")]
    phase: Option<String>,
}

impl Explain {
    /// Prints the equations: the system's, then those of each phase in closed form.
    pub fn execute(&self, models: &Models) -> Result<(), CommandError> {
        let equations = models.find(&self.model)?.layout().explain();
        match &self.phase {
            Some(supports) => Ok(print(phase(&equations.phases, supports)?)?),
            None => Ok(print(&equations.to_string())?),
        }
    }
}

/// The equations with exactly these supports closed, of phases by their closed supports.
fn phase<'a>(phases: &'a [(String, String)], supports: &str) -> Result<&'a str, CommandError> {
    let found = phases.iter().find(|(closed, _)| names(&title(closed)) == names(supports));
    found.map(|(_, equations)| equations.as_str()).ok_or_else(|| {
        let known: Vec<_> = phases.iter().map(|(closed, _)| title(closed)).collect();
        CommandError::Usage(format!("no phase `{supports}` in closed form; there are: {}", known.join("; ")))
    })
}

/// The supports named, in alphabetical order.
fn names(text: &str) -> Vec<&str> {
    let names = text.strip_prefix("on ").unwrap_or(text);
    let mut names: Vec<&str> = names.split(',').map(str::trim).collect();
    names.sort_unstable();
    names
}

/// A phase as it is headed in the equations.
fn title(closed: &str) -> String {
    if closed.is_empty() { "free".to_owned() } else { format!("on {closed}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_phase_is_found_whatever_the_order_of_its_supports() {
        let phases = [("", "free"), ("A, E, C", "on A, E, C")].map(|(a, b)| (a.to_owned(), b.to_owned()));
        assert!(phase(&phases, "C,A, E").is_ok_and(|equations| equations == "on A, E, C"));
        assert!(phase(&phases, "free").is_ok_and(|equations| equations == "free"));
        assert!(phase(&phases, "A").is_err_and(|error| error.to_string().contains("free; on A, E, C")));
    }
}
