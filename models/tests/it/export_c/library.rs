//! A library of C that `export --c` has written, built as users do, with a program that calls it.

use crate::processes::text;
use liftoff_core::model::{ContactSet, Layout, Slip};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What a C compiler must not find in it.
const FLAGS: [&str; 6] = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-pedantic"];

/// Numbers by name.
pub type Answer = BTreeMap<String, Vec<f64>>;

pub struct Library {
    program: PathBuf,
    layout: &'static Layout,
}

/// Whether a command succeeds without a word.
fn quietly(command: &mut Command) {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let told = text(&output.stdout) + &text(&output.stderr);
    assert!(output.status.success() && told.is_empty(), "{command:?}: {told}");
}

impl Library {
    /// Exports, compiles to a static library, and links it with the driver.
    pub fn build(folder: &Path, name: &str, layout: &'static Layout) -> Self {
        Self::of_file(folder, Path::new(name), &name.replace('-', "_"), layout)
    }

    /// The same of a model in a file, whose names begin with `prefix`.
    pub fn of_file(folder: &Path, model: &Path, prefix: &str, layout: &'static Layout) -> Self {
        let own = folder.join(format!("{prefix}-in-c"));
        let mut export = Command::new(env!("CARGO_BIN_EXE_liftoff"));
        let output =
            export.arg("export").arg(model).arg("--c").arg(&own).output().expect("the command starts");
        assert!(output.status.success(), "{}: {}", model.display(), text(&output.stderr));
        let flags = FLAGS.join(" ");
        let mut make = Command::new("make");
        quietly(make.current_dir(&own).args(["--silent", &format!("CFLAGS={flags}")]));
        let program = own.join("driver");
        let mut cc = Command::new("cc");
        cc.args(FLAGS).arg(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/it/export_c/driver.c"));
        cc.arg(format!("-DHEADER=\"{prefix}.h\"")).arg(format!("-DPREFIX={prefix}"));
        cc.arg(format!("-DCAPITAL={}", prefix.to_uppercase()));
        cc.arg(format!("-DTIMED={}", u8::from(layout.timed)));
        cc.arg(format!("-DPARAMETERS={}", layout.parameters.len()));
        cc.args(["-I.", "-o", "driver", "-L."]).args([&format!("-l{prefix}"), "-lm"]);
        quietly(cc.current_dir(&own));
        Self { program, layout }
    }

    /// The beginning of a question about a contact set.
    pub fn question(&self, word: &str, parameters: &[f64], set: ContactSet, state: &[f64]) -> String {
        let rubs = |i: usize| set.contains(i) && self.layout.contacts[i].friction.is_some();
        let contacts = 0..self.layout.contacts.len();
        let senses = contacts.clone().map(|i| if rubs(i) { set.sense(i) as f64 } else { 0.0 });
        let closed = contacts.map(|i| match set.contains(i) {
            true if rubs(i) && set.slip(i) != Slip::Stick => 2.0,
            closed => f64::from(u8::from(closed)),
        });
        let mut question = word.to_owned();
        for number in parameters.iter().copied().chain(senses).chain(closed).chain(state.iter().copied()) {
            write!(question, " {number:e}").expect("a text");
        }
        question
    }

    /// What the program says to these questions.
    pub fn ask(&self, questions: &[String]) -> Vec<Answer> {
        let mut command = Command::new(&self.program);
        let mut child =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("the driver starts");
        let mut input = child.stdin.take().expect("it is piped");
        let asked = questions.join("\n");
        // Both pipes are of limited size.
        let writer = std::thread::spawn(move || input.write_all(asked.as_bytes()));
        let output = child.wait_with_output().expect("the driver ends");
        writer.join().expect("no panic").expect("all is read");
        assert!(output.status.success(), "{:?}: {}", self.program, output.status);
        let said = text(&output.stdout);
        let mut answers = vec![Answer::new()];
        for line in said.lines() {
            let mut words = line.split(' ');
            let name = words.next().unwrap_or_default();
            if name == "end" {
                answers.push(Answer::new());
                continue;
            }
            let numbers = words.map(|word| word.parse().expect("a number")).collect();
            answers.last_mut().expect("one").insert(name.to_owned(), numbers);
        }
        answers.pop();
        assert_eq!(answers.len(), questions.len());
        answers
    }
}
