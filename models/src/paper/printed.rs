//! The numbers that the paper prints, each in its unit and with its digits.

use serde::Deserialize;

/// Gravity in the paper's numbers, m/s². The paper does not print it; standard gravity reproduces
/// 63.798 of Fig. 8 and −2.576 of Fig. 4, 9.81 does not.
pub const GRAVITY: f64 = 9.80665;

/// A printed number: `times` the quantity of its id, times g to `power_of_g`.
#[derive(Deserialize, Clone, Debug)]
pub struct Printed {
    printed: String,
    /// Its unit.
    pub unit: String,
    /// Where the paper prints it.
    pub source: String,
    /// What is printed, where it is not the quantity itself.
    pub what: Option<String>,
    /// Why it is not reproduced to its last digit.
    pub reason: Option<String>,
    #[serde(default = "one")]
    times: f64,
    #[serde(default)]
    power_of_g: f64,
}

fn one() -> f64 {
    1.0
}

impl Printed {
    fn factor(&self) -> f64 {
        self.times * GRAVITY.powf(self.power_of_g)
    }

    /// The digits as the paper has them.
    pub fn text(&self) -> &str {
        &self.printed
    }

    /// The printed number in the unit of its id; none where what is printed is no number.
    pub fn value(&self) -> Option<f64> {
        let printed: f64 = self.printed.parse().ok()?;
        Some(printed / self.factor())
    }

    /// A value in the unit of the id, in the paper's.
    pub fn in_its_unit(&self, value: f64) -> f64 {
        value * self.factor()
    }

    /// How many decimals are printed.
    pub fn decimals(&self) -> usize {
        self.printed.split_once('.').map_or(0, |(_, decimals)| decimals.len())
    }

    /// Whether the value, rounded to as many decimals, is what is printed.
    pub fn is_reproduced_by(&self, value: f64) -> bool {
        format!("{:.*}", self.decimals(), self.in_its_unit(value)) == self.printed
    }
}
