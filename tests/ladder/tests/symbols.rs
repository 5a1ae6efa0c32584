//! What a scene does not need is not in its program: functions of the runtime by their modules.
//! Built without optimisation: what none has removed was never asked for.

use liftoff_ladder::measure::{Binary, has_code};

/// What contacts need: the search for their events, their decision, their impacts.
const OF_CONTACTS: [&str; 6] = [
    "liftoff::event",
    "liftoff::event::detection",
    "liftoff::event::root_isolation",
    "liftoff::contact",
    "liftoff::integration::phase_run",
    "liftoff::simulation",
];

/// Which of these modules of the runtime have code in a program; `None` where its symbols cannot be read.
fn linked(program: &str) -> Option<Vec<&'static str>> {
    let functions = Binary::tested(program).expect("a program of this package").functions();
    let linked = |module: &&str| has_code(&functions, module);
    (!functions.is_empty()).then(|| OF_CONTACTS.into_iter().filter(linked).collect())
}

#[test]
fn without_supports_there_is_no_code_for_contacts() {
    for program in ["free_bar", "pendulum"] {
        if let Some(linked) = linked(program) {
            assert!(linked.is_empty(), "{program} has {linked:?}");
        }
    }
}

/// The names are right: a bar that strikes a floor needs all of it.
#[test]
fn impacts_need_it() {
    if let Some(linked) = linked("dropped_bar") {
        assert_eq!(linked, OF_CONTACTS);
    }
}
