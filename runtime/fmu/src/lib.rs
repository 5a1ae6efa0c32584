//! Models as functional mock-up units of FMI 3.0: an archive of a description in XML, the model's
//! declaration, and one shared library, the same for every model, which derives the equations of
//! that declaration when it is instantiated.
//!
//! - `interface`: the variables that importers see, by value reference; `guards`: event indicators;
//!   `contact_state`: how a contact stands, as an enumeration.
//! - `description`: `modelDescription.xml`.
//! - `resources`: what the library reads in the unpacked unit, and the token that tells whether
//!   both belong together.
//! - `package`: the archive; `platform`: where the library lies in it. `error`: why there is none.

mod contact_state;
mod description;
mod error;
mod guards;
mod interface;
mod package;
mod platform;
mod resources;
#[cfg(test)]
mod tests;

pub use contact_state::ContactState;
pub use description::ERRORS;
pub use error::FmuError;
pub use guards::{Guard, exchange_lacks};
pub use interface::{Interface, Quantity, Variable};
pub use package::write;
pub use platform::{LIBRARY, library_beside_program};
pub use resources::Resources;
