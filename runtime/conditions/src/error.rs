//! Why a contact set has no conditions in closed form.

/// What a contact set, or what is asked of it, has that a condition in closed form cannot have.
#[derive(thiserror::Error, Clone, Debug, PartialEq, Eq)]
pub enum ConditionError {
    /// No such contact set has a closed form.
    #[error("no contact set `{asked}` in closed form; there are: {known}")]
    Phase {
        /// What was asked for.
        asked: String,
        /// All that there are.
        known: String,
    },
    /// Not one degree of freedom.
    #[error(
        "{phase}: degrees of freedom: {freedom} ({coordinates}); an energy level determines the motion of a single coordinate"
    )]
    Freedom {
        /// The contact set.
        phase: String,
        /// How many.
        freedom: usize,
        /// The coordinates.
        coordinates: String,
    },
    /// No degree of freedom.
    #[error("{phase}: nothing moves")]
    Fixed {
        /// The contact set.
        phase: String,
    },
    /// The start names a coordinate that the contact set does not have.
    #[error("{phase}: the motion is that of `{coordinate}`; there is no start `{asked}`")]
    Start {
        /// The contact set.
        phase: String,
        /// Its coordinate.
        coordinate: String,
        /// What was given.
        asked: String,
    },
    /// No contact bears.
    #[error("{phase}: no one-sided contact is closed, hence no reaction vanishes")]
    NoReaction {
        /// The contact set.
        phase: String,
    },
    /// Contacts that slide with friction.
    #[error("{phase}: the friction of {contacts} takes energy")]
    Friction {
        /// The contact set.
        phase: String,
        /// The contacts.
        contacts: String,
    },
    /// Motions or loads that depend on time.
    #[error("{phase}: {what} depends on time, and the energy with it")]
    Time {
        /// The contact set.
        phase: String,
        /// What does.
        what: String,
    },
    /// Loads without a potential.
    #[error("{phase}: no potential has the force of {what}")]
    Dissipation {
        /// The contact set.
        phase: String,
        /// What damps or drives.
        what: String,
    },
    /// A load that acts on a condition.
    #[error("{phase}: {what} acts on a condition only")]
    Switch {
        /// The contact set.
        phase: String,
        /// What does.
        what: String,
    },
    /// A length of a spring, or another root.
    #[error("{phase}: `{what}` is no rational function of the coordinate's sine and cosine")]
    Root {
        /// The contact set.
        phase: String,
        /// What it is called.
        what: String,
    },
    /// A coordinate beside its own sine or cosine: torsion springs.
    #[error(
        "{phase}: `{coordinate}` occurs together with its own sine or cosine: the condition is not a polynomial"
    )]
    Transcendental {
        /// The contact set.
        phase: String,
        /// The coordinate.
        coordinate: String,
    },
    /// The energy of the start is not finite, or numbers overflow.
    #[error("{phase}: the energy at this start is not finite, or its coefficients are too long")]
    Overflow {
        /// The contact set.
        phase: String,
    },
    /// A parameter without a value.
    #[error("parameter `{name}` is not given")]
    Parameter {
        /// Its name.
        name: String,
    },
    /// A value that is not finite.
    #[error("`{name}` is not finite")]
    NotFinite {
        /// Of what.
        name: String,
    },
    /// No contact set of the model has a closed form, or nothing stays constant in any.
    #[error("no contact set in closed form has a condition or a first integral")]
    Nothing,
}

impl ConditionError {
    /// Whether what was asked for is wrong, and not the contact set.
    pub(crate) fn is_of_request(&self) -> bool {
        matches!(
            self,
            Self::Start { .. } | Self::Parameter { .. } | Self::NotFinite { .. } | Self::Overflow { .. }
        )
    }
}
