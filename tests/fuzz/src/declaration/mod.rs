//! Declarations: through the derive macro, and as a file through `explain`.
//!
//! No panic; what is emitted is Rust; mistakes are told where the file has text.

mod mutate;
mod pool;
mod tokens;
mod words;

use liftoff_studio::registry::{Entry, MotionError};
use liftoff_studio::run_spec::RunSpec;
use liftoff_studio::source;
use liftoff_tests::random::Source;
use proc_macro2::TokenStream;

use crate::{Fate, Finding, Subject};
use pool::Pool;

/// Valid declarations to start from, drawn once.
#[derive(Debug, Default)]
pub struct Declarations(Pool);

impl Subject for Declarations {
    type Case = String;

    fn generate(&self, seed: u64) -> String {
        let mut source = Source::new(seed);
        let kind = source.below(16);
        let tokens = match kind {
            0 => return self.0.pick(&mut source).join(" "),
            1..3 => words::arbitrary(&mut source),
            _ => mutate::mutated(&self.0, &mut source),
        };
        tokens::balanced(tokens).join(" ")
    }

    fn check(&self, case: &String) -> Result<Fate, Finding> {
        let Ok(tokens) = case.parse::<TokenStream>() else { return Ok(vec!["no tokens"]) };
        // Each way takes as long as the other: half of the cases go each.
        if case.len().is_multiple_of(2) { emitted(tokens) } else { explained(case) }
    }
}

/// What the derive macro emits is Rust.
fn emitted(tokens: TokenStream) -> Result<Fate, Finding> {
    let code = liftoff_codegen::expand(tokens);
    match syn::parse2::<syn::File>(code) {
        Ok(file) if file.items.iter().any(is_refusal) => Ok(vec!["refused by the macro"]),
        Ok(_) => Ok(vec!["derived"]),
        Err(error) => Err(Finding(format!("what is emitted is no Rust: {error}"))),
    }
}

/// Each mistake has a place in the file and a text.
fn explained(text: &str) -> Result<Fate, Finding> {
    let file = format!("#[derive(BarSystem)] {text}");
    let mistakes = match source::models(&file) {
        Ok(models) => return Ok(models.iter().map(interpreted).collect()),
        Err(mistakes) => mistakes,
    };
    if mistakes.is_empty() {
        return Err(Finding("refused without a mistake".to_owned()));
    }
    for mistake in mistakes {
        let (at, written) = (&mistake.at, &mistake.text);
        if file.get(at.clone()).is_none() || written.trim().is_empty() {
            return Err(Finding(format!("`{written}` at {at:?} of {} bytes", file.len())));
        }
    }
    Ok(vec!["refused by `explain`"])
}

/// What becomes of a short run of what no compiler sees, its parameters all 1 where the declaration
/// gives none.
fn interpreted(model: &Entry) -> &'static str {
    let mut spec = model.default_run();
    let given = |name: &str| spec.parameters.iter().any(|(known, _)| known == name);
    let open = model.layout().parameters.iter().filter(|name| !given(name));
    let ones: Vec<(String, f64)> = open.map(|name| ((*name).to_owned(), 1.0)).collect();
    spec.parameters.extend(ones);
    let spec = RunSpec { limit: Some(0.1), tolerance: 1e-6, ..spec };
    match model.run(&spec) {
        Ok(_) => "run",
        Err(MotionError::Run { .. }) => "stopped short",
        Err(_) => "refused to run",
    }
}

/// A `compile_error!`.
fn is_refusal(item: &syn::Item) -> bool {
    matches!(item, syn::Item::Macro(item) if item.mac.path.segments.last().is_some_and(|s| s.ident == "compile_error"))
}
