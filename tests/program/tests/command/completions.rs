//! Scripts for shells: they can be read, and know the names of this program's models.

use crate::program::run_program;
use std::io::Write;
use std::process::{Command, Stdio};

#[test]
fn every_shell_is_reported_commands_options_models_and_methods() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = run_program(&["completions", shell]);
        // The scripts of the last two complete no values.
        let names = ["precision", "energy-of", "trestle", "dop853"];
        let known = if ["powershell", "elvish"].contains(&shell) { &names[..2] } else { &names[..] };
        for name in known {
            assert!(script.contains(name), "{shell}: {name}");
        }
    }
}

#[test]
fn shells_can_read_their_scripts() {
    for shell in ["bash", "zsh"] {
        let reader = Command::new(shell).arg("-n").stdin(Stdio::piped()).stderr(Stdio::piped()).spawn();
        let Ok(mut reader) = reader else {
            eprintln!("not tested: there is no {shell}");
            continue;
        };
        let script = run_program(&["completions", shell]);
        let mut input = reader.stdin.take().expect("a pipe");
        input.write_all(script.as_bytes()).expect("written");
        drop(input);
        let read = reader.wait_with_output().expect("it ends");
        assert!(read.status.success(), "{shell}: {}", String::from_utf8_lossy(&read.stderr));
    }
}

#[test]
fn bash_completes_a_model() {
    let script = run_program(&["completions", "bash"]);
    let ask = "COMP_WORDS=(trestle run trest); COMP_CWORD=2; COMP_LINE='trestle run trest'; COMP_POINT=17\n\
               _trestle trestle trest run; echo \"${COMPREPLY[@]}\"\n";
    let Ok(output) = Command::new("bash").arg("-c").arg(script + "\n" + ask).output() else {
        eprintln!("not tested: there is no bash");
        return;
    };
    assert_eq!(String::from_utf8_lossy(&output.stdout).trim(), "trestle");
}
