//! The floors below `runtime/`: which crate may see which, where models stop being types, which
//! modules import each other, and which names say too little.

mod circles;
mod imports;
mod names;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use imports::Imports;

/// Each floor with the crates of ours that it may depend on.
const FLOORS: [(&str, &[&str]); 15] = [
    ("core", &[]),
    ("engine", &["liftoff-core", "liftoff-derive", "liftoff-codegen"]),
    // Of the generator only the resolved declaration; nothing of the engine.
    ("judge", &["liftoff-core", "liftoff-codegen"]),
    // What was derived, as the engine sees it.
    ("interpreter", &["liftoff-core", "liftoff-codegen"]),
    // Formulas of what was derived; nothing that runs.
    ("conditions", &["liftoff-codegen"]),
    ("replay", &["liftoff-core", "liftoff"]),
    // Knows no models.
    ("columnar", &[]),
    ("processes", &[]),
    ("verification", &["liftoff-core", "liftoff", "liftoff-judge", "liftoff-replay"]),
    (
        "studio",
        &[
            "liftoff-core",
            "liftoff",
            "liftoff-interpreter",
            "liftoff-analysis",
            "liftoff-verification",
            "liftoff-codegen",
            "liftoff-conditions",
            "liftoff-columnar",
            "liftoff-processes",
        ],
    ),
    ("fmu", &["liftoff-core", "liftoff", "liftoff-studio"]),
    ("fmu/library", &["liftoff-core", "liftoff", "liftoff-studio", "liftoff-fmu"]),
    ("analysis", &["liftoff-core", "liftoff", "liftoff-replay"]),
    (
        "cli",
        &[
            "liftoff-core",
            "liftoff",
            "liftoff-analysis",
            "liftoff-verification",
            "liftoff-studio",
            "liftoff-columnar",
            "liftoff-processes",
            "liftoff-fmu",
        ],
    ),
    // The bar systems that everything takes by name lie between the studio and the ways in.
    ("python", &["liftoff-core", "liftoff", "liftoff-analysis", "liftoff-studio", "liftoff-systems"]),
];

/// The places above core that name a model's type: the engine asks for its parts and its
/// declaration; the registry asks for the model, and for what works without it.
const ERASES: [&str; 4] = [
    "engine/src/equations.rs",
    "engine/src/simulation/scene.rs",
    "studio/src/registry/kind.rs",
    "studio/src/registry/origin.rs",
];

/// Where declarations are read: again, for their equations, or as texts that nothing compiles;
/// pictures have what they need in the layout.
const READ: [&str; 2] = ["studio/src/explain", "studio/src/source"];

/// The circles that there are: a crate, or a folder of it, with modules that import each other.
const CIRCLES: &[(&str, &[&str])] = &[
    ("runtime/judge", &["condition", "motion"]),
    ("runtime/interpreter", &["code", "constants", "interpreted", "native", "pool", "series", "system"]),
    ("runtime/interpreter/series", &["code", "lowering"]),
    ("runtime/interpreter/system", &["evaluator", "jacobian", "phase"]),
    ("runtime/conditions/numeric", &["chart", "values"]),
    ("runtime/conditions/numeric", &["way", "zeros"]),
    ("runtime/replay", &["collision", "friction"]),
    ("runtime/replay", &["replay", "root"]),
    ("runtime/columnar", &["ipc", "npz", "parquet", "table"]),
    ("runtime/fmu/library", &["c", "logger"]),
    ("runtime/analysis/fit", &["datum", "trial"]),
    ("runtime/cli", &["commands", "options", "output"]),
    ("runtime/cli/options", &["pose_args", "run_args"]),
    ("runtime/python", &["model", "trajectory"]),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of the workspace")
}

fn runtime() -> PathBuf {
    root().join("runtime")
}

/// Rust files of a floor that are no tests.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of sources");
    let mut files = Vec::new();
    for path in entries.map(|entry| entry.expect("an entry").path()) {
        let is_test = path.file_stem().is_some_and(|stem| stem == "tests");
        if path.is_dir() && !is_test {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") && !is_test {
            files.push(path);
        }
    }
    files
}

/// A file up to its unit tests.
fn before_tests(file: &Path) -> String {
    let text = fs::read_to_string(file).expect("a source");
    text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default().to_owned()
}

/// The lines of a file up to its unit tests, comments left out.
fn code(file: &Path) -> Vec<String> {
    let text = before_tests(file);
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.map(str::to_owned).collect()
}

#[test]
fn a_floor_sees_only_those_below_it() {
    for (floor, allowed) in FLOORS {
        let text = fs::read_to_string(runtime().join(floor).join("Cargo.toml")).expect("a manifest");
        let manifest: toml::Table = text.parse().expect("TOML");
        let dependencies =
            manifest.get("dependencies").and_then(toml::Value::as_table).expect("dependencies");
        for name in dependencies.keys().filter(|name| name.starts_with("liftoff")) {
            assert!(allowed.contains(&name.as_str()), "{floor} depends on {name}");
        }
    }
}

#[test]
fn models_are_types_in_core_only() {
    let generic = [": BarSystem", "M::LAYOUT", "<M>", "const N: usize"];
    // Polynomials in so many variables are no models.
    for (floor, _) in FLOORS[1..].iter().filter(|(floor, _)| *floor != "conditions") {
        for file in sources(&runtime().join(floor).join("src")) {
            if ERASES.iter().any(|place| file.ends_with(place)) {
                continue;
            }
            for line in code(&file) {
                assert!(!generic.iter().any(|mark| line.contains(mark)), "{}: {line}", file.display());
            }
        }
    }
}

