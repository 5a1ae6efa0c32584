//! What has no condition in closed form is refused in one line that names what it is.

use crate::declared::{declared, source};
use liftoff_conditions::{Conditions, Request, sections};

fn find_refusal(file: &str, phase: &str, start: &[(&str, f64)]) -> String {
    let start = start.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    let request = Request { start, parameters: Vec::new() };
    let refused = Conditions::derive(&declared(&source(file)), phase, &request)
        .map(|found| found.section().to_string());
    let line = refused.expect_err("a refusal").to_string();
    assert!(!line.contains('\n'), "{line}");
    line
}

#[test]
fn of_contact_sets() {
    let known =
        "free | on A, E | on C | on B, D | on A, E, C | on A, E, B, D | on C, B, D | on A, E, C, B, D";
    assert_eq!(
        find_refusal("zigzag", "Z", &[]),
        format!("no contact set `Z` in closed form; there are: {known}")
    );
    assert_eq!(
        find_refusal("zigzag", "A, E", &[]),
        "on A, E: degrees of freedom: 2 (phi_inner, phi_outer); an energy level determines the motion of a single coordinate"
    );
    assert_eq!(find_refusal("zigzag", "A, E, C, B, D", &[]), "on A, E, C, B, D: nothing moves");
    assert_eq!(
        find_refusal("pendulum", "free", &[]),
        "no contacts: no one-sided contact is closed, hence no reaction vanishes"
    );
}

#[test]
fn of_starts_and_parameters() {
    let asked = find_refusal("zigzag", "A, E, C", &[("phi_outer", 1.0)]);
    assert_eq!(asked, "on A, E, C: the motion is that of `phi_inner`; there is no start `phi_outer`");
    assert_eq!(find_refusal("zigzag", "A, E, C", &[("phi_inner", 1.0)]), "parameter `m1` is not given");
    assert_eq!(find_refusal("zigzag", "A, E, C", &[("phi_inner", f64::NAN)]), "`phi_inner` is not finite");
    let infinite = "on P, Q: the energy at this start is not finite, or its coefficients are too long";
    assert_eq!(find_refusal("falling_pair", "P, Q", &[("phi", core::f64::consts::FRAC_PI_2)]), infinite);
}

/// The same ladder with what takes or gives energy, or depends on time.
#[test]
fn of_loads() {
    let with = |attribute: &str, field: &str| {
        let text = source("ladder").replace("#[gravity(g)]", &format!("#[gravity(g)]\n{attribute}"));
        let text = text.replace("pub g: f64,", &format!("pub g: f64,\n    {field}"));
        let model = declared(&text);
        Conditions::derive(&model, "A, B", &Request::default()).map(|_| ()).expect_err(attribute).to_string()
    };
    let ground = "#[ground(O = (0, 0))]";
    assert_eq!(
        with(&format!("{ground} #[spring(OA, damping = c)]"), "pub c: f64,"),
        "on A, B: `κ_OA` is no rational function of the coordinate's sine and cosine"
    );
    assert_eq!(
        with("#[torsion(AB, damping = c)]", "pub c: f64,"),
        "on A, B: no potential has the force of damper `AB`"
    );
    assert_eq!(
        with("#[force(A = (f, 0))]", "pub f: f64,"),
        "on A, B: no potential has the force of load `A`"
    );
    assert_eq!(
        with("#[force(A = (f * t, 0))]", "pub f: f64,"),
        "on A, B: `A_x` depends on time, and the energy with it"
    );
}

#[test]
fn of_friction() {
    let sliding = find_refusal("slipping_ladder", "A sliding, B sliding", &[]);
    assert_eq!(sliding, "on A sliding, B sliding: the friction of A, B takes energy");
}

/// Without a contact set the sets that have nothing are left out; a start that suits none is
/// refused.
#[test]
fn of_whole_models() {
    let model = declared(&source("zigzag"));
    let all = sections(&model, None, &Request::default()).expect("sections");
    assert!(all.iter().any(|section| section.title == "free"));
    let strange = Request { start: vec![("psi".to_owned(), 1.0)], parameters: Vec::new() };
    let refused = sections(&model, None, &strange).map(|_| ()).expect_err("no such coordinate");
    assert!(refused.to_string().contains("there is no start `psi`"), "{refused}");
}
