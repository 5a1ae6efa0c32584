//! Which support of Fig. 1b opens first, over the outer bars' part of the mass and the angle it
//! starts from: a map.

use liftoff::prelude::*;
use liftoff_studio::plot::with_theme;
use liftoff_studio::sweep::Sweep;
use std::fs;
use std::path::Path;

/// Four bars in the shape of an M on a smooth floor.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m2, length = l)]
#[bar(BC, mass = m1, length = l)]
#[bar(CD, mass = m1, length = l)]
#[bar(DE, mass = m2, length = l)]
#[support(A = floor)]
#[support(C = floor)]
#[support(E = floor)]
#[support(B = floor, stop)]
#[support(D = floor, stop)]
#[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
#[coordinate(phi_inner = angle(CD), from = horizontal)]
#[coordinate(phi_outer = angle(DE), from = horizontal)]
#[coordinate(y = y(C))]
#[mirror(x = 0)]
struct Zigzag {
    m1: f64,
    m2: f64,
    l: f64,
    g: f64,
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    let models = liftoff_studio::models![Zigzag];
    let table = Sweep::new(models.find("zigzag")?)
        .vary("lambda=0.01:0.99:99")?
        .vary("phi=0.1:1.5:71")?
        .set("m1=1-lambda")?
        .set("m2=lambda")?
        .set("l=1")?
        .set("g=9.81")?
        .start("phi_inner=phi")?
        .start("phi_outer=phi")?
        .observe("first open")?
        .observe("first open phi_inner")?
        .run()?;
    print!("{}", table.summary());
    let folder = Path::new("target/liftoff/gallery");
    fs::create_dir_all(folder)?;
    Ok(fs::write(folder.join("sweep-map.svg"), with_theme(&table.svg()?))?)
}
