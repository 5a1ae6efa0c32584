//! Superposed positions at equal times, each phase in its colour.

use liftoff::prelude::*;
use liftoff_studio::picture::Positions;
use liftoff_studio::plot::with_theme;
use liftoff_studio::run_spec::RunSpec;

/// Two hinged bars fall through the gap between two corners.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
struct Pair {
    /// Mass of a bar, kg.
    m: f64,
    /// Length of a bar, m.
    l: f64,
    /// Gravity, m/s².
    g: f64,
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let models = liftoff_studio::models![Pair];
    let spec =
        RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 9.81)]).start(&[("phi", 0.15)]).until("phi = pi/2");
    let run = models.find("pair")?.run(&spec)?;
    let svg = Positions::new(&run).count(16).size(Some(560), None).svg()?;
    std::fs::create_dir_all("target/liftoff/gallery")?;
    Ok(std::fs::write("target/liftoff/gallery/pattern.svg", with_theme(&svg))?)
}
