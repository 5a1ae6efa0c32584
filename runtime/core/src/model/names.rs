//! A model's names as typed constants: derived code gives a model `Ladder::PHI`, `Ladder::A`,
//! beside which strings keep working.
//!
//! What takes a name takes anything of one of the traits here, so that a name of the wrong kind
//! does not compile:
//!
//! ```
//! use liftoff_core::model::names::{Coordinate, CoordinateName, Place, PointName};
//!
//! const PHI: Coordinate = Coordinate::new("phi", "phi'");
//! const A: Place = Place::new("A");
//!
//! fn given(coordinate: impl CoordinateName) -> usize {
//!     coordinate.as_ref().len()
//! }
//! fn struck(point: impl PointName) -> usize {
//!     point.as_ref().len()
//! }
//!
//! assert_eq!((given(PHI), given("phi"), given(&String::from("phi"))), (3, 3, 3));
//! assert_eq!((given(PHI.rate()), given("phi'")), (4, 4));
//! assert_eq!((struck(A), struck("A")), (1, 1));
//! assert_eq!(format!("N({A}) * sin({PHI})"), "N(A) * sin(phi)");
//! ```
//!
//! ```compile_fail,E0277
//! use liftoff_core::model::names::{CoordinateName, Place};
//!
//! fn given(_: impl CoordinateName) {}
//! given(Place::new("A"));
//! ```

use core::fmt;

macro_rules! kinds {
    ($($(#[$meaning:meta])* $kind:ident: $($role:ident),*;)*) => {$(
        $(#[$meaning])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $kind(&'static str);

        impl $kind {
            /// What the model declares under this name; called by derived code.
            pub const fn new(name: &'static str) -> Self {
                Self(name)
            }

            /// The name as in the declaration.
            pub const fn as_str(self) -> &'static str {
                self.0
            }
        }

        text!($kind);
        $(impl $role for $kind {})*
    )*};
}

macro_rules! text {
    ($kind:ident) => {
        impl AsRef<str> for $kind {
            fn as_ref(&self) -> &str {
                self.as_str()
            }
        }

        impl fmt::Display for $kind {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.pad(self.as_str())
            }
        }

        impl From<$kind> for &'static str {
            fn from(name: $kind) -> Self {
                name.as_str()
            }
        }

        #[cfg(feature = "std")]
        impl From<$kind> for String {
            fn from(name: $kind) -> Self {
                name.as_str().into()
            }
        }

        impl PartialEq<str> for $kind {
            fn eq(&self, other: &str) -> bool {
                self.as_str() == other
            }
        }

        impl PartialEq<&str> for $kind {
            fn eq(&self, other: &&str) -> bool {
                self.as_str() == *other
            }
        }

        impl PartialEq<$kind> for &str {
            fn eq(&self, other: &$kind) -> bool {
                *self == other.as_str()
            }
        }
    };
}

macro_rules! roles {
    ($($(#[$meaning:meta])* $role:ident;)*) => {$(
        $(#[$meaning])*
        pub trait $role: AsRef<str> {}

        impl<T: $role + ?Sized> $role for &T {}
        impl $role for str {}
        #[cfg(feature = "std")]
        impl $role for String {}
        #[cfg(feature = "std")]
        impl $role for std::borrow::Cow<'_, str> {}
    )*};
}

roles! {
    /// What names a generalised coordinate or a rate.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` does not name a coordinate",
        label = "not the name of a coordinate or a rate",
        note = "a coordinate is named by the model's constant, `Ladder::PHI`, a rate by `Ladder::PHI.rate()`, both by strings"
    )]
    CoordinateName;
    /// What names a one-sided contact: a support or a thread.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` does not name a support or thread",
        label = "not the name of a support or thread",
        note = "a support is named by the model's constant, `Ladder::A`, or by a string"
    )]
    ContactName;
    /// What names a thread.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` does not name a thread",
        label = "not the name of a thread",
        note = "a thread is named by the model's constant, `Mobile::ROPE`, or by a string"
    )]
    ThreadName;
    /// What names a point.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` does not name a point",
        label = "not the name of a point",
        note = "a point is named by the model's constant, `Ladder::A`, or by a string"
    )]
    PointName;
}

/// Which contacts are meant: one by its name, or all with `None`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not name a support or thread",
    label = "neither the name of a support or thread nor `None`",
    note = "a support is named by the model's constant, `Ladder::A`, or by a string; `None` stands for all"
)]
pub trait ContactFilter {
    /// The name; none for all.
    fn contact(&self) -> Option<&str>;
}

impl<T: ContactName> ContactFilter for T {
    fn contact(&self) -> Option<&str> {
        Some(self.as_ref())
    }
}

impl ContactFilter for Option<&str> {
    fn contact(&self) -> Option<&str> {
        *self
    }
}

kinds! {
    /// Name of the rate of a generalised coordinate, with a prime: `phi'`.
    Rate: CoordinateName;
    /// Name of a support.
    Support: ContactName;
    /// Name of a point.
    Point: PointName;
    /// Name of both a point and a support.
    Place: PointName, ContactName;
    /// Name of a thread.
    Thread: ContactName, ThreadName;
    /// Name of a bar, body, spring or section, for expressions.
    Part:;
    /// Name in a declaration with mistakes, of which the kind is not known: no second mistake
    /// wherever it stands.
    #[doc(hidden)]
    Unknown: CoordinateName, ContactName, ThreadName, PointName;
}

/// Name of a generalised coordinate.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Coordinate {
    name: &'static str,
    rate: &'static str,
}

impl Coordinate {
    /// A coordinate and its rate, which has the same name with a prime; called by derived code.
    pub const fn new(name: &'static str, rate: &'static str) -> Self {
        Self { name, rate }
    }

    /// The name as in the declaration.
    pub const fn as_str(self) -> &'static str {
        self.name
    }

    /// The name of its rate, `phi'`.
    pub const fn rate(self) -> Rate {
        Rate(self.rate)
    }
}

text!(Coordinate);
impl CoordinateName for Coordinate {}

#[doc(hidden)]
impl Unknown {
    pub const fn rate(self) -> Self {
        self
    }
}

#[cfg(test)]
mod tests;
