//! Models by name.

use super::{Entry, Failure, Model};
use crate::model::BarSystem;
use crate::names;
use crate::scene::{Scene, Setup};
use core::marker::PhantomData;

/// Models by name; made by [`models!`](crate::models).
pub struct Models(Vec<Box<dyn Model>>);

impl Models {
    /// These, in this order.
    pub fn new(models: Vec<Box<dyn Model>>) -> Self {
        Self(models)
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &dyn Model> {
        self.0.iter().map(AsRef::as_ref)
    }

    /// The model of this name.
    ///
    /// # Errors
    /// There is none; the nearest is told.
    pub fn find(&self, name: &str) -> Result<&dyn Model, Failure> {
        let known = self.iter().map(Model::name);
        let unknown = || Failure::Input(names::unknown("model", name, known).to_string());
        self.iter().find(|model| model.name() == name).ok_or_else(unknown)
    }
}

/// [`Models`](crate::catalog::Models) of these types: each derives `BarSystem`. Where it implements
/// [`Scene`](crate::scene::Scene) too, its default run is known; where it does not, every run says its parameters.
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
/// let models = liftoff::models![SwingingBar];
/// assert_eq!(models.find("swinging-bar")?.summary(), "A bar that swings.");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[macro_export]
macro_rules! models {
    [$($model:ty),* $(,)?] => {{
        #[allow(unused_imports)] // A list may have models of one kind only, or none.
        use $crate::catalog::{Bare as _, Staged as _};
        $crate::catalog::Models::new(::std::vec![$((&$crate::catalog::Kind::<$model>::new()).entry()),*])
    }};
}

/// A type, to tell whether it is a [`Scene`].
#[doc(hidden)]
pub struct Kind<M>(PhantomData<M>);

impl<M> Kind<M> {
    #[expect(clippy::new_without_default, reason = "made by a macro only")]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// Found first by method resolution: models with a run worth seeing.
#[doc(hidden)]
pub trait Staged {
    fn entry(&self) -> Box<dyn Model>;
}

impl<M: Scene> Staged for Kind<M> {
    fn entry(&self) -> Box<dyn Model> {
        Box::new(Entry::<M>::new(M::setup()))
    }
}

/// Found where [`Staged`] is not: models without one.
#[doc(hidden)]
pub trait Bare {
    fn entry(&self) -> Box<dyn Model>;
}

impl<M: BarSystem> Bare for &Kind<M> {
    fn entry(&self) -> Box<dyn Model> {
        Box::new(Entry::<M>::new(Setup::default()))
    }
}
