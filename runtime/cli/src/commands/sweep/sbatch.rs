//! `liftoff sweep --sbatch`: a sweep as an array of Slurm.

use super::Options;
use crate::CommandError;
use crate::output::file::{is_output, print_beside, tell_written, write};
use std::path::Path;

/// Tasks of an array where no number is given.
const TASKS: usize = 16;
/// Options of the script, which the tasks do not have; each has a value.
const OWN: [&str; 2] = ["--sbatch", "--shards"];

impl Options {
    /// Writes the script that computes a sweep of so many members of a model in a folder.
    pub fn write_sbatch(
        &self,
        path: &Path,
        (model, members): (&str, usize),
        folder: &Path,
    ) -> Result<(), CommandError> {
        let shards = self.shards.unwrap_or(TASKS);
        let failed = |what: &str| CommandError::Failed(format!("cannot write {}: {what}", path.display()));
        let unknown = |error: std::io::Error| failed(&error.to_string());
        let [program, here] =
            [std::env::current_exe().map_err(unknown)?, std::env::current_dir().map_err(unknown)?];
        let arguments: Option<Vec<String>> =
            std::env::args_os().skip(1).map(|word| word.into_string().ok()).collect();
        let words = [&program, &here, folder].map(|path: &Path| path.to_str().map(quoted));
        let (Some(arguments), [Some(program), Some(here), Some(folder)]) = (arguments, words) else {
            return Err(failed("a path or an option is not UTF-8"));
        };
        let command: Vec<String> = without_own(&arguments).map(quoted).collect();
        let threads = if self.threads.is_some() { "" } else { r#" --threads "${SLURM_CPUS_PER_TASK:-1}""# };
        let file = if is_output(path) { "FILE".to_owned() } else { quoted(&path.to_string_lossy()) };
        let text = format!(
            r#"#!/bin/bash
# {members} members of {model} in {shards} shards. What is done is kept: a task that is run again goes on where it was.
#   sbatch {file}
#   {program} merge {folder} --csv TABLE.csv    # afterwards; it says which tasks to run again: sbatch --array=3,5-7 {file}
#SBATCH --job-name={model}
#SBATCH --array=0-{last}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu
: "${{SLURM_ARRAY_TASK_ID:?submit this script by sbatch}}"
cd {here}
exec {program} {command} --shard "$SLURM_ARRAY_TASK_ID/{shards}"{threads}
"#,
            last = shards - 1,
            command = command.join(" "),
        );
        write(path, text)?;
        tell_written(path);
        let told = format!(
            "{members} members of {model} in {shards} shards of about {}\n",
            members.div_ceil(shards)
        );
        print_beside(Some(path), &told)
    }
}

/// The arguments that the tasks have too.
fn without_own(arguments: &[String]) -> impl Iterator<Item = &str> {
    let mut is_value = false;
    arguments.iter().map(String::as_str).filter(move |word| {
        let name = word.split_once('=').map_or(*word, |(name, _)| name);
        let is_own = OWN.contains(&name);
        let dropped = is_own || is_value;
        is_value = is_own && !word.contains('=');
        !dropped
    })
}

/// A word as a shell reads it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-./=:,+@%".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_as_a_shell_reads_them() {
        let words = ["first open", "phi'=1", "a=b", "", "$(ls)", "é\\\"`"];
        let said = words.map(quoted).join(" ");
        let output =
            std::process::Command::new("sh").args(["-c", &format!(r"printf '%s\n' {said}")]).output();
        let read = String::from_utf8(output.expect("a shell").stdout).expect("UTF-8");
        assert_eq!(read.lines().collect::<Vec<_>>(), words);
    }

    #[test]
    fn tasks_have_the_other_options() {
        let given = ["sweep", "--sbatch", "a.sh", "--out=b", "--shards=4", "--set", "m=1"].map(str::to_owned);
        let kept: Vec<_> = without_own(&given).collect();
        assert_eq!(kept, ["sweep", "--out=b", "--set", "m=1"]);
    }
}
