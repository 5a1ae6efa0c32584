//! The `liftoff` command as its users meet it: output, files and exit codes.

use serde_json::Value;
use std::process::{Command, Output};

fn liftoff(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    command.args(arguments).output().expect("the command starts")
}

fn json(arguments: &[&str]) -> Value {
    let output = liftoff(arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// Catalogue, entry 1: L = g = 1 from rest at 75°.
#[test]
fn a_run_as_json_has_events_with_states_and_reactions_by_name() {
    let run = json(&["run", "ladder", "--set", "g=1", "--start", "phi=75*pi/180", "--json"]);
    assert_eq!(run["model"], "ladder");
    assert_eq!(run["parameters"]["g"], 1.0);
    let events = run["events"].as_array().expect("a list");
    let kinds: Vec<_> = events.iter().map(|event| event["kind"].as_str().unwrap_or_default()).collect();
    assert_eq!(kinds, ["start", "open", "stop"]);
    let open = &events[1];
    assert_eq!(open["supports"], serde_json::json!(["B"]));
    // Ten times the default tolerance over some hundred steps.
    let near = |value: &Value, expected: f64| {
        assert!((value.as_f64().expect("a number") - expected).abs() < 1e-11, "{value} {expected}");
    };
    near(&open["t"], 1.547_598_570_079_887_3);
    near(&open["state"]["phi"], 0.699_650_781_421_522_1);
    near(&open["state"]["phi'"], -0.982_815_255_421_418_6);
    near(&open["reactions"]["A"], 0.25);
    near(&run["final_state"]["phi'"], -1.611_635_956_783_063);
}

/// The belt carries its block to k x = μₛ m g: R = 0.5 · 9.81 N, then 0.2 · 9.81 N.
#[test]
fn friction_forces_stand_beside_the_reactions() {
    let slip = &json(&["run", "belt", "--output", "mu(P)", "--json"])["events"][1];
    assert_eq!((&slip["kind"], &slip["outputs"]["mu(P)"]), (&Value::from("slip"), &Value::from(0.2)));
    assert!((slip["friction"]["P"].as_f64().expect("a number") - 1.962).abs() < 1e-9);
    let table = String::from_utf8(liftoff(&["run", "belt", "--csv", "-"]).stdout).expect("text");
    let heads: Vec<&str> = table.lines().next().expect("heads").split(',').collect();
    assert_eq!(heads[5..9], ["N(P) [N]", "R(P) [N]", "v(P) [m/s]", "gap(P) [m]"]);
    let last: Vec<f64> = table.lines().last().expect("rows").split(',').map(|x| x.parse().unwrap()).collect();
    assert!((last[6] + 0.2 * last[5] * last[7].signum()).abs() < 1e-9, "{last:?}");
    assert!(json(&["run", "ladder", "--json"])["events"][0].get("friction").is_none());
}

#[test]
fn an_energy_level_a_held_support_and_a_condition_pass_through() {
    let arguments = "run falling-pair --start phi=0.2 --energy-of phi=0 --hold P --until N(P)=0 --json";
    let run = json(&arguments.split(' ').collect::<Vec<_>>());
    let phi = run["final_state"]["phi"].as_f64().expect("a number");
    assert!((phi - 0.814_911_663_027_575_2).abs() < 1e-11, "{phi}");
    assert_eq!(run["events"][1]["kind"], "stop");
    // What the default run holds is held without being asked for.
    assert_eq!(json(&["run", "narrow-gap", "--json"]), json(&["run", "narrow-gap", "--hold", "P", "--json"]));
}

#[test]
fn a_cut_thread_and_a_blow_pass_through() {
    let kinds = |run: &Value| -> Vec<String> {
        let events = run["events"].as_array().expect("a list");
        events.iter().map(|event| event["kind"].as_str().unwrap_or_default().to_owned()).collect()
    };
    let cut = json(&["run", "zigzag-thread", "--cut", "BD=t = 0.1", "--until", "t = 0.2", "--json"]);
    assert_eq!(kinds(&cut), ["start", "cut", "stop"]);
    let blow = json(&["run", "struck-chain", "--impulse", "C=0,2@0.1", "--until", "t = 0.1001", "--json"]);
    assert_eq!(kinds(&blow), ["start", "impulse", "stop"]);
    assert_eq!(json(&["run", "bouncing-bar", "--stop-at-impacts", "--json"])["events"][1]["kind"], "close");
    let impact = &json(&["run", "bouncing-ball", "--json"])["events"][1];
    let impulse = impact["impulses"]["P"].as_f64().expect("a number");
    assert!((impulse - 1.8 * (2.0_f64 * 9.81).sqrt()).abs() < 1e-11, "{impulse}");
}

/// What a first look at a model shows.
#[test]
fn every_default_run_comes_to_its_end() {
    for model in liftoff_models::models().iter() {
        let run =
            model.run(&model.default_run()).unwrap_or_else(|failure| panic!("{}: {failure}", model.name()));
        assert!(run.interval()[1] > 0.0, "{}", model.name());
    }
}

#[test]
fn error_against_run_time_is_reported_row_by_row() {
    let arguments =
        "precision ladder bouncing-ball --methods dop853,taylor --tolerances 1e-6,1e-9 --measuring 1 --json";
    let told = json(&arguments.split(' ').collect::<Vec<_>>());
    let rows = told["rows"].as_array().expect("a list");
    let about = |row: &Value| (row["model"].clone(), row["method"].clone(), row["tolerance"].as_f64());
    assert_eq!(rows.len(), 8);
    assert_eq!(about(&rows[3]), ("ladder".into(), "taylor".into(), Some(1e-9)));
    for row in rows {
        // Some twenty steps, each at its tolerance; a ball's infinitely many impacts too.
        let most = 100.0 * row["tolerance"].as_f64().expect("a number");
        for error in ["state_error", "run_error", "event_error"] {
            assert!(row[error].as_f64().is_some_and(|error| error < most), "{row}");
        }
        for count in ["evaluations", "steps", "microseconds"] {
            assert!(row[count].as_f64().is_some_and(|count| count > 0.0), "{row}");
        }
    }
}

/// The undamped spring of relative stiffness 1e10 from rest at 60° on the slow manifold.
#[test]
fn a_change_of_method_is_noted() {
    let arguments = "run spring-pendulum --set k=1e10 --set c=0 --set g=1 --start x=0.866025403827739 --start y=0.500000000025 \
                     --until t=1 --tol 1e-6 --json";
    let told = json(&arguments.split_whitespace().collect::<Vec<_>>());
    let notes = told["notes"].as_array().expect("a list");
    let [note] = &notes[..] else { panic!("one note, not {notes:?}") };
    let note = note.as_str().expect("a text");
    assert!(note.ends_with("radau goes on: a stiff spring keeps explicit steps short"), "{note}");
}

#[test]
fn repeated_requests_are_measured_once() {
    let arguments =
        "precision ladder ladder --methods tsit5,taylor,tsit5 --tolerances 1e-3,0.001 --measuring 0 --json";
    let told = json(&arguments.split(' ').collect::<Vec<_>>());
    let methods = told["rows"].as_array().expect("a list").iter().map(|row| row["method"].clone());
    assert_eq!(methods.collect::<Vec<_>>(), ["tsit5", "taylor"]);
}

#[test]
fn an_unknown_group_is_refused_with_all_groups() {
    let output = liftoff(&["stability", "quixotic"]);
    let told = String::from_utf8_lossy(&output.stderr);
    for group in ["springs", "inputs", "tolerances", "energy"] {
        assert!(told.contains(group), "{told}");
    }
    assert!(!told.contains('…'), "{told}");
}

/// Tests run what a user builds without `--release`.
#[test]
fn run_times_of_an_unoptimised_build_come_with_a_warning() {
    let arguments = "precision pendulum --methods taylor --tolerances 1e-6 --measuring 1";
    let output = liftoff(&arguments.split(' ').collect::<Vec<_>>());
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && told.contains("--release") == cfg!(debug_assertions), "{told}");
    assert!(!String::from_utf8_lossy(&output.stdout).contains("warning"));
}

#[test]
fn modes_are_reported_as_text_and_as_a_graph() {
    let text = |arguments: &[&str]| String::from_utf8(liftoff(arguments).stdout).expect("UTF-8");
    let zigzag = text(&["modes", "zigzag"]);
    assert!(zigzag.contains("on A, E, C        degrees 1, own code; + B, D; − A, E; − C\n"), "{zigzag}");
    assert!(text(&["modes", "ladder", "--dot"]).starts_with("digraph Ladder {"));
}

/// From upright C opens first where the strict equations have it (`strict.phi_first[0.50]` of the
/// references).
#[test]
fn conditions_are_written_as_text_as_latex_and_as_a_page() {
    let told = |format: &str| {
        let arguments =
            ["conditions", "zigzag", "--phase", "A, E, C", "--from", "phi_inner=pi/2", "--format", format];
        let values = ["--set", "m1=0.5", "--set", "m2=0.5"];
        String::from_utf8(liftoff(&[&arguments[..], &values[..]].concat()).stdout).expect("UTF-8")
    };
    let text = told("text");
    assert!(text.contains("\n  N(C) = 3 N(A, E) where m₁ = 3 m₂\n"), "{text}");
    assert!(text.contains("C opens first, at φ_inner = 0.465444058966430"), "{text}");
    let [latex, html] = ["latex", "html"].map(told);
    assert!(
        latex.contains("& N_{\\mathrm{C}} = 3 N_{\\mathrm{A, E}}") && latex.ends_with("\\end{document}\n"),
        "{latex}"
    );
    assert!(
        html.contains("<msub><mi>N</mi><mtext>A, E</mtext></msub>") && !html.contains("<script"),
        "{html}"
    );
}

#[test]
fn invalid_requests_exit_with_code_2() {
    let asked: [(&[&str], &str); 12] = [
        (&["precision", "seesaw"], "no model `seesaw`"),
        (&["run", "laddr"], "did you mean `ladder`?"),
        (&["run", "ladder", "--set", "q=1"], "no parameter `q`"),
        (&["run", "ladder", "--set", "m=-1"], "negative"),
        (&["run", "ladder", "--set", "m=NaN"], "NaN"),
        (&["run", "ladder", "--until", "phj = 1"], "`phi`"),
        (&["run", "falling-pair", "--start", "phi=0"], "equilibrium"),
        (&["run", "ladder", "--start", "phi=1", "--start", "x=-2"], "B"),
        (&["explain", "zigzag", "--phase", "Z"], "in closed form: free"),
        (&["conditions", "zigzag", "--phase", "Z"], "no contact set `Z`"),
        (&["conditions", "zigzag", "--phase", "A, E"], "degrees of freedom: 2 (phi_inner, phi_outer)"),
        (&["conditions", "zigzag", "--from", "psi=1"], "`psi`"),
    ];
    for (arguments, said) in asked {
        let output = liftoff(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
        assert!(error.contains(said) && error.lines().count() == 1, "{arguments:?}: {error}");
    }
}

/// Without inner masses the free phase is singular as the inner bars pass the horizontal.
#[test]
fn a_run_that_stops_short_shows_what_it_has_with_code_1() {
    let file = std::env::temp_dir().join(format!("liftoff-{}.csv", std::process::id()));
    let path = file.to_str().expect("a path in UTF-8");
    let output = liftoff(&["run", "zigzag", "--set", "m1=0", "--tol", "1e-6", "--csv", path]);
    let written = std::fs::read_to_string(&file).expect("the motion so far");
    std::fs::remove_file(&file).expect("removed");
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stdout).contains("C open at t = "));
    assert!(
        written.starts_with("t [s],phi_inner [rad],phi_outer [rad],y [m],phi_inner' [rad/s],"),
        "{written}"
    );
    assert!(written.lines().count() > 1000);
}

