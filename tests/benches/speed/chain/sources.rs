//! The crates that are compiled for one length.

use core::fmt::Write;

/// A chain of so many bars whose coordinates are the angles from the downward vertical.
pub fn declaration(bars: usize) -> String {
    let mut text = format!(
        "#[gravity(g)] #[pin(O = (0, 0))] #[chain(bar, links = {bars}, from = O, mass = m, length = l)]"
    );
    for k in 1..=bars {
        write!(text, " #[coordinate(phi_{k} = angle(bar{k}), from = down)]").expect("text grows");
    }
    text + " pub struct Chain { pub m: f64, pub l: f64, pub g: f64 }"
}

/// The implementation with the signature of those by hand.
pub fn generated(bars: usize, implementation: &str) -> String {
    format!(
        "pub struct Chain {{ pub m: f64, pub l: f64, pub g: f64 }}
{implementation}
const N: usize = {bars};
{}",
        include_str!("generated.rs")
    )
}

/// A program that writes the nanoseconds of each, in turn; it fails where their results differ by
/// more than a condition of n² (of the mass matrix) times 100 roundings.
pub fn driver(bars: usize, crates: &[String]) -> String {
    let mut list = String::new();
    for name in crates {
        write!(list, "prepared!({name}), ").expect("text grows");
    }
    format!("const N: usize = {bars};\n{}", include_str!("driver.rs").replace("VARIANTS", &list))
}

/// A program that writes the nanoseconds of a state, evaluated with many others.
pub fn batch(bars: usize) -> String {
    let text = include_str!("batch.rs").replace("generated_BARS", &format!("generated_{bars}"));
    format!("const BARS: usize = {bars};\n{text}")
}
