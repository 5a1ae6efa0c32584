//! What the computed values are compared with: the paper's printed numbers and references of 25
//! digits.

use super::printed::Printed;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A reference that the integrator had no part in; `data/references.py` made it.
#[derive(Deserialize, Clone, Debug)]
pub struct Reference {
    /// Its digits, or the names of supports.
    pub value: String,
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

    /// Either the reference rounds to the printed digits, or the table says why it does not.
    #[test]
    fn printed_numbers_match_references_or_have_a_reason() {
        let tables = References::load().expect("both tables are JSON");
        let mut reproduced = 0;
        for (id, printed) in &tables.published {
            let reference: f64 = tables.references[id].value.parse().expect("a number");
            assert_ne!(printed.is_reproduced_by(reference), printed.reason.is_some(), "{id}");
            reproduced += usize::from(printed.is_reproduced_by(reference));
            let value = printed.value().expect("a number");
            // The plots are good to 0.2 %, the tables to a unit of the last digit.
            let unit = 10f64.powi(-(printed.decimals() as i32));
            assert!((value - reference).abs() <= (0.003 * reference.abs()).max(unit), "{id}: {value}");
        }
        assert_eq!((reproduced, tables.published.len()), (29, 32));
    }
}
