//! Outputs with their names in print.

use crate::explain::names::printed;
use liftoff::Trajectory;

/// The name of an axis: the outputs in print, with their unit.
pub(super) fn axis(names: &str, unit: Option<&str>) -> String {
    match unit {
        Some(unit) if !unit.is_empty() => format!("{names}, {unit}"),
        _ => names.to_owned(),
    }
}

/// The energies of a motion, with what it has lost if it may have.
pub(crate) fn energies(record: &Trajectory) -> &'static [&'static str] {
    if record.dissipates() { &["T", "V", "E", "D"] } else { &["T", "V", "E"] }
}

/// The output with the reaction of each contact of several supports as their sum, in parentheses
/// where more is beside it.
fn with_sums(output: &str) -> String {
    let mut text = String::new();
    let mut rest = output;
    while let Some((before, call)) = rest.split_once("N(").filter(|(_, call)| call.contains(')')) {
        let (supports, after) = call.split_once(')').unwrap_or((call, ""));
        let is_name = before.ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let sum = supports.split(',').map(|support| format!("N({})", support.trim()));
        let sum = sum.collect::<Vec<_>>().join(" + ");
        text += before;
        text += &match supports.contains(',') && !is_name {
            true if output.len() > supports.len() + 3 => format!("({sum})"),
            true => sum,
            false => format!("N({supports})"),
        };
        rest = after;
    }
    text + rest
}

/// An output as it is printed: `phi'` as φ̇, `N(A, E)` as N(A) + N(E).
pub(crate) fn shown(output: &str) -> String {
    let mut text = String::new();
    let summed = with_sums(output.trim());
    let mut rest = summed.as_str();
    while let Some(first) = rest.chars().next() {
        let is_name = first.is_alphabetic() || first == '_';
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        if is_name {
            let (name, after) = rest.split_at(end);
            let primes = after.bytes().take_while(|byte| *byte == b'\'').count();
            text.push_str(&printed(name, u8::try_from(primes).unwrap_or(u8::MAX)));
            rest = &after[primes..];
        } else {
            let number = first.is_ascii_digit();
            let (part, after) = rest.split_at(if number { end.max(1) } else { first.len_utf8() });
            text.push_str(&part.replace('-', "−").replace('*', "·"));
            rest = after;
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outputs_are_printed_with_their_letters() {
        for (output, text) in [
            ("phi'", "φ\u{307}"),
            ("phi_inner", "φ_inner"),
            ("N(A, E)", "N(A) + N(E)"),
            ("N(A, E) / (m1 * g)", "(N(A) + N(E)) / (m₁ · g)"),
            ("2 * N(A)", "2 · N(A)"),
            ("-2.5*omega", "−2.5·ω"),
            ("t", "t"),
        ] {
            assert_eq!(shown(output), text);
        }
    }
}
