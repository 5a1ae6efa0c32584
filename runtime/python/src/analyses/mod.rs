//! What follows from a model, as the dataclasses of `_analyses.py`.
//!
//! - `rest`: equilibria and linearised motions.
//! - `beginning`: the run that a search begins with; `orbit`: periodic ones; `sensitivity`:
//!   derivatives; `fit`, `optimum`: what values of parameters and starts are best.

mod beginning;
pub mod fit;
pub mod optimum;
pub mod orbit;
pub mod rest;
pub mod sensitivity;

use liftoff_core::model::Layout;
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray2};
use pyo3::call::PyCallArgs;
use pyo3::prelude::*;

/// An answer: a dataclass with these fields, in their order.
pub fn answer<'py>(
    py: Python<'py>,
    class: &str,
    fields: impl PyCallArgs<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import("liftoff._analyses")?.getattr(class)?.call1(fields)
}

/// A matrix of this shape.
fn matrix(
    py: Python<'_>,
    shape: (usize, usize),
    entry: impl Fn((usize, usize)) -> f64,
) -> Bound<'_, PyArray2<f64>> {
    Array2::from_shape_fn(shape, entry).into_pyarray(py)
}

fn coordinates(layout: &Layout) -> impl Iterator<Item = &'static str> {
    layout.coordinates.iter().map(|coordinate| coordinate.name)
}
