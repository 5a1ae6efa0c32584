//! Descriptions, tokens and archives.

use crate::description::{Head, description};
use crate::{FmuError, Guard, Interface, Resources, exchange_lacks, write};
use liftoff_studio::registry::Entry;
use liftoff_studio::{RunSpec, source};
use std::fs;
use std::io::Read;

const FIG_1A: &str = include_str!("../../web/gallery/fig_1a.rs");
const BELT: &str = include_str!("../../web/gallery/belt.rs");

fn model(text: &str) -> Entry {
    source::models(text).expect("a model").remove(0)
}

fn described(text: &str) -> String {
    let model = model(text);
    let interface = Interface::from_model(&model, &Resources::from_model(&model).spec).expect("values");
    let head = Head {
        name: "FallingPair",
        identifier: "falling_pair",
        token: "token",
        summary: "Fig. 1a",
        stop: Some(1.0),
    };
    description(&head, &interface).expect("a description")
}

#[test]
fn fig_1a_is_described() {
    insta::assert_snapshot!(described(FIG_1A));
}

/// Of the variables of contacts with friction only what others do not have.
#[test]
fn friction_is_described() {
    let text = described(BELT);
    let lines: Vec<&str> = text.lines().filter(|line| line.contains("(P")).map(str::trim).collect();
    insta::assert_snapshot!(lines.join("\n"));
}

/// Names that XML would read otherwise.
#[test]
fn names_and_summaries_are_escaped() {
    let model = model(FIG_1A);
    let interface = Interface::from_model(&model, &Resources::from_model(&model).spec).expect("values");
    let head = Head { name: "A", identifier: "a", token: "t", summary: "a < b & \"c\"", stop: None };
    let text = description(&head, &interface).expect("a description");
    assert!(text.contains("description=\"a &lt; b &amp; &quot;c&quot;\"") && !text.contains("stopTime"));
    assert!(text.contains("name=\"phi&apos;\""));
}

#[test]
fn a_model_has_a_guard_for_each_way_in_which_its_contacts_change() {
    assert_eq!(Guard::all(model(FIG_1A).layout()), [Guard::Normal(0), Guard::End(0)]);
    assert_eq!(Guard::all(model(BELT).layout()), [Guard::Normal(0), Guard::Friction(0)]);
}

#[test]
fn what_no_guard_tells_is_for_co_simulation() {
    let lacks = |change: fn(RunSpec) -> RunSpec| {
        let model = model(BELT);
        exchange_lacks(model.layout(), &change(model.default_run()))
    };
    assert_eq!(lacks(|spec| spec), None);
    assert_eq!(lacks(|spec| spec.release("P", 1.0)), Some("supports or threads that vanish"));
    assert_eq!(lacks(|spec| spec.hold(&["P"])), Some("supports that are held"));
    assert_eq!(lacks(|spec| spec.impulse("P", [0.0, 1.0], 1.0)), Some("impulses"));
    for condition in ["while(\"t < 1\")", "breaks(\"N(P) > 1\")"] {
        let armed = model(&BELT.replace("moving = w)", &format!("moving = w, {condition})")));
        assert_eq!(
            exchange_lacks(armed.layout(), &armed.default_run()),
            Some("supports or drives on conditions")
        );
    }
}

#[test]
fn the_token_follows_the_declaration_and_the_run() {
    let token = |text: &str| Resources::from_model(&model(text)).token().expect("a token");
    assert_eq!(token(FIG_1A), token(FIG_1A));
    assert_ne!(token(FIG_1A), token(&FIG_1A.replace("phi = 0.1", "phi = 0.2")));
    assert_ne!(token(FIG_1A), token(&FIG_1A.replace("value(9.81", "value(9.82")));
    let resources = Resources::from_model(&model(FIG_1A));
    let other =
        Resources { spec: RunSpec { tolerance: 1e-9, ..resources.spec.clone() }, ..resources.clone() };
    assert_ne!(resources.token().ok(), other.token().ok());
}

#[test]
fn a_unit_carries_what_its_library_reads() {
    let folder = std::env::temp_dir().join(format!("liftoff-fmu-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let library = folder.join("library.so");
    let missing = write(&model(FIG_1A), &library);
    assert!(matches!(missing, Err(FmuError::NoLibrary(path)) if path == library));
    fs::write(&library, "an older one").expect("a file");
    assert!(matches!(write(&model(FIG_1A), &library), Err(FmuError::OtherLibrary { .. })));
    fs::write(&library, format!("… {} …", crate::LIBRARY)).expect("a file");
    let unit = write(&model(FIG_1A), &library).expect("a unit");
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(unit)).expect("an archive");
    for name in ["model.rs", "run.toml"] {
        let mut text = String::new();
        let mut file = archive.by_name(&format!("resources/{name}")).expect("a resource");
        file.read_to_string(&mut text).expect("a text");
        fs::write(folder.join(name), text).expect("a file");
    }
    let read = Resources::load(&folder).expect("resources");
    assert_eq!(read, Resources::from_model(&model(FIG_1A)));
    assert_eq!(read.model().expect("a model").name(), "falling-pair");
    let binary =
        format!("binaries/{}/falling_pair{}", crate::platform::platform(), std::env::consts::DLL_SUFFIX);
    assert!(archive.by_name(&binary).is_ok());
    fs::remove_dir_all(&folder).expect("a folder");
}

#[test]
fn parameters_need_values() {
    let without = model(&FIG_1A.replace("#[value(1, unit = \"m\")]", ""));
    let error = Interface::from_model(&without, &Resources::from_model(&without).spec)
        .map(drop)
        .expect_err("no value");
    assert_eq!(error.to_string(), "parameter `l` has no value to begin with: declare one, #[value(…)]");
}
