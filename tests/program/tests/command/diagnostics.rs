//! What `explain FILE` tells of a mistake is what the compiler tells of it.

use crate::program::{command, errors};
use std::path::Path;

/// Word for word, for every mistake that the compiler's messages are tested on.
#[test]
fn mistakes_in_a_file_are_reported_as_the_compiler_tells_them() {
    let derive = Path::new(env!("CARGO_MANIFEST_DIR")).join("../derive");
    let files = std::fs::read_dir(derive.join("tests/ui"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path());
    let mut compared = 0;
    for file in files.filter(|file| file.extension().is_some_and(|extension| extension == "rs")) {
        let name = format!("tests/ui/{}", file.file_name().expect("a name").display());
        let expected =
            std::fs::read_to_string(file.with_extension("stderr")).expect("what the compiler tells");
        let told = command(&["explain", &name]).current_dir(&derive).output().expect("the program starts");
        assert_eq!(errors(&told).trim_end(), expected.trim_end(), "{name}");
        compared += 1;
    }
    assert!(compared > 20);
}
