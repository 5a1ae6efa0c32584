//! Equations, conditions and the drawing of a model.

use crate::errors::{AnalysisError, invalid, request};
use crate::options::Options;
use crate::request::pose;
use crate::values::named;
use liftoff_studio::equations;
use liftoff_studio::explain::{Drawings, conditions, export, latex as document, latex_display, page, part};
use liftoff_studio::picture::{clearest_pose, drawing};
use liftoff_studio::registry::{Entry, Place};
use liftoff_studio::run_spec::RunSpec;
use pyo3::prelude::*;
use pyo3::types::IntoPyDict;

/// A text for people, in which formulas are set.
enum Format {
    Text,
    Latex,
    Html,
}

impl Format {
    fn parse(text: &str) -> PyResult<Self> {
        match text {
            "text" => Ok(Self::Text),
            "latex" => Ok(Self::Latex),
            "html" => Ok(Self::Html),
            other => Err(invalid(format!("format: `{other}`; known: text, latex, html"))),
        }
    }

    fn show(self, py: Python<'_>, text: String) -> PyResult<Bound<'_, PyAny>> {
        match self {
            Self::Html => crate::pictures::html(py, text),
            _ => Ok(text.into_pyobject(py)?.into_any()),
        }
    }
}

/// The equations in a format.
pub fn explained<'py>(py: Python<'py>, entry: &Entry, format: &str) -> PyResult<Bound<'py, PyAny>> {
    let (format, equations) = (Format::parse(format)?, || equations(entry.layout()));
    let text = py.detach(|| match format {
        Format::Text => equations().to_string(),
        Format::Latex => document(&equations()),
        Format::Html => {
            let drawings = Drawings { model: drawn(entry, &entry.default_run(), false).ok(), modes: None };
            page(&equations(), &drawings)
        }
    });
    format.show(py, text)
}

/// When reactions vanish and what stays constant, in a format.
pub fn conditions<'py>(
    py: Python<'py>,
    entry: &Entry,
    phase: Option<&str>,
    start: Option<&Bound<'py, PyAny>>,
    mut options: Options<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let layout = entry.layout();
    let format = options.take("format")?.map_or(Ok("text".to_owned()), |given| given.extract::<String>())?;
    let format = Format::parse(&format)?;
    let parameters = pose(entry, None, &mut options)?.parameters;
    options.finish()?;
    // Without a start the motion starts at rest anywhere.
    let start = start.map_or(Ok(Vec::new()), |start| named(Place::Start, layout, start))?;
    let text = py.detach(|| {
        let sections = conditions::conditions(layout, phase, &conditions::Request { start, parameters })?;
        Ok(match format {
            Format::Text => conditions::text(layout.name, &sections),
            Format::Latex => conditions::latex(layout.name, &sections),
            Format::Html => conditions::page(layout.name, &sections),
        })
    });
    format.show(py, text.map_err(|error: String| invalid(error))?)
}

/// The equations as source text for other programs: a module of Python, or the files of a library
/// of C.
pub fn exported<'py>(py: Python<'py>, entry: &Entry, target: &str) -> PyResult<Bound<'py, PyAny>> {
    let layout = entry.layout();
    match target {
        "sympy" => {
            let text = py.detach(|| export::sympy(layout)).map_err(AnalysisError::new_err)?;
            Ok(text.into_pyobject(py)?.into_any())
        }
        "c" => {
            let files = py.detach(|| export::c(layout)).map_err(AnalysisError::new_err)?;
            Ok(files.into_iter().map(|file| (file.name, file.text)).into_py_dict(py)?.into_any())
        }
        other => Err(invalid(format!("target: `{other}`; known: sympy, c"))),
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
