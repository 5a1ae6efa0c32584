//! The paper's conditions and numbers, and the strict ones, from the closed form alone.
//!
//! Rozenblat & Grishakin, Rus. J. Nonlin. Dyn. 2023, 19(2), 187–200.

use crate::declared::{by_ratio, declared, source};
use core::f64::consts::FRAC_PI_2;
use liftoff_codegen::Analysis;
use liftoff_conditions::{Conditions, First, Numbers, Request, Zero};

fn named(values: &[(&str, f64)]) -> Vec<(String, f64)> {
    values.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect()
}

/// From rest upright, or from another start.
fn conditions(model: &Analysis, phase: &str, start: (&str, f64), parameters: &[(&str, f64)]) -> Conditions {
    let request = Request { start: named(&[start]), parameters: named(parameters) };
    Conditions::derive(model, phase, &request).expect("conditions")
}

fn numbers(model: &Analysis, phase: &str, start: (&str, f64), parameters: &[(&str, f64)]) -> Numbers {
    conditions(model, phase, start, parameters).numbers.expect("numbers")
}

fn reference(name: &str) -> f64 {
    let all: serde_json::Value =
        serde_json::from_str(include_str!("../../../../models/data/references.json")).expect("JSON");
    all[name]["value"].as_str().unwrap_or_else(|| panic!("{name}")).parse().expect("a number")
}

fn falling(numbers: &Numbers) -> (f64, Vec<&str>) {
    match &numbers.first[0] {
        Some(First::Opens { at, contacts }) => (*at, contacts.iter().map(String::as_str).collect()),
        other => panic!("{other:?}"),
    }
}

/// Roots are rounded once, by the arcus tangent: a few units in the last place of a number below 1.
const ROUNDING: f64 = 1e-15;

#[test]
fn the_condition_of_the_paper() {
    let model = by_ratio("zigzag_published");
    insta::assert_snapshot!(Conditions::derive(&model, "A, C, E", &Request::default()).unwrap().section());
    let upright = conditions(
        &model,
        "A, C, E",
        ("phi", FRAC_PI_2),
        &[("m", 1.0), ("lambda", 0.5), ("l", 1.0), ("g", 1.0)],
    );
    insta::assert_snapshot!(upright.section());
}

#[test]
fn the_strict_conditions() {
    let model = by_ratio("zigzag");
    insta::assert_snapshot!(Conditions::derive(&model, "A, E, C", &Request::default()).unwrap().section());
}

#[test]
fn the_condition_of_the_falling_pair() {
    let model = declared(&source("falling_pair"));
    let from_rest = conditions(&model, "P, Q", ("phi", 0.0), &[("m", 1.0), ("l", 1.0), ("g", 9.80665)]);
    insta::assert_snapshot!(from_rest.section());
    let (at, _) = match &from_rest.numbers.as_ref().unwrap().first[1] {
        Some(First::Opens { at, contacts }) => (*at, contacts),
        other => panic!("{other:?}"),
    };
    assert!((at - reference("fig1a.phi1")).abs() < ROUNDING, "{at}");
}

/// Table 1: where the total reaction is least, how small it is, and where it vanishes.
#[test]
fn table_1() {
    let model = declared(&source("zigzag_published"));
    for (key, lambda) in [("0.00", 0.0), ("0.25", 0.25), ("0.50", 0.5), ("0.75", 0.75), ("1.00", 1.0)] {
        let parameters = [("m1", 1.0 - lambda), ("m2", lambda), ("l", 1.0), ("g", 1.0)];
        let found = numbers(&model, "A, C, E", ("phi", FRAC_PI_2), &parameters);
        let star = reference(&format!("fig1b.phi_star[{key}]"));
        let least = found.stationary[0].1.iter().find(|place| (place.at - star).abs() < ROUNDING);
        // N = (m₁ + m₂) g (2 − μ).
        let mu = 2.0 - least.unwrap_or_else(|| panic!("{star}: {found:?}")).reaction;
        assert!((mu - reference(&format!("fig1b.mu[{key}]"))).abs() < 4.0 * ROUNDING, "{mu}");
        let vanishes = reference(&format!("fig1b.phi1[{key}]"));
        if lambda == 0.0 {
            // It only touches zero there.
            let touched = |zero: &Zero| (zero.at - vanishes).abs() < ROUNDING && zero.multiplicity == 2;
            assert!(found.zeros[0].1.iter().any(touched), "{found:?}");
            assert!(!matches!(found.first[0], Some(First::Opens { at, .. }) if at > 0.0), "{found:?}");
        } else {
            let (at, contacts) = falling(&found);
            assert!((at - vanishes).abs() < ROUNDING, "{at} {vanishes}");
            assert_eq!(contacts, ["A, C, E"]);
        }
    }
}

/// Which of C and of A, E opens first changes where the algebra says: at m₁ = 3 m₂, λ = ¼.
#[test]
fn strict_first_openings() {
    let model = declared(&source("zigzag"));
    for (key, lambda) in [("0.10", 0.1), ("0.25", 0.25), ("0.50", 0.5), ("0.75", 0.75), ("0.90", 0.9)] {
        let parameters = [("m1", 1.0 - lambda), ("m2", lambda), ("l", 1.0), ("g", 1.0)];
        let found = numbers(&model, "A, E, C", ("phi_inner", FRAC_PI_2), &parameters);
        let (at, contacts) = falling(&found);
        let expected = reference(&format!("strict.phi_first[{key}]"));
        assert!((at - expected).abs() < ROUNDING, "{key}: {at} {expected}");
        let mut contacts = contacts;
        contacts.sort_unstable();
        let known: &[&str] = match lambda {
            l if l < 0.25 => &["A, E"],
            l if l > 0.25 => &["C"],
            _ => &["A, E", "C"],
        };
        assert_eq!(contacts, known);
    }
}

/// `N_C = 6 N_E`: A and E bear half of N(A, E) each, so 3 of it. Found from the coefficients of
/// both; that it happens nowhere else, from the resultant.
#[test]
fn the_critical_ratio_is_found_by_the_algebra() {
    let told = |model: &Analysis| {
        let found = Conditions::derive(model, "A, E, C", &Request::default()).expect("conditions");
        let [pair] = found.pairs.as_slice() else { panic!("{found:?}") };
        let proportional = pair.proportional.iter();
        let proportional: Vec<(String, Option<String>)> = proportional
            .map(|(place, multiple)| (place.to_string(), multiple.as_ref().map(ToString::to_string)))
            .collect();
        assert_eq!(pair.together.as_deref(), Some(&[][..]));
        proportional
    };
    let multiple = Some("N(C) = 3 N(A, E)".to_owned());
    assert_eq!(told(&declared(&source("zigzag"))), [("m₁ = 3 m₂".to_owned(), multiple.clone())]);
    // λ = 1 makes inner bars massless: no positive mass excludes it by its sign.
    assert!(told(&by_ratio("zigzag")).contains(&("λ = ¼".to_owned(), multiple)));
}

/// `sin φ = ⅔ sin φ₀`: the ladder leaves its wall.
#[test]
fn a_ladder_leaves_the_wall_at_two_thirds_of_its_height() {
    let model = declared(&source("ladder"));
    let parameters: Vec<(&str, f64)> = [("m", 1.0), ("l", 2.0), ("g", 9.81)].to_vec();
    let found = numbers(&model, "A, B", ("phi", 1.3), &parameters);
    let (at, contacts) = falling(&found);
    assert!((at.sin() - 2.0 / 3.0 * 1.3_f64.sin()).abs() < 4.0 * f64::EPSILON, "{at}");
    assert_eq!(contacts, ["B"]);
}
