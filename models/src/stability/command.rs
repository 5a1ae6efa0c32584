//! `liftoff stability`.

use crate::stability::{Effort, GROUPS, Group, Verdict, html, summary, text};
use clap::Args;
use liftoff::cli::{CommandError, print};
use serde::Serialize;
use std::path::PathBuf;
use std::time::Duration;

/// A case that has not answered by then never will.
const PATIENCE: Duration = Duration::from_secs(300);

#[derive(Args, Debug)]
pub struct Stability {
    /// Groups of cases; all of them by default
    group: Vec<String>,
    /// Shorten the long runs; in full an optimised build takes minutes
    #[arg(long)]
    short: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Where to write stability.html
    #[arg(long, value_name = "DIRECTORY", default_value = "target/liftoff")]
    out: PathBuf,
}

#[derive(Serialize)]
struct Cases<'a> {
    cases: &'a [Verdict],
}

impl Stability {
    /// Judges every case asked for; fails if one of them does.
    pub fn execute(self) -> Result<(), CommandError> {
        let effort = if self.short { Effort::Short } else { Effort::Full };
        let mut verdicts = Vec::new();
        for group in self.groups()? {
            let judged: Vec<_> = group.cases(effort).into_iter().map(|case| case.judge(PATIENCE)).collect();
            if !self.json {
                print(&format!("{}\n{}\n", group.title, text(&judged)))?;
            }
            verdicts.extend(judged);
        }
        let page = self.write(&verdicts)?;
        if self.json {
            let cases = serde_json::to_string_pretty(&Cases { cases: &verdicts });
            print(&(cases.map_err(|error| CommandError::Failed(error.to_string()))? + "\n"))?;
        } else {
            print(&format!("{}; {} written\n", summary(&verdicts), page.display()))?;
        }
        if verdicts.iter().all(|verdict| verdict.pass) {
            Ok(())
        } else {
            Err(CommandError::Failed(summary(&verdicts)))
        }
    }

    fn groups(&self) -> Result<Vec<&'static Group>, CommandError> {
        let known = || GROUPS.iter().map(|group| group.name).collect::<Vec<_>>().join(", ");
        let stranger = self.group.iter().find(|name| GROUPS.iter().all(|group| group.name != **name));
        if let Some(name) = stranger {
            return Err(CommandError::Usage(format!("no group `{name}`; there are {}", known())));
        }
        let asked =
            |group: &&Group| self.group.is_empty() || self.group.iter().any(|name| name == group.name);
        Ok(GROUPS.iter().filter(asked).collect())
    }

    fn write(&self, verdicts: &[Verdict]) -> Result<PathBuf, CommandError> {
        let path = self.out.join("stability.html");
        let written = std::fs::create_dir_all(&self.out).and_then(|()| std::fs::write(&path, html(verdicts)));
        match written {
            Ok(()) => Ok(path),
            Err(error) => Err(CommandError::Failed(format!("cannot write {}: {error}", path.display()))),
        }
    }
}
