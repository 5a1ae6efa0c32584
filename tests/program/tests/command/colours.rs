//! Colours are for terminals, and for who asks for them.

use crate::program::{command, run};

const ESCAPE: u8 = 0x1b;

fn coloured(text: &[u8]) -> bool {
    text.contains(&ESCAPE)
}

#[test]
fn piped_output_has_no_colours() {
    for arguments in
        [&["list"][..], &["run", "trestle"], &["run", "nothing"], &["run", "--help"], &["--help"]]
    {
        let output = run(arguments);
        assert!(!coloured(&output.stdout) && !coloured(&output.stderr), "{arguments:?}");
    }
}

#[test]
fn colours_can_be_asked_for_and_forbidden() {
    assert!(coloured(&run(&["list", "--color", "always"]).stdout));
    assert!(coloured(&run(&["run", "trestle", "--color", "always"]).stdout));
    let forced = |no: bool| {
        let mut command = command(&["list"]);
        command.env("CLICOLOR_FORCE", "1");
        if no {
            command.args(["--color", "never"]);
        }
        command.output().expect("the program starts").stdout
    };
    assert!(coloured(&forced(false)) && !coloured(&forced(true)));
}

/// `script` gives the program a terminal.
#[test]
fn a_terminal_has_colours_unless_they_are_unwanted() {
    let on_terminal = |no_color: Option<&str>| {
        let program = format!("{} list", env!("CARGO_BIN_EXE_trestle"));
        let mut script = std::process::Command::new("script");
        script.args(["-qec", &program, "/dev/null"]).env("TERM", "xterm").env_remove("NO_COLOR");
        if let Some(value) = no_color {
            script.env("NO_COLOR", value);
        }
        script.output().ok().filter(|output| output.status.success())
    };
    match (on_terminal(None), on_terminal(Some("1"))) {
        (Some(with), Some(without)) => assert!(coloured(&with.stdout) && !coloured(&without.stdout)),
        _ => eprintln!("not tested: there is no `script`"),
    }
}
