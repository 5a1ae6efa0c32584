//! The right-hand side of a chain for many states, in the lanes of vectors, on one thread.

use serde_json::{Value, json};

use crate::Result;
use crate::chain::sources;
use crate::compiler::Compiler;
use crate::expansion::Expansion;

const BARS: [usize; 5] = [2, 4, 8, 16, 32];

/// A row for every length.
pub fn rows() -> Result<Vec<Value>> {
    let compiler = Compiler::new()?;
    BARS.into_iter().map(|bars| row(&compiler, bars)).collect()
}

fn row(compiler: &Compiler, bars: usize) -> Result<Value> {
    let expansion = Expansion::expand(&sources::declaration(bars))?;
    let library = format!("generated_{bars}");
    compiler.library(&library, &sources::generated(bars, &expansion.text))?;
    let (_, text) = compiler.run(&format!("batch_{bars}"), &sources::batch(bars), &[&library])?;
    Ok(json!({ "n": bars, "ns": text.trim().parse::<f64>()? }))
}
