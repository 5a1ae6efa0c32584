//! `liftoff explain`.

use super::CommandError;
use super::print::print;
use crate::catalog::find;
use clap::Args;

#[derive(Args, Debug)]
pub struct Explain {
    /// Name of the model, see `liftoff list`
    model: String,
    /// Only the phase with these supports closed (`A, E`), or `free`
    #[arg(long, value_name = "SUPPORTS")]
    phase: Option<String>,
}

impl Explain {
    /// Prints the equations: the system's, then those of each phase in closed form.
    pub fn execute(&self) -> Result<(), CommandError> {
        let equations = find(&self.model)?.equations();
        match &self.phase {
            Some(supports) => Ok(print(&phase(&equations, supports)?)?),
            None => Ok(print(&equations)?),
        }
    }
}

/// The phase with these supports closed. Phases follow the system after blank lines, each under the heading
/// `free` or `on A, E`.
fn phase(equations: &str, supports: &str) -> Result<String, CommandError> {
    let phases: Vec<&str> = equations.split("\n\n").skip(1).collect();
    let heading = |phase: &&str| phase.lines().next().unwrap_or_default().to_owned();
    let found = phases.iter().find(|phase| closed(&heading(phase)) == closed(supports));
    found.map(|phase| phase.trim_end().to_owned() + "\n").ok_or_else(|| {
        let known: Vec<String> = phases.iter().map(heading).collect();
        CommandError::Usage(format!("no phase `{supports}` in closed form; there are: {}", known.join("; ")))
    })
}

/// The supports named, in alphabetical order.
fn closed(text: &str) -> Vec<&str> {
    let names = text.strip_prefix("on ").unwrap_or(text);
    let mut names: Vec<&str> = names.split(',').map(str::trim).collect();
    names.sort_unstable();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    const EQUATIONS: &str = "Zigzag\n  T = 0\n\nfree\n  x'' = 0\n\non A, E, C\n  y = 0\n";

    #[test]
    fn a_phase_is_found_whatever_the_order_of_its_supports() {
        assert!(phase(EQUATIONS, "C,A, E").is_ok_and(|text| text == "on A, E, C\n  y = 0\n"));
        assert!(phase(EQUATIONS, "free").is_ok_and(|text| text.starts_with("free\n")));
        assert!(phase(EQUATIONS, "A").is_err_and(|error| error.to_string().contains("on A, E, C")));
    }
}
