//! The language: a chapter for each of its headings, with the examples drawn.

use crate::File;
use crate::markdown::{is_hidden, publish};
use liftoff::__private::LANGUAGE;
use liftoff_studio::picture::{clearest_pose, drawing};
use liftoff_studio::plot::with_theme;
use liftoff_studio::run_spec::RunSpec;
use liftoff_studio::source;

/// A chapter with its pictures.
pub struct Chapter {
    pub file: String,
    pub title: String,
    pub text: String,
    pub pictures: Vec<File>,
}

/// The chapters, the table of all words first.
pub fn chapters() -> Vec<Chapter> {
    let mut parts: Vec<(String, Vec<&str>)> = Vec::new();
    let mut is_code = false;
    for line in LANGUAGE.lines() {
        is_code ^= line.starts_with("```");
        match line.trim_start_matches('#').strip_prefix(' ').filter(|_| line.starts_with('#') && !is_code) {
            Some(title) => parts.push((title.to_owned(), Vec::new())),
            None => parts.iter_mut().last().into_iter().for_each(|(_, lines)| lines.push(line)),
        }
    }
    let files: Vec<String> = parts.iter().map(|(title, _)| anchor(title)).collect();
    let link = |text: String| {
        let link = |text: String, file: &String| {
            text.replace(&format!("](#{file})"), &format!("](words-{file}.md)"))
        };
        files.iter().skip(1).fold(text, link)
    };
    let chapter = |(k, (title, lines)): (usize, (String, Vec<&str>))| {
        let file = if k == 0 { "words.md".to_owned() } else { format!("words-{}.md", files[k]) };
        let (body, pictures) = with_pictures(&lines);
        Chapter { file, text: link(publish(&format!("# {title}\n{body}"))), title, pictures }
    };
    parts.into_iter().enumerate().map(chapter).collect()
}

/// A title as links have it.
fn anchor(title: &str) -> String {
    let kept = |c: &char| c.is_alphanumeric() || " -_".contains(*c);
    title.to_lowercase().chars().filter(kept).collect::<String>().replace(' ', "-")
}

/// The lines with a picture behind each example that declares a model.
fn with_pictures(lines: &[&str]) -> (String, Vec<File>) {
    let (mut text, mut pictures) = (String::new(), Vec::new());
    let mut code: Option<String> = None;
    for line in lines {
        text += &format!("{line}\n");
        match (line.strip_prefix("```"), &mut code) {
            (Some(language), None) => code = Some(language.to_owned()),
            (Some(_), Some(example)) => {
                if let Some((name, summary, svg)) = draw(example) {
                    let name = format!("words-{}.svg", name.to_lowercase());
                    text += &format!("\n![{summary}]({name})\n");
                    pictures.push(File { name, text: svg });
                }
                code = None;
            }
            (None, Some(example)) => {
                *example += &format!("\n{}", if is_hidden(line) { &line[1..] } else { line })
            }
            (None, None) => {}
        }
    }
    (text, pictures)
}

/// The model of an example with the values that it takes there: its name, its summary, its drawing.
fn draw(example: &str) -> Option<(&'static str, &'static str, String)> {
    let program = example.strip_prefix('\n')?;
    let model = source::models(&format!("fn main() {{ {program} }}")).ok()?.pop()?;
    let layout = model.layout();
    let values: Vec<(&str, f64)> = layout
        .parameters
        .iter()
        .filter_map(|name| Some((*name, value(program, layout.name, name)?)))
        .collect();
    let spec = if values.is_empty() { model.default_run() } else { RunSpec::with(&values) };
    let pose = clearest_pose(&model, &spec).unwrap_or_else(|error| panic!("{}: {error}", layout.name));
    Some((layout.name, layout.summary, with_theme(&drawing(&pose))))
}

/// The value of a parameter where an example makes its model: `Ladder { m: 1.0, l }` after
/// `let l = 2.0`.
fn value(program: &str, model: &str, parameter: &str) -> Option<f64> {
    let begin = format!("{model} {{");
    let mut made = program.split(&begin).skip(1).filter_map(|part| part.split_once('}'));
    let (fields, _) = made.find(|(fields, _)| !fields.contains(": f64"))?;
    let field = list(fields).find(|field| field.split(':').next() == Some(parameter))?;
    if let Some((_, value)) = field.split_once(':') {
        return number(value);
    }
    let bindings = program.lines().filter_map(|line| line.strip_prefix("let ")?.split_once(" = "));
    bindings.into_iter().find_map(|(names, values)| {
        let place = list(names).position(|name| name == parameter)?;
        number(list(values).nth(place)?)
    })
}

/// The parts of `(a, b)`.
fn list(text: &str) -> impl Iterator<Item = &str> {
    text.trim_matches(|c: char| "(); ".contains(c)).split(',').map(str::trim)
}

fn number(text: &str) -> Option<f64> {
    text.trim().trim_end_matches("_f64").parse().ok()
}

/// The words of the table.
#[cfg(test)]
pub fn names(table: &str) -> Vec<&str> {
    let rows = table.lines().filter_map(|line| line.strip_prefix("| ")?.split_once(" | "));
    rows.flat_map(|(form, _)| form.split("#[").skip(1))
        .filter_map(|part| part.split(|c: char| !(c.is_alphanumeric() || c == '_')).next())
        .collect()
}

/// Whether code has an attribute of this name.
#[cfg(test)]
pub fn uses(code: &str, name: &str) -> bool {
    ["(", " ", "]"].iter().any(|end| code.contains(&format!("#[{name}{end}")))
}
