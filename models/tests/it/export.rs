//! Equations that `export` has written, read by the programs that they are written for, beside the
//! program's own numbers.

use crate::cases::{model, sets, state};
use crate::processes::{folder, python_with, text};
use liftoff_core::model::{ContactSet, Form, Slip};
use liftoff_core::system::Model;
use serde_json::{Map, Value, json};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::Arc;

fn liftoff(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_liftoff"));
    command.current_dir(folder).args(arguments).output().expect("the command starts")
}

/// What the program computes at a random state of a contact set; none where its multipliers are not
/// unique.
fn case(model: &Model, set: ContactSet, seed: &mut u64) -> Option<Value> {
    let (layout, state) = (model.layout(), state(model, seed));
    let n = layout.coordinates.len();
    let equations = model.system.equations(&state);
    let (mut accelerations, mut multipliers) = (vec![0.0; n], vec![0.0; equations.gap().len()]);
    if !model.system.solve(&state, set, &mut accelerations, &mut multipliers) {
        return None;
    }
    let energy = model.system.energy(&state);
    let mut points = vec![0.0; 2 * layout.points.len()];
    model.system.points(&state, &mut points);
    let mut senses = Map::new();
    for friction in layout.frictions {
        if set.contains(friction.contact) && set.slip(friction.contact) != Slip::Stick {
            senses.insert(
                layout.contacts[friction.contact].label.to_owned(),
                set.sense(friction.contact).into(),
            );
        }
    }
    let closed: Vec<&str> = set.iter().map(|i| layout.contacts[i].label).collect();
    let mut case = json!({
        "state": state[..2 * n],
        "time": if layout.timed { state[2 * n] } else { 0.0 },
        "closed": closed,
        "senses": senses,
        "accelerations": accelerations,
        "energies": [energy.kinetic, energy.potential],
        "gaps": equations.gap()[..layout.contacts.len()],
        "points": points,
    });
    if let Some(reduced) = reduced(model, set, &state) {
        case["reduced"] = reduced;
    }
    Some(case)
}

/// The same by the closed form of the set, if it has one, at the state that it makes of this one.
fn reduced(model: &Model, set: ContactSet, state: &[f64]) -> Option<Value> {
    let layout = model.layout();
    let phase = Arc::clone(&model.system).phase(set, Form::Reduced);
    let info = phase.info();
    if info.form != Form::Reduced {
        return None;
    }
    let n = layout.coordinates.len();
    let (mut y, mut dy) = (vec![0.0; info.entries], vec![0.0; info.entries]);
    phase.restrict(state, &mut y);
    phase.derivative(&y, &mut dy);
    let mut reactions = vec![0.0; layout.contacts.len() + layout.frictions.len()];
    phase.reactions(&y, &mut reactions);
    let mut full = vec![0.0; layout.entries()];
    phase.embed(&y, &mut full);
    // The accelerations of the rates that stay stand at the places of these.
    let mut accelerations = vec![f64::NAN; n];
    for (entry, slope) in phase.kept().iter().zip(&dy).filter(|(entry, _)| (n..2 * n).contains(*entry)) {
        accelerations[entry - n] = *slope;
    }
    let accelerations: Vec<Value> = accelerations.iter().map(|a| json!(a)).collect();
    let normal: Map<String, Value> =
        set.iter().map(|i| (layout.contacts[i].label.to_owned(), json!(reactions[i]))).collect();
    let rubbing = layout.frictions.iter().enumerate().filter(|(_, friction)| set.contains(friction.contact));
    let friction: Map<String, Value> = rubbing
        .map(|(k, friction)| {
            let label = layout.contacts[friction.contact].label;
            (label.to_owned(), json!(reactions[layout.contacts.len() + k]))
        })
        .collect();
    Some(json!({
        "state": full[..2 * n],
        "accelerations": accelerations,
        "reactions": normal,
        "friction": friction,
    }))
}

/// Closed forms, joints, threads, friction, springs, drives, conditions, mirror images.
const MODELS: [&str; 14] = [
    "double-pendulum",
    "unequal-pendulum",
    "spring-pendulum",
    "ladder",
    "slipping-ladder",
    "zigzag",
    "zigzag-thread",
    "slider-crank",
    "quick-return",
    "trebuchet",
    "balance-wheel",
    "belt",
    "falling-pair-full",
    "jansen-leg",
];

fn cases(model: &Model) -> Vec<Value> {
    let mut seed = 18;
    let sets = sets(model.layout(), &mut seed);
    sets.iter().flat_map(|set| [*set; 2]).filter_map(|set| case(model, set, &mut seed)).collect()
}

/// What a script says of the equations of these models and of the program's numbers, where there is
/// a Python with the packages.
fn run_script(name: &str, models: &[&str], packages: &[&str]) -> Option<String> {
    let python = python_with(packages)?;
    let folder = folder(name);
    let exported = models.iter().map(|name| {
        let file = format!("{}.py", name.replace('-', "_"));
        let output = liftoff(&folder, &["export", name, "--sympy", &file]);
        assert!(output.status.success(), "{name}: {}", text(&output.stderr));
        let model = model(name);
        let cases = cases(&model);
        assert!(!cases.is_empty(), "{name}");
        json!({ "name": name, "file": file, "parameters": model.parameters, "cases": cases })
    });
    let exported: Vec<Value> = exported.collect();
    fs::write(folder.join("cases.json"), json!(exported).to_string()).expect("a file");
    let script = format!("{}/tests/it/export/in_{name}.py", env!("CARGO_MANIFEST_DIR"));
    let mut command = Command::new(python);
    let output = command.current_dir(&folder).args([&script, "cases.json"]).output().expect("Python");
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
    println!("{}", text(&output.stdout));
    Some(text(&output.stdout))
}

/// 1e-12 of the largest entry: numbers of the program are rounded, those of SymPy have 40 digits;
/// more where the condition of the equations, which takes digits of the program's, is beyond 1e4.
#[test]
fn sympy_computes_the_same_accelerations_and_derives_the_same_equations() {
    let Some(told) = run_script("sympy", &MODELS, &["sympy"]) else { return };
    assert_eq!(told.matches("by Lagrange's equations too").count(), 3, "{told}");
}

/// The same to 1e-11 by CasADi's functions of the module for SymPy, which round as the program
/// does, in another order.
#[test]
fn casadi_computes_the_same_accelerations_and_differentiates_them() {
    let Some(told) = run_script("casadi", &MODELS, &["sympy", "casadi"]) else { return };
    assert_eq!(told.matches("of derivatives").count(), MODELS.len(), "{told}");
}
