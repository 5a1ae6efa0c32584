//! The model: its drawing, its names with their dimensions, its declaration.

use super::Subject;
use crate::explain::written;
use crate::html::escaped;
use crate::picture;
use crate::registry::{Dimension, MotionError};
use core::fmt::Write;

pub fn html(subject: &Subject) -> Result<String, MotionError> {
    let drawing = drawn(subject).map_or(String::new(), |svg| {
        format!("<div class=figures><figure class=\"model wide\">{svg}</figure></div>\n")
    });
    let declaration = escaped(&written(subject.model.layout()));
    let declaration =
        format!("<details><summary>Declaration</summary>\n<pre>{declaration}</pre></details>\n");
    Ok(drawing + &names(subject) + &declaration)
}

/// The model where its run starts or as its figure has it.
pub fn drawn(subject: &Subject) -> Option<String> {
    let configuration = picture::clearest_pose(subject.model, &subject.spec).ok()?;
    Some(picture::drawing(&configuration))
}

/// Parameters with the values of the default run, coordinates, contacts.
fn names(subject: &Subject) -> String {
    let layout = subject.model.layout();
    let dimensions = subject.model.dimensions();
    let mut html = String::from(
        "<div class=table><table>\n<thead><tr><th class=word>name<th class=word>what<th>default<th class=word>unit</tr></thead>\n<tbody>\n",
    );
    let mut line = |name: &str, what: &str, value: String, unit: String| {
        let _ = writeln!(
            html,
            "<tr><td class=word>{}<td class=\"word wide\">{what}<td>{value}<td class=word>{unit}</tr>",
            escaped(name)
        );
    };
    let explained = crate::explain::equations(layout);
    for (i, name) in layout.parameters.iter().enumerate() {
        let value = subject.spec.parameters.iter().find(|(known, _)| known == name);
        let unit = dimensions.as_ref().map_or(String::new(), |all| unit(all[i]));
        line(
            name,
            &meaning_or_kind(&explained.parameters[i].meaning, "parameter"),
            value.map_or(String::new(), |(_, value)| value.to_string()),
            unit,
        );
    }
    for (name, explained) in layout.names_of_positions().zip(&explained.coordinates) {
        let unit = if layout.is_angle(name) { "rad" } else { "m" };
        line(name, &meaning_or_kind(&explained.meaning, "coordinate"), String::new(), unit.to_owned());
    }
    for contact in layout.contacts {
        line(contact.label, "contact", String::new(), String::new());
    }
    html + "</tbody></table></div>\n"
}

/// What something means, or else what it is.
fn meaning_or_kind(meaning: &str, kind: &str) -> String {
    if meaning.is_empty() { kind.to_owned() } else { escaped(meaning) }
}

/// In SI units: `kg m²/s²`; empty where powers are no whole numbers, as of parameters that only
/// occur as a product.
fn unit([length, time, mass]: Dimension) -> String {
    let powers = [("kg", mass), ("m", length), ("s", time)];
    if powers.iter().any(|(_, power)| power.fract() != 0.0) {
        return String::new();
    }
    let side = |sign: f64| {
        let there = powers.iter().filter(move |(_, power)| power * sign > 0.0);
        there.map(|(unit, power)| raised(unit, power.abs())).collect::<Vec<_>>()
    };
    match (side(1.0).join(" "), side(-1.0)) {
        (above, below) if below.is_empty() && above.is_empty() => "1".to_owned(),
        (above, below) if below.is_empty() => above,
        (above, below) => {
            let above = if above.is_empty() { "1".to_owned() } else { above };
            let below = if below.len() > 1 { format!("({})", below.join(" ")) } else { below.concat() };
            format!("{above}/{below}")
        }
    }
}

fn raised(unit: &str, power: f64) -> String {
    match power {
        1.0 => unit.to_owned(),
        2.0 => format!("{unit}²"),
        3.0 => format!("{unit}³"),
        _ => format!("{unit}<sup>{power}</sup>"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_written_as_in_print() {
        assert_eq!(unit([1.0, -2.0, 0.0]), "m/s²");
        assert_eq!(unit([0.0, 0.0, 1.0]), "kg");
        assert_eq!(unit([0.0, -1.0, 0.0]), "1/s");
        assert_eq!(unit([0.0; 3]), "1");
        assert_eq!(unit([2.0, -1.0, 1.0]), "kg m²/s");
        assert_eq!(unit([-1.0, -2.0, 1.0]), "kg/(m s²)");
        assert_eq!(unit([0.5, 0.0, 0.0]), "");
    }
}
