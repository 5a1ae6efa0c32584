//! Mistakes in a source file as the compiler tells them.

use crate::explain::source::Mistake;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use std::io::{IsTerminal, stderr};

/// All mistakes, each with its line and what it is about underlined.
pub fn rendered(path: &str, source: &str, mistakes: &[Mistake]) -> String {
    let renderer = if stderr().is_terminal() { Renderer::styled() } else { Renderer::plain() };
    let told = mistakes.iter().map(|Mistake { text, at }| {
        let place = Snippet::source(source).path(path).annotation(AnnotationKind::Primary.span(at.clone()));
        renderer.render(&[Level::ERROR.primary_title(text.as_str()).element(place)])
    });
    told.collect::<Vec<_>>().join("\n\n")
}
