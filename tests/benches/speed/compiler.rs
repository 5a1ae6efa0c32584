//! Small crates of their own, compiled as a user's release build compiles them, and timed doing so.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use crate::Result;

const FLAGS: [&str; 8] = [
    "--edition=2024",
    "-Copt-level=3",
    "-Ctarget-cpu=native",
    "-Ccodegen-units=1",
    "-Cembed-bitcode=no",
    "--cap-lints=allow",
    "-Cpanic=unwind",
    "-Cstrip=none",
];

/// A folder for sources and what is made of them.
pub struct Compiler {
    folder: PathBuf,
    dependencies: PathBuf,
    liftoff: PathBuf,
}

impl Compiler {
    /// With the `liftoff` that this benchmark was linked with.
    pub fn new() -> Result<Self> {
        let folder = crate::output::folder()?.join("speed");
        fs::create_dir_all(&folder)?;
        let program = std::env::current_exe()?;
        let dependencies = program.parent().ok_or("no folder of dependencies")?.to_path_buf();
        let liftoff = newest(&dependencies, "libliftoff-")?;
        Ok(Self { folder, dependencies, liftoff })
    }

    /// Compiles a library; milliseconds.
    pub fn library(&self, name: &str, source: &str) -> Result<f64> {
        self.compile(name, source, &["--crate-type=lib".into()])
    }

    /// Compiles a program that uses some of the libraries, runs it, gives what it writes.
    pub fn run(&self, name: &str, source: &str, libraries: &[&str]) -> Result<(PathBuf, String)> {
        let library = |name: &&str| format!("--extern={name}={}", self.path(&format!("lib{name}.rlib")));
        let libraries: Vec<String> = libraries.iter().map(library).collect();
        self.compile(name, source, &libraries)?;
        let program = self.folder.join(name);
        let output = Command::new(&program).output()?;
        match output.status.success() {
            true => Ok((program, String::from_utf8(output.stdout)?)),
            false => Err(String::from_utf8_lossy(&output.stderr).into()),
        }
    }

    fn compile(&self, name: &str, source: &str, more: &[String]) -> Result<f64> {
        let file = self.folder.join(format!("{name}.rs"));
        fs::write(&file, source)?;
        let mut rustc = Command::new("rustc");
        rustc.args(FLAGS).args(more).arg(format!("--crate-name={name}")).arg(&file);
        rustc.arg("--out-dir").arg(&self.folder);
        rustc.arg(format!("-Ldependency={}", self.dependencies.display()));
        rustc.arg(format!("-Ldependency={}", self.folder.display()));
        rustc.arg(format!("--extern=liftoff={}", self.liftoff.display()));
        let start = Instant::now();
        let output = rustc.output()?;
        let time = 1e3 * start.elapsed().as_secs_f64();
        match output.status.success() {
            true => Ok(time),
            false => Err(format!("{}: {}", file.display(), String::from_utf8_lossy(&output.stderr)).into()),
        }
    }

    fn path(&self, file: &str) -> String {
        self.folder.join(file).display().to_string()
    }
}

/// The library of this name that was built last.
fn newest(folder: &Path, name: &str) -> Result<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let file = entry?;
        let title = file.file_name().to_string_lossy().into_owned();
        if title.starts_with(name) && title.ends_with(".rlib") {
            found.push((file.metadata()?.modified()?, file.path()));
        }
    }
    let last = found.into_iter().max_by_key(|(time, _)| *time);
    Ok(last.ok_or_else(|| format!("no {name}*.rlib in {}", folder.display()))?.1)
}
