//! Time of the derive macro's work, its operations counted.

use std::time::Instant;

use liftoff_codegen::{Analysis, analyse, expand};
use proc_macro2::TokenStream;

use crate::Result;

/// Expansions of which the fastest counts.
const REPEATS: usize = 5;

/// What the macro makes of a declaration.
pub struct Expansion {
    /// The implementation, as text.
    pub text: String,
    /// Milliseconds.
    pub time: f64,
    /// Additions, multiplications (fused ones as one), divisions and roots of the accelerations
    /// without contacts.
    pub operations: usize,
}

impl Expansion {
    /// Expands it.
    pub fn expand(declaration: &str) -> Result<Self> {
        let tokens: TokenStream = declaration.parse().map_err(|error| format!("{error:?}"))?;
        let expansion = expand(tokens.clone());
        let time = |_| {
            let (tokens, start) = (tokens.clone(), Instant::now());
            drop(expand(tokens));
            1e3 * start.elapsed().as_secs_f64()
        };
        let time = (0..REPEATS).map(time).fold(f64::INFINITY, f64::min);
        Ok(Self {
            text: expansion.to_string(),
            time,
            operations: operations(&analyse(tokens)?, 0).unwrap_or(0),
        })
    }
}

/// Operations of the accelerations in a contact set that has a closed form.
pub fn operations(analysis: &Analysis, set: u64) -> Option<usize> {
    let phase = analysis.functions.phases.iter().find(|phase| phase.set.closed == set)?;
    let cost = analysis.functions.program.cost(&phase.accelerations);
    Some(cost.additions + cost.multiplications + cost.fused + cost.divisions + cost.roots)
}
