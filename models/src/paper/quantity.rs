//! A computed quantity, and its comparison with the paper and the reference.

use super::reference::References;
use serde::Serialize;

/// What a quantity's value is.
#[derive(Serialize, Clone, PartialEq, Debug)]
#[serde(untagged)]
pub enum Value {
    /// A number in the quantity's unit.
    Number(f64),
    /// Names of supports.
    Supports(String),
}

/// A computed quantity.
#[derive(Clone, PartialEq, Debug)]
pub struct Quantity {
    /// Its id in `references.json`.
    pub id: String,
    /// The model it was computed with.
    pub model: &'static str,
    /// What it is, in words.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its value; none where the motion has no such event.
    pub computed: Option<Value>,
}

impl Quantity {
    /// A number, or none.
    pub fn number(
        id: impl Into<String>,
        model: &'static str,
        quantity: &'static str,
        unit: &'static str,
        value: Option<f64>,
    ) -> Self {
        Self { id: id.into(), model, quantity, unit, computed: value.map(Value::Number) }
    }
}

/// A quantity with what it is compared to; a row of `results.json`.
#[derive(Serialize, Clone, PartialEq, Debug)]
pub struct Row {
    /// Its id in `references.json`.
    pub id: String,
    /// The model it was computed with.
    pub model: &'static str,
    /// What it is, in words.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// What the paper prints, in that unit.
    pub published: Option<f64>,
    /// What the runs gave.
    pub computed: Option<Value>,
    /// The reference.
    pub reference: Option<Value>,
    /// |computed − reference| relative to the larger of |reference| and 0.1.
    pub relative_error: Option<f64>,
}

impl Row {
    /// `quantity` beside what the tables say of it.
    pub fn compare(quantity: Quantity, tables: &References) -> Self {
        let reference = tables.reference(&quantity.id).map(|reference| match reference.value.parse() {
            Ok(number) => Value::Number(number),
            Err(_) => Value::Supports(reference.value.clone()),
        });
        Self {
            published: tables.published(&quantity.id).and_then(|printed| printed.value()),
            relative_error: relative_error(quantity.computed.as_ref(), reference.as_ref()),
            reference,
            id: quantity.id,
            model: quantity.model,
            quantity: quantity.quantity,
            unit: quantity.unit,
            computed: quantity.computed,
        }
    }
}

impl Row {
    /// The system, its λ and the quantity, in words.
    pub fn name(&self) -> String {
        self.name_as(None)
    }

    /// The same with other words for the quantity.
    pub fn name_as(&self, what: Option<&str>) -> String {
        let (system, rest) = self.id.split_once('.').unwrap_or((&self.id, ""));
        let system = match system {
            "fig1a" => "Fig. 1a",
            "fig1b" => "Fig. 1b",
            _ => "Fig. 1b strict",
        };
        let ratio = rest.split_once('[').map_or("", |(_, ratio)| ratio.trim_end_matches(']'));
        let ratio = if ratio.is_empty() { String::new() } else { format!(", λ = {ratio}") };
        format!("{system}{ratio}: {}", what.unwrap_or(self.quantity))
    }
}

fn relative_error(computed: Option<&Value>, reference: Option<&Value>) -> Option<f64> {
    match (computed?, reference?) {
        (Value::Number(computed), Value::Number(reference)) => Some(error(*computed, *reference)),
        _ => None,
    }
}

/// |computed − reference| relative to the larger of |reference| and 0.1.
pub fn error(computed: f64, reference: f64) -> f64 {
    (computed - reference).abs() / reference.abs().max(0.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_relative_to_a_tenth_at_least() {
        assert_eq!(error(2.5, 2.0), 0.25);
        assert_eq!(error(0.2, 0.0), 2.0);
    }
}
