//! The first screen of the README as its readers meet it.

use std::process::Command;

/// The text between two marks, the first of which ends with a line.
fn between<'a>(text: &'a str, begin: &str, end: &str) -> &'a str {
    let (_, rest) = text.split_once(begin).unwrap_or_else(|| panic!("no {begin}"));
    rest.split_once(end).unwrap_or_else(|| panic!("no {end}")).0
}

#[test]
fn the_ten_lines_print_what_is_shown() {
    let readme = include_str!("../../../README.md");
    let source = between(readme, "```rust,ignore\n", "```");
    let shown = between(readme, "```text\n", "```");
    let path = std::env::temp_dir().join(format!("liftoff-readme-{}.rs", std::process::id()));
    std::fs::write(&path, source).expect("a file");
    let output = Command::new(env!("CARGO_BIN_EXE_liftoff"))
        .arg("run")
        .arg(&path)
        .output()
        .expect("the command starts");
    std::fs::remove_file(path).expect("removed");
    assert_eq!(String::from_utf8_lossy(&output.stdout), shown, "{}", String::from_utf8_lossy(&output.stderr));
    assert!(source.lines().count() <= 10);
}

/// The commands of the chapter on outputs.
#[test]
fn outputs_and_conditions_are_read_as_the_book_has_them() {
    let chapter = include_str!("../../../runtime/cli/src/book/outputs.md");
    let commands = between(chapter, "```sh\n", "```");
    assert!(commands.lines().count() > 3);
    for line in commands.lines() {
        let line = line.replacen("liftoff", env!("CARGO_BIN_EXE_liftoff"), 1);
        let output = Command::new("sh").args(["-c", &line]).output().expect("a shell");
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    }
}
