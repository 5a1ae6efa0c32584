//! What clap finds wrong with the arguments, in a line.

use clap::Error;
use clap::error::ErrorKind;

/// Characters of a line.
const LONGEST: usize = 600;

/// Prints help or version, or returns the error in a line; with the exit code.
pub fn report(error: &Error) -> (Option<String>, i32) {
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            // A reader that has gone away is no error.
            let _ = error.print();
            (None, 0)
        }
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let _ = error.print();
            (None, 2)
        }
        _ => (Some(line(&error.render().to_string())), 2),
    }
}

/// The paragraphs before the usage, joined.
fn line(text: &str) -> String {
    let text = text.strip_prefix("error: ").unwrap_or(text);
    let before = text.lines().map(str::trim).take_while(|line| !is_usage(line));
    let mut joined = String::new();
    for part in before.filter(|line| !line.is_empty()) {
        let between = match joined.chars().last() {
            None => "",
            Some(':') => " ",
            Some(_) => "; ",
        };
        joined = joined + between + part.strip_prefix("tip: ").unwrap_or(part);
    }
    shortened(joined)
}

/// Without the middle of a value that is longer than anybody reads.
fn shortened(line: String) -> String {
    let count = line.chars().count();
    if count <= LONGEST {
        return line;
    }
    let part = |skip: usize| line.chars().skip(skip).take(LONGEST / 2).collect::<String>();
    format!("{} … {}", part(0), part(count - LONGEST / 2))
}

fn is_usage(line: &str) -> bool {
    line.starts_with("Usage:") || line.starts_with("For more information")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tip_stands_in_the_same_line() {
        let text = "error: unexpected argument '--unti' found\n\n  tip: a similar argument exists: '--until'\n\n\
                    Usage: liftoff run <MODEL>\n\nFor more information, try '--help'.\n";
        assert_eq!(line(text), "unexpected argument '--unti' found; a similar argument exists: '--until'");
        let text =
            "error: the following required arguments were not provided:\n  <MODEL>\n\nUsage: liftoff run\n";
        assert_eq!(line(text), "the following required arguments were not provided: <MODEL>");
        let long = line(&format!("error: invalid value '{}': too long\n", "1+".repeat(70_000)));
        assert!(
            long.len() < 700 && long.starts_with("invalid value '1+") && long.ends_with(": too long"),
            "{long}"
        );
    }
}
