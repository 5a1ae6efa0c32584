//! Models of files of Rust that need not be compiled, wherever a command takes the name of a model.

use crate::CommandError;
use liftoff::NameError;
use liftoff_studio::file::read_text;
use liftoff_studio::registry::{Entry, Models, kebab};
use liftoff_studio::source::{self, Mistake};
use std::path::Path;

/// Bytes of a source file.
const LARGEST: u64 = 16 << 20;

/// Puts the name of the model that is in it in place of each file among the words, the one that is chosen where it has several;
/// the models with those.
pub fn resolved(
    words: Vec<&mut String>,
    chosen: Option<&str>,
    models: &'static Models,
) -> Result<&'static Models, CommandError> {
    let mut found: Vec<Entry> = Vec::new();
    for word in words.into_iter().filter(|word| is_file(word, models)) {
        let model = one(word, parse_file(word, source::models)?, chosen, |model| model.layout().name)?;
        if found.iter().any(|other| other.name() == model.name()) {
            let text = format!("{word}: a model `{}` is in another file too", model.name());
            return Err(CommandError::Usage(text));
        }
        model.name().clone_into(word);
        found.push(model);
    }
    match found.is_empty() {
        true => no_choice(chosen).map(|()| models),
        // The program ends with the command.
        false => Ok(Box::leak(Box::new(models.with(found)))),
    }
}

/// Refuses to choose where there is no file.
pub fn no_choice(chosen: Option<&str>) -> Result<(), CommandError> {
    let refused = |_| Err(CommandError::Usage("`--model` chooses a model of a FILE.rs".to_owned()));
    chosen.map_or(Ok(()), refused)
}

/// Whether it is not the name of a model.
pub fn is_file(word: &str, models: &Models) -> bool {
    let path = Path::new(word);
    models.find(word).is_err() && (path.extension().is_some_and(|end| end == "rs") || path.is_file())
}

/// What is made of a source file, or its mistakes as the compiler tells them.
pub fn parse_file<T>(
    path: &str,
    make: impl Fn(&str) -> Result<Vec<T>, Vec<Mistake>>,
) -> Result<Vec<T>, CommandError> {
    parse(path, &text(Path::new(path))?, make)
}

/// The text of a source file.
pub fn text(path: &Path) -> Result<String, CommandError> {
    read_text(path, LARGEST)
        .map_err(|error| CommandError::Failed(format!("cannot read {}: {error}", path.display())))
}

/// The model of a file with this text, the one that is chosen where it has several.
pub fn of_text(path: &str, text: &str, chosen: Option<&str>) -> Result<Entry, CommandError> {
    one(path, parse(path, text, source::models)?, chosen, |model| model.layout().name)
}

/// What is made of the text of a source file, or its mistakes as the compiler tells them.
pub fn parse<T>(
    path: &str,
    text: &str,
    make: impl Fn(&str) -> Result<Vec<T>, Vec<Mistake>>,
) -> Result<Vec<T>, CommandError> {
    let found = make(text)
        .map_err(|mistakes| CommandError::Mistakes(source::rendered(path, text, &mistakes, true)))?;
    match found.is_empty() {
        true => Err(CommandError::Usage(format!("nothing in {path} derives `BarSystem`"))),
        false => Ok(found),
    }
}

/// That of the model that is chosen, by the name of its struct or as `list` has it.
pub fn one<T>(
    path: &str,
    mut found: Vec<T>,
    chosen: Option<&str>,
    name: impl Fn(&T) -> &str,
) -> Result<T, CommandError> {
    let names: Vec<String> = found.iter().map(|model| name(model).to_owned()).collect();
    let usage = |text: String| Err(CommandError::Usage(text));
    let fits = |name: &String| chosen.is_none_or(|chosen| *name == chosen || kebab(name) == chosen);
    let fitting: Vec<usize> = (0..names.len()).filter(|index| fits(&names[*index])).collect();
    match (&fitting[..], chosen) {
        ([index], _) => Ok(found.swap_remove(*index)),
        ([], Some(name)) => {
            usage(NameError::new("model", name, names.iter().map(String::as_str)).to_string())
        }
        (_, None) => usage(format!("{path} has several models; choose one: --model {}", names.join(", "))),
        (_, Some(name)) => usage(format!("{path} has several models `{name}`; rename all but one")),
    }
}
