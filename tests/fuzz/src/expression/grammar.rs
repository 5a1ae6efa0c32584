//! Random expressions and conditions that are valid for a model.

use liftoff_core::model::Layout;
use liftoff_tests::random::Source;

const NUMBERS: [&str; 16] = [
    "0", "1", "2", "0.5", "pi", "0.1", "10", "1e3", "1e-8", "1e8", "-1", "0.3", "1e-300", "1e308", "7",
    "1302.37",
];

/// A comparison of two random sides, or one side alone.
pub(super) fn condition(layout: &Layout, source: &mut Source) -> String {
    let left = sum(layout, source, 3);
    match source.below(5) {
        0 => left,
        1 => format!("{left} < {}", source.choose(&NUMBERS)),
        2 => format!("{left} > {}", sum(layout, source, 2)),
        _ => format!("{left} = {}", source.choose(&NUMBERS)),
    }
}

fn sum(layout: &Layout, source: &mut Source, depth: usize) -> String {
    if depth == 0 || source.chance(0.25) {
        return leaf(layout, source);
    }
    let a = sum(layout, source, depth - 1);
    match source.below(14) {
        0 => format!("{a} + {}", sum(layout, source, depth - 1)),
        1 => format!("{a} - {}", sum(layout, source, depth - 1)),
        2 | 3 => format!("({a})*({})", sum(layout, source, depth - 1)),
        4 => format!("({a})/({})", sum(layout, source, depth - 1)),
        5 => format!("({a})^{}", source.choose(&["2", "3", "0.5", "(-1)", "8"])),
        6 => format!("-({a})"),
        7 => format!("{}*({a})", source.choose(&NUMBERS)),
        8 => format!("1/(1 + ({}*({a}))^2)", source.choose(&NUMBERS)),
        9 => format!("sqrt({a})"),
        10 => format!("abs({a})"),
        11 => format!("tan({}*({a}))", source.choose(&NUMBERS)),
        12 => format!("cos({a})"),
        _ => format!("sin({}*({a}))", source.choose(&NUMBERS)),
    }
}

fn leaf(layout: &Layout, source: &mut Source) -> String {
    let coordinate = source.choose(layout.coordinates).name;
    let supports: Vec<&str> = layout.contacts.iter().map(|contact| contact.label).collect();
    match source.below(12) {
        0..3 => coordinate.to_owned(),
        3 | 4 => format!("{coordinate}'"),
        5 => format!("{coordinate}''"),
        6 => "t".to_owned(),
        7 if !layout.points.is_empty() => {
            let what = source.choose(&["x", "y", "vx", "vy", "ax", "ay"]);
            format!("{what}({})", source.choose(layout.points))
        }
        8 if !supports.is_empty() => {
            format!("{}({})", source.choose(&["N", "gap"]), source.choose(&supports))
        }
        9 if !layout.parameters.is_empty() => source.choose(layout.parameters).to_owned(),
        10 => source.choose(&["E", "T", "V"]).to_owned(),
        _ => source.choose(&NUMBERS).to_owned(),
    }
}
