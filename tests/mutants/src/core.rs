//! The cores, their files and their tests.

use std::path::{Path, PathBuf};
use std::process::Command;

use clap::ValueEnum;

/// What is mutated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Core {
    /// Poisson series and their quotients
    Algebra,
    /// Contact sets with a closed form
    Phases,
    /// Complementarity of accelerations and of impulses
    Contact,
    /// Events and roots of guards
    Event,
    /// Decisions, responses to events, and the loop over them
    Simulation,
}

impl Core {
    /// Folder of its crate.
    pub fn home(self) -> &'static str {
        match self {
            Self::Algebra | Self::Phases => "codegen",
            Self::Contact | Self::Event | Self::Simulation => "runtime/engine",
        }
    }

    /// Root of its crate.
    pub fn home_file(self) -> PathBuf {
        Path::new(self.home()).join("src/lib.rs")
    }

    /// Its folder.
    pub fn folder(self) -> PathBuf {
        let name = match self {
            Self::Algebra => "algebra",
            Self::Phases => "phases",
            Self::Contact => "contact",
            Self::Event => "event",
            Self::Simulation => "simulation",
        };
        Path::new(self.home()).join("src").join(name)
    }

    /// Options of `cargo test` for the tests that judge it.
    pub fn targets(self) -> &'static [&'static str] {
        match self {
            Self::Algebra | Self::Phases => &["-p", "liftoff-codegen", "--lib"],
            Self::Contact | Self::Event | Self::Simulation => {
                &["-p", "liftoff-dynamics", "-p", "liftoff-engine-tests", "--lib", "--test", "it"]
            }
        }
    }

    /// Of these files of the workspace those that are its own, without tests.
    pub fn files(self, all: &[PathBuf]) -> Vec<PathBuf> {
        let test = |part: &Path| part.file_stem().is_some_and(|stem| stem == "tests");
        let own = |path: &&PathBuf| {
            path.starts_with(self.folder())
                && path.extension().is_some_and(|extension| extension == "rs")
                && !path.ancestors().any(test)
        };
        all.iter().filter(own).cloned().collect()
    }
}

/// Files that git knows, of the folder in which this runs.
pub fn tracked() -> Vec<PathBuf> {
    let output =
        Command::new("git").args(["ls-files", "-z"]).output().expect("lists the files of the workspace");
    let names = String::from_utf8(output.stdout).expect("reads names of files");
    names.split('\0').map(PathBuf::from).filter(|path| path.is_file()).collect()
}

/// Writes a file if that changes it, so that nothing is compiled anew for nothing.
pub fn write(path: &Path, bytes: &[u8]) {
    if std::fs::read(path).is_ok_and(|present| present == bytes) {
        return;
    }
    std::fs::create_dir_all(path.parent().expect("has a folder")).expect("makes a folder");
    std::fs::write(path, bytes).expect("writes a file");
}
