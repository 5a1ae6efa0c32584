//! `liftoff new`.

use crate::CommandError;
use crate::options::files;
use crate::output::print::print;
use clap::Args;
use liftoff_studio::registry::{Models, kebab};
use liftoff_studio::source::{declarations, equations};
use std::fs;
use std::path::{Path, PathBuf};

/// Files of a project: where, and what is in them.
const FILES: [(&str, &str); 5] = [
    ("Cargo.toml", include_str!("new/manifest.toml")),
    ("src/main.rs", include_str!("new/main.rs.txt")),
    (
        "src/snapshots/{crate}__tests__equations.snap",
        "---\nsource: src/main.rs\nexpression: equations\n---\n{equations}",
    ),
    (".cargo/config.toml", include_str!("new/config.toml")),
    (".gitignore", "/target\n"),
];

/// The model where none is asked for.
const SWING: &str = include_str!("new/swing.rs.txt");

/// The sources of this crate where this program was built.
const SOURCE: &str = env!("CARGO_MANIFEST_DIR");

/// Cargo's own folders, and what the project depends on.
const TAKEN: [&str; 8] =
    ["build", "deps", "examples", "incremental", "insta", "liftoff", "liftoff-cli", "liftoff-dynamics"];

#[derive(Args, Debug)]
pub struct New {
    /// Name of the project and of its folder
    name: PathBuf,
    /// The model to begin with: a name from `list`, or a file
    #[arg(long, value_name = "MODEL|FILE.rs")]
    from: Option<String>,
    /// Folder of liftoff's sources; by default crates.io, or the folder that this program was built
    /// from if its version is not published
    #[arg(long, value_name = "DIRECTORY")]
    liftoff: Option<PathBuf>,
}

/// What a project begins with.
struct Template {
    /// Name of the struct.
    name: String,
    /// Its declaration, with its run.
    text: String,
}

impl New {
    /// Writes a project with one model, every command over it, and a test of its equations.
    pub fn execute(&self, models: &Models, chosen: Option<&str>) -> Result<(), CommandError> {
        let name = package(&self.name)?;
        // A link that leads nowhere is there too.
        if self.name.symlink_metadata().is_ok() {
            return Err(CommandError::Usage(format!("{} is there already", self.name.display())));
        }
        let [engine, cli] = ["runtime/engine", "runtime/cli"].map(|part| self.source(part));
        let (engine, cli) = (engine?, cli?);
        let template = self.template(models, chosen)?;
        let equations = files::parse("the model", &template.text, equations)?;
        let equations: String = equations.iter().map(ToString::to_string).collect();
        let fields = [
            ("{name}", name.as_str()),
            ("{crate}", &name.replace('-', "_")),
            ("{engine}", &engine),
            ("{cli}", &cli),
            ("{struct}", &template.name),
            ("{model}", template.text.trim_end()),
            ("{equations}", &equations),
        ];
        let fill = |text: &str| {
            fields.iter().fold(text.to_owned(), |text, (field, value)| text.replace(field, value))
        };
        for (file, text) in FILES {
            let path = self.name.join(fill(file));
            write(&path, &fill(text))
                .map_err(|error| CommandError::Failed(format!("cannot write {}: {error}", path.display())))?;
        }
        let (folder, model) = (self.name.display(), kebab(&template.name));
        Ok(print(&format!(
            "{folder} is written; next: cd {folder} && cargo run --release -- animate {model} --open\n"
        ))?)
    }

    fn template(&self, models: &Models, chosen: Option<&str>) -> Result<Template, CommandError> {
        let Some(from) = &self.from else {
            return Ok(Template { name: "Swing".to_owned(), text: SWING.to_owned() });
        };
        if files::is_file(from, models) {
            let found =
                files::one(from, files::parse_file(from, declarations)?, chosen, |found| &found.name)?;
            return Ok(Template { text: found.text().to_owned(), name: found.name });
        }
        let model = models.find(from)?;
        let unknown = || {
            CommandError::Usage(format!(
                "--from {from}: this program does not have the text of this model; give its file"
            ))
        };
        let found = files::parse(from, model.source().ok_or_else(unknown)?, declarations)?;
        let found = found.into_iter().find(|found| kebab(&found.name) == model.name()).ok_or_else(unknown)?;
        Ok(Template { text: found.with_run(&model.default_run()), name: found.name })
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
            "`{name}` is not a package name: use a letter, then letters, digits, `-` and `_`"
        ))),
    }
}
