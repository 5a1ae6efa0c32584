//! Paths of points: a double pendulum released from above.

use liftoff::prelude::*;
use liftoff_studio::picture::Positions;
use liftoff_studio::plot::with_theme;
use liftoff_studio::run_spec::RunSpec;

/// Two equal bars, hinged to the ground and to each other.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
struct DoublePendulum {
    /// Mass of a bar, kg.
    m: f64,
    /// Length of a bar, m.
    l: f64,
    /// Gravity, m/s².
    g: f64,
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let models = liftoff_studio::models![DoublePendulum];
    let start = [("phi", 2.0), ("psi", 2.5)];
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 9.81)]).start(&start).until("t = 6");
    let run = models.find("double-pendulum")?.run(&spec)?;
    let svg = Positions::new(&run).count(4).trails(["A", "B"]).size(Some(620), None).svg()?;
    std::fs::create_dir_all("target/liftoff/gallery")?;
    Ok(std::fs::write("target/liftoff/gallery/trails.svg", with_theme(&svg))?)
}
