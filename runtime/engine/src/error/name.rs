//! A name that is not known.

use thiserror::Error;

/// A name that the model does not know.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("no {kind} `{name}`{}", suggestion(nearest.as_deref(), known))]
pub struct NameError {
    /// What was looked for: `support`, `coordinate`, `name`.
    pub kind: &'static str,
    /// The name given.
    pub name: String,
    /// The nearest known one, if one is near.
    pub nearest: Option<String>,
    /// All known ones.
    pub known: Vec<String>,
}

/// How many known names are listed where none is near.
const LISTED: usize = 12;

fn suggestion(nearest: Option<&str>, known: &[String]) -> String {
    match nearest {
        Some(nearest) => format!("; did you mean `{nearest}`?"),
        None if known.is_empty() => String::new(),
        None => {
            let more = if known.len() > LISTED { ", …" } else { "" };
            format!("; known: {}{more}", known[..known.len().min(LISTED)].join(", "))
        }
    }
}
