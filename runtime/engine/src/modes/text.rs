//! Modes in print.

use core::fmt;

use super::{Change, MAX_ENUMERATED_SETS, Mode, ModeTransition, Modes};

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
        for ModeTransition { contact, change, from, to } in &self.transitions {
            let style = if *change == Change::Sticks { ", style=dotted" } else { "" };
            text += &format!("  {from} -> {to} [label=\"{contact}\"{style}]\n");
        }
        text + "}\n"
    }
}

impl ModeTransition {
    fn there(&self) -> String {
        let contact = self.contact;
        match self.change {
            Change::Closes => format!("+ {contact}"),
            Change::ClosesSliding => format!("+ {contact} sliding"),
            Change::ClosesSticking => format!("+ {contact} sticking"),
            Change::Sticks => format!("{contact} sticks"),
        }
    }

    fn back(&self) -> String {
        match self.change {
            Change::Sticks => format!("{} slips", self.contact),
            _ => format!("− {}", self.contact),
        }
    }
}

impl fmt::Display for Modes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.complete {
            writeln!(f, "more than {MAX_ENUMERATED_SETS} sets: only those with code of their own")?;
        }
        let titles: Vec<String> = self.modes.iter().map(|mode| self.title(mode)).collect();
        let width = titles.iter().map(|title| title.chars().count()).max().unwrap_or(0);
        for (i, mode) in self.modes.iter().enumerate() {
            let code = if mode.own_code { "own code" } else { "multipliers" };
            write!(f, "{:<width$}  degrees {}, {code}", titles[i], mode.degrees)?;
            let there = self.transitions.iter().filter(|change| change.from == i).map(ModeTransition::there);
            let back = self.transitions.iter().filter(|change| change.to == i).map(ModeTransition::back);
            let changes: Vec<String> = there.chain(back).collect();
            writeln!(f, "{}{}", if changes.is_empty() { "" } else { "; " }, changes.join("; "))?;
        }
        Ok(())
    }
}
