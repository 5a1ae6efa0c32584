//! The programs of the ladder as the compiler leaves them.

use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs, io};

use object::{Object, ObjectSection, ObjectSymbol, SectionKind};

/// An executable file.
pub struct Binary {
    data: Vec<u8>,
}

/// A function of an executable file.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its mangled name.
    pub name: String,
    /// Where it begins.
    pub address: u64,
    /// Bytes of machine code.
    pub size: u64,
}

impl Binary {
    /// The program that is running.
    pub fn running() -> io::Result<Self> {
        Ok(Self { data: fs::read(env::current_exe()?)? })
    }

    /// The program at a path.
    pub fn built(path: &str) -> io::Result<Self> {
        Ok(Self { data: fs::read(path)? })
    }

    /// A program of this package, built in release, and how long that took with all that it depends
    /// on ready.
    pub fn released(name: &str) -> io::Result<(Self, Duration)> {
        cargo(name, &[])?;
        let start = Instant::now();
        // Another name for its symbols is another program to compile.
        let metadata = format!("metadata=measure{}", std::process::id());
        cargo(name, &["-C", &metadata])?;
        let took = start.elapsed();
        Ok((Self { data: fs::read(target()?.join("release").join(name))? }, took))
    }

    /// Its functions; none where the format of executables is not ELF.
    pub fn functions(&self) -> Vec<Function> {
        let Ok(file) = object::File::parse(&*self.data) else { return Vec::new() };
        let functions = file.symbols().filter(|symbol| symbol.kind() == object::SymbolKind::Text);
        let function = |symbol: object::Symbol| {
            let name = symbol.name().ok()?.to_owned();
            Some(Function { name, address: symbol.address(), size: symbol.size() })
        };
        functions.filter_map(function).collect()
    }

    /// Bytes of machine code.
    pub fn text(&self) -> u64 {
        let Ok(file) = object::File::parse(&*self.data) else { return 0 };
        file.sections()
            .filter(|section| section.kind() == SectionKind::Text)
            .map(|section| section.size())
            .sum()
    }
}

/// Whether a module, `liftoff::event`, has code: it is named as a path, or in the name of an
/// implementation.
pub fn has_code(functions: &[Function], module: &str) -> bool {
    let parts = module.split("::").map(|part| format!("{}{part}", part.len()));
    let names = [parts.collect::<String>(), module.replace("::", "..")];
    functions.iter().any(|function| names.iter().any(|name| function.name.contains(name)))
}

/// Where this program was built: it is `target/PROFILE/deps/PROGRAM`.
fn target() -> io::Result<PathBuf> {
    let program = env::current_exe()?;
    let target = program.ancestors().nth(3).map(PathBuf::from);
    target.ok_or_else(|| io::Error::other("the program does not lie in a target directory"))
}

/// Builds a program in release, with its symbols and further options of the compiler.
fn cargo(name: &str, options: &[&str]) -> io::Result<()> {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["rustc", "--quiet", "--package", "liftoff-ladder", "--bin", name, "--release"]);
    command.args(["--features", "programs,by-hand"]);
    command.arg("--target-dir").arg(target()?).args(["--", "-C", "strip=none"]).args(options);
    let built = command.current_dir(env!("CARGO_MANIFEST_DIR")).status()?.success();
    if built { Ok(()) } else { Err(io::Error::other(format!("{name} was not built"))) }
}
