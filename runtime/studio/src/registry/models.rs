//! Models by name.

use super::{Entry, MotionError};
use liftoff::NameError;

/// Models by name; made by [`models!`](crate::models).
pub struct Models(Vec<Entry>);

impl Models {
    /// These, in this order.
    pub fn new(entries: Vec<Entry>) -> Self {
        Self(entries)
    }

    /// These with others, which come first and hide those of the same name.
    #[must_use]
    pub fn with(&self, others: Vec<Entry>) -> Self {
        let hidden = |model: &&Entry| others.iter().any(|other| other.name() == model.name());
        let known: Vec<Entry> = self.iter().filter(|model| !hidden(model)).cloned().collect();
        Self(others.into_iter().chain(known).collect())
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &Entry> {
        self.0.iter()
    }

    /// The model of this name.
    ///
    /// # Errors
    /// No such model; the error suggests the nearest name, or a model whose summary has this one:
    /// `fig-1a` of "(Fig. 1a)".
    pub fn find(&self, name: &str) -> Result<&Entry, MotionError> {
        let plain = |text: &str| text.to_lowercase().replace(|c: char| !c.is_alphanumeric(), "");
        let unknown = || {
            let mut error = NameError::new("model", name, self.iter().map(Entry::name));
            let is_told = |model: &&Entry| plain(model.summary()).contains(&plain(name));
            let told = || self.iter().find(is_told).filter(|_| plain(name).len() > 3);
            error.nearest = error.nearest.or_else(|| told().map(|model| model.name().to_owned()));
            MotionError::Input(error.to_string())
        };
        self.iter().find(|model| model.name() == name).ok_or_else(unknown)
    }
}

/// [`Models`](crate::registry::Models) of these types: each derives `BarSystem`. Where it
/// implements [`DefaultRun`](crate::run_spec::DefaultRun) too, its default run is known; where it
/// does not, every run says its parameters.
///
/// ```
/// use liftoff::prelude::*;
///
/// /// A bar that swings.
/// #[derive(BarSystem)]
/// #[gravity(g)]
/// #[bar(OA, mass = m, length = l)]
/// #[pin(O = (0, 0))]
/// #[figure(A = (0, -l))]
/// #[coordinate(phi = angle(OA), from = down)]
/// struct SwingingBar {
///     m: f64,
///     l: f64,
///     g: f64,
/// }
///
/// let models = liftoff_studio::models![SwingingBar];
/// assert_eq!(models.find("swinging-bar")?.summary(), "A bar that swings.");
/// let unknown = models.find("that-swings").err().map(|error| error.to_string());
/// assert_eq!(unknown.as_deref(), Some("no model `that-swings`; did you mean `swinging-bar`?"));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[macro_export]
macro_rules! models {
    [$($model:ty),* $(,)?] => {{
        #[allow(unused_imports)] // A list may have models of one kind only, or none.
        use $crate::registry::{Bare as _, WithDefaultRun as _};
        $crate::registry::Models::new(::std::vec![$((&$crate::registry::Kind::<$model>::new()).entry()),*])
    }};
}
