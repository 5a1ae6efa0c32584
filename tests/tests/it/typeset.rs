//! The equations of models as LaTeX and MathML.

use liftoff_compiled::{FallingPair, Walker, Zigzag, models};
use liftoff_core::model::BarSystem;
use liftoff_studio::explain::{Equations, equations, latex, math::Equation};

#[test]
fn falling_pair() {
    insta::assert_snapshot!(latex(&equations(FallingPair::LAYOUT)));
}

#[test]
fn walker() {
    insta::assert_snapshot!(latex(&equations(Walker::LAYOUT)));
}

#[test]
fn zigzag() {
    insta::assert_snapshot!(latex(&equations(Zigzag::LAYOUT)));
}

/// What KaTeX and amsmath both have, of what is used.
const COMMANDS: [&str; 34] = [
    "Delta",
    "Bigl",
    "Bigr",
    "alpha",
    "beta",
    "bigl",
    "bigr",
    "cdot",
    "chi",
    "cos",
    "ddot",
    "delta",
    "dfrac",
    "dot",
    "gamma",
    "kappa",
    "lambda",
    "mathrm",
    "mu",
    "nu",
    "omega",
    "operatorname",
    "pi",
    "psi",
    "rho",
    "sin",
    "sqrt",
    "tan",
    "text",
    "tfrac",
    "theta",
    "varepsilon",
    "varphi",
    "xi",
];

#[test]
fn latex_is_well_formed() {
    let mut seen = 0;
    for model in models().iter() {
        for equation in all(&equations(model.layout())) {
            let text = equation.latex();
            let unknown = commands(&text).into_iter().find(|command| !COMMANDS.contains(command));
            assert_eq!((unknown, depth(&text, ['{', '}'])), (None, Some(0)), "{}: {text}", model.name());
            assert_eq!(depth(&text, ['(', ')']), Some(0), "{}: {text}", model.name());
            seen += 1;
        }
    }
    assert!(seen > 1000, "{seen}");
}

#[test]
fn mathml_is_well_formed() {
    for model in models().iter() {
        for equation in all(&equations(model.layout())) {
            let text = equation.mathml();
            assert_eq!(unclosed(&text), Vec::<&str>::new(), "{}: {text}", model.name());
        }
    }
}

fn all(equations: &Equations) -> Vec<&Equation> {
    let system = equations.energies.iter().chain(&equations.mass).chain(&equations.velocity_terms);
    let system = system.chain(&equations.forces).chain(&equations.definitions).chain(&equations.gaps);
    let phases = equations.phases.iter().flat_map(|phase| {
        phase.eliminated.iter().chain(&phase.energies).chain(&phase.motion).chain(&phase.reactions)
    });
    system.chain(phases).collect()
}

/// The names after backslashes.
fn commands(text: &str) -> Vec<&str> {
    text.split('\\')
        .skip(1)
        .map(|rest| &rest[..rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len())])
        .filter(|name| !name.is_empty())
        .collect()
}

/// How many brackets are open at the end; `None` where one closes that was not open.
fn depth(text: &str, [open, close]: [char; 2]) -> Option<usize> {
    text.chars().try_fold(0_usize, |depth, c| match c {
        c if c == open => Some(depth + 1),
        c if c == close => depth.checked_sub(1),
        _ => Some(depth),
    })
}

/// Tags left open, or closed out of turn.
fn unclosed(text: &str) -> Vec<&str> {
    let mut open = Vec::new();
    for tag in text.split('<').skip(1).filter_map(|part| part.split_once('>')).map(|(tag, _)| tag) {
        match tag.strip_prefix('/') {
            Some(name) if open.last() == Some(&name) => {
                open.pop();
            }
            Some(name) => open.push(name),
            None if tag.ends_with('/') => {}
            None => open.push(tag.split(' ').next().unwrap_or(tag)),
        }
    }
    open
}
