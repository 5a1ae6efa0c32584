//! What a scene does not need is not in its program: the modules that have code in it, and the
//! bytes of that code.

use liftoff_ladder::measure::{Binary, has_code};

/// A program with the most bytes of machine code that it may have in release, and the modules of
/// the runtime that it needs not.
struct Rung {
    name: &'static str,
    path: &'static str,
    most: u64,
    without: &'static [&'static str],
}

macro_rules! rung {
    ($name:literal, $most:literal kB, without $without:expr) => {
        Rung {
            name: $name,
            path: env!(concat!("CARGO_BIN_EXE_", $name)),
            most: 1000 * $most,
            without: $without,
        }
    };
}

/// What decides contacts, finds their events and runs from one to the next.
const CONTACTS: &[&str] = &[
    "liftoff::event",
    "liftoff::contact",
    "liftoff::integration",
    "liftoff::simulation",
    "liftoff::assembly",
    "liftoff_core::integrate::radau",
    "liftoff_core::integrate::gauss",
    "liftoff_core::system::erased",
];

/// What a scene without friction, conditions, springs and roots of the motion needs not: friction
/// and hinges with it, expressions as text, kinks, and methods for what is stiff or nobody asked
/// for.
const SMOOTH: &[&str] = &[
    "liftoff::integration::method::kinks",
    "liftoff::contact::friction::decision",
    "liftoff::contact::friction::impact::at_once",
    "liftoff::contact::hinges",
    "liftoff::contact::nondegenerate::slider",
    "liftoff::expression::parse",
    "liftoff_core::integrate::radau",
    "liftoff_core::integrate::gauss",
];

/// What one with threads needs not: their lengths are roots, which have kinks.
const THREADS: &[&str] = SMOOTH.split_at(1).1;

/// What one with friction needs not.
const ROUGH: &[&str] = &[
    "liftoff::contact::hinges",
    "liftoff::expression::parse",
    "liftoff::integration::method::kinks",
    "liftoff_core::integrate::radau",
    "liftoff_core::integrate::gauss",
];

/// Budgets serve processors with AVX-512 and with AVX2 alone, whose code is 6 % longer: they are
/// the first with 9 % to spare.
const RUNGS: [Rung; 11] = [
    rung!("free_bar", 320 kB, without CONTACTS),
    rung!("falling_bar", 320 kB, without CONTACTS),
    rung!("pendulum", 320 kB, without CONTACTS),
    rung!("sprung_pendulum", 320 kB, without CONTACTS),
    rung!("standing_bar", 1840 kB, without SMOOTH),
    rung!("dropped_bar", 1840 kB, without SMOOTH),
    rung!("slung_bar", 1900 kB, without THREADS),
    rung!("rubbing_rod", 2080 kB, without ROUGH),
    rung!("fig_1a", 1840 kB, without SMOOTH),
    rung!("fig_1b", 1950 kB, without SMOOTH),
    rung!("four_bar", 1880 kB, without SMOOTH),
];

#[test]
fn programs_have_what_their_scenes_need() {
    for Rung { name, path, without, .. } in &RUNGS {
        let functions = Binary::built(path).expect("a program of this package").functions();
        let linked: Vec<_> = without.iter().filter(|module| has_code(&functions, module)).collect();
        assert!(linked.is_empty(), "{name} has {linked:?}");
    }
}

/// The names are right: a bar that strikes a floor has events, contacts and impacts.
#[test]
fn modules_are_found_by_their_names() {
    let path = env!("CARGO_BIN_EXE_dropped_bar");
    let functions = Binary::built(path).expect("a program of this package").functions();
    let needed =
        ["liftoff::event", "liftoff::contact", "liftoff::simulation", "liftoff_core::system::erased"];
    for module in needed.iter().filter(|_| !functions.is_empty()) {
        assert!(has_code(&functions, module), "{module}");
    }
}

#[test]
#[cfg_attr(debug_assertions, ignore = "bytes are those of programs built with --release")]
fn programs_stay_within_their_budgets() {
    for Rung { name, path, most, .. } in &RUNGS {
        let text = Binary::built(path).expect("a program of this package").text();
        println!("{name}: {text} bytes");
        assert!(text <= *most, "{name}: {text} bytes of machine code, {most} allowed");
    }
}
