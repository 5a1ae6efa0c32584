//! Reactions, gaps and energies against time: phases are shaded, events marked, an impact makes the
//! energy jump.

use liftoff::prelude::*;
use liftoff_studio::picture::Charts;
use liftoff_studio::plot::with_theme;
use liftoff_studio::run_spec::RunSpec;

/// A bar slides down a wall, its lower end on the floor, and falls flat.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor)]
#[support(B = wall(0), facing = right)]
#[support(end = floor, under = B)]
#[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
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
    let spec = RunSpec::with(&[("m", 10.0), ("l", 3.0), ("g", 9.81)]).start(&[("phi", 1.3)]).until("t = 1.5");
    let run = models.find("ladder")?.run(&spec)?;
    let outputs = ["N(A)", "N(B)", "N(end)", "gap(B)", "gap(end)", "T", "V", "E"];
    let svg = Charts::new(&run).outputs(outputs).svg()?;
    std::fs::create_dir_all("target/liftoff/gallery")?;
    Ok(std::fs::write("target/liftoff/gallery/reactions.svg", with_theme(&svg))?)
}
