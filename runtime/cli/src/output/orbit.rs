//! What `orbit` prints.

use crate::CommandError;
use crate::output::json::pretty;
use core::fmt::Write;
use liftoff::__private::expression::significant;
use liftoff_analysis::{Branch, Orbit, OrbitStability, describe_events};
use liftoff_core::model::Layout;
use liftoff_studio::sweep::aligned;
use serde_json::{Map, Value, json};

/// Digits of what is printed.
const DIGITS: usize = 10;
/// Digits in a table.
const FEWER: usize = 7;

/// The period, the state on the section, what drifts, and the multipliers.
pub fn text(layout: &Layout, orbit: &Orbit) -> String {
    let stability = match orbit.stability() {
        OrbitStability::Stable => "stable",
        OrbitStability::Neutral => "neutral: a multiplier is on the unit circle",
        OrbitStability::Unstable => "not stable",
    };
    let mut text = format!("period {}, {stability}\n", number(orbit.period));
    let entries = layout.names_of_state().zip(&orbit.state);
    let entries: Vec<_> = entries.map(|(name, x)| format!("{name} = {}", number(*x))).collect();
    let _ = writeln!(text, "  {}", entries.join("  "));
    let shifts = layout.coordinates.iter().zip(&orbit.shift).filter(|(_, by)| **by != 0.0);
    let shifts: Vec<_> = shifts.map(|(c, by)| format!("{} by {}", c.name, number(*by))).collect();
    if !shifts.is_empty() {
        let _ = writeln!(text, "  shifted: {}", shifts.join(", "));
    }
    let _ = writeln!(text, "  events: {}", describe_events(&orbit.events));
    let _ = writeln!(text, "  multipliers: {}", multipliers(orbit, DIGITS));
    let _ = writeln!(text, "  differs from its image by {:.0e} natural units", orbit.residual);
    text
}

/// A row for each orbit of a branch, and where it ends.
pub fn branch_text(layout: &Layout, branch: &Branch, parameter: usize) -> String {
    let head = [layout.parameters[parameter], "period", "multipliers", ""].map(str::to_owned).to_vec();
    let rows = branch.points.iter().map(|point| {
        let orbit = &point.orbit;
        vec![
            number(orbit.parameters[parameter]),
            significant(orbit.period, FEWER),
            multipliers(orbit, FEWER),
            point.special.map_or_else(String::new, |special| special.to_string()),
        ]
    });
    let rows: Vec<Vec<String>> = [head].into_iter().chain(rows).collect();
    let lines: String = aligned(&rows, Some(2)).iter().map(|line| format!("{}\n", line.trim_end())).collect();
    format!("{lines}{}\n", branch.end)
}

fn multipliers(orbit: &Orbit, digits: usize) -> String {
    let each = orbit.multipliers.iter().map(|multiplier| {
        let sign = if multiplier.im < 0.0 { "−" } else { "+" };
        let im = multiplier.im.abs();
        let im = if im == 0.0 { String::new() } else { format!(" {sign} {}i", significant(im, digits)) };
        format!("{}{im}", significant(multiplier.re, digits))
    });
    each.collect::<Vec<_>>().join(", ")
}

fn number(x: f64) -> String {
    significant(x, DIGITS)
}

/// The same with all digits.
pub fn json(layout: &Layout, orbit: &Orbit) -> Result<String, CommandError> {
    pretty(&value(layout, orbit))
}

/// All orbits of a branch with all digits, and where it ends.
pub fn branch_json(layout: &Layout, branch: &Branch) -> Result<String, CommandError> {
    let points = branch.points.iter().map(|point| {
        let mut told = value(layout, &point.orbit);
        told["special"] = json!(point.special.map(|special| special.to_string()));
        told
    });
    pretty(&json!({ "orbits": points.collect::<Vec<_>>(), "end": branch.end.to_string() }))
}

fn value(layout: &Layout, orbit: &Orbit) -> Value {
    let named = |names: Vec<String>, values: &[f64]| -> Map<String, Value> {
        names.into_iter().zip(values.iter().map(|x| json!(x))).collect()
    };
    let coordinates = layout.coordinates.iter().map(|c| c.name.to_owned()).collect();
    json!({
        "parameters": named(layout.parameters.iter().map(|name| (*name).to_owned()).collect(), &orbit.parameters),
        "period": orbit.period,
        "state": named(layout.names_of_state().collect(), &orbit.state),
        "shift": named(coordinates, &orbit.shift),
        "events": describe_events(&orbit.events),
        "multipliers": orbit.multipliers.iter().map(|m| json!([m.re, m.im])).collect::<Vec<_>>(),
        "stable": orbit.stability() == OrbitStability::Stable,
        "residual": orbit.residual,
    })
}
