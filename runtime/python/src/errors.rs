//! What goes wrong, as exceptions.

use liftoff::OutputError;
use liftoff_studio::analyses::{Failure, VariableError};
use liftoff_studio::registry::MotionError;
use liftoff_studio::source::{Mistake, rendered};
use liftoff_studio::sweep::SweepError;
use pyo3::exceptions::{PyUserWarning, PyValueError};
use pyo3::prelude::*;
use std::ffi::CString;

pyo3::import_exception!(liftoff._errors, AnalysisError);
pyo3::import_exception!(liftoff._errors, DeclarationError);
pyo3::import_exception!(liftoff._errors, RunError);
pyo3::import_exception!(liftoff._errors, UnknownName);

/// An invalid value.
pub fn invalid(text: impl ToString) -> PyErr {
    PyValueError::new_err(text.to_string())
}

/// A name that nothing has.
pub fn unknown(error: &impl ToString) -> PyErr {
    UnknownName::new_err(error.to_string())
}

/// An expression of which nothing can be made.
pub fn expression(error: &OutputError) -> PyErr {
    match error {
        OutputError::Name(_) | OutputError::Centre { .. } => UnknownName::new_err(error.to_string()),
        _ => invalid(error),
    }
}

/// A request of which no motion follows.
pub fn request(error: &MotionError) -> PyErr {
    invalid(error)
}

/// The same with arguments in the place of the options of the command line.
pub fn in_python(text: &str) -> String {
    text.replace("--", "")
}

/// An analysis that gives nothing.
pub fn analysis(failure: Failure) -> PyErr {
    match failure {
        Failure::Name(error) => unknown(&error),
        Failure::Variable(error) => match &error {
            VariableError::Unknown { name, .. } => {
                UnknownName::new_err(format!("{error}; start={{\"{name}\": …}} gives it"))
            }
            _ => invalid(error),
        },
        Failure::Input(text) => invalid(in_python(&text)),
        Failure::NotFound(text) => AnalysisError::new_err(in_python(&text)),
    }
}

/// A sweep that cannot be made.
pub fn sweep(error: &SweepError) -> PyErr {
    match error {
        SweepError::Name(error) => unknown(error),
        _ => invalid(error),
    }
}

/// The mistakes of a declaration, each with the part of the text that it is about.
pub fn declaration(path: &str, text: &str, mistakes: &[Mistake]) -> PyErr {
    let letters = |bytes: usize| text.get(..bytes).map_or(0, |before| before.chars().count());
    let place = |mistake: &Mistake| {
        let [start, end] = [mistake.at.start, mistake.at.end].map(letters);
        (mistake.text.clone(), start, end)
    };
    let places: Vec<(String, usize, usize)> = mistakes.iter().map(place).collect();
    DeclarationError::new_err((rendered(path, text, mistakes, false), places))
}

/// Warns of what changes an answer.
pub fn warn(py: Python<'_>, text: &str) -> PyResult<()> {
    PyErr::warn(py, &py.get_type::<PyUserWarning>(), &CString::new(in_python(text))?, 1)
}
