//! Libraries of C that `export --c` has written, beside the program's own numbers and motions.

mod expected;
mod functions;
mod library;
mod motions;

use crate::cases::{model, sets, state};
use crate::processes::{folder, text};
use expected::Expected;
use functions::{compiled, in_closed_form, interpreted, is_unique};
use library::Library;
use liftoff_core::model::ContactSet;
use liftoff_core::system::Model;
use liftoff_models::models;

/// What the library says differs from what the program does by no more than these multiples of
/// rounding. Operations are those of the interpreter, in its order: 4 are left to compilers that
/// compute sines of numbers themselves. The compiled model sums in another order, and its
/// elimination has other pivots: 1000.
const ROUNDINGS: [f64; 2] = [4.0, 1e3];

/// How many cases of a model there are, and how many of them are of a closed form.
fn compared(library: &Library, name: &str, model: &Model) -> [usize; 2] {
    let declaration = model.layout().declaration.parse().expect("tokens");
    let analysis = liftoff_codegen::analyse(declaration).expect("a model");
    let mut seed = 18;
    let sets = sets(model.layout(), &mut seed);
    let asked: Vec<(ContactSet, Vec<f64>)> =
        sets.iter().flat_map(|&set| [set; 2]).map(|set| (set, state(model, &mut seed))).collect();
    let questions: Vec<String> =
        asked.iter().map(|(set, state)| library.question("at", &model.parameters, *set, state)).collect();
    let (mut worst, mut closed) = ([0.0_f64; 2], 0);
    for ((set, state), answer) in asked.iter().zip(library.ask(&questions)) {
        let mut whole = compiled(model, *set, state);
        // Nothing where there is no motion; of supports more than are needed the accelerations,
        // where friction does not follow from them.
        assert_eq!(answer["status"] == [0.0], is_unique(model, *set, state), "{name} {set:?} {state:?}");
        let slides = set.iter().any(|i| model.layout().contacts[i].friction.is_some());
        match answer["status"][0] as u8 {
            0 => {}
            2 if !slides => _ = whole.remove(1),
            _ => _ = whole.drain(..2),
        }
        let reduced = in_closed_form(model, *set, state);
        assert_eq!(reduced.is_empty(), !answer.contains_key("derivative"), "{name} {set:?}");
        closed += usize::from(!reduced.is_empty());
        let off = |all: &[Expected]| all.iter().map(|one| one.off(&answer)).fold(0.0, f64::max);
        let errors = [off(&interpreted(&analysis, model, *set, state)), off(&whole).max(off(&reduced))];
        let holds = (0..2).all(|i| errors[i] <= ROUNDINGS[i]);
        assert!(holds, "{name} {set:?} {errors:?} at {state:?}");
        worst = [worst[0].max(errors[0]), worst[1].max(errors[1])];
    }
    println!("{name}: {} cases, {:.1} and {:.0} roundings", asked.len(), worst[0], worst[1]);
    [asked.len(), closed]
}

#[test]
fn every_function_of_every_model_is_that_of_the_program() {
    let folder = folder("functions");
    let mut sum = [0, 0];
    for entry in models().iter() {
        let model = model(entry.name());
        let library = Library::build(&folder, entry.name(), model.layout());
        let [cases, closed] = compared(&library, entry.name(), &model);
        sum = [sum[0] + cases, sum[1] + closed];
    }
    assert!(sum[0] > 300 && sum[1] > 200, "{sum:?}");
}

/// Journals as thick as a third of their bar, which rub much.
const ON_JOURNALS: &str = "
/// Two bars on journals.
#[derive(BarSystem)]
#[gravity(g)]
#[pin(O = (0, 0))]
#[pin(O, friction = mu, radius = r)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[hinge(A, friction = mu, radius = r)]
#[figure(A = (l, 0), B = (2 * l, 0))]
struct OnJournals { m: f64, l: f64, g: f64, r: f64, mu: f64 }
";

#[test]
fn friction_in_hinges_is_that_of_the_program() {
    let folder = folder("journals");
    let file = folder.join("on_journals.rs");
    std::fs::write(&file, ON_JOURNALS).expect("a file");
    let entries = liftoff_studio::source::models(ON_JOURNALS).expect("a model");
    let values = [("m", 1.5), ("l", 0.8), ("g", 9.81), ("r", 0.25), ("mu", 0.5)];
    let model =
        entries[0].model(&liftoff_studio::run_spec::RunSpec::with(&values).parameters).expect("parameters");
    let library = Library::of_file(&folder, &file, "on_journals", model.layout());
    let [cases, closed] = compared(&library, "on journals", &model);
    assert!(cases >= 2 && closed == 0);
}

/// Chains beyond what is solved by unrolled statements: their equations are recursions, their mass
/// matrix products along paths.
#[test]
fn long_chains_are_those_of_the_program() {
    let folder = folder("chains");
    for links in [9, 40] {
        let source = format!(
            "#[derive(BarSystem)] #[gravity(g)] #[pin(O = (0, 0))]
             #[chain(bar, links = {links}, from = O, mass = m, length = l)] struct Chain {{ m: f64, l: f64, g: f64 }}"
        );
        let file = folder.join(format!("chain_of_{links}.rs"));
        std::fs::write(&file, &source).expect("a file");
        let entries = liftoff_studio::source::models(&source).expect("a model");
        let parameters =
            liftoff_studio::run_spec::RunSpec::with(&[("m", 1.5), ("l", 0.3), ("g", 9.81)]).parameters;
        let model = entries[0].model(&parameters).expect("parameters");
        let library = Library::of_file(&folder, &file, "chain", model.layout());
        assert_eq!(compared(&library, &format!("chain of {links}"), &model), [2, 2]);
    }
}

/// The program in the book, and what it says it prints.
#[test]
fn the_program_of_the_book_finds_when_the_contact_opens() {
    let folder = folder("book");
    let book = include_str!("../../../../runtime/cli/src/book/other_programs.md");
    let source = book.split("```c\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a program");
    let model = model("falling-pair");
    Library::build(&folder, "falling-pair", model.layout());
    std::fs::write(folder.join("fall.c"), source).expect("a file");
    let commands = [
        "cc -std=c99 -Wall -Wextra -Werror -pedantic fall.c -Ifalling_pair-in-c -Lfalling_pair-in-c -lfalling_pair -lm",
        "./a.out",
    ];
    let mut said = String::new();
    for command in commands {
        let mut shell = std::process::Command::new("sh");
        let output = shell.current_dir(&folder).args(["-c", command]).output().expect("a shell");
        assert!(output.status.success(), "{}", text(&output.stderr));
        said = text(&output.stdout);
    }
    assert_eq!(said, "opens at t = 0.8294, phi = 0.8155\n");
    assert!(source.contains(&format!("/* {} */", said.trim_end().replace("opens at ", ""))));
}
