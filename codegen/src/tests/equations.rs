//! Equations as books have them.

use super::PAIR;
use crate::Analysis;
use crate::algebra::work;

fn lines(declaration: &str) -> Vec<String> {
    let equations = crate::equations(declaration.parse().unwrap()).unwrap();
    equations.to_string().lines().map(|line| line.trim().to_owned()).collect()
}

fn has(declaration: &str, expected: &[&str]) {
    let lines = lines(declaration);
    for line in expected {
        assert!(lines.iter().any(|other| other == line), "{line} is not in {lines:#?}");
    }
}

/// T and V of the closed form are those of the free one with y = ½ l tan φ, ẏ = ½ l φ̇/cos² φ.
#[test]
fn a_pair_on_corners() {
    let expected = [
        "φ: angle of DB from the right, counter-clockwise",
        "T = ⅓ m (l² φ̇² − 3 l φ̇ ẏ cos φ + 3 ẏ²)",
        "V = m g (l sin φ − 2 y)",
        "gap(P, Q) = ½ (l sin φ − 2 y cos φ)",
        "y = ½ l tan φ",
        "T = ¹⁄₁₂ m l² φ̇² (4 − 6/cos φ + 3/cos⁴ φ)",
        "V = m g l (sin φ − tan φ)",
        "⅙ m l² (4 − 6/cos φ + 3/cos⁴ φ) φ̈ + ½ m l² φ̇² (2 tan φ/cos⁴ φ − tan φ/cos φ) = m g l (1/cos² φ − cos φ)",
    ];
    has(PAIR, &expected);
}

/// The masses are collected.
#[test]
fn an_unequal_pendulum() {
    let declaration =
        "#[gravity(g)] #[bar(OA, mass = m1, length = l)] #[bar(AB, mass = m2, length = l)] #[pin(O = (0, 0))]
        #[figure(A = (0, -l), B = (0, -2 * l))] #[coordinate(phi_1 = angle(OA), from = down)]
        #[coordinate(phi_2 = angle(AB), from = down)] struct Unequal { m1: f64, m2: f64, l: f64, g: f64 }";
    let expected = [
        "V = −½ g l ((m₁ + 2 m₂) cos φ₁ + m₂ cos φ₂)",
        "M[φ₁, φ₁] = ⅓ (m₁ + 3 m₂) l²",
        "M[φ₂, φ₁] = ½ m₂ l² cos(φ₁ − φ₂)",
        "Q[φ₁] = −½ (m₁ + 2 m₂) g l sin φ₁",
    ];
    has(declaration, &expected);
}

/// Squares and products of waves where they are shorter: y = l sin φ, so that the top's energy is ½
/// p l² φ̇² cos² φ; the thread is 2 l cos φ long. The set without a closed form has its equations
/// with multipliers.
#[test]
fn a_step_ladder() {
    let declaration =
        "#[gravity(g)] #[bar(AC, mass = m, length = l)] #[bar(CB, mass = m, length = l)] #[mass(C, p)] #[thread(AB, length = s)]
        #[support(A = floor)] #[support(B = floor)] #[figure(A = (-s / 2, 0), C = (0, sqrt(l * l - s * s / 4)))]
        #[coordinate(phi = angle(AC), from = horizontal)] #[mirror(x = 0)]
        struct StepLadder { m: f64, p: f64, l: f64, s: f64, g: f64 }";
    let expected = [
        "gap(AB) = ½ (s² − 4 l² cos² φ)/s",
        "T = ⅙ l² φ̇² (2 m + 3 p cos² φ)",
        "V = (m + p) g l sin φ",
        "⅓ l² (2 m + 3 p cos² φ) φ̈ − ½ p l² φ̇² sin 2φ = −(m + p) g l cos φ",
        "with multipliers: AB | A, B, AB",
    ];
    has(declaration, &expected);
    let equations = crate::equations(declaration.parse().unwrap()).unwrap();
    let set = equations.others.iter().find(|set| set.closed == ["A, B", "AB"]).unwrap();
    let expected = [
        "with multipliers: A, B, AB",
        "0 = y_C − l sin φ",
        "0 = ½ (s² − 4 l² cos² φ)/s",
        "⅔ m l² φ̈ − m l y_C'' cos φ = m g l cos φ − l N(A, B) cos φ + 2 (l²/s) N(AB) sin 2φ",
        "−m l φ̈ cos φ + (2 m + p) y_C'' + m l φ̇² sin φ = −(2 m + p) g + N(A, B)",
        "N(A, B) = N(A) + N(B)",
    ];
    let text = set.to_string();
    assert_eq!(text.lines().map(str::trim).collect::<Vec<_>>(), expected);
}

#[test]
fn what_a_scene_lacks_is_reported() {
    let wheel = "#[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))] #[figure(A = (0, 0), B = (l, 0))] struct Wheel { m: f64, l: f64 }";
    let left_out = |declaration: &str| crate::equations(declaration.parse().unwrap()).unwrap().left_out;
    let says =
        |declaration: &str, start: &str| left_out(declaration).iter().any(|line| line.starts_with(start));
    for start in ["No gravity: ", "No one-sided contacts: "] {
        assert!(says(wheel, start) && !says(PAIR, start), "{start}");
    }
    assert!(says(PAIR, "Mirror symmetry: ") && !says(wheel, "Mirror symmetry: "));
}

/// Of a chain twice as long the text is four times as long; nothing grows faster.
#[test]
fn a_long_chain_costs_what_its_text_is() {
    let spent = |links: usize| {
        let declaration = format!(
            "#[gravity(g)] #[chain(c, links = {links}, from = O, mass = m, length = l)] #[pin(O = (0, 0))]
             #[figure(O = (0, 0))] struct Chain {{ m: f64, l: f64, g: f64 }}"
        );
        let analysis: Analysis = super::analysis(&declaration);
        work::limited(u64::MAX - 1, || {
            crate::text::equations(&analysis).unwrap();
            u64::MAX - 1 - work::left()
        })
    };
    let (short, long) = (spent(20), spent(40));
    assert!(long < 5 * short, "{short} and {long} operations");
}

/// A journal is pressed by the force of its hinge; what it rubs is a couple.
#[test]
fn a_pendulum_on_a_journal() {
    let declaration = "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[hinge(O, friction = mu, radius = r)]
        #[figure(A = (0, -l))] #[coordinate(phi = angle(OA), from = down)]
        struct Pendulum { m: f64, l: f64, g: f64, mu: f64, r: f64 }";
    let expected = [
        "N(O) = √((fx(O, OA))² + (fy(O, OA))²)",
        "R(O) = −μ N(O) sgn v(O)",
        "⅓ m l² φ̈ = −½ m g l sin φ + r R(O)",
    ];
    has(declaration, &expected);
}
