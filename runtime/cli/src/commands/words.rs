//! `liftoff words`: the reference of the language, whose only source is the documentation of
//! `BarSystem`.

use crate::CommandError;
use crate::output::print::print;
use crate::output::style::{NAME, styled};
use clap::Args;
use liftoff::__private::LANGUAGE;
use liftoff::NameError;

#[derive(Args, Debug)]
pub struct Words {
    /// A word of the language, as `spring` or `floor`, or a chapter; without one all words are listed
    #[arg(value_name = "WORD")]
    word: Option<String>,
    /// Print the whole reference
    #[arg(long, conflicts_with = "word")]
    all: bool,
}

impl Words {
    /// Prints the words, or one of them with its equation and an example.
    pub fn execute(&self) -> Result<(), CommandError> {
        let reference = Reference::parse(LANGUAGE);
        let text = match &self.word {
            Some(word) => reference.find(word).map_err(|error| CommandError::Usage(error.to_string()))?,
            None if self.all => reference.chapters.iter().map(Chapter::text).collect(),
            None => reference.list(),
        };
        Ok(print(&text)?)
    }
}

/// The reference, read from Markdown.
struct Reference<'a> {
    rows: Vec<Row<'a>>,
    chapters: Vec<Chapter<'a>>,
}

/// An attribute in the table of all.
struct Row<'a> {
    /// How it is written.
    form: &'a str,
    declares: &'a str,
}

/// What stands under a heading.
struct Chapter<'a> {
    title: &'a str,
    lines: Vec<&'a str>,
}

impl<'a> Reference<'a> {
    fn parse(text: &'a str) -> Self {
        let mut chapters: Vec<Chapter<'a>> = Vec::new();
        let mut is_code = false;
        for line in text.lines() {
            is_code ^= line.starts_with("```");
            match line.trim_start_matches('#').strip_prefix(' ').filter(|_| line.starts_with('#') && !is_code)
            {
                Some(title) => chapters.push(Chapter { title, lines: Vec::new() }),
                None => chapters.iter_mut().last().into_iter().for_each(|chapter| chapter.lines.push(line)),
            }
        }
        let rows = chapters.iter().flat_map(|chapter| &chapter.lines).filter_map(|line| {
            let (form, declares) = line.strip_prefix("| ")?.strip_suffix(" |")?.split_once(" | ")?;
            form.starts_with('`').then_some(Row { form, declares })
        });
        Self { rows: rows.collect(), chapters }
    }

    /// Every word with what it declares, then the chapters.
    fn list(&self) -> String {
        let rows: String = self.rows.iter().map(Row::text).collect();
        let titles: Vec<String> = self.chapters.iter().map(Chapter::anchor).collect();
        format!("{rows}\nChapters, each printed by its name: {}\n", titles.join(", "))
    }

    /// A word with its chapter or, where it has none of its own, with an example; else what names
    /// or mentions it.
    fn find(&self, word: &str) -> Result<String, NameError> {
        if let Some(chapter) = self.chapters.iter().find(|chapter| chapter.anchor() == word) {
            return Ok(chapter.text());
        }
        let own: Vec<&Row<'_>> =
            self.rows.iter().filter(|row| row.names().any(|name| name == word)).collect();
        let rows = match own.is_empty() {
            true => self.rows.iter().filter(|row| has_word(row.form, word)).collect(),
            false => own,
        };
        let linked = |chapter: &&Chapter<'_>| {
            rows.iter().any(|row| row.declares.contains(&format!("(#{})", chapter.anchor())))
        };
        let mentions = |chapter: &&Chapter<'_>| {
            rows.is_empty() && chapter.lines.iter().any(|line| !line.starts_with('|') && has_code(line, word))
        };
        let chapters: Vec<&Chapter<'_>> =
            self.chapters.iter().filter(|chapter| linked(chapter) || mentions(chapter)).collect();
        if rows.is_empty() && chapters.is_empty() {
            let names = self.rows.iter().flat_map(Row::names).map(str::to_owned);
            let known: Vec<String> = names.chain(self.chapters.iter().map(Chapter::anchor)).collect();
            return Err(NameError::new("word", word, known.iter().map(String::as_str)));
        }
        let rows = rows.into_iter().map(Row::text);
        let texts = match chapters.is_empty() {
            true => self.example(word).into_iter().collect(),
            false => chapters.into_iter().map(Chapter::text).collect::<Vec<_>>(),
        };
        Ok(rows.chain(texts.into_iter().map(|text| format!("\n{text}"))).collect())
    }

    /// The first example that uses an attribute.
    fn example(&self, word: &str) -> Option<String> {
        let uses =
            |code: &String| code.contains(&format!("#[{word}(")) || code.contains(&format!("#[{word} "));
        self.chapters.iter().flat_map(Chapter::examples).find(uses)
    }
}

