//! A model as textbooks draw it: a boom held by a spring and a damper, a load hung from its tip.

use liftoff::prelude::*;
use liftoff_studio::picture::drawing;
use liftoff_studio::plot::with_theme;
use liftoff_studio::run_spec::RunSpec;

/// A boom hinged to the ground, held by a spring and a damper; a load hangs from its tip.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m / 4, length = l / 2)]
#[mass(B, p)]
#[pin(O = (0, 0))]
#[ground(C = (0, l))]
#[spring(CA, stiffness = k, damping = c)]
#[support(B = floor)]
#[figure(A = (4 * l / 5, 3 * l / 5), B = (4 * l / 5, l / 10))]
#[coordinate(phi = angle(OA), from = right)]
#[coordinate(psi = angle(AB), from = down)]
struct Crane {
    /// Mass of the boom, kg.
    m: f64,
    /// Mass of the load, kg.
    p: f64,
    /// Length of the boom, m.
    l: f64,
    /// Stiffness, N/m.
    k: f64,
    /// Damping, N s/m.
    c: f64,
    /// Gravity, m/s².
    g: f64,
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let models = liftoff_studio::models![Crane];
    let parameters = [("m", 20.0), ("p", 5.0), ("l", 2.0), ("k", 400.0), ("c", 30.0), ("g", 9.81)];
    let spec = RunSpec::with(&parameters).start(&[("phi", 0.6), ("psi", 0.25)]);
    let svg = drawing(&models.find("crane")?.configuration(&spec)?);
    std::fs::create_dir_all("target/liftoff/gallery")?;
    Ok(std::fs::write("target/liftoff/gallery/drawing.svg", with_theme(&svg))?)
}
