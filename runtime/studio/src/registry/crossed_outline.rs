//! Outlines of bodies that cross themselves with the values of a run.

use super::Configuration;
use crate::explain::describe_crossing;

/// Which sides of the first body cross, and the order of its corners.
pub fn crossed_outline(configuration: &Configuration) -> Option<String> {
    let mut bodies = configuration.geometry().bodies.iter();
    bodies.find_map(|body| {
        let names: Vec<&str> = body.outline.iter().map(|&point| configuration.layout.points[point]).collect();
        let corners: Vec<_> = body.outline.iter().map(|&point| configuration.points[point]).collect();
        describe_crossing(&names, &corners).map(|text| format!("the outline {}: {text}", names.join("–")))
    })
}
