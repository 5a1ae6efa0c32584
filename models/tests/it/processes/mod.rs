//! What tests of the program's processes share.

use std::fs;
use std::path::{Path, PathBuf};

/// An empty folder of a test's own.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-{name}", env!("CARGO_CRATE_NAME")));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A Python that has these packages: the one there is, else one in an environment of its own where
/// pip can install them; none, which is told, where it cannot.
#[allow(dead_code, reason = "tests of other formats need none")]
pub fn python_with(packages: &[&str]) -> Option<PathBuf> {
    let has = |python: &Path| {
        let import = format!("import {}", packages.join(", "));
        std::process::Command::new(python)
            .args(["-c", &import])
            .output()
            .is_ok_and(|output| output.status.success())
    };
    let system = PathBuf::from("python3");
    if has(&system) {
        return Some(system);
    }
    let environment = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("python-{}", packages.join("-")));
    let own = environment.join("bin/python");
    let done = |program: &Path, arguments: &[&str]| {
        std::process::Command::new(program)
            .args(arguments)
            .output()
            .is_ok_and(|output| output.status.success())
    };
    let made = has(&own)
        || done(&system, &["-m", "venv", &environment.to_string_lossy()])
            && done(&own, &[&["-m", "pip", "install", "-q"], packages].concat())
            && has(&own);
    if !made {
        eprintln!("skipped: no Python with {}, and pip cannot install it", packages.join(", "));
    }
    made.then_some(own)
}
