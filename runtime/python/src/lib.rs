//! The native part of the Python package `liftoff`: models, trajectories and sweeps as Python's objects.
//!
//! - `model`: a declaration that runs; `explain`: its equations and its drawing.
//! - `analyses`: what follows from a model.
//! - `request`, `options`, `values`: what a call asks for, by the names of the model.
//! - `trajectory`: a motion as arrays; `event`: what happened; `pictures`: its chart and its page.
//! - `sweep`: many runs over arrays; `columns`: what was read of them.
//! - `errors`: exceptions; `interrupt`: Ctrl-C while nothing holds the interpreter.

mod analyses;
mod columns;
mod errors;
mod event;
mod explain;
mod interrupt;
mod model;
mod options;
mod pictures;
mod request;
mod sweep;
mod trajectory;
mod values;

/// What runs behind the package `liftoff`.
#[pyo3::pymodule]
mod _liftoff {
    #[pymodule_export]
    use crate::event::Event;
    #[pymodule_export]
    use crate::model::Model;
    #[pymodule_export]
    use crate::trajectory::Trajectory;
    use pyo3::prelude::*;

    /// What the code may take of a processor beside what all of its kind have.
    const FEATURES: [(&str, bool); 3] = [
        ("avx", cfg!(target_feature = "avx")),
        ("avx2", cfg!(target_feature = "avx2")),
        ("fma", cfg!(target_feature = "fma")),
    ];

    #[pymodule_init]
    fn constants(module: &Bound<'_, PyModule>) -> PyResult<()> {
        let used: Vec<&str> = FEATURES.iter().filter(|(_, used)| *used).map(|(name, _)| *name).collect();
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("_processor_features", used)
    }
}
