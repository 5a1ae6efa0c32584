//! The accelerations of a pinned chain of [`BARS`] uniform bars as a C function in a shared library; masses and lengths 1,
//! g = 9.81. To time another length, change the number in `chain!`. `liftoff export --c` writes the same as source, which its tests compare.
//!
//! ```text
//! cargo build --release -p liftoff-chain-library
//! python3 tests/chain-library/harness.py target/release/libliftoff_chain.so
//! ```
//!
//! ```python
#![doc = include_str!("../harness.py")]
//! ```

use liftoff::prelude::*;

use liftoff_core::model::{ContactSet, Form, Phase, PhaseVisitor};

/// Declares the chain. Gravity pulls along +x, so that angles from +x are angles from the downward vertical.
macro_rules! chain {
    ($bars:tt) => {
        /// How many bars the chain has.
        pub const BARS: usize = $bars;

        /// Equal bars, the first hinged at O.
        #[derive(BarSystem)]
        #[gravity(g, 0)]
        #[pin(O = (0, 0))]
        #[chain(bar, links = $bars, from = O, mass = m, length = l)]
        pub struct Chain {
            /// Mass of a bar.
            pub m: f64,
            /// Length of a bar.
            pub l: f64,
            /// The acceleration of free fall.
            pub g: f64,
        }
    };
}

chain!(16);

/// Writes the angular accelerations of the bars to `a`: `q` holds their angles from the downward vertical, counter-clockwise,
/// from the pinned bar on, `u` the rates of these.
///
/// # Safety
/// `q` and `u` point to [`BARS`] doubles that can be read, `a` to as many that can be written; `a` may be one of the others.
#[allow(unsafe_code, reason = "a C function takes pointers")]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rhs(q: *const f64, u: *const f64, a: *mut f64) {
    // SAFETY: by the contract above; both are copied before anything is written.
    let [q, u] = [q, u].map(|values| unsafe { values.cast::<[f64; BARS]>().read() });
    let accelerations = <Chain as BarSystem>::phase(ContactSet::EMPTY, Form::Reduced, Accelerations { q, u });
    // SAFETY: by the contract above.
    unsafe { a.cast::<[f64; BARS]>().write(accelerations) }
}

struct Accelerations {
    q: [f64; BARS],
    u: [f64; BARS],
}

impl PhaseVisitor<Chain, f64> for Accelerations {
    type Output = [f64; BARS];

    #[inline]
    fn visit<const N: usize>(self, phase: Phase<Chain, f64, N>) -> [f64; BARS] {
        let state: [f64; N] = core::array::from_fn(|i| if i < BARS { self.q[i] } else { self.u[i - BARS] });
        let constants = Chain { m: 1.0, l: 1.0, g: 9.81 }.constants();
        let rates = (phase.derivative)(&constants, &phase.set, &state);
        core::array::from_fn(|i| rates[BARS + i])
    }
}
