//! What is tried, and what is found.

use std::any::Any;
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What became of a case, in words that are counted: `refused`, `ran`.
pub type Fate = Vec<&'static str>;

/// Something that is fed with hostile input.
pub trait Subject {
    /// One input.
    type Case: Display;

    /// The case of a seed, the same whenever it is drawn.
    fn generate(&self, seed: u64) -> Self::Case;

    /// Tries a case.
    ///
    /// # Errors
    /// What is wrong, if something is. A panic is wrong too; [`judge`] catches it.
    fn check(&self, case: &Self::Case) -> Result<Fate, Finding>;

    /// What else there is to see of a case, for those who look into a finding.
    fn details(&self, _: &Self::Case) -> String {
        String::new()
    }
}

/// Something wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding(pub String);

impl Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// Tries a case; a panic is a finding.
///
/// # Errors
/// What is wrong.
pub fn judge<S: Subject>(subject: &S, case: &S::Case) -> Result<Fate, Finding> {
    let checked = catch_unwind(AssertUnwindSafe(|| subject.check(case)));
    checked.unwrap_or_else(|panic| Err(Finding(format!("panic: {}", message(panic.as_ref())))))
}

fn message(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("without a message")
}
