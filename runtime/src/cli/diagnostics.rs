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

#[cfg(test)]
mod tests {
    use super::rendered;
    use crate::explain::source;
    use anstream::adapter::strip_str;
    use std::path::Path;

    /// Word for word, for every mistake that the compiler's messages are tested on.
    #[test]
    fn mistakes_in_a_file_are_told_as_the_compiler_tells_them() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui");
        let files = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
        let mut compared = 0;
        for file in files.filter(|file| file.extension().is_some_and(|extension| extension == "rs")) {
            let (source, name) = (std::fs::read_to_string(&file).unwrap(), file.file_name().unwrap());
            let expected = std::fs::read_to_string(file.with_extension("stderr")).unwrap();
            let mistakes = source::equations(&source).unwrap_err();
            let told = rendered(&format!("tests/ui/{}", name.display()), &source, &mistakes);
            assert_eq!(strip_str(&told).to_string().trim_end(), expected.trim_end(), "{}", file.display());
            compared += 1;
        }
        assert!(compared > 20);
    }

    #[test]
    fn what_is_no_rust_is_told_at_its_place() {
        let source = "struct Bar {\n    m: f64,\n";
        let told = rendered("bar.rs", source, &source::equations(source).unwrap_err());
        assert!(strip_str(&told).to_string().starts_with("error: "), "{told}");
        assert!(told.contains("bar.rs") && told.contains(":1:12"), "{told}");
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
