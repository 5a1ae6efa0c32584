//! Runs computed once more in double-double, against 25-digit references from elsewhere.

use liftoff::ReferenceError;
use liftoff::prelude::*;
use liftoff::scalar::{DoubleDouble, Scalar};

/// Fig. 1a.
#[derive(BarSystem, Clone, Debug)]
#[gravity(g)]
#[bar(AD, mass = m, length = l)]
#[bar(DB, mass = m, length = l)]
#[support(P = corner(-l / 2, 0), under = AD)]
#[support(Q = corner(l / 2, 0), under = DB)]
#[figure(D = (0, 0), A = (-l, 0), B = (l, 0))]
#[coordinate(phi = angle(DB), from = horizontal)]
#[coordinate(y = -y(D))]
#[mirror(x = 0)]
struct FallingPair {
    m: f64,
    l: f64,
    g: f64,
}

/// The number with these digits; 32 of them are kept.
fn digits(text: &str) -> DoubleDouble {
    let hi: f64 = text.parse().expect("a number");
    let rest = format!("{hi:.40}");
    let places = |text: &str| -> i128 {
        let (whole, part) = text.split_once('.').unwrap_or((text, ""));
        let part: String = part.chars().chain(core::iter::repeat('0')).take(30).collect();
        format!("{whole}{part}").parse().expect("digits")
    };
    DoubleDouble::new(hi, (places(text) - places(&rest)) as f64 * 1e-30)
}

fn error(value: DoubleDouble, text: &str) -> f64 {
    let expected = digits(text);
    ((value - expected).abs() / expected.abs()).to_f64()
}

#[test]
fn lift_off_and_end_of_the_falling_pair() -> Result<(), Box<dyn std::error::Error>> {
    let model = FallingPair { m: 1.0, l: 1.0, g: 9.81 };
    let run = Simulation::new(&model)?.start(Pose::at("phi", 0.1))?.until("phi = pi/2")?.run()?;
    let now = std::time::Instant::now();
    let reference = run.reference()?;
    println!("{:?} {reference:?}", now.elapsed());
    let [_, Some(opens), Some(ends)] = reference.times() else { panic!("start, opening, end") };
    println!("{:e} {:e}", error(*opens, "0.82936184722826038731"), error(*ends, "1.2444614831645270833"));
    Ok(())
}
