//! `liftoff sweep --shard`: which part of a sweep a process computes.

use super::Options;
use crate::CommandError;
use crate::output::file::{check_folder, tell_written};
use crate::output::notes::note;
use crate::output::print::print;
use liftoff_studio::sweep::{Shard, Share};
use std::path::Path;

/// Variables of a task of a Slurm array: its number, how many tasks there are, the least and the greatest number.
const ID: &str = "SLURM_ARRAY_TASK_ID";
const COUNT: &str = "SLURM_ARRAY_TASK_COUNT";
const MIN: &str = "SLURM_ARRAY_TASK_MIN";
const MAX: &str = "SLURM_ARRAY_TASK_MAX";

/// What a variable of the environment says.
type Environment<'a> = &'a dyn Fn(&str) -> Option<String>;

impl Options {
    /// The folder of shards, where a part of the sweep is asked for, or a script that does.
    pub fn folder(&self) -> Result<Option<&Path>, CommandError> {
        self.out.iter().try_for_each(|folder| check_folder(folder))?;
        let usage = |text: String| Err(CommandError::Usage(text));
        let part = [("--shard", self.shard.is_some()), ("--sbatch", self.sbatch.is_some())];
        let whole = [
            ("--svg", self.svg.is_some()),
            ("--journal", self.journal.is_some()),
            ("--bisect", self.bisect.is_some()),
        ];
        let given = |options: &[(&'static str, bool)]| {
            options.iter().find(|(_, given)| *given).map(|(name, _)| *name)
        };
        let mut tables = self.csv.iter().map(|_| "--csv").chain(self.columnar.each().map(|(name, ..)| name));
        match (&self.out, given(&part), tables.next(), given(&whole)) {
            (None, Some(name), ..) => {
                usage(format!("{name} needs a folder for the shards: say --out FOLDER"))
            }
            (Some(_), _, Some(name), _) => usage(format!(
                "{name} needs the whole sweep, --out writes shards: `merge FOLDER {name} FILE` writes it from these"
            )),
            (Some(_), _, None, Some(name)) => {
                usage(format!("{name} needs the whole sweep, --out writes shards"))
            }
            (folder, ..) => Ok(folder.as_deref()),
        }
    }

    /// The shard that is asked for, or that belongs to the task of a Slurm array.
    pub fn shard(&self, environment: Environment<'_>) -> Result<Shard, CommandError> {
        let of_task = || {
            of_task(environment)?.ok_or_else(|| {
                format!("--out needs to know which shard to compute: say --shard i/n, or run it as an array of Slurm, which sets {ID} and {COUNT}")
            })
        };
        self.shard.map_or_else(of_task, Ok).map_err(CommandError::Usage)
    }

    /// Says that every task of an array would compute the whole sweep.
    pub fn note_array(&self, environment: Environment<'_>) {
        if let Ok(Some(shard)) = of_task(environment) {
            note(&format!(
                "task {} of an array of {} computes the whole sweep; with --out FOLDER it computes its share",
                shard.index(),
                shard.count()
            ));
        }
    }
}

/// What this process's environment says.
pub fn environment(name: &str) -> Option<String> {
    std::env::var_os(name).map(|value| value.to_string_lossy().into_owned())
}

/// The shard of a task of a Slurm array, if this is one: tasks have numbers from 0 or 1 on, without gaps.
fn of_task(environment: Environment<'_>) -> Result<Option<Shard>, String> {
    let number = |name: &str| -> Result<Option<usize>, String> {
        let Some(text) = environment(name) else { return Ok(None) };
        text.trim()
            .parse()
            .map(Some)
            .map_err(|_| format!("{name} is `{text}`, and not a number: say --shard i/n"))
    };
    let needed = |name, other| format!("{other} is set, and {name} is not: say --shard i/n");
    let (id, count) = match (number(ID)?, number(COUNT)?) {
        (None, None) => return Ok(None),
        (Some(id), Some(count)) => (id, count),
        (None, Some(_)) => return Err(needed(ID, COUNT)),
        (Some(_), None) => return Err(needed(COUNT, ID)),
    };
    let first = number(MIN)?.unwrap_or(0);
    if first > 1 {
        return Err(format!("{MIN} is {first}, and shards are counted from 0 or 1: say --shard i/n"));
    }
    if number(MAX)?.is_some_and(|last| last.checked_sub(first).is_none_or(|span| span + 1 != count)) {
        return Err(format!("{COUNT} is {count}, which leaves gaps up to {MAX}: say --shard i/n"));
    }
    let index =
        id.checked_sub(first).ok_or_else(|| format!("{ID} is {id}, less than {MIN}: say --shard i/n"))?;
    Shard::new(index, count).map(Some).map_err(|reason| format!("{ID} is {id}, {COUNT} {count}: {reason}"))
}

/// Prints what came of a shard.
pub fn tell(share: &Share) -> Result<(), CommandError> {
    if share.is_whole() {
        tell_written(&share.file);
    }
    print(&share.summary())?;
    match share.is_whole() {
        true => Ok(()),
        false => Err(CommandError::Interrupted(format!(
            "interrupted; the same command resumes from {}",
            share.journal.display()
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn find_shard(variables: &[(&str, &str)]) -> Result<Option<String>, String> {
        let value =
            |name: &str| variables.iter().find(|(known, _)| *known == name).map(|(_, v)| (*v).to_owned());
        of_task(&value).map(|shard| shard.map(|shard| shard.to_string()))
    }

    #[test]
    fn tasks_are_numbered_from_zero_or_one() {
        assert_eq!(find_shard(&[]), Ok(None));
        assert_eq!(find_shard(&[(ID, "3"), (COUNT, "16")]), Ok(Some("3/16".into())));
        assert_eq!(
            find_shard(&[(ID, "16"), (COUNT, "16"), (MIN, "1"), (MAX, "16")]),
            Ok(Some("15/16".into()))
        );
        assert_eq!(find_shard(&[(ID, "0"), (COUNT, "16"), (MIN, "0"), (MAX, "15")]), Ok(Some("0/16".into())));
    }

    #[test]
    fn a_senseless_environment_is_refused_by_name() {
        let cases: [(&[(&str, &str)], &str); 8] = [
            (&[(ID, "3")], "SLURM_ARRAY_TASK_ID is set, and SLURM_ARRAY_TASK_COUNT is not"),
            (&[(COUNT, "3")], "SLURM_ARRAY_TASK_COUNT is set, and SLURM_ARRAY_TASK_ID is not"),
            (&[(ID, ""), (COUNT, "3")], "SLURM_ARRAY_TASK_ID is ``, and not a number"),
            (&[(ID, "0"), (COUNT, "-1")], "SLURM_ARRAY_TASK_COUNT is `-1`, and not a number"),
            (&[(ID, "16"), (COUNT, "16")], "no shard 16 of 16: they are numbered from 0 to 15"),
            (&[(ID, "0"), (COUNT, "0")], "no shards"),
            (&[(ID, "6"), (COUNT, "3"), (MIN, "5"), (MAX, "7")], "SLURM_ARRAY_TASK_MIN is 5"),
            // Of `--array=1,3,5`.
            (&[(ID, "3"), (COUNT, "3"), (MIN, "1"), (MAX, "5")], "leaves gaps up to SLURM_ARRAY_TASK_MAX"),
        ];
        for (variables, expected) in cases {
            let told = find_shard(variables).expect_err("a mistake");
            assert!(told.contains(expected), "{variables:?}: {told}");
        }
    }
}
