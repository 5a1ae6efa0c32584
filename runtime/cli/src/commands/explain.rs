//! `liftoff explain`.

use crate::CommandError;
use crate::options::files;
use crate::output::file::{Form, check_form, tell_written, write};
use crate::output::print::print;
use clap::{Args, ValueEnum};
use liftoff_studio::explain::text::{Equations, PhaseEquations};
use liftoff_studio::explain::{Drawings, latex, page, phase_latex, phase_page};
use liftoff_studio::picture::drawing;
use liftoff_studio::registry::{Entry, Models};
use liftoff_studio::source;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct Explain {
    /// Name of the model, as in `list`, or a Rust file, `FILE.rs`, compiled or not
    #[arg(value_name = "MODEL|FILE.rs")]
    model: String,
    /// Only the phase with these supports closed (`A, E`), or `free`
    #[arg(long, value_name = "SUPPORTS")]
    phase: Option<String>,
    #[command(flatten)]
    target: Target,
}

/// How equations are written, and where.
#[derive(Args, Debug)]
pub struct Target {
    /// Format; by default by the extension of the file, else text
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// File to write instead of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Target {
    /// The format that is asked for by its name or by that of the file.
    ///
    /// # Errors
    /// A file whose name ends as that of another format.
    pub fn format(&self) -> Result<Format, CommandError> {
        let formats = [Format::Text, Format::Latex, Format::Html];
        let Some(path) = &self.output else { return Ok(self.format.unwrap_or(Format::Text)) };
        let allowed: Vec<_> =
            formats.into_iter().filter(|format| self.format.is_none_or(|asked| asked == *format)).collect();
        let forms: Vec<Form> = allowed.iter().map(|format| format.form()).collect();
        check_form(path, &forms)?;
        let found = Form::find(path, &forms);
        Ok(allowed
            .iter()
            .find(|format| found.is_none_or(|form| form == format.form()))
            .copied()
            .unwrap_or(Format::Text))
    }

    /// Prints the text, or writes it to the file.
    pub fn write(&self, text: &str) -> Result<(), CommandError> {
        match &self.output {
            None => Ok(print(text)?),
            Some(path) => write(path, text).map(|()| tell_written(path)),
        }
    }
}

/// How equations are written.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub enum Format {
    /// In Unicode, as in a textbook
    Text,
    /// A document for LaTeX
    Latex,
    /// A self-contained page
    Html,
}

impl Format {
    fn form(self) -> Form {
        match self {
            Self::Text => Form::TEXT,
            Self::Latex => Form::LATEX,
            Self::Html => Form::HTML,
        }
    }
}

impl Explain {
    /// Prints or writes the equations: the system's, then those of each phase in closed form; of a file, of the model that is
    /// chosen or of all.
    pub fn execute(&self, models: &Models, chosen: Option<&str>) -> Result<(), CommandError> {
        let format = self.target.format()?;
        let text = match files::is_file(&self.model, models) {
            true => self.of_file(chosen, format)?,
            false => files::no_choice(chosen).and_then(|()| self.of_model(models, format))?,
        };
        self.target.write(&text)
    }

    fn of_model(&self, models: &Models, format: Format) -> Result<String, CommandError> {
        let model = models.find(&self.model)?;
        let drawings = if format == Format::Html { drawings(model) } else { Drawings::default() };
        self.written(&liftoff_studio::explain::equations(model.layout()), format, &drawings)
    }

    fn of_file(&self, chosen: Option<&str>, format: Format) -> Result<String, CommandError> {
        let all = files::parse_file(&self.model, source::equations)?;
        let one = chosen.is_some() || format != Format::Text;
        let chosen = match one {
            true => vec![files::one(&self.model, all, chosen, |equations| &equations.name)?],
            false => all,
        };
        let texts: Result<Vec<String>, _> =
            chosen.iter().map(|equations| self.written(equations, format, &Drawings::default())).collect();
        Ok(texts?.join("\n"))
    }