impl<'a> Row<'a> {
    fn text(&self) -> String {
        format!("{}\n    {}\n", styled(NAME, &plain(self.form)), plain(self.declares))
    }

    /// The attributes that it is about.
    fn names(&self) -> impl Iterator<Item = &'a str> {
        let parts = self.form.split("#[").skip(1);
        parts.map(|part| part.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap_or(part))
    }
}

impl Chapter<'_> {
    /// Its title as links have it.
    fn anchor(&self) -> String {
        let letters = self.title.to_lowercase();
        letters
            .chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
            .collect::<String>()
            .replace(' ', "-")
    }

    fn text(&self) -> String {
        let mut text = format!("{}\n", styled(NAME, self.title));
        let mut is_code = false;
        for line in &self.lines {
            if line.starts_with("```") {
                is_code = !is_code;
            } else if !is_code {
                text += &format!("{}\n", plain(line));
            } else if !is_hidden(line) {
                text += &format!("    {line}\n");
            }
        }
        text.trim_end().to_owned() + "\n"
    }

    fn examples(&self) -> Vec<String> {
        let blocks = self.lines.split(|line| line.starts_with("```")).skip(1).step_by(2);
        let shown = |block: &[&str]| {
            block.iter().filter(|line| !is_hidden(line)).map(|line| format!("    {line}\n")).collect()
        };
        blocks.map(shown).collect()
    }
}

/// A line of an example that is compiled and not shown.
fn is_hidden(line: &str) -> bool {
    line == "#" || line.starts_with("# ")
}

/// Whether one of the words between backticks is this one.
fn has_code(line: &str, word: &str) -> bool {
    line.split('`').skip(1).step_by(2).any(|code| has_word(code, word))
}

fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|part| part == word)
}

/// Markdown without links' targets and backticks.
fn plain(text: &str) -> String {
    let mut parts = text.split("](");
    let first = parts.next().unwrap_or_default().to_owned();
    let joined = parts.fold(first, |text, part| text + part.split_once(')').map_or(part, |(_, rest)| rest));
    // A bracket that begins a link; those of attributes stand behind `#`.
    let mut plain = String::new();
    for c in joined.chars().filter(|c| *c != '`') {
        match c {
            '[' if !plain.ends_with('#') && text.contains("](") => {}
            c => plain.push(c),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every word of the table is found, and shown in use.
    #[test]
    fn every_word_has_an_example() {
        let reference = Reference::parse(LANGUAGE);
        let names: Vec<&str> = reference.rows.iter().flat_map(Row::names).collect();
        assert!(names.len() > 25, "{names:?}");
        for name in names {
            let text = reference.find(name).unwrap();
            assert!(text.contains(&format!("#[{name}")), "{name}: {text}");
        }
        for name in ["floor", "thread", "restitution", "springs-and-dampers"] {
            assert!(reference.find(name).unwrap().lines().count() > 10, "{name}");
        }
    }

    #[test]
    fn a_word_has_its_equation_and_its_example() {
        let reference = Reference::parse(LANGUAGE);
        let text = reference.find("spring").unwrap();
        for part in ["k (r − s) + c ṙ", "    #[spring(OP, stiffness = k, length = l, damping = c)]"] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert!(!text.contains("](#") && !text.contains("# Ok::<"), "{text}");
        let error = reference.find("sprng").unwrap_err().to_string();
        assert!(error.contains("did you mean `spring`?"), "{error}");
        assert!(reference.list().contains("springs-and-dampers"));
    }
}
