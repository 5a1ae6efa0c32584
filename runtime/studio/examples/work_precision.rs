//! Error against run time, method by method, measured here and now.

use liftoff::prelude::*;
use liftoff_studio::plot::with_theme;
use liftoff_studio::registry::{MethodId, PrecisionSpec};
use liftoff_studio::run_spec::RunSpec;
use liftoff_studio::work_precision::{figure, rows};
use std::time::Duration;

/// A bar topples on a smooth floor beside a wall.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
struct Ladder {
    /// Mass, kg.
    m: f64,
    /// Length, m.
    l: f64,
    /// Gravity, m/s².
    g: f64,
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let models = liftoff_studio::models![Ladder];
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 9.81)]).start(&[("phi", 1.3)]).until("phi = 0");
    let request = PrecisionSpec {
        methods: vec![MethodId::Tsit5, MethodId::Dop853, MethodId::Taylor, MethodId::Radau],
        tolerances: vec![1e-4, 1e-6, 1e-8, 1e-10, 1e-12],
        measuring: Duration::from_millis(5),
    };
    let svg = figure(&rows(models.find("ladder")?, &spec, &request)?);
    std::fs::create_dir_all("target/liftoff/gallery")?;
    Ok(std::fs::write("target/liftoff/gallery/work_precision.svg", with_theme(&svg))?)
}
