//! `liftoff new`.

use crate::CommandError;
use crate::output::print::print;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};

/// Files of a project: where, and what is in them.
const FILES: [(&str, &str); 4] = [
    ("Cargo.toml", include_str!("new/manifest.toml")),
    ("src/main.rs", include_str!("new/main.rs.txt")),
    (".cargo/config.toml", include_str!("new/config.toml")),
    (".gitignore", "/target\n"),
];

/// The sources of this crate where this program was built.
const SOURCE: &str = env!("CARGO_MANIFEST_DIR");

/// Cargo's own folders, and what the project depends on.
const TAKEN: [&str; 7] =
    ["build", "deps", "examples", "incremental", "liftoff", "liftoff-cli", "liftoff-dynamics"];

#[derive(Args, Debug)]
pub struct New {
    /// Name of the project and of its folder
    name: PathBuf,
    /// Where liftoff's sources are; by default crates.io, or where this program was built from if that was no published version
    #[arg(long, value_name = "DIRECTORY")]
    liftoff: Option<PathBuf>,
}

impl New {
    /// Writes a project with one model and every command over it.
    pub fn execute(&self) -> Result<(), CommandError> {
        let name = package(&self.name)?;
        // A link that leads nowhere is there too.
        if self.name.symlink_metadata().is_ok() {
            return Err(CommandError::Usage(format!("{} is there already", self.name.display())));
        }
        let [engine, cli] = ["runtime/engine", "runtime/cli"].map(|part| self.source(part));
        let (engine, cli) = (engine?, cli?);
        for (file, text) in FILES {
            let path = self.name.join(file);
            let text = text.replace("{name}", &name).replace("{engine}", &engine).replace("{cli}", &cli);
            write(&path, &text)
                .map_err(|error| CommandError::Failed(format!("cannot write {}: {error}", path.display())))?;
        }
        let folder = self.name.display();
        Ok(print(&format!(
            "{folder} is written; next: cd {folder} && cargo run --release -- animate swing --open\n"
        ))?)
    }

    /// What `Cargo.toml` says of a crate: a version, or the path to its sources.
    fn source(&self, part: &str) -> Result<String, CommandError> {
        let folder = match &self.liftoff {
            Some(folder) => folder,
            // Cargo keeps the sources of a published crate in a folder that ends with its version.
            None if SOURCE.ends_with(concat!("-", env!("CARGO_PKG_VERSION"))) => {
                return Ok(format!("version = \"{}\"", env!("CARGO_PKG_VERSION")));
            }
            None => Path::new(SOURCE).parent().and_then(Path::parent).unwrap_or(Path::new(SOURCE)),
        };
        let path = folder.join(part);
        let found = fs::canonicalize(&path).map_err(|error| {
            CommandError::Usage(match &self.liftoff {
                Some(_) => format!("--liftoff: {}: {error}", path.display()),
                None => format!(
                    "the sources that this program was built from are not there any more ({}: {error}); say where \
                     they are by --liftoff DIRECTORY",
                    path.display()
                ),
            })
        })?;
        Ok(format!("path = {:?}", found.display().to_string()))
    }
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    path.parent().map_or(Ok(()), fs::create_dir_all)?;
    fs::write(path, text)
}

/// The name of the package: that of the folder, as cargo demands names.
fn package(folder: &Path) -> Result<String, CommandError> {
    let name = folder.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic());
    let fits = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
    match begins && fits {
        true if TAKEN.contains(&name.replace('_', "-").as_str()) => {
            Err(CommandError::Usage(format!("a package `{name}` cannot be built: the name is taken")))
        }
        true => Ok(name.to_owned()),
        false => Err(CommandError::Usage(format!(
            "`{name}` is no name of a package: a letter, then letters, digits, `-` and `_`"
        ))),
    }
}
