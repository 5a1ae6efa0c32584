//! The book as sources of mdBook, `target/liftoff/book-source`, for `mdbook build runtime/cli`: its
//! chapters without what only tests need, and one for each chapter of the language, with a picture
//! of each of its examples.

mod markdown;
mod words;

use std::fs;
use std::io;
use std::path::Path;

/// The folder of this package.
const PACKAGE: &str = env!("CARGO_MANIFEST_DIR");

/// The chapter behind which those of the language stand.
const BEFORE: &str = "(outputs.md)";

/// A file of the book.
struct File {
    name: String,
    text: String,
}

fn main() -> io::Result<()> {
    let out = Path::new("target/liftoff/book-source");
    if out.exists() {
        fs::remove_dir_all(out)?;
    }
    fs::create_dir_all(out)?;
    for File { name, text } in collect_files()? {
        fs::write(out.join(name), text)?;
    }
    println!("{}", out.display());
    Ok(())
}

/// All files of the book.
fn collect_files() -> io::Result<Vec<File>> {
    let words = words::chapters();
    let mut files = Vec::new();
    for entry in fs::read_dir(Path::new(PACKAGE).join("src/book"))? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if name.ends_with(".md") {
            let text = fs::read_to_string(&path)?;
            let text =
                if name == "SUMMARY.md" { with_words(&text, &words) } else { markdown::publish(&text) };
            files.push(File { name, text });
        }
    }
    for words::Chapter { file, text, pictures, .. } in words {
        files.push(File { name: file, text });
        files.extend(pictures);
    }
    Ok(files)
}

/// The summary with the chapters of the language.
fn with_words(summary: &str, words: &[words::Chapter]) -> String {
    let line = |chapter: &words::Chapter| format!("  - [{}]({})\n", chapter.title, chapter.file);
    let lines: String = words.iter().map(line).collect();
    summary
        .lines()
        .map(|line| format!("{line}\n{}", if line.contains(BEFORE) { &lines } else { "" }))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// What links and pictures lead to.
    fn find_targets(text: &str) -> Vec<&str> {
        let inline = text.split("](").skip(1).filter_map(|part| part.split_once(')'));
        let defined = text.lines().filter_map(|line| line.strip_prefix('[')?.split_once("]: "));
        let defined = defined.map(|(_, target)| target).filter(|target| !target.contains(' '));
        inline.map(|(target, _)| target).chain(defined).collect()
    }

    #[test]
    fn every_link_leads_somewhere_and_no_line_is_hidden() {
        let files = collect_files().expect("the book");
        let mut links = 0;
        for File { name, text } in files.iter().filter(|file| file.name.ends_with(".md")) {
            let (code, prose) = markdown::divide(text);
            assert!(!code.iter().any(|line| markdown::is_hidden(line)), "{name}");
            for target in find_targets(&prose) {
                let file = target.split('#').next().unwrap_or_default();
                let known = file.is_empty() || files.iter().any(|other| other.name == file);
                assert!(known || target.starts_with("http"), "{name}: {target}");
                links += 1;
            }
        }
        assert!(links > 80, "{links}");
    }

    #[test]
    fn every_chapter_is_in_the_summary() {
        let files = collect_files().expect("the book");
        let summary = &files.iter().find(|file| file.name == "SUMMARY.md").expect("a summary").text;
        for File { name, .. } in files.iter().filter(|file| file.name.ends_with(".md")) {
            assert!(name == "SUMMARY.md" || summary.contains(&format!("({name})")), "{name}");
        }
        let names: BTreeSet<&str> = files.iter().map(|file| file.name.as_str()).collect();
        assert_eq!(names.len(), files.len(), "one file takes the place of another");
    }

    #[test]
    fn every_word_has_an_example_and_its_picture() {
        let words = words::chapters();
        let names = words::names(&words[0].text);
        assert!(names.len() > 25, "{names:?}");
        for name in names {
            let is_drawn = |text: &str| {
                let mut parts = text.split("```rust\n").skip(1).filter_map(|part| part.split_once("```"));
                parts.any(|(code, rest)| words::uses(code, name) && rest.trim_start().starts_with("!["))
            };
            assert!(words.iter().any(|chapter| is_drawn(&chapter.text)), "{name}");
        }
        for picture in words.iter().flat_map(|chapter| &chapter.pictures) {
            assert!(picture.text.starts_with("<svg"), "{}", picture.name);
        }
    }
}
