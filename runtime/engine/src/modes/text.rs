//! Modes in print.

use core::fmt;

use super::{ALL, Mode, Modes, Transition};

impl Modes {
    /// `free`, or `on A, E`.
    fn title(&self, mode: &Mode) -> String {
        match mode.closed.as_slice() {
            [] => self.layout.unclosed().to_owned(),
            closed => format!("on {}", closed.join(", ")),
        }
    }

    /// The graph in the language of Graphviz.
    pub fn dot(&self) -> String {
        let mut text = format!("digraph {} {{\n  edge [dir=both]\n", self.layout.name);
        for (i, mode) in self.modes.iter().enumerate() {
            let style = if mode.own_code { "" } else { ", style=dashed" };
            text += &format!("  {i} [label=\"{}\\n{}\"{style}]\n", self.title(mode), mode.degrees);
        }
        for Transition { contact, open, closed } in &self.transitions {
            text += &format!("  {open} -> {closed} [label=\"{contact}\"]\n");
        }
        text + "}\n"
    }
}

impl fmt::Display for Modes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.complete {
            writeln!(f, "more than {ALL} contacts: only the sets with code of their own")?;
        }
        let titles: Vec<String> = self.modes.iter().map(|mode| self.title(mode)).collect();
        let width = titles.iter().map(|title| title.chars().count()).max().unwrap_or(0);
        for (i, mode) in self.modes.iter().enumerate() {
            let code = if mode.own_code { "own code" } else { "multipliers" };
            write!(f, "{:<width$}  degrees {}, {code}", titles[i], mode.degrees)?;
            let of = |sign: char, from: fn(&Transition) -> usize| {
                let changes = self.transitions.iter().filter(move |change| from(change) == i);
                changes.map(move |change| format!("{sign} {}", change.contact))
            };
            let changes: Vec<String> =
                of('+', |change| change.open).chain(of('−', |change| change.closed)).collect();
            writeln!(f, "{}{}", if changes.is_empty() { "" } else { "; " }, changes.join("; "))?;
        }
        Ok(())
    }
}