#[test]
fn declarations_are_read_at_two_places_only() {
    for floor in ["studio", "cli"] {
        for file in sources(&runtime().join(floor).join("src")) {
            let reads = READ.iter().any(|place| file.starts_with(runtime().join(place)));
            // Its table of units is no declaration.
            let reads_code =
                |line: &String| line.contains("liftoff_codegen") && !line.contains("liftoff_codegen::units");
            let named = code(&file).iter().any(reads_code);
            assert!(reads || !named, "{}", file.display());
        }
    }
}

/// What the judge reads of the generator: the resolved declaration, and the numbers in it.
const DECLARED: [&str; 3] =
    ["liftoff_codegen::resolve", "liftoff_codegen::system", "liftoff_codegen::algebra"];

#[test]
fn the_judge_shares_no_equations_with_the_judged() {
    for file in sources(&runtime().join("judge/src")) {
        for line in code(&file).iter().filter(|line| line.contains("liftoff_codegen")) {
            assert!(DECLARED.iter().any(|part| line.contains(part)), "{}: {line}", file.display());
        }
        let core = code(&file).join("\n");
        assert!(
            !core.contains("liftoff_core::") || core.contains("liftoff_core::scalar"),
            "{}",
            file.display()
        );
    }
}

/// Crates in which no import circle between modules is added.
fn packages() -> impl Iterator<Item = String> {
    let floors = FLOORS.iter().map(|(floor, _)| format!("runtime/{floor}"));
    ["codegen", "runtime/web"].map(str::to_owned).into_iter().chain(floors)
}

#[test]
fn no_import_circle_is_added() {
    let mut complaints = Vec::new();
    let mut searched = Vec::new();
    for package in packages() {
        let imports = Imports::from_root(&root().join(&package).join("src/lib.rs"));
        for folder in imports.folders() {
            let place = folder.iter().fold(package.clone(), |place, name| format!("{place}/{name}"));
            let listed = CIRCLES.iter().filter(|(of, _)| *of == place).map(|(_, circle)| *circle);
            let listed: Vec<&[&str]> = listed.collect();
            let found = circles::complaints(&imports.arrows(folder), &listed);
            complaints.extend(found.iter().map(|complaint| format!("{place}: {complaint}")));
            searched.push(place);
        }
    }
    let gone = CIRCLES.iter().filter(|(place, _)| !searched.iter().any(|other| other == place));
    complaints.extend(gone.map(|(place, _)| format!("shorten the list: {place} has no modules")));
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn functions_say_what_they_do() {
    let folders = ["codegen", "derive", "runtime", "models", "tests"];
    let (mut complaints, mut count) = (Vec::new(), 0);
    for folder in folders {
        let (found, functions) = names::find_vague_functions(&root().join(folder));
        complaints.extend(found);
        count += functions;
    }
    assert!(count > 10_000, "{count}");
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

/// Names that two public types of a crate have: a coordinate, and the constant that names it.
const SHARED: [(&str, &str); 1] = [("runtime/core", "Coordinate")];

#[test]
fn public_types_of_a_crate_have_names_of_their_own() {
    for package in packages() {
        let shared = names::find_shared_types(&sources(&root().join(&package).join("src")));
        let allowed = SHARED.iter().filter(|(of, _)| *of == package).map(|(_, name)| (*name).to_owned());
        assert_eq!(shared, allowed.collect(), "{package}");
    }
}

/// A package none of whose targets in `src` is built for tests has none there.
#[test]
fn no_tests_are_left_out() {
    let root = root();
    let workspace: toml::Table =
        fs::read_to_string(root.join("Cargo.toml")).expect("a manifest").parse().expect("TOML");
    let members = workspace["workspace"]["members"].as_array().expect("a list");
    let mut without = 0;
    for package in members.iter().map(|member| root.join(member.as_str().expect("a folder"))) {
        let manifest: toml::Table =
            fs::read_to_string(package.join("Cargo.toml")).expect("a manifest").parse().expect("TOML");
        let is_tested =
            |target: &toml::Value| target.get("test").is_none_or(|test| test.as_bool() != Some(false));
        let library = manifest.get("lib").map_or(package.join("src/lib.rs").exists(), is_tested);
        let program = manifest.get("bin").and_then(toml::Value::as_array);
        let program = program.map_or(package.join("src/main.rs").exists(), |all| all.iter().any(is_tested));
        if library || program {
            continue;
        }
        without += 1;
        for file in sources(&package.join("src")) {
            let text = fs::read_to_string(&file).expect("a source");
            assert!(!text.contains("#[test]") && !text.contains("#[cfg(test)]"), "{}", file.display());
        }
    }
    assert!(without > 8, "{without}");
}

/// Packages of a program at most, itself among them: those that it is built from and with.
const PACKAGES: [(&str, &[&str], usize); 5] = [
    ("liftoff-dynamics", &[], 28),
    ("liftoff-dynamics", &["--no-default-features", "--features", "libm"], 13),
    ("liftoff-cli", &[], 111),
    ("liftoff-dynamics-cli", &[], 118),
    ("liftoff-python", &[], 87),
];

#[test]
fn programs_are_made_of_few_packages() {
    for (package, features, most) in PACKAGES {
        let mut tree = Command::new(env!("CARGO"));
        tree.args(["tree", "--offline", "--edges", "normal,build", "--prefix", "none", "--package", package]);
        let output = tree.args(features).current_dir(runtime()).output().expect("cargo");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let names: BTreeSet<&str> = text.lines().filter_map(|line| line.split(' ').next()).collect();
        assert!(names.len() <= most, "{package} is made of {} packages: {names:?}", names.len());
    }
}
