//! Equations and the drawing of a model.

use crate::errors::{invalid, request};
use liftoff_studio::equations;
use liftoff_studio::explain::{Drawings, latex as document, latex_display, page, part};
use liftoff_studio::picture::{clearest_pose, drawing};
use liftoff_studio::registry::Entry;
use liftoff_studio::run_spec::RunSpec;
use pyo3::prelude::*;

/// The equations in a format.
pub fn explained<'py>(py: Python<'py>, entry: &Entry, format: &str) -> PyResult<Bound<'py, PyAny>> {
    let equations = || equations(entry.layout());
    match format {
        "text" => Ok(py.detach(|| equations().to_string()).into_pyobject(py)?.into_any()),
        "latex" => Ok(py.detach(|| document(&equations())).into_pyobject(py)?.into_any()),
        "html" => {
            let drawings = Drawings { model: drawn(entry, &entry.default_run(), false).ok(), modes: None };
            crate::pictures::html(py, py.detach(|| page(&equations(), &drawings)))
        }
        other => Err(invalid(format!("format: `{other}`; known: text, latex, html"))),
    }
}

/// The drawing, at the start of a run or where it is clearest.
pub fn drawn(entry: &Entry, spec: &RunSpec, at_start: bool) -> PyResult<String> {
    let configuration = if at_start { entry.configuration(spec) } else { clearest_pose(entry, spec) };
    Ok(drawing(&configuration.map_err(|error| request(&error))?))
}

/// The equations as a notebook sets LaTeX.
pub fn latex(entry: &Entry) -> String {
    latex_display(&equations(entry.layout()))
}

/// The drawing and the equations as a part of a page.
pub fn html(entry: &Entry, drawing: Option<&str>) -> String {
    format!("<div>{}\n{}</div>", drawing.unwrap_or_default(), part(&equations(entry.layout())))
}
