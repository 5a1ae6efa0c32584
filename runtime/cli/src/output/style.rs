//! Colours and weights of text; they reach a terminal only.

use anstyle::{AnsiColor, Color, Style};

const fn ink(colour: AnsiColor) -> Style {
    Style::new().fg_color(Some(Color::Ansi(colour)))
}

/// Names of models, heads of columns.
pub const NAME: Style = Style::new().bold();
/// What a word is about: `parameters`.
pub const LABEL: Style = Style::new().dimmed();
pub const ERROR: Style = ink(AnsiColor::Red).bold();
/// What happened.
pub const EVENT: Style = ink(AnsiColor::Cyan);
pub const PASS: Style = ink(AnsiColor::Green);

/// `text` in a style.
pub fn styled(style: Style, text: &str) -> String {
    format!("{style}{text}{style:#}")
}
