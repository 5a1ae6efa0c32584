//! The right-hand side of a pinned chain of equal bars: accelerations of the bars' absolute angles
//! from angles and rates, generated and written by hand, of independent states.

mod by_hand;
pub mod sources;

use serde_json::{Value, json};

use crate::Result;
use crate::compiler::Compiler;
use crate::expansion::Expansion;
use crate::symbols;

const BARS: [usize; 12] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];

/// Beyond, LDLᵀ written out takes minutes to compile and more time than any recursion.
const WRITTEN_OUT: usize = 24;

/// One variant of one length.
struct Variant {
    name: &'static str,
    source: String,
    operations: usize,
    expansion: Option<f64>,
}

/// A row for every length and variant.
pub fn rows() -> Result<Vec<Value>> {
    let compiler = Compiler::new()?;
    let mut rows = Vec::new();
    for bars in BARS {
        rows.extend(length(&compiler, bars)?);
    }
    Ok(rows)
}

fn length(compiler: &Compiler, bars: usize) -> Result<Vec<Value>> {
    let variants = variants(bars)?;
    let crate_name = |variant: &Variant| format!("{}_{bars}", variant.name.replace('-', "_"));
    let names: Vec<String> = variants.iter().map(crate_name).collect();
    let compiled = variants.iter().zip(&names).map(|(variant, name)| compiler.library(name, &variant.source));
    let compiled = compiled.collect::<Result<Vec<f64>>>()?;
    let libraries: Vec<&str> = names.iter().map(String::as_str).collect();
    let (program, text) =
        compiler.run(&format!("chain_{bars}"), &sources::driver(bars, &names), &libraries)?;
    let times = text.split_whitespace().map(str::parse).collect::<core::result::Result<Vec<f64>, _>>()?;
    let row = |(k, variant): (usize, &Variant)| {
        let own = |symbol: &str| {
            let is_generated = variant.expansion.is_some() && symbol.contains("liftoff");
            (symbol.contains(&names[k]) || is_generated) && !symbol.contains("prepare")
        };
        json!({
            "n": bars,
            "variant": variant.name,
            "ns": times[k],
            "operations": variant.operations,
            "code_bytes": symbols::bytes(&program, own),
            "expand_ms": variant.expansion,
            "rustc_ms": compiled[k],
        })
    };
    Ok(variants.iter().enumerate().map(row).collect())
}

fn variants(bars: usize) -> Result<Vec<Variant>> {
    let expansion = Expansion::expand(&sources::declaration(bars))?;
    let mut variants = vec![Variant {
        name: "generated",
        source: sources::generated(bars, &expansion.text),
        operations: expansion.operations,
        expansion: Some(expansion.time),
    }];
    if bars <= WRITTEN_OUT {
        let (source, operations) = by_hand::ldl(bars);
        variants.push(Variant { name: "hand-ldl", source, operations, expansion: None });
    }
    let (source, operations) = by_hand::recursion(bars);
    variants.push(Variant { name: "hand-recursion", source, operations, expansion: None });
    Ok(variants)
}
