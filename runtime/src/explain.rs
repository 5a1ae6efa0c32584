//! Equations as text, derived again from the declaration that the model carries.

use crate::model::BarSystem;

/// The equations of motion of `M` and of its phases in textbook notation; a stable text, fit for snapshots.
pub fn equations<M: BarSystem>() -> String {
    match M::LAYOUT.declaration.parse() {
        Ok(declaration) => match liftoff_codegen::equations(declaration) {
            Ok(equations) => equations.to_string(),
            Err(mistake) => mistake.to_string(),
        },
        Err(mistake) => mistake.to_string(),
    }
}
