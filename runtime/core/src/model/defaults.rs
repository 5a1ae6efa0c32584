//! What a run takes where nothing else is said.

/// Values of the parameters, and the run, that a declaration gives.
#[derive(Clone, Copy, Debug)]
pub struct Defaults {
    /// Of each parameter; none where the declaration gives none. Empty where it gives none at all.
    pub values: &'static [Option<f64>],
    /// What each is measured in, as written; empty where the declaration does not say.
    pub units: &'static [&'static str],
    /// Coordinates and rates (`phi'`) at the start; the others are those of the nominal figure.
    pub start: &'static [(&'static str, f64)],
    /// Conditions to stop at, whichever comes first.
    pub until: &'static [&'static str],
    /// The latest end.
    pub limit: Option<f64>,
}

impl Defaults {
    /// Of a declaration that says nothing.
    pub const NONE: Self = Self { values: &[], units: &[], start: &[], until: &[], limit: None };

    /// The unit of a parameter.
    pub fn unit(&self, parameter: usize) -> &'static str {
        self.units.get(parameter).copied().unwrap_or_default()
    }
}
