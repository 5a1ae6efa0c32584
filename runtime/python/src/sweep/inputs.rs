//! Arrays as NumPy broadcasts them.

use crate::errors::invalid;
use crate::values::numbers;
use liftoff_studio::sweep::{MOST_MEMBERS, Spread, Varied};
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

/// Arrays as NumPy broadcasts them.
pub struct Inputs<'py> {
    pub shape: Vec<usize>,
    pub varied: Vec<Varied>,
    pub arrays: Vec<(String, Bound<'py, PyAny>)>,
}

impl<'py> Inputs<'py> {
    /// Of arrays by their names.
    pub fn from_arrays(py: Python<'py>, given: &[(String, Bound<'py, PyAny>)]) -> PyResult<Self> {
        let numpy = py.import("numpy")?;
        let mut arrays = Vec::new();
        for (name, values) in given {
            arrays.push(numbers(values).map_err(|error| invalid(format!("{name}: {}", error.value(py))))?);
        }
        let shapes: PyResult<Vec<Vec<usize>>> =
            arrays.iter().map(|array| array.getattr("shape")?.extract()).collect();
        let shapes = shapes?;
        let shape = broadcast(&shapes).ok_or_else(|| {
            let told = given.iter().zip(&shapes).map(|((name, _), shape)| format!("{name} {shape:?}"));
            invalid(format!("arrays whose shapes do not agree: {}", told.collect::<Vec<_>>().join(", ")))
        })?;
        let runs = shape.iter().try_fold(1, |product: usize, length| product.checked_mul(*length));
        if runs.is_none_or(|runs| runs > MOST_MEMBERS) {
            return Err(invalid(format!("shape {shape:?}: {MOST_MEMBERS} runs are the most")));
        }
        let mut inputs = Self { shape, varied: Vec::new(), arrays: Vec::new() };
        for ((name, _), array) in given.iter().zip(arrays) {
            let array = numpy.call_method1("broadcast_to", (array, inputs.shape.clone()))?;
            let values = array.cast::<PyArrayDyn<f64>>()?.readonly();
            let spread = Spread::Listed(values.as_array().iter().copied().collect());
            inputs.varied.push(Varied { name: name.clone(), spread, units: Vec::new() });
            inputs.arrays.push((name.clone(), array));
        }
        Ok(inputs)
    }
}

/// The shape that all of these are broadcast to.
fn broadcast(shapes: &[Vec<usize>]) -> Option<Vec<usize>> {
    let dimensions = shapes.iter().map(Vec::len).max().unwrap_or(0);
    let mut shape = vec![1; dimensions];
    for given in shapes {
        for (length, own) in shape.iter_mut().rev().zip(given.iter().rev()) {
            match (*length, *own) {
                (a, b) if a == b || b == 1 => {}
                (1, b) => *length = b,
                _ => return None,
            }
        }
    }
    Some(shape)
}
