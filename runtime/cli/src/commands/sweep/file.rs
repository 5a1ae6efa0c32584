//! A sweep in a TOML file: the options by their names.

use super::Options;
use crate::CommandError;
use clap::{Args, CommandFactory, FromArgMatches, Parser};
use liftoff::NameError;
use liftoff_studio::file::read_text;
use std::path::Path;
use toml::{Table, Value};

/// The options by themselves, to be read as on the command line.
#[derive(Parser)]
#[command(no_binary_name = true)]
struct Alone {
    #[command(flatten)]
    options: Options,
}

const MODEL: &str = "model";
/// Bytes of a file.
const LARGEST: u64 = 1 << 20;

/// The model that a file names, and its options under those given.
pub fn load(path: &Path, given: Options) -> Result<(String, Options), CommandError> {
    let wrong = |reason: String| CommandError::Usage(format!("{}: {reason}", path.display()));
    let text = read_text(path, LARGEST)
        .map_err(|error| CommandError::Failed(format!("cannot read {}: {error}", path.display())))?;
    let table: Table =
        text.parse().map_err(|error: toml::de::Error| wrong(describe_position(&text, &error)))?;
    let (model, options) = understood(table).map_err(wrong)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    Ok((model, given.over(options.within(folder))))
}

fn describe_position(text: &str, error: &toml::de::Error) -> String {
    let line = error.span().map(|span| text[..span.start.min(text.len())].matches('\n').count() + 1);
    line.map_or_else(|| error.message().to_owned(), |line| format!("line {line}: {}", error.message()))
}

fn understood(mut table: Table) -> Result<(String, Options), String> {
    let model = match table.remove(MODEL) {
        Some(Value::String(name)) => name,
        Some(_) => return Err("the model is a name".into()),
        None => return Err("no model: say model = \"name\"".into()),
    };
    let known = known();
    let mut arguments = Vec::new();
    for (key, value) in &table {
        // An option's name on the command line, or with an underscore as TOML's keys often have.
        let option = key.replace('_', "-");
        if !known.contains(&option) {
            return Err(
                NameError::new("key", key, known.iter().map(String::as_str).chain([MODEL])).to_string()
            );
        }
        arguments.extend(argument(&option, value)?);
    }
    let matches = Alone::command().try_get_matches_from(arguments).map_err(|error| first_line(&error))?;
    Ok((model, Alone::from_arg_matches(&matches).map_err(|error| first_line(&error))?.options))
}

/// The names of all options.
fn known() -> Vec<String> {
    let command = Options::augment_args(clap::Command::new("sweep"));
    command.get_arguments().filter_map(|option| option.get_long().map(str::to_owned)).collect()
}

/// `key = value` as on the command line; a list is one option for each of its entries, `key.name = value` is `name=value`.
fn argument(option: &str, value: &Value) -> Result<Vec<String>, String> {
    let said = |text: String| vec![format!("--{option}={text}")];
    match value {
        Value::Boolean(true) => Ok(vec![format!("--{option}")]),
        Value::Boolean(false) => Ok(Vec::new()),
        Value::Array(values) => values
            .iter()
            .map(|value| argument(option, value))
            .collect::<Result<Vec<_>, _>>()
            .map(|all| all.concat()),
        Value::Table(values) => {
            let named =
                |(name, value): (&String, &Value)| Ok(format!("--{option}={name}={}", word(option, value)?));
            values.iter().map(named).collect()
        }
        value => word(option, value).map(said),
    }
}

fn word(option: &str, value: &Value) -> Result<String, String> {
    match value {
        Value::String(text) => Ok(text.clone()),
        Value::Integer(number) => Ok(number.to_string()),
        Value::Float(number) => Ok(format!("{number:e}")),
        _ => Err(format!("`{option}` must be text or numbers")),
    }
}

fn first_line(error: &clap::Error) -> String {
    let text = error.render().to_string();
    text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> Result<(String, Options), String> {
        understood(text.parse::<Table>().expect("TOML"))
    }

    #[test]
    fn a_file_says_what_options_say() {
        let text = "model = 'zigzag'\nobserve = ['first open', 'end']\nvary.lambda = '0:1:5'\nset = { m1 = '1-lambda', l = 2 }\n\
                    tol = 1e-9\nstop-at-impacts = true\nenergy_of = 'y=1'\nthreads = 2\nrandom = 10\n";
        let (model, options) = said(text).expect("options");
        assert_eq!(model, "zigzag");
        assert_eq!(options.observe, ["first open", "end"]);
        assert_eq!(options.vary, ["lambda=0:1:5"]);
        assert_eq!((&options.energy_of[..], options.random), (&["y=1".to_owned()][..], Some(10)));
        let mut set = options.set.clone();
        set.sort();
        assert_eq!(set, ["l=2", "m1=1-lambda"]);
        let spec = options.events.spec(liftoff_studio::run_spec::RunSpec::default());
        assert!(spec.stop_at_impacts && spec.tolerance == 1e-9);
    }

    #[test]
    fn mistakes_are_reported_with_the_nearest_key() {
        let error = |text| said(text).expect_err("a mistake");
        assert_eq!(error("model='a'\nvari='x=0:1:3'"), "no key `vari`; did you mean `vary`?");
        assert_eq!(error("vary='x=0:1:3'"), "no model: say model = \"name\"");
        assert!(error("model='a'\nthreads=0").contains("threads"));
        assert_eq!(error("model='a'\nset=1979-05-27"), "`set` must be text or numbers");
    }

    /// What a file may say, and what it may not.
    const WORDS: &str = "model|vary|set|observe|random|threads|csv|tol|limit| = |'|\"|[|]|{|}|,|.|\n|1|-1|1e999|nan|true|\
                         0:1:5|zigzag|x|=|1979-05-27|\\u|\0|é";

    /// Keys, values and any characters: understood or refused.
    #[test]
    fn whatever_a_file_says_is_understood_or_refused() {
        let words: Vec<&str> = WORDS.split('|').collect();
        let whole = "model = 'zigzag'\nobserve = ['first open', 'end']\nvary.lambda = '0:1:5'\nset = { m1 = '1', l = 2 }\n";
        let mut state = 3u64;
        let mut draw = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below
        };
        let mut kinds = [0; 3];
        for _ in 0..3000 {
            let mut text: Vec<char> = whole.chars().collect();
            for _ in 0..=draw(5) {
                let at = draw(text.len());
                let to = (at + draw(8)).min(text.len());
                text.splice(at..to, words[draw(words.len())].chars());
            }
            let text: String = text.into_iter().collect();
            let kind = match text.parse::<Table>().map(understood) {
                Ok(Ok(_)) => 0,
                Ok(Err(_)) => 1,
                Err(error) => {
                    assert!(!describe_position(&text, &error).is_empty());
                    2
                }
            };
            kinds[kind] += 1;
        }
        assert!(kinds.iter().all(|count| *count > 20), "{kinds:?}");
    }

    #[test]
    fn options_go_before_the_file() {
        let (_, file) = said("model='a'\nobserve='end'\ntol=1e-9\ncsv='a.csv'").expect("options");
        let own = Options { observe: vec!["first open".into()], ..Options::default() };
        let both = own.over(file.within(Path::new("runs")));
        assert_eq!(both.observe, ["first open"]);
        assert_eq!(both.csv.as_deref(), Some(Path::new("runs/a.csv")));
        assert_eq!(both.journal().as_deref(), Some(Path::new("runs/a.csv.journal")));
    }
}
