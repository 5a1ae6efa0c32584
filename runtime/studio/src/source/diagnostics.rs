//! Errors in a source file, rendered like those of the compiler.

use super::Mistake;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// All mistakes, each with its line and what it is about underlined; in the colours of a terminal
/// where they are asked for.
pub fn rendered(path: &str, source: &str, mistakes: &[Mistake], coloured: bool) -> String {
    let renderer = if coloured { Renderer::styled() } else { Renderer::plain() };
    let report = mistakes.iter().map(|Mistake { text, at }| {
        let place = Snippet::source(source).path(path).annotation(AnnotationKind::Primary.span(at.clone()));
        renderer.render(&[Level::ERROR.primary_title(text.as_str()).element(place)])
    });
    report.collect::<Vec<_>>().join("\n\n")
}

#[cfg(test)]
mod tests {
    use super::rendered;
    use crate::source;

    #[test]
    fn syntax_errors_are_reported_at_their_place() {
        let source = "struct Bar {\n    m: f64,\n";
        let mistakes = source::equations(source).unwrap_err();
        let report = rendered("bar.rs", source, &mistakes, false);
        assert!(report.starts_with("error: ") && report.contains("bar.rs:1:12"), "{report}");
        assert!(!report.contains('\u{1b}') && rendered("bar.rs", source, &mistakes, true).contains('\u{1b}'));
    }

    #[test]
    fn declarations_are_found_at_any_depth() {
        let rod = "#[derive(Clone, liftoff::BarSystem)] #[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))]\n\
                   #[figure(A = (0, -l))] struct Rod { m: f64, l: f64 }";
        let source = format!("mod a {{ {rod} }}\nfn main() {{ {rod} }}\nstruct Other;\n");
        let names: Vec<String> =
            source::equations(&source).unwrap().into_iter().map(|equations| equations.name).collect();
        assert_eq!(names, ["Rod", "Rod"]);
    }
}
