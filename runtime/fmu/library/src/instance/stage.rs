//! The states of an instance, as FMI has them.

/// A state of an instance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    Instantiated,
    Initialization,
    Event,
    Step,
    Continuous,
    Terminated,
}

impl Stage {
    /// Refuses calls that are not for this state.
    pub(crate) fn must_be(self, allowed: &[Self]) -> Result<(), String> {
        if allowed.contains(&self) {
            return Ok(());
        }
        let allowed: Vec<&str> = allowed.iter().map(|stage| stage.name()).collect();
        Err(format!("this call is for {}, not for {}", allowed.join(" or "), self.name()))
    }

    fn name(self) -> &'static str {
        match self {
            Self::Instantiated => "what is instantiated",
            Self::Initialization => "initialization mode",
            Self::Event => "event mode",
            Self::Step => "step mode",
            Self::Continuous => "continuous-time mode",
            Self::Terminated => "what is terminated",
        }
    }
}
