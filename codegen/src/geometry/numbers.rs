//! What forms need of the parameters, each number once.

use crate::algebra::{Angle, Series};

/// An index into [`Numbers`].
pub type Number = usize;

/// Lengths and angles that parameters determine.
#[derive(Clone, Debug, Default)]
pub struct Numbers(pub Vec<Value>);

/// One of [`Numbers`].
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// A length or the like.
    Length(Series),
    /// An angle, rad.
    Angle(Angle),
}

impl Numbers {
    pub(super) fn length(&mut self, length: &Series) -> Number {
        self.index(Value::Length(length.clone()))
    }

    pub(super) fn angle(&mut self, angle: &Angle) -> Number {
        self.index(Value::Angle(angle.clone()))
    }

    pub(super) fn position(&mut self, at: &[Series; 2]) -> [Number; 2] {
        [self.length(&at[0]), self.length(&at[1])]
    }

    fn index(&mut self, value: Value) -> Number {
        let known = self.0.iter().position(|other| *other == value);
        known.unwrap_or_else(|| {
            self.0.push(value);
            self.0.len() - 1
        })
    }
}
