//! What makes a release, most of which does not run here: that it parses, and that what it names is
//! there and named alike elsewhere.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_yaml_ng::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn load(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn parse_yaml(path: &str) -> Value {
    serde_yaml_ng::from_str(&load(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn parse_toml(path: &str) -> toml::Table {
    load(path).parse().unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A job of a workflow: its name, and what it asks for.
struct Job<'a>(&'a str, &'a Value);

impl Job<'_> {
    fn steps(&self) -> impl Iterator<Item = &Value> {
        self.1["steps"].as_sequence().unwrap_or_else(|| panic!("{} has no steps", self.0)).iter()
    }

    fn commands(&self) -> Vec<&str> {
        self.steps().filter_map(|step| step["run"].as_str()).flat_map(str::lines).collect()
    }

    fn targets(&self) -> Vec<&str> {
        let rows = self.1["strategy"]["matrix"]["include"].as_sequence();
        rows.into_iter().flatten().filter_map(|row| row["target"].as_str()).collect()
    }
}

fn list_jobs(workflow: &Value) -> Vec<Job<'_>> {
    let jobs = workflow["jobs"].as_mapping().expect("jobs");
    jobs.iter().map(|(name, job)| Job(name.as_str().expect("a name"), job)).collect()
}

fn load_workflows() -> Vec<Value> {
    let folder = fs::read_dir(root().join(".github/workflows")).expect("workflows");
    let names: BTreeSet<_> =
        folder.map(|file| file.expect("a file").file_name().into_string().expect("a name")).collect();
    assert_eq!(names.iter().map(String::as_str).collect::<Vec<_>>(), ["ci.yml", "release.yml"]);
    names.iter().map(|name| parse_yaml(&format!(".github/workflows/{name}"))).collect()
}

/// The lines `#   .ci/release STEP ARGUMENT  …` at the head of the script, as words.
fn list_steps() -> Vec<Vec<String>> {
    let script = load(".ci/release");
    let usage = script.lines().filter_map(|line| line.strip_prefix("#   .ci/release "));
    let words = |line: &str| line.split("  ").next().unwrap_or(line).split(' ').map(str::to_owned).collect();
    usage.map(words).collect()
}

#[test]
fn workflows_run_only_scripts_of_this_repository_and_two_tools() {
    let steps = list_steps();
    for workflow in load_workflows() {
        for job in list_jobs(&workflow) {
            for command in job.commands() {
                let words: Vec<_> = command.split_whitespace().collect();
                match words[..] {
                    [".ci/run"] => {}
                    [".ci/release", step, ref rest @ ..] => assert!(
                        steps.iter().any(|known| known[0] == step && known.len() == rest.len() + 1),
                        "{command} is none of {steps:?}"
                    ),
                    ["rustup", "target", "add", "\"$TARGET\""] | ["gh", "release", "create", ..] => {}
                    _ => panic!("{}: {command}", job.0),
                }
                assert!(
                    !command.contains("${{"),
                    "{command}: a value that a shell reads comes by a variable"
                );
            }
        }
    }
}

#[test]
fn scripts_parse_and_are_programs() {
    for script in [".ci/run", ".ci/long", ".ci/release"] {
        let parsed = Command::new("bash").args(["-n", script]).current_dir(root()).status().expect("bash");
        assert!(parsed.success(), "{script}");
        let listed =
            Command::new("git").args(["ls-files", "-s", script]).current_dir(root()).output().expect("git");
        assert!(
            listed.stdout.is_empty() || listed.stdout.starts_with(b"100755"),
            "{script} is not executable"
        );
    }
}

#[test]
fn jobs_need_jobs_that_there_are_and_take_what_others_leave() {
    for workflow in load_workflows() {
        let jobs = list_jobs(&workflow);
        let names: BTreeSet<_> = jobs.iter().map(|job| job.0).collect();
        let mut kept = BTreeSet::new();
        for job in &jobs {
            assert!(job.1["runs-on"].is_string(), "{}", job.0);
            for needed in job.1["needs"].as_sequence().into_iter().flatten() {
                assert!(names.contains(needed.as_str().expect("a name")), "{} needs {needed:?}", job.0);
            }
            for step in job.steps() {
                let (uses, with) = (&step["uses"], &step["with"]);
                assert_ne!(uses.is_string(), step["run"].is_string(), "{}: {step:?}", job.0);
                let Some(action) = uses.as_str() else { continue };
                // Those of the service itself: others are code of anybody.
                assert!(action.starts_with("actions/") && action.contains("@v"), "{action}");
                if action.starts_with("actions/upload-artifact") {
                    kept.insert(
                        with["name"].as_str().expect("a name").split(['-', '$']).next().expect("a name"),
                    );
                }
            }
        }
        for step in jobs
            .iter()
            .flat_map(Job::steps)
            .filter(|step| step["uses"].as_str().is_some_and(|uses| uses.contains("download")))
        {
            let with = &step["with"];
            let wanted = with["name"].as_str().or(with["pattern"].as_str()).expect("a name");
            let wanted: BTreeSet<_> =
                wanted.trim_end_matches("-*").trim_matches(['{', '}']).split(',').collect();
            assert!(wanted.is_subset(&kept), "{wanted:?} of {kept:?}");
        }
    }
}

/// What a job keeps is what its command writes: the script says where and under which name.
#[test]
fn what_is_kept_is_what_is_written() {
    let script = load(".ci/release");
    assert!(script.contains("OUT=${OUT:-$PWD/target/release-files}"));
    let written = [
        ("liftoff-*.tar.gz", "name=liftoff-$1"),
        ("liftoff-*.tar.gz", "\"$OUT/$name.tar.gz\""),
        ("*.whl", "maturin build"),
        ("liftoff.html", "\"$OUT/liftoff.html\""),
        ("site", "\"$OUT/site\""),
    ];
    let mut kept = BTreeSet::new();
    let workflow = parse_yaml(".github/workflows/release.yml");
    for job in list_jobs(&workflow) {
        for step in
            job.steps().filter(|step| step["uses"].as_str().is_some_and(|uses| uses.contains("upload")))
        {
            let path = step["with"]["path"].as_str().expect("a path");
            kept.insert(
                path.strip_prefix("target/release-files/").unwrap_or_else(|| panic!("{path}")).to_owned(),
            );
        }
    }
    assert_eq!(kept, written.iter().map(|(file, _)| (*file).to_owned()).collect());
    for (file, line) in written {
        assert!(script.contains(line), "{file}: {line}");
    }
}

#[test]
fn programs_and_wheels_are_for_the_same_machines() {
    let workflow = parse_yaml(".github/workflows/release.yml");
    let jobs = list_jobs(&workflow);
    let targets = |name: &str| jobs.iter().find(|job| job.0 == name).map(Job::targets).unwrap_or_default();
    let known = Command::new("rustc").args(["--print", "target-list"]).output().expect("rustc").stdout;
    let known = String::from_utf8(known).expect("text");
    assert_eq!(targets("programs").len(), 5);
    assert_eq!(targets("programs"), targets("wheels"));
    for target in targets("programs") {
        assert!(known.lines().any(|line| line == target), "{target}");
    }
}

#[test]
fn packages_programs_and_files_of_the_script_are_there() {
    let workspace = parse_toml("Cargo.toml");
    let members = workspace["workspace"]["members"].as_array().expect("members");
    let manifests: Vec<_> = members
        .iter()
        .map(|member| parse_toml(&format!("{}/Cargo.toml", member.as_str().expect("a path"))))
        .collect();
    let script = load(".ci/release");
    let words: Vec<_> = script.split_whitespace().collect();
    let after = |option: &str| {
        words.windows(2).filter(|pair| pair[0] == option).map(|pair| pair[1]).collect::<Vec<_>>()
    };
    let packages: Vec<_> = after("-p").into_iter().filter(|word| word.starts_with("liftoff")).collect();
    assert_eq!(packages.len(), 3);
    for package in packages {
        assert!(
            manifests.iter().any(|manifest| manifest["package"]["name"].as_str() == Some(package)),
            "{package}"
        );
    }
    let example = &parse_toml("runtime/cli/Cargo.toml")["example"][0]["name"];
    assert_eq!(after("--example"), [example.as_str().expect("a name")]);
    let program = parse_toml("models/Cargo.toml");
    assert_eq!(after("--bin"), [program["bin"][0]["name"].as_str().expect("a name")]);
    assert_eq!(after("--features"), ["jit"]);
    assert!(program["features"].get("jit").is_some());
    let is_file =
        |word: &&&str| word.ends_with(".md") || word.ends_with(".toml") || word.starts_with("LICENSE");
    let files: Vec<_> = words.iter().filter(is_file).collect();
    assert!(files.len() > 4, "{files:?}");
    for file in files {
        assert!(root().join(file).is_file(), "{file}");
    }
}

/// What other scripts do too, they do with the same words.
#[test]
fn commands_that_are_checked_elsewhere_are_the_same() {
    let (release, others) = (load(".ci/release"), [load(".ci/run"), load(".ci/long")].concat());
    for command in ["cargo doc --release --workspace --no-deps", "cargo run --release -p liftoff-web-bundle"]
    {
        assert!(release.contains(command) && others.contains(command), "{command}");
    }
    let project = parse_toml("runtime/python/pyproject.toml");
    let builder = project["build-system"]["requires"][0].as_str().expect("a requirement");
    let versions = builder.strip_prefix("maturin").expect("maturin");
    assert_eq!(others.matches(builder).count(), 2);
    assert!(release.contains(&format!("'maturin[zig]{versions}'")));
    let recipe = parse_yaml("conda/recipe.yaml");
    let host = recipe["outputs"][1]["requirements"]["host"].as_sequence().expect("requirements");
    assert!(host.contains(&format!("maturin {versions}").into()), "{host:?}");
}

#[test]
fn binstall_looks_for_the_archives_that_are_made() {
    let program = parse_toml("models/Cargo.toml");
    let settings = &program["package"]["metadata"]["binstall"];
    let setting = |name: &str| settings[name].as_str().expect("text").replace("{ target }", "TARGET");
    assert_eq!(setting("pkg-url"), "{ repo }/releases/download/v{ version }/liftoff-TARGET.tar.gz");
    assert_eq!(setting("bin-dir"), "liftoff-TARGET/{ bin }{ binary-ext }");
    assert_eq!(setting("pkg-fmt"), "tgz");
    let script = load(".ci/release");
    assert!(
        script.contains("local name=liftoff-$1")
            && script.contains("tar -C \"$OUT\" -czf \"$OUT/$name.tar.gz\" \"$name\"")
    );
}

#[test]
fn tags_are_those_of_the_version() {
    let version =
        parse_toml("Cargo.toml")["workspace"]["package"]["version"].as_str().expect("a version").to_owned();
    let out = root().join("target/release-files");
    let passes = |tag: &str| {
        let mut command = Command::new(root().join(".ci/release"));
        command.args(["version", tag]).env("OUT", &out).status().expect("the script").success()
    };
    assert!(passes(&format!("v{version}")));
    assert!(!passes(&version) && !passes("v0.0.0") && !passes(""));
}

#[test]
fn the_recipe_for_conda_and_the_citation_have_the_version() {
    let recipe = parse_yaml("conda/recipe.yaml");
    let workspace = parse_toml("Cargo.toml");
    let project = parse_toml("runtime/python/pyproject.toml");
    let program = parse_toml("models/Cargo.toml");
    assert_eq!(recipe["context"]["version"].as_str(), workspace["workspace"]["package"]["version"].as_str());
    let citation = parse_yaml("CITATION.cff");
    assert_eq!(citation["version"].as_str(), recipe["context"]["version"].as_str());
    assert_eq!(recipe["about"]["license"].as_str(), workspace["workspace"]["package"]["license"].as_str());
    let names = [&program["package"]["name"], &project["project"]["name"]].map(toml::Value::as_str);
    let [first, second] = [0, 1].map(|output| recipe["outputs"][output]["package"]["name"].as_str());
    assert_eq!([first, second], names);
    for file in recipe["about"]["license_file"].as_sequence().expect("files") {
        assert!(root().join(file.as_str().expect("a path")).is_file(), "{file:?}");
    }
    let host = recipe["outputs"][1]["requirements"]["host"].as_sequence().expect("requirements");
    let python = format!("python {}", project["project"]["requires-python"].as_str().expect("a version"));
    assert!(host.contains(&python.into()), "{host:?}");
    for numeric in project["project"]["dependencies"].as_array().expect("dependencies") {
        let run = recipe["outputs"][1]["requirements"]["run"].as_sequence().expect("requirements");
        assert!(run.contains(&numeric.as_str().expect("a name").into()), "{run:?}");
    }
}