/// Where components are zero by symmetry the iteration of Gauss's method once took millions of
/// steps, 20 s and more.
#[test]
fn gauss_passes_loose_tolerances_in_few_steps() {
    for tolerance in ["1e-3", "1e-4", "1e-6", "1e-8"] {
        let output = liftoff(&[
            "run",
            "falling-pair-full",
            "--method",
            "gauss",
            "--tol",
            tolerance,
            "--max-steps",
            "2000",
        ]);
        assert!(output.status.success(), "{tolerance}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

/// Formats that are a feature of the program are told where it is built without them, before
/// anything is run.
#[cfg(not(any(feature = "parquet", feature = "npz")))]
#[test]
fn missing_features_are_reported() {
    let sweep = ["sweep", "zigzag", "--vary=m1=0.1:0.9:3", "--observe=end"];
    let commands: [(&[&str], &str, &str, &str); 5] = [
        (&["run", "ladder"], "--parquet", "Parquet", "parquet"),
        (&["run", "ladder"], "--arrow", "Arrow", "parquet"),
        (&sweep, "--parquet", "Parquet", "parquet"),
        (&sweep, "--npz", "NPZ", "npz"),
        (&["merge", "nowhere"], "--arrow", "Arrow", "parquet"),
    ];
    for (command, option, format, feature) in commands {
        let output = liftoff(&[command, &[option, "never-written"]].concat());
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(
            (error.trim_end(), output.status.code()),
            (
                format!(
                    "error: {option}: this program is built without {format}: build it with --features {feature}"
                )
                .as_str(),
                Some(2)
            )
        );
    }
}

/// Long results begin with what fits a screen, and say how to have the rest.
#[test]
fn long_results_fit_a_screen_unless_all_is_asked_for() {
    let vary = ["--vary", "lambda=0.05:0.75", "--vary", "phi=0.45:1.5", "--set", "m1=1-lambda"];
    let start = ["--set", "m2=lambda", "--start", "phi_inner=phi", "--start", "phi_outer=phi"];
    let folder = std::env::temp_dir().join(format!("liftoff-screen-{}", std::process::id()));
    let folder = folder.to_str().expect("a path in UTF-8");
    let begin =
        ["precision", "falling-pair", "--start", "phi=0.1", "--until", "phi=pi/2", "--measuring", "0"];
    let cases = ["stability", "--short", "starts", "--out", folder];
    for (command, whole, shown) in [
        (vec!["equilibrium", "walker"], 30, "damping ratio 0.736544; decays at 97.1866 1/s"),
        ([&["boundary", "zigzag"], &vary[..], &start[..]].concat(), 90, "  0.05000000000  0.7792378930"),
        (begin.to_vec(), 75, "gauss                      1e-14"),
        (cases.to_vec(), 28, "degenerate equilibrium: 26 of 26 cases pass"),
    ] {
        let print = |command: &[&str]| {
            let output = liftoff(command);
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            String::from_utf8(output.stdout).expect("text")
        };
        let (brief, all) = (print(&command), print(&[&command[..], &["--all"]].concat()));
        assert!(brief.lines().count() <= 24 && brief.contains(shown), "{brief}");
        assert!(brief.lines().last().is_some_and(|line| line.contains("--all prints ")), "{brief}");
        assert!(all.lines().count() >= whole && !all.contains("--all"), "{all}");
    }
    std::fs::remove_dir_all(folder).expect("removed");
}
