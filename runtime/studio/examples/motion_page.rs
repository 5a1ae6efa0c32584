//! A bar dropped on a floor: a page that plays its motion, `target/liftoff/gallery/motion.html`.

use liftoff::prelude::*;
use liftoff_studio::animation::{About, page};
use liftoff_studio::run_spec::RunSpec;
use std::fs;

/// A bar is dropped on a smooth floor and bounces from end to end.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, restitution = e)]
#[support(B = floor, restitution = e)]
#[figure(A = (-l / 2, l), B = (l / 2, l))]
#[coordinate(phi = angle(AB), from = horizontal)]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
struct DroppedBar {
    /// Mass, kg.
    m: f64,
    /// Length, m.
    l: f64,
    /// Restitution.
    e: f64,
    /// Gravity, m/s².
    g: f64,
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let models = liftoff_studio::models![DroppedBar];
    let model = models.find("dropped-bar")?;
    let spec = RunSpec::with(&[("m", 1.0), ("l", 1.0), ("e", 0.6), ("g", 9.81)])
        .start(&[("phi", 0.5), ("y", 1.0)])
        .until("t = 3");
    let record = model.run(&spec)?;
    let outputs = ["y(B)".to_owned()];
    let about = About {
        title: "Dropped bar",
        summary: model.summary(),
        parameters: &spec.parameters,
        outputs: &outputs,
        stopped: None,
    };
    fs::create_dir_all("target/liftoff/gallery")?;
    fs::write("target/liftoff/gallery/motion.html", page(&record, &about)?)?;
    println!("target/liftoff/gallery/motion.html");
    Ok(())
}
