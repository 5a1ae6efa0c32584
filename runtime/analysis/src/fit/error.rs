//! Why data give no values of variables.

use thiserror::Error;

use super::trial::TrialError;

/// Why data give no values of variables.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// There is nothing to find.
    #[error("nothing is varied")]
    NoVariable,
    /// Fewer values than variables.
    #[error("{data} measured values are too few for {variables} variables")]
    TooFew {
        /// How many values there are.
        data: usize,
        /// How many variables.
        variables: usize,
    },
    /// The run that the search begins with cannot be compared with the data.
    #[error("at the initial values: {0}")]
    Start(TrialError),
    /// A variable does not change what is measured, or several only together.
    #[error("{}", undetermined(.0))]
    Undetermined(Vec<String>),
}

fn undetermined(names: &[String]) -> String {
    match names {
        [name] => format!("the data do not determine {name}: nothing measured depends on it"),
        names => format!(
            "the data do not determine {}: they are correlated: changes of some compensate changes of the others",
            names.join(", ")
        ),
    }
}
