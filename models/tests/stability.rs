//! The stability suite, shortened where runs are long; `liftoff stability` runs it in full.

use liftoff_models::stability::{Effort, GROUPS, text};
use std::time::Duration;

/// Where the product falls short; a case that passes must leave this list.
const OPEN: [&str; 6] = [
    // Reactions count as zero relative to the weight of all bars, the outer ones' never leave that bound.
    "ratios.outer/inner=1e-12 dop853",
    "ratios.outer/inner=1e-12 radau",
    // A reaction below its bound is told as a touch that was decided.
    "feet.touches eps=1e-11 tol=1e-12 dop853",
    "feet.touches eps=1e-11 tol=1e-12 taylor",
    "feet.touches eps=1e-12 tol=1e-12 dop853",
    "feet.touches eps=1e-12 tol=1e-12 taylor",
];

fn judge(name: &str) {
    let group = GROUPS.iter().find(|group| group.name == name).expect("the group exists");
    let cases = group.cases(Effort::Short);
    assert!(!cases.is_empty());
    let verdicts: Vec<_> = cases.into_iter().map(|case| case.judge(Duration::from_secs(120))).collect();
    let wrong = |pass: bool, id: &str| pass == OPEN.contains(&id);
    let (wrong, _): (Vec<_>, Vec<_>) = verdicts.into_iter().partition(|v| wrong(v.pass, &v.id));
    assert!(wrong.is_empty(), "not as expected:\n{}", text(&wrong));
}

macro_rules! groups {
    ($($name:ident),*) => {
        const TESTED: &[&str] = &[$(stringify!($name)),*];
        $(#[test]
        fn $name() {
            judge(stringify!($name));
        })*
    };
}

groups!(
    springs, ratios, massless, starts, units, feet, grazing, zeno, together, edges, long, loops, chart,
    extremes, inputs
);

#[test]
fn every_group_is_tested() {
    let names: Vec<_> = GROUPS.iter().map(|group| group.name).collect();
    assert_eq!(names, TESTED);
}
