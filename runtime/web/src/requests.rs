//! What can be asked.

use liftoff_studio::run_spec::RunSpec;
use serde::Deserialize;
use std::collections::BTreeMap;

/// What a page asks.
#[derive(Deserialize, Debug)]
#[serde(tag = "ask", rename_all = "lowercase", deny_unknown_fields)]
pub enum Request {
    /// To derive what a text declares; of several models the one of this name.
    Derive {
        /// Rust.
        text: String,
        /// The model's name.
        #[serde(default)]
        model: Option<String>,
    },
    /// The equations of what has been derived last.
    Equations,
    /// Its motion.
    Run(Box<Run>),
    /// Its motion as a table.
    Table(Box<Run>),
}

/// The run of a model; what is not given is as in its `spec`.
#[derive(Deserialize, Debug)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The run to begin with; none for the declared one.
    #[serde(default)]
    pub spec: Option<RunSpec>,
    /// Values of parameters.
    #[serde(default)]
    pub set: BTreeMap<String, f64>,
    /// Coordinates and rates at the start.
    #[serde(default)]
    pub start: BTreeMap<String, f64>,
    /// Conditions to stop at.
    #[serde(default)]
    pub until: Vec<String>,
    /// The latest end.
    #[serde(default)]
    pub limit: Option<f64>,
    /// Relative tolerance.
    #[serde(default)]
    pub tolerance: Option<f64>,
    /// Expressions to draw over time.
    #[serde(default)]
    pub outputs: Vec<String>,
}
