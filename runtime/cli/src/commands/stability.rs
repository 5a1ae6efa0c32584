//! `liftoff stability`.

use crate::CommandError;
use crate::errors::interrupted::is_interrupted;
use crate::options::length::Length;
use crate::output::file::{check_folder, unwritable, write};
use crate::output::json::pretty;
use crate::output::print::print;
use crate::output::progress::Progress;
use crate::output::style::{ERROR, NAME, PASS, styled};
use clap::Args;
use liftoff::NameError;
use liftoff_studio::checks::{Case, Effort, GENERAL, Group, GroupResult, Verdict, html, summary, text};
use liftoff_studio::registry::{Entry, Models};
use serde::Serialize;
use std::path::PathBuf;
use std::time::Duration;

/// A case that has not answered by then never will.
const PATIENCE: Duration = Duration::from_secs(300);

#[derive(Args, Debug)]
pub struct Stability {
    /// Models and groups of cases; by default the program's own groups, or without these all groups
    /// of all models
    #[arg(value_name = "MODEL|GROUP")]
    pub names: Vec<String>,
    /// Shorten the long runs; in full an optimised build takes minutes
    #[arg(long)]
    short: bool,
    #[command(flatten)]
    length: Length,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Where to write stability.html
    #[arg(long, value_name = "DIRECTORY", default_value = "target/liftoff")]
    out: PathBuf,
}

#[derive(Serialize)]
struct Cases<'a> {
    cases: Vec<&'a Verdict>,
}

/// A group's name, its title and its cases.
type SelectedGroup = (&'static str, &'static str, Vec<Case>);

impl Stability {
    /// Judges every case asked for; fails if one of them does.
    pub fn execute(&self, groups: &[Group], models: &'static Models) -> Result<(), CommandError> {
        check_folder(&self.out)?;
        let selected = self.selected(groups, models)?;
        let count: usize = selected.iter().map(|(.., cases)| cases.len()).sum();
        // A title and an empty line stand around the cases of a group, and the page is named at the
        // end.
        let is_whole = self.length.fits(count + 2 * selected.len() + 1);
        let results = self.judge(selected, is_whole)?;
        let verdicts: Vec<_> = results.iter().flat_map(|group| group.verdicts.iter().cloned()).collect();
        let page = self.write(&results)?;
        if self.json {
            print(&pretty(&Cases { cases: verdicts.iter().collect() })?)?;
        } else {
            let rest = if is_whole { "" } else { "; --all prints each" };
            print(&format!("{}; {} written{rest}\n", summary(&verdicts), page.display()))?;
        }
        if is_interrupted() {
            Err(CommandError::Interrupted(format!("interrupted after {} cases", verdicts.len())))
        } else if !verdicts.iter().any(Verdict::fails) {
            Ok(())
        } else {
            Err(CommandError::Failed(summary(&verdicts)))
        }
    }

    /// The cases of the program's own groups that are named, and of the general ones of the models that are named; where no
    /// group or no model is named, of all; the program's own groups alone where nothing is named.
    fn selected(
        &self,
        groups: &[Group],
        models: &'static Models,
    ) -> Result<Vec<SelectedGroup>, CommandError> {
        let effort = if self.short { Effort::Short } else { Effort::Full };
        let known = || groups.iter().map(|group| group.name).chain(GENERAL.iter().map(|group| group.name));
        let (of_groups, of_models): (Vec<&String>, Vec<&String>) =
            self.names.iter().partition(|name| known().any(|group| group == **name));
        let stranger = of_models.iter().find(|name| models.iter().all(|model| model.name() != name.as_str()));
        if let Some(name) = stranger {
            return Err(CommandError::Usage(describe_unknown(name, &known().collect::<Vec<_>>(), models)));
        }
        let is_selected = |name: &str| match of_groups.is_empty() {
            true => true,
            false => of_groups.iter().any(|group| *group == name),
        };
        // Own groups have scenes of their own, of no one model.
        let own = groups
            .iter()
            .filter(|group| is_selected(group.name) && (of_models.is_empty() || !of_groups.is_empty()));
        let own = own.map(|group| (group.name, group.title, group.cases(effort)));
        let own_alone = self.names.is_empty() && !groups.is_empty();
        let general = GENERAL.iter().filter(|group| !own_alone && is_selected(group.name)).map(|group| {
            let of = models
                .iter()
                .filter(|model| of_models.is_empty() || of_models.iter().any(|m| *m == model.name()));
            (group.name, group.title, of.flat_map(|model| (group.cases)(model, effort)).collect())
        });
        Ok(own.chain(general).collect())
    }

    /// Group by group, as long as nobody interrupts; each case is printed, or those that fail.
    fn judge(&self, selected: Vec<SelectedGroup>, is_whole: bool) -> Result<Vec<GroupResult>, CommandError> {
        let progress = Progress::new(selected.iter().map(|(.., cases)| cases.len()).sum(), "cases");
        let mut all = Vec::new();
        for (name, title, cases) in selected {
            let mut verdicts = Vec::new();
            for case in cases.into_iter().take_while(|_| !is_interrupted()) {
                progress.doing(&case.id);
                let Some(verdict) = case.judge_unless(PATIENCE, &is_interrupted) else { break };
                verdicts.push(verdict);
                progress.advance();
            }
            if !self.json && !verdicts.is_empty() {
                let text = if is_whole { table(title, &verdicts) } else { failures(title, &verdicts) };
                progress.aside(|| print(&text))?;
            }
            all.push(GroupResult { name, title, verdicts });
        }
        Ok(all)
    }

    fn write(&self, results: &[GroupResult]) -> Result<PathBuf, CommandError> {
        let path = self.out.join("stability.html");
        std::fs::create_dir_all(&self.out).map_err(|error| unwritable(&path, &error))?;
        write(&path, html(results)).map(|()| path)
    }
}

/// That a name is neither a group nor a model; all groups where none is near.
fn describe_unknown(name: &str, groups: &[&'static str], models: &'static Models) -> String {
    let all = groups.iter().copied().chain(models.iter().map(Entry::name));
    let error = NameError::new("model or group", name, all);
    match error.nearest {
        Some(_) => error.to_string(),
        None => {
            format!("no model or group `{name}`; groups: {}; `list` has the models", groups.join(", "))
        }
    }
}

/// How many cases of a group pass, and those that do not.
fn failures(title: &str, verdicts: &[Verdict]) -> String {
    let failed: Vec<Verdict> = verdicts.iter().filter(|verdict| verdict.fails()).cloned().collect();
    let head = format!("{}: {}\n", styled(NAME, title), summary(verdicts));
    if failed.is_empty() { head } else { head + &lines(&failed) }
}

fn table(title: &str, verdicts: &[Verdict]) -> String {
    format!("{}\n{}\n", styled(NAME, title), lines(verdicts))
}

/// A line for each case.
fn lines(verdicts: &[Verdict]) -> String {
    let line = |line: &str| match (line.strip_prefix("pass "), line.strip_prefix("FAIL ")) {
        (Some(rest), _) => format!("{}{rest}\n", styled(PASS, "pass ")),
        (_, Some(rest)) => format!("{}{rest}\n", styled(ERROR, "FAIL ")),
        _ => format!("{line}\n"),
    };
    text(verdicts).lines().map(line).collect()
}
