//! Names of a model in expressions; coordinates and parameters go before the words of the language.

use super::OutputError;
use super::expression::{Expression, Function};
use crate::model::{Contact, Layout};
use crate::names::unknown;

const POINTS: [(&str, usize, usize); 6] =
    [("x", 0, 0), ("y", 1, 0), ("vx", 0, 1), ("vy", 1, 1), ("ax", 0, 2), ("ay", 1, 2)];
const CONSTANTS: [&str; 5] = ["pi", "t", "T", "V", "E"];

pub(super) struct Names {
    pub(super) layout: &'static Layout,
}

impl Names {
    /// A name that stands for itself.
    pub(super) fn value(&self, name: &str, primes: usize) -> Result<Expression, OutputError> {
        if let Some(index) = self.layout.coordinates.iter().position(|c| c.name == name)
            && primes <= 2
        {
            return Ok(Expression::Coordinate { index, order: primes });
        }
        if primes == 0 {
            if let Some(index) = self.layout.parameters.iter().position(|p| *p == name) {
                return Ok(Expression::Parameter(index));
            }
            match name {
                "pi" => return Ok(Expression::Number(core::f64::consts::PI)),
                "t" => return Ok(Expression::Time),
                "T" => return Ok(Expression::Kinetic),
                "V" => return Ok(Expression::Potential),
                "E" => return Ok(Expression::Energy),
                _ => {}
            }
        }
        let coordinates = self.layout.coordinates.iter().map(|c| c.name);
        let known = coordinates.chain(self.layout.parameters.iter().copied()).chain(CONSTANTS);
        let name = format!("{name}{}", "'".repeat(primes));
        Err(unknown("name", &name, known).into())
    }

    /// Refuses unknown functions before their arguments are read.
    pub(super) fn check_function(&self, name: &str) -> Result<(), OutputError> {
        let of_names = || POINTS.iter().map(|(name, ..)| *name).chain(["N", "gap"]);
        if of_names().any(|known| known == name) {
            return Ok(());
        }
        let known = of_names().chain(Function::NAMED.iter().map(|(name, _)| *name));
        Err(unknown("function", name, known).into())
    }

    /// A function of points or supports.
    pub(super) fn call(&self, name: &str, arguments: &[String]) -> Result<Expression, OutputError> {
        if name == "N" {
            return self.reaction(arguments);
        }
        let [argument] = arguments else {
            return Err(OutputError::NoContact { supports: arguments.join(", ") });
        };
        match POINTS.iter().find(|(known, ..)| *known == name) {
            Some((_, axis, order)) => {
                Ok(Expression::Point { index: self.point(argument)?, axis: *axis, order: *order })
            }
            None => Ok(Expression::Gap(self.contact(argument)?.0)),
        }
    }

    fn point(&self, name: &str) -> Result<usize, OutputError> {
        let points = self.layout.points;
        let found = points.iter().position(|p| *p == name);
        found.ok_or_else(|| unknown("point", name, points.iter().copied()).into())
    }

    fn contact(&self, support: &str) -> Result<(usize, &'static Contact), OutputError> {
        contact_of(self.layout, support).ok_or_else(|| unknown_support(self.layout, support).into())
    }

    /// One support's share, or all supports of one contact.
    fn reaction(&self, supports: &[String]) -> Result<Expression, OutputError> {
        let Some(first) = supports.first() else {
            return Err(OutputError::NoContact { supports: String::new() });
        };
        let (index, contact) = self.contact(first)?;
        if let [_] = supports {
            if !contact.shared && contact.supports.len() > 1 {
                return Err(OutputError::NotShared { contact: contact.label.to_owned() });
            }
            return Ok(Expression::Reaction { contact: index, share: contact.supports.len() as f64 });
        }
        for support in supports {
            self.contact(support)?;
        }
        let whole = contact.supports.len() == supports.len()
            && contact.supports.iter().all(|member| supports.iter().any(|s| s == member));
        if whole {
            Ok(Expression::Reaction { contact: index, share: 1.0 })
        } else {
            Err(OutputError::NoContact { supports: supports.join(", ") })
        }
    }
}

/// The contact that a support belongs to.
pub(crate) fn contact_of(layout: &'static Layout, support: &str) -> Option<(usize, &'static Contact)> {
    layout.contacts.iter().enumerate().find(|(_, contact)| contact.supports.contains(&support))
}

/// The error for a support that is not there.
pub(crate) fn unknown_support(layout: &'static Layout, support: &str) -> crate::error::NameError {
    unknown("support", support, layout.contacts.iter().flat_map(|c| c.supports.iter().copied()))
}
