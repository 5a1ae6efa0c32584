//! What the computed values are compared with: the paper's printed numbers and references of 25 digits.

use serde::Deserialize;
use std::collections::BTreeMap;

/// A reference that the integrator had no part in; `data/references.py` made it.
#[derive(Deserialize, Clone, Debug)]
pub struct Reference {
    /// Its digits, or the names of supports.
    pub value: String,
}

/// A number as the paper prints it: in the id's unit once divided by `times` and by g to `power_of_g`.
#[derive(Deserialize, Clone, Debug)]
pub struct Printed {
    printed: String,
    /// Where the paper prints it.
    pub source: String,
    #[serde(default = "one")]
    times: f64,
    #[serde(default)]
    power_of_g: f64,
}

/// Gravity in the paper's plots, m/s².
pub const PAPER_GRAVITY: f64 = 9.81;

fn one() -> f64 {
    1.0
}

impl Printed {
    /// The printed number in the id's unit; none where what is printed is no number.
    pub fn value(&self) -> Option<f64> {
        let printed: f64 = self.printed.parse().ok()?;
        Some(printed / self.times / PAPER_GRAVITY.powf(self.power_of_g))
    }
}

/// Both tables by id.
#[derive(Clone, Debug)]
pub struct References {
    references: BTreeMap<String, Reference>,
    published: BTreeMap<String, Printed>,
}

impl References {
    /// The tables that come with the program.
    pub fn load() -> Result<Self, serde_json::Error> {
        Ok(Self {
            references: serde_json::from_str(include_str!("../../data/references.json"))?,
            published: serde_json::from_str(include_str!("../../data/published.json"))?,
        })
    }

    /// The reference of `id`.
    pub fn reference(&self, id: &str) -> Option<&Reference> {
        self.references.get(id)
    }

    /// What the paper prints for `id`.
    pub fn published(&self, id: &str) -> Option<&Printed> {
        self.published.get(id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_the_paper_prints_agrees_with_its_reference() {
        let tables = References::load().expect("both tables are JSON");
        for (id, printed) in &tables.published {
            let reference: f64 = tables.references[id].value.parse().expect("a number");
            let value = printed.value().expect("a number");
            // The paper's plots are good to 0.2 %, its tables to a unit of the last digit printed.
            let digits = printed.printed.split('.').nth(1).map_or(0, str::len) as i32;
            let room = (0.003 * reference.abs()).max(10f64.powi(-digits) * 1.2);
            assert!((value - reference).abs() <= room, "{id}: {value} against {reference}");
        }
    }
}
