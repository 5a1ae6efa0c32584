//! Resolution of declarations, and the mistakes that are told. Where each message stands is tested
//! on the compiler's output, in the workspace's `tests/derive/tests/ui`.

mod bodies;
mod constraints;
mod discs;
mod drives;
mod edges;
mod expressions;
mod figure;
mod loads;
mod mirror;
mod mistakes;
mod round_trip;
mod syntax_mistakes;

use super::{Series, System};
use crate::syntax;

/// The system that attributes describe, its parameters m, l, g, a.
fn resolve(attributes: &str) -> syn::Result<System> {
    let item = format!("{attributes} struct S {{ m: f64, l: f64, g: f64, a: f64 }}");
    System::resolve(&syntax::parse(item.parse()?)?)
}

/// The system of an item that has no mistakes.
fn system(item: &str) -> System {
    let tokens = item.parse().unwrap();
    System::resolve(&syntax::parse(tokens).unwrap()).unwrap()
}

/// All messages about an item.
fn messages(item: &str) -> Vec<String> {
    let resolved = syntax::parse(item.parse().unwrap()).and_then(|d| System::resolve(&d));
    let Err(errors) = resolved else {
        return Vec::new();
    };
    errors.into_iter().map(|error| error.to_string()).collect()
}

fn point(system: &System, name: &str) -> usize {
    system.points.iter().position(|point| point.name == name).unwrap()
}

fn text(system: &System, series: &Series) -> String {
    series.text(&system.names())
}

fn write_position(system: &System, name: &str) -> String {
    let [x, y] = system.figure[point(system, name)].each_ref().map(|c| text(system, c));
    format!("{x}, {y}")
}
