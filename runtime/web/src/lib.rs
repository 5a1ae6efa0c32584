//! Declarations in the browser: derived, run and drawn by what a page asks, in a worker of its own.
//!
//! - [`answer`]: a request as JSON, and what comes of it; `requests`: what can be asked; `answers`: what is told.
//! - `session`: the models of the text that is worked on.
//! - `exports`: what the page calls. A text goes in and out through memory that the page reads and writes.

mod answers;
mod exports;
mod requests;
mod session;

use answers::Answer;
use requests::Request;
use session::Session;

/// What comes of a request, both as JSON; what is no request is told as a mistake.
pub fn answer(session: &mut State, request: &str) -> String {
    let answer = match serde_json::from_str::<Request>(request) {
        Ok(request) => session.0.answer(request),
        Err(error) => Answer::refused(format!("no request: {error}")),
    };
    serde_json::to_string(&answer).unwrap_or_default()
}

/// What is kept from one request to the next.
#[derive(Default)]
pub struct State(Session);
