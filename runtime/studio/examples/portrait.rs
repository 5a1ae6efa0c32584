//! Phase portrait of a pendulum: swinging, nearly at the top, and going round.

use liftoff::prelude::*;
use liftoff_studio::picture::Portrait;
use liftoff_studio::plot::with_theme;
use liftoff_studio::run_spec::RunSpec;

/// A bar hinged at its end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Pendulum {
    /// Mass, kg.
    m: f64,
    /// Length, m.
    l: f64,
    /// Gravity, m/s².
    g: f64,
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let models = liftoff_studio::models![Pendulum];
    let from = |phi: f64, rate: f64| {
        let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("g", 9.81)]);
        models.find("pendulum")?.run(&spec.start(&[("phi", phi), ("phi'", rate)]).until("t = 2.5"))
    };
    let (small, wide, round) = (from(-1.0, 0.0)?, from(-3.0, 0.0)?, from(-3.0, 2.0)?);
    let portrait = Portrait::new("phi = −1 at rest", &small);
    let svg = portrait.and("phi = −3 at rest", &wide).and("phi = −3 with 2 rad/s", &round).svg()?;
    std::fs::create_dir_all("target/liftoff/gallery")?;
    Ok(std::fs::write("target/liftoff/gallery/portrait.svg", with_theme(&svg))?)
}
