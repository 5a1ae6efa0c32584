//! The book. Its examples are tests.
//!
//! 1. [`tutorial`]: from an empty directory to your own system that moves on a page.
//! 2. [`equations`]: how a description becomes equations, on Fig. 1a of the paper.
//! 3. [`events`]: which supports carry, and how it is decided.
//! 4. [`methods`]: choosing a method of integration, a tolerance, a way of running.
//! 5. [`vocabulary`]: what to do when a system needs more than there is a word for.
//! 6. [`promises`]: what is promised, how it is tested, what is not promised, and what was measured.

#[doc = include_str!("equations.md")]
pub mod equations {}
#[doc = include_str!("events.md")]
pub mod events {}
#[doc = include_str!("methods.md")]
pub mod methods {}
#[doc = include_str!("promises.md")]
#[doc = include_str!("measured.md")]
pub mod promises {}
#[doc = include_str!("tutorial.md")]
pub mod tutorial {}
#[doc = include_str!("vocabulary.md")]
pub mod vocabulary {}

#[cfg(test)]
mod tests {
    /// The tutorial's program is the example of that name, which is compiled and run.
    #[test]
    fn the_tutorial_shows_the_example() {
        assert!(include_str!("tutorial.md").contains(include_str!("../../examples/step_ladder.rs")));
    }
}
