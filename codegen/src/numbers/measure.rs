//! One quantity of a model as a number to be checked.

/// Kinds of measures: those of the runtime.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MeasureKind {
    /// A mass.
    Mass,
    /// A length.
    Length,
    /// A length that sets no natural scale.
    Extent,
    /// The distance of a section from an end of its bar.
    Margin,
    /// A moment of inertia.
    Inertia,
    /// A component of gravity.
    Gravity,
    /// Force per length.
    Stiffness,
    /// Torque per angle.
    TorsionalStiffness,
    /// Force per speed or torque per angular speed.
    Damping,
    /// What settled the sign of a coordinate.
    Sign,
    /// What settled the side of a support.
    Side,
    /// What settled the direction of a bar.
    Direction,
    /// What settled the branch of a closed form.
    Branch,
}

/// One measure.
#[derive(Clone, Debug)]
pub struct Measure {
    /// What it belongs to.
    pub of: String,
    /// Its kind.
    pub kind: MeasureKind,
    /// Its value.
    pub value: MeasureValue,
}

/// What a measure is of the numbers.
#[derive(Clone, Debug)]
pub enum MeasureValue {
    /// One of them.
    Number(usize),
    /// One over another.
    Quotient(usize, usize),
    /// How far the other angle is from zero in the figure, less how far the first is.
    Branch([Turned; 2]),
}

/// An angle of the figure: a number plus multiples of coordinates.
#[derive(Clone, Debug)]
pub struct Turned {
    /// The number.
    pub constant: usize,
    /// Coordinates and their multipliers.
    pub terms: Vec<(usize, i16)>,
}
