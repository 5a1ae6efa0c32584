//! Which methods of integration a program has: those that its phases name, each for the sizes of
//! these phases alone.
//!
//! All capacities are compiled here, once. A compiled phase knows its size, so that it names one of
//! the tables below while it is compiled, and the linker leaves out the others. What learns sizes
//! at run time has them all.

use super::{InitialValueProblem, PhaseStepper, sized};

/// Starts an integration; none where the tolerance is invalid or the method does not serve the
/// phase.
pub type StartStepper = for<'a> fn(&InitialValueProblem<'a>) -> Option<Box<dyn PhaseStepper + 'a>>;

/// Explicit methods for phases of one capacity.
#[derive(Debug)]
pub struct ExplicitMethods {
    /// Dormand and Prince's method of order 8.
    pub dop853: StartStepper,
    /// Tsitouras's pair of order 5.
    pub tsit5: StartStepper,
    /// Taylor's method; none where the phase has no series.
    pub taylor: StartStepper,
}

impl ExplicitMethods {
    const fn with_capacity<const N: usize>() -> Self {
        Self { dop853: sized::dop853::<N>, tsit5: sized::tsit5::<N>, taylor: sized::taylor::<N> }
    }
}

/// The methods that a phase names.
#[derive(Clone, Copy, Debug, Default)]
pub struct Methods {
    /// None beyond 8192 entries.
    pub explicit: Option<&'static ExplicitMethods>,
    /// Radau's method where the equations can be stiff; none beyond 64 entries.
    pub implicit: Option<&'static StartStepper>,
}

impl Methods {
    /// Those for phases of so many entries.
    pub const fn for_entries(entries: usize, can_be_stiff: bool) -> Self {
        Self { explicit: explicit(entries), implicit: if can_be_stiff { radau(entries) } else { None } }
    }
}

/// Declares a table for each capacity, and the function that finds the least capacity for so many
/// entries.
macro_rules! capacities {
    ($(#[$meta:meta])* $find:ident -> $table:ty: $($capacity:ident = $value:expr, $size:literal;)*) => {
        $(static $capacity: $table = $value;)*

        $(#[$meta])*
        pub const fn $find(entries: usize) -> Option<&'static $table> {
            match entries {
                $(..=$size => Some(&$capacity),)*
                _ => None,
            }
        }
    };
}

// Loops of small systems are unrolled, so that these have nearly their own size.
capacities! {
    /// Explicit methods for phases of so many entries.
    explicit -> ExplicitMethods:
    EXPLICIT_2 = ExplicitMethods::with_capacity::<2>(), 2;
    EXPLICIT_4 = ExplicitMethods::with_capacity::<4>(), 4;
    EXPLICIT_6 = ExplicitMethods::with_capacity::<6>(), 6;
    EXPLICIT_8 = ExplicitMethods::with_capacity::<8>(), 8;
    EXPLICIT_12 = ExplicitMethods::with_capacity::<12>(), 12;
    EXPLICIT_16 = ExplicitMethods::with_capacity::<16>(), 16;
    EXPLICIT_32 = ExplicitMethods::with_capacity::<32>(), 32;
    EXPLICIT_64 = ExplicitMethods::with_capacity::<64>(), 64;
    EXPLICIT_128 = ExplicitMethods::with_capacity::<128>(), 128;
    EXPLICIT_1024 = ExplicitMethods::with_capacity::<1024>(), 1024;
    EXPLICIT_8192 = ExplicitMethods::with_capacity::<8192>(), 8192;
}

// Its matrices lie in place.
capacities! {
    /// Radau's method for phases of so many entries.
    radau -> StartStepper:
    RADAU_2 = sized::radau::<2>, 2;
    RADAU_4 = sized::radau::<4>, 4;
    RADAU_6 = sized::radau::<6>, 6;
    RADAU_8 = sized::radau::<8>, 8;
    RADAU_12 = sized::radau::<12>, 12;
    RADAU_16 = sized::radau::<16>, 16;
    RADAU_32 = sized::radau::<32>, 32;
    RADAU_64 = sized::radau::<64>, 64;
}

capacities! {
    /// Gauss's method for phases of so many entries.
    gauss -> StartStepper:
    GAUSS_2 = sized::gauss::<2>, 2;
    GAUSS_4 = sized::gauss::<4>, 4;
    GAUSS_8 = sized::gauss::<8>, 8;
    GAUSS_16 = sized::gauss::<16>, 16;
    GAUSS_32 = sized::gauss::<32>, 32;
    GAUSS_64 = sized::gauss::<64>, 64;
    GAUSS_128 = sized::gauss::<128>, 128;
    GAUSS_1024 = sized::gauss::<1024>, 1024;
}
