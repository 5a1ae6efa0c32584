//! Invalid parameters.

use thiserror::Error;

use super::OutputError;

/// Parameters that describe no mechanical system.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The condition on which a contact, a spring or a load is there.
    #[error("the condition `while` of {of}: {source}")]
    Switch {
        /// Its label.
        of: String,
        /// What is wrong with it.
        source: OutputError,
    },
    /// The condition on which a contact breaks.
    #[error("the condition `breaks` of {of}: {source}")]
    Break {
        /// Its label.
        of: String,
        /// What is wrong with it.
        source: OutputError,
    },
    /// The condition on which a contact, a spring or a load is there reads a force that depends on
    /// whether it is.
    #[error(
        "the condition `while` of {of} reads a reaction, friction or the force of a joint, which are decided after it; use the motion or the time; \
         what lets go for good `breaks`"
    )]
    SwitchedByForce {
        /// Its label.
        of: String,
    },
    /// A parameter is infinite or not a number.
    #[error("parameter `{name}` is {value}")]
    Parameter {
        /// The parameter.
        name: String,
        /// Its value.
        value: f64,
    },
    /// A mass, length, inertia or gravity is infinite or not a number.
    #[error("{of} is {value}")]
    NotFinite {
        /// What is measured.
        of: String,
        /// Its value.
        value: f64,
    },
    /// A mass is negative.
    #[error("mass of {of} is negative: {value}")]
    NegativeMass {
        /// The body.
        of: String,
        /// Its mass.
        value: f64,
    },
    /// A moment of inertia is negative.
    #[error("moment of inertia of {of} is negative: {value}")]
    NegativeInertia {
        /// The body.
        of: String,
        /// Its moment of inertia.
        value: f64,
    },
    /// A length is not positive.
    #[error("{of} is {value}; it must be positive")]
    Length {
        /// The bar.
        of: String,
        /// Its length.
        value: f64,
    },
    /// A length or a moment of inertia is lost beside the largest, so that contacts and joints
    /// cannot be told.
    #[error("{of}, {value:e}, is below the roundoff of {beside:e}: contacts and joints cannot be resolved")]
    Spread {
        /// What is measured.
        of: String,
        /// Its value.
        value: f64,
        /// The largest of its kind, or the mass at the natural length.
        beside: f64,
    },
    /// A section lies beyond an end of its bar.
    #[error("{of} lies beyond the end of its bar by {beyond}")]
    OffBar {
        /// The section.
        of: String,
        /// How far, > 0.
        beyond: f64,
    },
    /// The figure gives a coordinate no number.
    #[error(
        "the figure gives `{coordinate}` no number with {parameters}: its bars do not reach, or a root in it is of less than zero; change \
         lengths until the figure can be drawn"
    )]
    Figure {
        /// The coordinate.
        coordinate: String,
        /// The parameters, `r = 2, l = 1`.
        parameters: String,
    },
    /// With these parameters the figure gives a coordinate another sign, or another end of its
    /// line, than was settled when the model was compiled.
    #[error(
        "with these parameters `{coordinate}` is not between 0 and 90° in the figure, by {by}; declare it from a direction: \
         `from = right`, `up`, `left` or `down`"
    )]
    Sign {
        /// The coordinate.
        coordinate: String,
        /// How far the bar's end lies beyond the quadrant, > 0.
        by: f64,
    },
    /// With these parameters the figure is on the other side of a support than was settled when the
    /// model was compiled.
    #[error(
        "with these parameters the figure is on the other side of support {support}, by {by}; declare the side or change the \
         figure"
    )]
    Side {
        /// The support.
        support: String,
        /// How far it is on the other side, > 0.
        by: f64,
    },
    /// With these parameters the figure turns a bar otherwise than was settled when the model was
    /// compiled.
    #[error("with these parameters the figure turns {of} the other way, by {by}; declare the angle")]
    Direction {
        /// The bar, or two that are welded.
        of: String,
        /// How far its end lies on the other side, > 0.
        by: f64,
    },
    /// With these parameters the figure is nearer to another solution of a contact or joint than
    /// that of its closed form.
    #[error(
        "with these parameters the figure is nearer to another branch of {of}, by {by} rad; change the figure"
    )]
    Branch {
        /// The contact or joint.
        of: String,
        /// How much nearer, > 0.
        by: f64,
    },
    /// A distance that is driven is not above zero at t = 0.
    #[error(
        "`drive({drive} = …)` prescribes {value} at t = 0: a distance is above zero; change the parameters, or drive a coordinate or \
         `along(POINT, BAR)`, which have a sign"
    )]
    DrivenDistance {
        /// What is driven, `distance(A, B)`.
        drive: String,
        /// Its value.
        value: f64,
    },
    /// A coefficient of friction is negative.
    #[error("friction of {contact} is {value}: a coefficient of friction is a number ≥ 0")]
    NegativeFriction {
        /// The contact.
        contact: String,
        /// Its coefficient of friction.
        value: f64,
    },
    /// The coefficient of static friction is below that of sliding at v = 0.
    #[error(
        "static friction {limit} of {contact} is below its sliding friction {kinetic} at v = 0; it must be at least as large"
    )]
    StaticFriction {
        /// The contact.
        contact: String,
        /// μₛ.
        limit: f64,
        /// μ as the slip velocity becomes zero.
        kinetic: f64,
    },
    /// The stiffness of a spring is negative.
    #[error("stiffness of {of} is negative: {value}")]
    NegativeStiffness {
        /// The spring.
        of: String,
        /// Its stiffness.
        value: f64,
    },
    /// The damping of a spring is negative.
    #[error("damping of {of} is negative: {value}")]
    NegativeDamping {
        /// The spring.
        of: String,
        /// Its damping.
        value: f64,
    },
    /// A coefficient of restitution is not between 0 and 1.
    #[error("restitution of {contact} is not between 0 and 1: {value}")]
    Restitution {
        /// The contact.
        contact: String,
        /// Its coefficient.
        value: f64,
    },
    /// Nothing has mass.
    #[error("the total mass is zero")]
    Massless,
}
