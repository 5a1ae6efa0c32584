//! A coordinate that a closed row determines, in terms of the coordinates kept.

use crate::algebra::{Angle, Quotient, Series};

/// A coordinate in terms of others.
#[derive(Clone, Debug)]
pub enum CoordinateValue {
    /// A length.
    Length(Quotient),
    /// An angle.
    Angle(Angle),
    /// A rate, in terms of coordinates and kept rates; the coordinate itself stays.
    Rate(Quotient),
}

/// A coordinate that a closed row determines.
#[derive(Clone, Debug)]
pub struct Elimination {
    /// Index of the coordinate.
    pub coordinate: usize,
    /// Index of the row that determines it.
    pub row: usize,
    /// Its value, in terms of the coordinates kept.
    pub value: CoordinateValue,
    /// The row's coefficient of the coordinate, where it may be small.
    pub pivot: Option<Series>,
    /// Of an angle that might lie on another branch too, where the figure's parameters say which.
    pub branch: Option<AngleBranch>,
}

/// Two angles of which one vanishes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AngleBranch {
    /// The one taken for zero, the nearer to it in the figure.
    pub zero: Angle,
    /// The other.
    pub other: Angle,
}
