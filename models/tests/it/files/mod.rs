//! Commands on files that no compiler sees.

mod new;
mod watch;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/files").join(name)
}

fn liftoff(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    command.args(arguments).current_dir(env!("CARGO_TARGET_TMPDIR")).output().expect("the command starts")
}

/// What a command prints on a file, where it succeeds.
fn run_command(command: &str, name: &str, arguments: &[&str]) -> String {
    let path = file(name);
    let output = liftoff(&[&[command, path.to_str().expect("UTF-8")], arguments].concat());
    assert!(output.status.success(), "{command} {name}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// What it says where it refuses.
fn refused(command: &str, path: &Path, arguments: &[&str]) -> String {
    let output = liftoff(&[&[command, path.to_str().expect("UTF-8")], arguments].concat());
    assert!(matches!(output.status.code(), Some(1 | 2)), "{output:?}");
    String::from_utf8(output.stderr).expect("text")
}

/// A pendulum of a bar: ½ m l² φ̇²/3 = ½ m g l (cos φ − cos 80°) + the start's ½ m l² 1²/3.
#[test]
fn a_file_runs_with_the_values_and_the_run_that_it_declares() {
    let run = run_command("run", "swing.rs", &["--until", "phi = 0", "--output", "phi'", "--json"]);
    let run: serde_json::Value = serde_json::from_str(&run).expect("JSON");
    assert_eq!((&run["model"], &run["parameters"]["l"]), (&"swinging-bar".into(), &0.5.into()));
    let rate = run["final_state"]["phi'"].as_f64().expect("a number");
    let start = 80.0_f64.to_radians();
    let expected = 1.0 + 3.0 * 9.81 / 0.5 * (1.0 - start.cos());
    assert!((rate * rate - expected).abs() < 1e-10 * expected, "{rate}");
    assert!(run_command("list", "swing.rs", &[]).contains("m = 2 kg, l = 0.5, g = 9.81 m/s²"));
}

/// A point flies round the end of a bar and is below it: from each state that is printed the run
/// goes on.
#[test]
fn a_state_that_is_printed_is_a_start() {
    let run = |start: &[String], limit: f64| {
        let options = ["--limit".to_owned(), format!("{limit:?}"), "--every".to_owned(), "0.1".to_owned()];
        let start = start.iter().flat_map(|given| ["--start".to_owned(), given.clone()]);
        let arguments: Vec<String> = options.into_iter().chain(start).chain(["--json".to_owned()]).collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        serde_json::from_str::<serde_json::Value>(&run_command("run", "beside.rs", &arguments)).expect("JSON")
    };
    let start = ["phi=0", "x=2.2", "y=0.3", "phi'=0", "x'=-1", "y'=-2"].map(str::to_owned);
    let whole = run(&start, 0.6);
    let samples = whole["samples"].as_array().expect("samples");
    let mut below = 0;
    for sample in samples {
        let state = sample["state"].as_object().expect("a state");
        below += usize::from(state.contains_key("below(P)"));
        let given: Vec<String> = state.iter().map(|(name, value)| format!("{name}={value}")).collect();
        let rest = run(&given, 0.6 - sample["t"].as_f64().expect("a time"));
        for (name, value) in whole["final_state"].as_object().expect("a state") {
            let [found, expected] =
                [&rest["final_state"][name], value].map(|x| x.as_f64().expect("a number"));
            assert!((found - expected).abs() < 1e-9, "{name} from {given:?}: {found}, not {expected}");
        }
    }
    assert!(below >= 2 && below < samples.len(), "{below} of {}", samples.len());
}

#[test]
fn every_command_takes_a_file() {
    assert!(run_command("modes", "swing.rs", &[]).contains("own code"));
    assert!(run_command("explain", "swing.rs", &[]).contains("sin φ"));
    for (command, out) in [("plot", "swing.svg"), ("animate", "swing.html")] {
        run_command(command, "swing.rs", &["--out", out]);
        let written =
            std::fs::read_to_string(Path::new(env!("CARGO_TARGET_TMPDIR")).join(out)).expect("written");
        assert!(written.contains("<svg"));
    }
    let rows =
        run_command("sweep", "swing.rs", &["--vary", "l=1:2:5", "--observe", "end phi'", "--csv", "-"]);
    assert_eq!(rows.lines().count(), 6, "{rows}");
    let table = run_command(
        "precision",
        "swing.rs",
        &["--until", "t = 1", "--methods", "taylor", "--tolerances", "1e-9"],
    );
    assert!(table.contains("agrees within"), "{table}");
    assert!(run_command("stability", "swing.rs", &["--short", "--out", "stability"]).contains("cases pass"));
    run_command("report", "swing.rs", &["--out", "report"]);
}

#[test]
fn of_what_never_moves_that_alone_is_said() {
    let text = run_command("stability", "rests.rs", &["--short", "--out", "rests"]);
    assert_eq!(text.matches("never moves").count(), 2, "{text}");
    assert!(text.contains("0 of 1 cases pass, 1 is not judged"), "{text}");
}

#[test]
fn of_several_models_one_is_chosen() {
    let path = file("two.rs");
    assert!(refused("run", &path, &[]).contains("choose one: --model Ball, LongBar"));
    assert!(refused("run", &path, &["--model", "Bal"]).contains("did you mean `Ball`?"));
    assert!(run_command("run", "two.rs", &["--model", "Ball"]).contains("impact"));
    assert!(
        run_command(
            "run",
            "two.rs",
            &["--model", "long-bar", "--set", "l=2", "--limit", "1", "--start", "theta_OA=-1"]
        )
        .contains("start")
    );
    assert!(refused("run", &path, &["--model", "LongBar"]).contains("parameter `l` is not given"));
    for name in ["LongBar", "long-bar"] {
        assert_eq!(run_command("explain", "two.rs", &["--model", name]).lines().next(), Some("LongBar"));
    }
    assert!(refused("explain", &path, &["--format", "html"]).contains("choose one: --model Ball, LongBar"));
    assert!(refused("explain", &path, &["--model", "Bal"]).contains("did you mean `Ball`?"));
    assert!(refused("explain", Path::new("ladder"), &["--model", "Ladder"]).contains("of a FILE.rs"));
    let twice = Path::new(env!("CARGO_TARGET_TMPDIR")).join("twice.rs");
    let text = std::fs::read_to_string(file("swing.rs")).expect("read");
    std::fs::write(&twice, format!("mod a {{ {text} }} mod b {{ {text} }}")).expect("written");
    assert!(refused("run", &twice, &["--model", "SwingingBar"]).contains("rename all but one"));
}

#[test]
fn units_are_converted_wherever_they_stand() {
    let text = std::fs::read_to_string(file("swing.rs")).expect("read");
    let text = text
        .replace("#[value = 0.5]", "#[value(500, unit = \"mm\")]")
        .replace("9.81, unit = \"m/s²", "9810, unit = \"mm/s²");
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("millimetres.rs");
    std::fs::write(&path, text).expect("written");
    let events = |path: &Path, options: &[&str]| {
        let run = liftoff(&[&["run", path.to_str().expect("UTF-8"), "--json"], options].concat());
        assert!(run.status.success(), "{run:?}");
        let told: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
        (told["parameters"].clone(), told["events"].clone())
    };
    let metres = events(&file("swing.rs"), &[]);
    assert_eq!(events(&path, &[]), metres);
    assert_eq!(events(&path, &["--set", "l=50cm", "--set", "g=981 cm/s²"]), metres);
    assert_eq!(events(&path, &["--start", "phi=80deg", "--start", "phi'=1 rad/s"]), metres);
    for (command, options, wrong) in [
        ("run", vec!["--set", "l=5 kg"], "--set l: measured in m, not in kg"),
        ("run", vec!["--start", "phi=5 mm"], "--start phi: measured in rad, not in m"),
        ("run", vec!["--start", "phi'=5 deg"], "--start phi': measured in rad/s, not in rad"),
        ("run", vec!["--limit", "5 mm"], "measured in m, not in s"),
        (
            "sweep",
            vec!["--vary", "l=5:6 s:3", "--observe", "first stop t"],
            "--set l: measured in m, not in s",
        ),
        (
            "sweep",
            vec!["--bisect", "l=0.4:0.6", "--observe", "end phi = 5 mm"],
            "`end phi`: measured in rad, not in m",
        ),
        (
            "optimise",
            vec!["--vary", "l=40 s:60 s", "--of", "end phi"],
            "--vary l=40 s:60 s: measured in m, not in s",
        ),
        (
            "fit",
            vec!["--vary", "l", "--event", "first stop=3 m"],
            "--event first stop=3 m: measured in s, not in m",
        ),
        (
            "orbit",
            vec!["--section", "phi' > 0", "--continue", "l=3 s"],
            "--continue l: measured in m, not in s",
        ),
        ("equilibrium", vec!["--load", "g=3 s"], "--load g: measured in m/s², not in s"),
    ] {
        let told = refused(command, &path, &options);
        assert!(told.contains(wrong), "{command}: {told}");
    }
}

/// A figure is drawn with the values of parameters: which numbers of a scene are literals makes no
/// difference.
#[test]
fn figures_are_drawn_with_the_values_of_parameters() {
    let leaning = "#[bar(AB, mass = 1, length = 1)] #[support(A = floor(H))] #[support(B = wall(W))] \
                   #[figure(A = (3, 2.5), B = (3.6, 3.3))] #[coordinate(phi = angle(AB), from = horizontal)]";
    let pinned = "#[bar(AB, mass = 1, length = 1)] #[pin(A = (H, 0.1))] #[support(B = wall(W))] \
                  #[figure(B = (1.8, 0.7))] #[coordinate(phi = angle(AB), from = horizontal)]";
    let corner = "#[bar(AB, mass = 1, length = 2)] #[support(K = corner(W, H), under = AB)] #[support(A = floor)] \
                  #[figure(A = (3, 0), B = (1.4, 1.2))] #[coordinate(phi = angle(AB), from = right)]";
    let welded = "#[bar(AB, mass = 1, length = W)] #[bar(BC, mass = 1, length = 1)] #[weld(AB, BC)] #[pin(A = (0, 0))] \
                  #[figure(B = (W, 0), C = (W, W - H))] #[coordinate(phi = angle(AB), from = right)]";
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("figure.rs");
    let run = |scene: String| {
        let text = format!("#[derive(BarSystem)] #[gravity(9.81)] #[run(limit = 0.3)] {scene}");
        std::fs::write(&path, text).expect("written");
        let run = liftoff(&["run", path.to_str().expect("UTF-8")]);
        assert!(run.status.success(), "{run:?}");
        String::from_utf8(run.stdout).expect("text")
    };
    for (scene, w, h) in
        [(leaning, "4.5", "2.5"), (pinned, "1.2", "1.1"), (corner, "2.2", "0.5"), (welded, "1", "2")]
    {
        let literal = run(format!("{} struct S {{}}", scene.replace('W', w).replace('H', h)));
        let fields = format!("struct S {{ #[value = {w}] w: f64, #[value = {h}] h: f64 }}");
        assert_eq!(
            run(format!("{} {fields}", scene.replace('W', "w").replace('H', "h"))),
            literal,
            "{scene}"
        );
    }
}

#[test]
fn mistakes_in_files_are_reported_at_their_place() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let wrong = |name: &str, from: &str, to: &str| {
        let text = std::fs::read_to_string(file("swing.rs")).expect("read").replace(from, to);
        let path = folder.join(name);
        std::fs::write(&path, text).expect("written");
        refused("run", &path, &[])
    };
    assert!(wrong("a.rs", "length = l)", "length = k)").contains("a.rs:4:"));
    assert!(wrong("b.rs", "phi = 80 deg", "psi = 80 deg").contains("there is no coordinate `psi`"));
    assert!(wrong("c.rs", "(2, unit = \"kg\")", "(l / 2)").contains("an expression of numbers and `pi`"));
    assert!(wrong("d.rs", "derive(BarSystem)", "derive(Debug)").contains("nothing in"));
    assert!(wrong("e.rs", "t = 10", "z = 10").contains("until `z = 10`: no name `z`"));
    assert!(refused("run", &folder.join("f.rs"), &[]).contains("cannot read"));
    assert!(
        refused("run", Path::new("ladder"), &["--model", "Ladder"]).contains("chooses a model of a FILE.rs")
    );
}