    fn written(
        &self,
        equations: &Equations,
        format: Format,
        drawings: &Drawings,
    ) -> Result<String, CommandError> {
        let phase = self.phase.as_ref().map(|supports| phase(equations, supports)).transpose()?;
        Ok(match (format, phase) {
            (Format::Text, None) => equations.to_string(),
            (Format::Text, Some(phase)) => phase.to_string(),
            (Format::Latex, None) => latex(equations),
            (Format::Latex, Some(phase)) => phase_latex(phase),
            (Format::Html, None) => page(equations, drawings),
            (Format::Html, Some(phase)) => phase_page(&equations.name, phase),
        })
    }
}

/// What can be drawn of a model with its default parameters.
fn drawings(model: &Entry) -> Drawings {
    let modes = model.modes(&model.default_run()).ok().filter(|modes| modes.modes.len() > 1);
    let model = model.configuration(&model.default_run()).ok().map(|configuration| drawing(&configuration));
    Drawings { model, modes: modes.as_ref().map(liftoff_studio::modes::svg) }
}

/// The equations with exactly these supports closed.
fn phase<'a>(equations: &'a Equations, supports: &str) -> Result<&'a PhaseEquations, CommandError> {
    let mut all = equations.phases.iter().chain(&equations.others);
    let is_free = |phase: &PhaseEquations| phase.closed.is_empty() && supports.trim() == "free";
    let found = all.find(|phase| names(&named(phase)) == names(supports) || is_free(phase));
    found.ok_or_else(|| CommandError::Usage(unknown(equations, supports)))
}

/// Which sets there are: `A, E | C`, a bar between two.
fn unknown(equations: &Equations, supports: &str) -> String {
    let sets = |phases: &[PhaseEquations]| phases.iter().map(named).collect::<Vec<_>>().join(" | ");
    let mut text = format!("no contact set `{supports}`; in closed form: {}", sets(&equations.phases));
    if !equations.others.is_empty() {
        text += &format!("; with multipliers: {}", sets(&equations.others));
    }
    text
}

/// The supports named, in alphabetical order.
fn names(text: &str) -> Vec<&str> {
    let names = text.strip_prefix("on ").unwrap_or(text);
    let mut names: Vec<&str> = names.split(',').map(str::trim).collect();
    names.sort_unstable();
    names
}

/// A phase as it is asked for.
fn named(phase: &PhaseEquations) -> String {
    match phase.closed.as_slice() {
        [] => phase.unclosed.unwrap_or("free").to_owned(),
        labels => labels.join(", "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_phase_is_found_whatever_the_order_of_its_supports() {
        let set = |closed: &[&str]| {
            let closed = closed.iter().map(|label| (*label).to_owned()).collect();
            PhaseEquations { closed, ..PhaseEquations::default() }
        };
        let equations = Equations {
            phases: vec![set(&[]), set(&["A, E", "C"])],
            others: vec![set(&["AB"])],
            ..Equations::default()
        };
        let title = |supports| phase(&equations, supports).map(PhaseEquations::title).ok();
        assert_eq!(title("C,A, E").as_deref(), Some("on A, E, C"));
        assert_eq!(title("on A, E, C").as_deref(), Some("on A, E, C"));
        assert_eq!(title("free").as_deref(), Some("free"));
        assert_eq!(title("AB").as_deref(), Some("on AB"));
        let driven = PhaseEquations { unclosed: Some("no contacts"), ..set(&[]) };
        let driven = Equations { phases: vec![driven], ..Equations::default() };
        for asked in ["free", "no contacts"] {
            assert_eq!(phase(&driven, asked).unwrap().title(), "no contacts");
        }
        let told = phase(&equations, "Z").err().map(|error| error.to_string());
        let known = "no contact set `Z`; in closed form: free | A, E, C; with multipliers: AB";
        assert_eq!(told.as_deref(), Some(known));
    }
}
