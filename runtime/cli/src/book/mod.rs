//! The book. Its examples are tests.
//!
//! 1. [`tutorial`]: from an empty directory to your own system that moves on a page.
//! 2. [`equations`]: how a description becomes equations, on Fig. 1a of the paper.
//! 3. [`events`]: which supports carry, and how it is decided.
//! 4. [`friction`]: contacts that stick and slip, Painlevé's paradox, impacts with friction.
//! 5. [`equilibria`]: where a system rests, what its contacts bear there, how it vibrates.
//! 6. [`conditions`]: when a contact opens, as a formula; first integrals.
//! 7. [`sensitivities`]: derivatives of times and states with respect to parameters and starts.
//! 8. [`fits`]: parameters and starts from measurements, with their errors.
//! 9. [`optima`]: parameters and starts with which an output is least or greatest.
//! 10. [`orbits`]: motions that repeat, their multipliers, branches of them.
//! 11. [`boundaries`]: where in a plane of parameters something else happens first.
//! 12. [`methods`]: choosing a method of integration, a tolerance, a way of running.
//! 13. [`tolerances`]: what follows the tolerance, and what does not.
//! 14. [`without_a_compiler`]: files run at once, a page that follows them, the browser.
//! 15. [`python`]: the same from Python, as arrays, in notebooks.
//! 16. [`other_programs`]: tables as Parquet and Arrow, the equations as sources for SymPy, models as functional mock-up units.
//! 17. [`vocabulary`]: what to do when a system needs more than there is a word for.
//! 18. [`promises`]: what is promised, how it is tested, what is not promised, and what was measured.
//! 19. [`performance`]: accuracy, speed and cost, each with the command that measures it.
//! 20. [`architecture`]: how the source is laid out, and what holds everywhere in it.

#[doc = include_str!("architecture.md")]
pub mod architecture {}
#[doc = include_str!("boundaries.md")]
pub mod boundaries {}
#[doc = include_str!("conditions.md")]
pub mod conditions {}
#[doc = include_str!("equilibria.md")]
pub mod equilibria {}
#[doc = include_str!("equations.md")]
pub mod equations {}
#[doc = include_str!("events.md")]
pub mod events {}
#[doc = include_str!("fits.md")]
pub mod fits {}
#[doc = include_str!("friction.md")]
pub mod friction {}
#[doc = include_str!("methods.md")]
pub mod methods {}
#[doc = include_str!("optima.md")]
pub mod optima {}
#[doc = include_str!("orbits.md")]
pub mod orbits {}
#[doc = include_str!("other_programs.md")]
pub mod other_programs {}
#[doc = include_str!("performance.md")]
pub mod performance {}
#[doc = include_str!("promises.md")]
#[doc = include_str!("measured.md")]
pub mod promises {}
#[doc = include_str!("python.md")]
pub mod python {}
#[doc = include_str!("sensitivities.md")]
pub mod sensitivities {}
#[doc = include_str!("tolerances.md")]
pub mod tolerances {}
#[doc = include_str!("tutorial.md")]
pub mod tutorial {}
#[doc = include_str!("vocabulary.md")]
pub mod vocabulary {}
#[doc = include_str!("weight.md")]
pub mod weight {}
#[doc = include_str!("without_a_compiler.md")]
pub mod without_a_compiler {}

#[cfg(test)]
mod tests {
    /// The tutorial's program is the example of that name, which is compiled and run.
    #[test]
    fn the_tutorial_shows_the_example() {
        assert!(include_str!("tutorial.md").contains(include_str!("../../examples/step_ladder.rs")));
    }

    /// `.ci` runs every command that the README shows; what is compiled once more, `.ci/long` does.
    #[test]
    fn the_commands_of_the_readme_are_run() {
        let readme = include_str!("../../../../README.md");
        let commands =
            readme.lines().filter(|line| line.starts_with("cargo run") || line.starts_with("cargo test"));
        let commands: Vec<&str> = commands.map(|line| line.split("  ").next().unwrap_or(line)).collect();
        assert!(commands.len() > 12);
        let scripts = [include_str!("../../../../.ci/run"), include_str!("../../../../.ci/long")];
        for command in commands {
            let run = |line: &str| line.trim_start().split(" >").next() == Some(command);
            assert!(scripts.iter().any(|script| script.lines().any(run)), "{command}");
        }
    }
}
