//! The book. Its examples are tests.
//!
//! 1. [`without_a_compiler`]: files run at once, a page that follows them, the browser.
//! 2. [`outputs`]: the words of a declaration, outputs, conditions.
//! 3. [`tutorial`]: from an empty directory to your own system that moves on a page.
//! 4. [`events`]: which supports carry, and how it is decided.
//! 5. [`friction`]: contacts that stick and slip, Painlevé's paradox, impacts with friction.
//! 6. [`equilibria`]: where a system rests, what its contacts bear there, how it vibrates.
//! 7. [`conditions`]: when a contact opens, as a formula; first integrals.
//! 8. [`sensitivities`]: derivatives of times and states with respect to parameters and starts.
//! 9. [`fits`]: parameters and starts from measurements, with their errors.
//! 10. [`optima`]: parameters and starts with which an output is least or greatest.
//! 11. [`orbits`]: motions that repeat, their multipliers, branches of them.
//! 12. [`boundaries`]: where in a plane of parameters something else happens first.
//! 13. [`python`]: the same from Python, as arrays, in notebooks.
//! 14. [`other_programs`]: tables as Parquet and Arrow, the equations as sources for SymPy, models as functional mock-up units.
//! 15. [`equations`]: how a description becomes equations, on Fig. 1a of the paper.
//! 16. [`methods`]: choosing a method of integration, a tolerance, a way of running; sweeps in parts.
//! 17. [`tolerances`]: what follows the tolerance, and what does not.
//! 18. [`performance`]: accuracy, speed and cost, each with the command that measures it.
//! 19. [`weight`]: what builds and programs weigh.
//! 20. [`promises`]: what is promised, how it is tested, what is not promised, and what was measured.
//! 21. [`vocabulary`]: what to do when a system needs more than there is a word for.
//! 22. [`glossary`]: the words of this book and of the source.

/// Chapters, each with where its links to others lead: in the files they lead to files.
macro_rules! chapters {
    ($($name:ident $([$link:ident = $path:literal])* $($text:literal)+;)*) => {
        $(
            $(#[doc = concat!("[", stringify!($link), "]: ", $path)])*
            #[doc = ""]
            $(#[doc = include_str!($text)])+
            pub mod $name {}
        )*

        /// The chapters in order.
        #[cfg(test)]
        const CHAPTERS: &[&str] = &[$(stringify!($name)),*];
    };
}

chapters! {
    without_a_compiler "without_a_compiler.md";
    outputs [language = "derive@liftoff::BarSystem"] "outputs.md";
    tutorial "tutorial.md";
    events "events.md";
    friction [events = "crate::book::events"] "friction.md";
    equilibria "equilibria.md";
    conditions "conditions.md";
    sensitivities "sensitivities.md";
    fits [sensitivities = "crate::book::sensitivities"] "fits.md";
    optima [sensitivities = "crate::book::sensitivities"] "optima.md";
    orbits [sensitivities = "crate::book::sensitivities"] "orbits.md";
    boundaries "boundaries.md";
    python "python.md";
    other_programs [events = "crate::book::events"] "other_programs.md";
    equations "equations.md";
    methods [tolerances = "crate::book::tolerances"] [tutorial = "crate::book::tutorial"] "methods.md";
    tolerances "tolerances.md";
    performance [weight = "crate::book::weight"] "performance.md";
    weight "weight.md";
    promises [measured = "crate::book::promises"] "promises.md" "measured.md";
    vocabulary "vocabulary.md";
    glossary "glossary.md";
}

#[cfg(test)]
mod tests {
    use super::CHAPTERS;

    /// The tutorial's program is the example of that name, which is compiled and run.
    #[test]
    fn the_tutorial_shows_the_example() {
        assert!(include_str!("tutorial.md").contains(include_str!("../../examples/step_ladder.rs")));
    }

    /// `.ci` runs every command that the README shows; what is compiled once more, `.ci/long` does.
    #[test]
    fn the_commands_of_the_readme_are_run() {
        let readme = include_str!("../../../../README.md");
        let commands =
            readme.lines().filter(|line| line.starts_with("cargo run") || line.starts_with("cargo test"));
        let commands: Vec<&str> = commands.map(|line| line.split("  ").next().unwrap_or(line)).collect();
        assert!(commands.len() > 12);
        let scripts = [include_str!("../../../../.ci/run"), include_str!("../../../../.ci/long")];
        for command in commands {
            let run = |line: &str| line.trim_start().split(" >").next() == Some(command);
            assert!(scripts.iter().any(|script| script.lines().any(run)), "{command}");
        }
    }

    const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    const BOOK: &str = "runtime/cli/src/book";

    fn load(path: &str) -> String {
        std::fs::read_to_string(format!("{ROOT}/{path}")).unwrap_or_else(|error| panic!("{path}: {error}"))
    }

    #[test]
    fn the_site_and_the_readme_have_every_chapter() {
        let (summary, readme) = (load(&format!("{BOOK}/SUMMARY.md")), load("README.md"));
        let listed = summary
            .lines()
            .filter_map(|line| line.strip_prefix("- [")?.split_once("](")?.1.strip_suffix(".md)"));
        assert_eq!(listed.collect::<Vec<_>>(), CHAPTERS);
        for chapter in CHAPTERS {
            assert!(readme.contains(&format!("]({BOOK}/{chapter}.md)")), "{chapter}");
        }
    }

    /// Headings as links have them.
    fn find_anchors(text: &str) -> Vec<String> {
        let titles =
            text.lines().filter(|line| line.starts_with('#')).map(|line| line.trim_start_matches('#').trim());
        let kept = |c: &char| c.is_alphanumeric() || " -_".contains(*c);
        titles
            .map(|title| title.to_lowercase().chars().filter(kept).collect::<String>().replace(' ', "-"))
            .collect()
    }

    /// Targets of links: those in parentheses, and those of definitions, `[name]: target`.
    fn find_targets(text: &str) -> Vec<&str> {
        let mut targets = Vec::new();
        let mut is_code = false;
        for line in text.lines() {
            is_code ^= line.starts_with("```");
            let inline = line.split("](").skip(1).filter_map(|part| Some(part.split_once(')')?.0));
            let definition =
                line.strip_prefix('[').and_then(|line| line.split_once("]: ")).map(|(_, target)| target);
            let definition = definition.filter(|target| !target.contains(' '));
            targets.extend(inline.chain(definition).filter(|_| !is_code));
        }
        // Paths of Rust are links of the documentation only.
        targets
            .retain(|target| !target.contains("::") && !target.contains('@') && !target.starts_with("http"));
        targets
    }

    #[test]
    fn links_lead_to_files_and_headings() {
        let chapters =
            CHAPTERS.iter().chain(&["measured", "SUMMARY"]).map(|name| format!("{BOOK}/{name}.md"));
        let pages = ["README.md", "runtime/engine/src/attributes.md", "runtime/python/README.md"];
        let mut count = 0;
        for page in pages.map(str::to_owned).into_iter().chain(chapters) {
            let text = load(&page);
            let folder = page.rsplit_once('/').map_or("", |(folder, _)| folder);
            for target in find_targets(&text) {
                let (path, anchor) = target.split_once('#').unwrap_or((target, ""));
                let linked = match path {
                    "" => text.clone(),
                    path => load(&format!("{folder}/{path}")),
                };
                assert!(
                    anchor.is_empty() || find_anchors(&linked).iter().any(|known| known == anchor),
                    "{page}: {target}"
                );
                count += 1;
            }
        }
        assert!(count > 50, "{count}");
    }
}
