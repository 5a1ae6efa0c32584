//! Mistakes in a source file as the compiler tells them.

use crate::explain::source::Mistake;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// All mistakes, each with its line and what it is about underlined, in colours that are stripped where there are none.
pub fn rendered(path: &str, source: &str, mistakes: &[Mistake]) -> String {
    let renderer = Renderer::styled();
    let told = mistakes.iter().map(|Mistake { text, at }| {
        let place = Snippet::source(source).path(path).annotation(AnnotationKind::Primary.span(at.clone()));
        renderer.render(&[Level::ERROR.primary_title(text.as_str()).element(place)])
    });
    told.collect::<Vec<_>>().join("\n\n")
}
