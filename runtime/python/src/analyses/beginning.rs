//! The run that a search begins with.

use crate::errors;
use crate::interrupt::watched;
use crate::options::Options;
use crate::request::Request;
use liftoff_studio::analyses::Failure;
use liftoff_studio::registry::{Entry, RunOptions};
use liftoff_studio::run_spec::RunSpec;
use pyo3::prelude::*;
use std::sync::Arc;

/// The run that a search begins with.
pub struct Beginning {
    pub request: Request,
    /// Whether an end is given.
    pub has_until: bool,
    /// The latest end, where one is given.
    pub limit: Option<f64>,
}

impl Beginning {
    /// Of the arguments of a call.
    pub fn from_options(
        entry: &Entry,
        start: Option<&Bound<'_, PyAny>>,
        options: &mut Options<'_>,
    ) -> PyResult<Self> {
        let until = options.take("until")?;
        let request = Request::from_options(entry, start, until.as_ref(), options)?;
        let limit = options.take("limit")?.and(request.spec.limit);
        Ok(Self { request, has_until: until.is_some(), limit })
    }

    /// Does a work with it without the interpreter; Ctrl-C stops its runs.
    pub fn search<T: Send>(
        self,
        py: Python<'_>,
        work: impl FnOnce((RunOptions, RunSpec)) -> Result<T, Failure> + Send,
    ) -> PyResult<T> {
        let Request { spec, method } = self.request;
        let found = watched(py, |stop| work((RunOptions::by(method).cancel(Arc::clone(stop)), spec)))?;
        found.map_err(errors::analysis)
    }
}
