//! Physical quantities of a model.

/// A physical quantity of a model, to be checked and to derive its natural scales from.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// What it belongs to: `bar AD`, `mass at P`, `gravity`, `spring AB`.
    pub of: &'static str,
    /// Its kind, which says what values are admissible.
    pub kind: MeasureKind,
    /// Its value.
    pub value: f64,
}

/// Kinds of [`Measure`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MeasureKind {
    /// A mass, ≥ 0.
    Mass,
    /// A length, > 0.
    Length,
    /// A length, > 0, that sets no natural scale: of a thread, a radius.
    Extent,
    /// The distance of a section from an end of its bar, ≥ 0.
    Margin,
    /// A moment of inertia about the centre of mass, ≥ 0.
    Inertia,
    /// A component of gravity, finite.
    Gravity,
    /// Force per length of a spring, ≥ 0.
    Stiffness,
    /// Torque per angle of a torsion spring, ≥ 0.
    TorsionalStiffness,
    /// Force per speed or torque per angular speed of a damper, ≥ 0.
    Damping,
    /// A length of the nominal figure, ≥ 0 where a coordinate has the sign that it was given.
    Sign,
    /// A length of the nominal figure, ≥ 0 where a support has the side that it was given.
    Side,
    /// A length of the nominal figure, ≥ 0 where a bar has the direction that it was given.
    Direction,
    /// An angle in the nominal figure, ≥ 0 where a contact or joint is on the branch of its closed
    /// form.
    Branch,
}
