//! Sizes of functions in a program.

use std::path::Path;
use std::process::Command;

/// Bytes of the functions whose mangled names `counts`; `None` where `nm` is missing.
pub fn bytes(program: &Path, counts: impl Fn(&str) -> bool) -> Option<u64> {
    let output = Command::new("nm").args(["--print-size", "--defined-only"]).arg(program).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let size = |line: &str| {
        let [_, size, kind, name] = line.split_whitespace().collect::<Vec<_>>()[..] else { return None };
        let is_code = kind.eq_ignore_ascii_case("t") && counts(name);
        is_code.then(|| u64::from_str_radix(size, 16).ok()).flatten()
    };
    output.status.success().then(|| text.lines().filter_map(size).sum())
}
