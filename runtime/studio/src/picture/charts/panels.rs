//! Curves of one unit in one panel.

use crate::picture::quantities::{axis, energies, shown};
use crate::picture::sample::{Traced, seen};
use crate::plot::{Axis, Chart, Colour, Curve, Dash};
use crate::registry::Units;
use liftoff::Trajectory;
use liftoff_core::model::Contact;

/// Curves of a panel at most.
const MOST: usize = 6;
/// Jumps of a curve beyond which they are not drawn as such.
const JUMPS: usize = 20;

/// Curves over one pair of axes.
pub(super) struct Panel {
    pub unit: Option<String>,
    /// Each with its output.
    pub curves: Vec<(String, Traced)>,
}

impl Panel {
    /// Outputs in the order given, one panel for each unit; those of unknown unit have one each.
    pub fn grouped(curves: Vec<(String, Traced)>, units: &Units) -> Vec<Self> {
        let mut panels: Vec<Self> = Vec::new();
        for (output, curve) in curves {
            let unit = units.unit(&output);
            let room =
                |panel: &&mut Self| panel.unit.is_some() && panel.unit == unit && panel.curves.len() < MOST;
            match panels.iter_mut().find(room) {
                Some(panel) => panel.curves.push((output, curve)),
                None => panels.push(Self { unit, curves: vec![(output, curve)] }),
            }
        }
        panels
    }

    /// The chart; only the last of a figure names the axis that all share.
    pub fn chart(&self, x: &Axis, is_last: bool) -> Chart {
        let one = self.curves.len() == 1;
        let names: Vec<String> = self.curves.iter().map(|(output, _)| shown(output)).collect();
        let values = self.curves.iter().flat_map(|(_, curve)| &curve.pieces).flat_map(|piece| &piece.points);
        let finite: Vec<f64> = values.map(|point| point[1]).filter(|value| value.is_finite()).collect();
        let name = axis(&axis_name(&names), self.unit.as_deref());
        let range = seen(finite.iter().copied());
        let x = if is_last { x.clone() } else { Axis { name: String::new(), ..x.clone() } };
        let mut curves = Vec::new();
        for (i, ((_, curve), name)) in self.curves.iter().zip(&names).enumerate() {
            let (colour, dash) = Dash::choose(i);
            curves.extend(jumps(curve, colour));
            let name = if one { "" } else { name };
            curves.push(Curve { dash, ..Curve::solid(name, colour, curve.joined()) });
        }
        let y = if finite.is_empty() { Axis::holding(&name, []) } else { Axis::holding(&name, range) };
        Chart { x, y, curves, marks: Vec::new() }
    }
}

/// Few names as they are, else the first with dots: all are in the legend.
fn axis_name(names: &[String]) -> String {
    let all = names.join(", ");
    match names {
        [first, _, ..] if all.chars().count() > 22 => format!("{first}, …"),
        _ => all,
    }
}

/// Thin lines from the value before an event to that after it.
fn jumps(curve: &Traced, colour: Colour) -> Vec<Curve> {
    let jumps = curve.jumps();
    if jumps.len() > JUMPS {
        return Vec::new();
    }
    let line = |(_, ends): (usize, [[f64; 2]; 2])| Curve {
        dash: Dash::Dotted,
        ..Curve::solid("", colour, ends.to_vec())
    };
    jumps.into_iter().map(line).collect()
}

/// Coordinates, reactions and tensions, friction forces, energies.
pub(super) fn defaults(record: &Trajectory) -> Vec<String> {
    let layout = record.layout();
    let coordinates = layout.coordinates.iter().map(|coordinate| coordinate.name.to_owned());
    let of = |function: &str, contact: &Contact| match contact.supports {
        [first, ..] if contact.shared => format!("{function}({first})"),
        _ => format!("{function}({})", contact.label),
    };
    let reactions = layout.contacts.iter().map(|contact| of("N", contact));
    let rubbing = layout.contacts.iter().filter(|contact| contact.friction.is_some());
    let frictions = rubbing.map(|contact| of("R", contact));
    coordinates
        .chain(reactions)
        .chain(frictions)
        .chain(energies(record).iter().map(ToString::to_string))
        .collect()
}
