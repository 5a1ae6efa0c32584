//! Why a browser did not do what was asked.

use serde_json::Value;

/// Why a browser did not do what was asked.
#[derive(thiserror::Error, Debug)]
pub enum BrowserError {
    /// ChromeDriver could not be started.
    #[error("cannot start chromedriver: {0}")]
    Start(String),
    /// ChromeDriver could not be reached.
    #[error("no answer from chromedriver: {0}")]
    Connection(#[from] ureq::Error),
    /// It refused a command.
    #[error("{command}: {answer}")]
    Refused {
        /// The command's path.
        command: String,
        /// What it answered.
        answer: Value,
    },
    /// A page is not as it should be.
    #[error("{0}")]
    Page(String),
}
