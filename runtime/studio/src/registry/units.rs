//! What outputs of a model are measured in.

use super::Quantity;
use liftoff::__private::expression::si_unit::{SiUnit, si_unit, unit};
use liftoff_core::model::{self, Layout};

/// What parameters of a model are measured in, as far as its declaration tells, and outputs with
/// them.
pub struct Units {
    layout: &'static Layout,
    parameters: Vec<Option<SiUnit>>,
}

impl Units {
    /// Those of a model.
    pub fn from_layout(layout: &'static Layout) -> Self {
        let parameters = layout.dimensions.iter().map(|dimension| dimension.and_then(whole));
        Self { layout, parameters: parameters.collect() }
    }

    /// The unit of an output; none if it is not known, empty for a number.
    pub fn unit(&self, output: &str) -> Option<String> {
        unit(output, self.layout, &self.parameters)
    }

    /// The same as powers of base units.
    pub fn si(&self, output: &str) -> Option<SiUnit> {
        si_unit(output, self.layout, &self.parameters)
    }

    /// Refuses a unit that measures something else than an output, where that is known.
    ///
    /// # Errors
    /// What each is measured in.
    pub fn check(&self, output: &str, given: Option<SiUnit>) -> Result<(), String> {
        let Some((given, expected)) = given.zip(self.si(output)) else { return Ok(()) };
        let symbol = |unit: SiUnit| match unit.symbol() {
            symbol if symbol.is_empty() => "nothing".to_owned(),
            symbol => symbol,
        };
        match given.agrees(expected) {
            true => Ok(()),
            false => Err(format!("measured in {}, not in {}", symbol(expected), symbol(given))),
        }
    }

    /// A number as an expression of numbers and `pi`, with or without a unit, that is compared with
    /// an output, or taken by a parameter, coordinate or rate of this name.
    ///
    /// # Errors
    /// It is no number, or measures something else.
    pub fn measure(&self, output: &str, text: &str) -> Result<f64, String> {
        let number = Quantity::parse_number(text)?;
        self.check(output, number.unit()).map(|()| number.value(&[]))
    }

    /// What stands over a column: the output with its unit, `phi [rad]`, where it has one.
    pub fn head(&self, output: &str) -> String {
        match self.unit(output) {
            Some(unit) if !unit.is_empty() => format!("{output} [{unit}]"),
            _ => output.to_owned(),
        }
    }

    /// The same with `1` for a number.
    pub fn symbol(&self, output: &str) -> Option<String> {
        self.unit(output).map(|unit| if unit.is_empty() { "1".to_owned() } else { unit })
    }
}

/// None where a power is not whole.
fn whole(dimension: model::Dimension) -> Option<SiUnit> {
    let whole = |n: i8| (n % dimension.denominator == 0).then(|| n / dimension.denominator);
    let [length, time, mass] = dimension.numerators.map(whole);
    Some(SiUnit::new(mass?, length?, time?, 0))
}

/// The columns of a motion's table, each of them an output: time, state, reactions, slip
/// velocities, gaps, energies.
pub fn motion_columns(layout: &Layout) -> Vec<String> {
    let mut columns = vec!["t".to_owned()];
    columns.extend(layout.names_of_motion());
    for contact in layout.contacts {
        let functions = if contact.has_friction_force() { &["N", "R"][..] } else { &["N"] };
        for function in functions {
            match contact.shared {
                true => {
                    columns.extend(contact.supports.iter().map(|support| format!("{function}({support})")))
                }
                false => columns.push(format!("{function}({})", contact.label)),
            }
        }
        columns.extend(contact.friction.map(|_| format!("v({})", contact.supports[0])));
    }
    let gaps = layout.contacts.iter().filter_map(|contact| contact.supports.first());
    columns.extend(gaps.map(|support| format!("gap({support})")));
    columns.extend(["T", "V", "E"].map(str::to_owned));
    columns
}
