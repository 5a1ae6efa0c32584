//! A declaration that runs.

use crate::errors::{self, RunError};
use crate::interrupt::Watch;
use crate::options::Options;
use crate::request::{Request, pose, spec_arguments};
use crate::trajectory::Trajectory;
use crate::{analyses, explain, sweep};
use liftoff::NameError;
use liftoff_studio::file::read_text;
use liftoff_studio::registry::{Entry, Models, MotionError, RunOptions, kebab, start_notes};
use liftoff_studio::source::{self, declarations};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};
use std::io::Error;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

/// Bytes of a source file.
const LARGEST: u64 = 16 << 20;

/// The models of the command line, from their texts.
static BUILT_IN: LazyLock<Models> =
    LazyLock::new(|| liftoff_systems::with_default_runs(&Models::new(Vec::new())));

/// A planar bar system, declared as in Rust: `Model(text)`, `Model.from_file(path)`, or
/// `Model.built_in(name)`.
///
/// The text is that of a Rust file with a struct that derives `BarSystem`; where it has several,
/// `model` names one.
/// Mistakes in it are raised as `DeclarationError`, with the place of each.
#[pyclass(frozen, module = "liftoff")]
pub struct Model {
    text: String,
    pub entry: Entry,
}

impl Model {
    fn parse(py: Python<'_>, path: &str, text: String, name: Option<&str>) -> PyResult<Self> {
        let entry = chosen(path, declared(py, path, &text)?, name)?;
        Ok(Self { text, entry })
    }

    /// With its default run in its text.
    fn from_built_in(entry: &Entry) -> Self {
        let found = entry.source().and_then(|text| declarations(text).ok()?.pop());
        let text = found.map_or_else(String::new, |found| found.with_run(&entry.default_run()));
        Self { text, entry: entry.clone() }
    }
}

#[pymethods]
impl Model {
    #[new]
    #[pyo3(signature = (text, model=None))]
    fn new(py: Python<'_>, text: String, model: Option<&str>) -> PyResult<Self> {
        Self::parse(py, "text", text, model)
    }

    /// The model that a file declares; where it has several, `model` names one.
    #[classmethod]
    #[pyo3(signature = (path, model=None))]
    fn from_file(class: &Bound<'_, PyType>, path: PathBuf, model: Option<&str>) -> PyResult<Self> {
        Self::parse(class.py(), &path.display().to_string(), file_text(&path)?, model)
    }

    /// All models that a file declares.
    #[classmethod]
    #[pyo3(signature = (path))]
    fn list_file(class: &Bound<'_, PyType>, path: PathBuf) -> PyResult<Vec<Self>> {
        let text = file_text(&path)?;
        let found = declared(class.py(), &path.display().to_string(), &text)?;
        Ok(found.into_iter().map(|entry| Self { text: text.clone(), entry }).collect())
    }

    /// The model that the command line runs by this name, `"zigzag"`, with its default run.
    #[classmethod]
    #[pyo3(signature = (name))]
    fn built_in(_class: &Bound<'_, PyType>, name: &str) -> PyResult<Self> {
        BUILT_IN.find(&kebab(name)).map(Self::from_built_in).map_err(|error| errors::unknown(&error))
    }

    /// Names of the models that `built_in` takes.
    #[classmethod]
    fn list_built_in(_class: &Bound<'_, PyType>) -> Vec<&'static str> {
        BUILT_IN.iter().map(Entry::name).collect()
    }

    /// The text that declares it.
    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    /// Name of the struct that declares it.
    #[getter]
    fn name(&self) -> &'static str {
        self.entry.layout().name
    }

    /// The first paragraph of its documentation.
    #[getter]
    fn summary(&self) -> &'static str {
        self.entry.summary()
    }

    /// Names of the parameters.
    #[getter]
    fn parameters(&self) -> Vec<&'static str> {
        self.entry.layout().parameters.to_vec()
    }

    /// Names of the coordinates; that of a rate has a prime behind it, `phi'`.
    #[getter]
    fn coordinates(&self) -> Vec<&'static str> {
        self.entry.layout().coordinates.iter().map(|coordinate| coordinate.name).collect()
    }

    /// Names of the supports and threads.
    #[getter]
    fn supports(&self) -> Vec<&'static str> {
        self.entry.layout().contacts.iter().flat_map(|contact| contact.supports.iter().copied()).collect()
    }

    /// Names of the points.
    #[getter]
    fn points(&self) -> Vec<&'static str> {
        self.entry.layout().points.to_vec()
    }

    /// What a run takes where nothing else is said, as arguments of `simulate`.
    #[getter]
    fn defaults<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        spec_arguments(py, &self.entry.default_run())
    }

    /// Computes a motion up to the event that ends it, without holding the interpreter; Ctrl-C
    /// interrupts.
    ///
    /// start: coordinates and rates at the start, `{"phi": 0.1}` or `{"phi": "85deg"}`; what is
    /// left open follows; `{"t": 0.3}` is the time of the start, by default 0.
    /// until: a condition to stop at, `"phi = pi/2"`, or several.
    /// set: values of parameters.
    /// energy_of: a pose at rest on whose energy level the motion starts.
    /// hold: supports that never open. release: supports that vanish, with the times. cut: threads,
    /// with the conditions.
    /// impulses: list of (point, (px, py), t).
    /// stop_at_impacts: whether the run ends where a contact closes.
    /// limit: latest end. tolerance: relative, of the integration. method: of integration, by
    /// default the one that suits.
    #[pyo3(
        signature = (start=None, until=None, **options),
        text_signature = "($self, start=None, until=None, *, set=None, energy_of=None, hold=None, release=None, cut=None, \
                          impulses=None, stop_at_impacts=None, limit=None, tolerance=None, method=None)"
    )]
    fn simulate<'py>(
        this: &Bound<'py, Self>,
        start: Option<&Bound<'py, PyAny>>,
        until: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Trajectory> {
        let (py, entry) = (this.py(), &this.get().entry);
        let mut options = Options::new("simulate", options).beside(&["start", "until"]);
        let request = Request::from_options(entry, start, until, &mut options)?;
        options.finish()?;
        start_notes(entry, &request.spec).iter().try_for_each(|text| errors::warn(py, text))?;
        let made = |run, stopped| Trajectory::new(this.clone().unbind(), request.clone(), run, stopped);
        match run(py, entry, &request)? {
            Ok(run) => Ok(made(run, None)),
            Err(MotionError::Run { reason, trajectory }) => {
                let error = RunError::new_err(reason.clone());
                let so_far = made(*trajectory, Some(reason));
                error.value(py).setattr("trajectory", so_far.into_pyobject(py)?)?;
                Err(error)
            }
            Err(error) => Err(errors::request(&error)),
        }
    }

    /// Runs the model once for each of the values of arrays, on all processors, without holding the
    /// interpreter.
    ///
    /// observe: what to read of each run, a text or several: `"first open"`, `"t of first open A"`,
    /// `"end phi"`, `"max N(A)"`, `"count impact"`, `"end"`.
    /// start, set, energy_of, release: as in `simulate`; where a value is an array or a list, the
    /// runs take its values, all arrays together as NumPy broadcasts them; where it is a text, it
    /// is an expression of the names in `vary`.
    /// vary: arrays by names of their own, for such expressions and for conditions.
    /// threads: by default as many as there are processors.
    /// until, hold, cut, impulses, stop_at_impacts, limit, tolerance: as in `simulate`.
    #[pyo3(
        signature = (observe, *, vary=None, **options),
        text_signature = "($self, observe, *, vary=None, start=None, set=None, energy_of=None, release=None, until=None, \
                          hold=None, cut=None, impulses=None, stop_at_impacts=None, limit=None, tolerance=None, threads=None)"
    )]
    fn sweep<'py>(
        &self,
        py: Python<'py>,
        observe: &Bound<'py, PyAny>,
        vary: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        sweep::run(py, &self.entry, (observe, vary), options)
    }

    /// The equilibria that are found from a start, a list of `Equilibrium`, each with its reactions
    /// and the motion nearby.
    ///
    /// start, set: as in `simulate`.
    /// load: a parameter, such as a force, `"F"`, or with the value that it goes towards,
    /// `{"F": 0}`: finds how far it may go until a contact opens or slides.
    #[pyo3(signature = (start=None, **options), text_signature = "($self, start=None, *, set=None, load=None)")]
    fn equilibrium<'py>(
        &self,
        py: Python<'py>,
        start: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let options = Options::new("equilibrium", options).beside(&["start"]);
        analyses::rest::equilibria(py, &self.entry, start, options)
    }

    /// The motion about a start, at rest, a `Linearisation`: its modes of vibration and its
    /// matrices.
    ///
    /// start, set: as in `simulate`.
    /// closed: the closed supports, by default all that touch; `"free"` for none.
    /// unfold: of a mirrored model, the motions that keep its symmetry and those that break it,
    /// `LinearHalves`.
    #[pyo3(
        signature = (start=None, **options),
        text_signature = "($self, start=None, *, set=None, closed=None, unfold=False)"
    )]
    fn linearise<'py>(
        &self,
        py: Python<'py>,
        start: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = Options::new("linearise", options).beside(&["start"]);
        analyses::rest::linearise(py, &self.entry, start, options)
    }

    /// The periodic orbit near a run, an `Orbit`; or with `continue_to` the orbits that follow it
    /// in a parameter, a `Branch`.
    ///
    /// section: what is met once per period, an event, `"impact"` or `"impact A"`, or a condition
    /// that becomes true, `"phi' > 0"`; for a driven model `"t = T"` with the period of its drive.
    /// drift: coordinates that need not return, such as the distance walked.
    /// continue_to: a parameter and its final value, `{"gamma": 0.1}`.
    /// All others as in `simulate`.
    #[pyo3(
        signature = (section, start=None, **options),
        text_signature = "($self, section, start=None, *, drift=None, continue_to=None, set=None, until=None, energy_of=None, hold=None, release=None, cut=None, \
                          impulses=None, stop_at_impacts=None, limit=None, tolerance=None, method=None)"
    )]
    fn orbit<'py>(
        &self,
        py: Python<'py>,
        section: &str,
        start: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = Options::new("orbit", options).beside(&["section", "start"]);
        analyses::orbit::orbit(py, &self.entry, section, start, options)
    }

    /// The derivatives of a run, `Sensitivities`: of the times of its events, of the states there
    /// and at its end.
    ///
    /// of: parameters, coordinates and rates at the start; by default all.
    /// All others as in `simulate`.
    #[pyo3(
        signature = (of=None, start=None, **options),
        text_signature = "($self, of=None, start=None, *, set=None, until=None, energy_of=None, hold=None, release=None, cut=None, \
                          impulses=None, stop_at_impacts=None, limit=None, tolerance=None, method=None)"
    )]
    fn sensitivity<'py>(
        &self,
        py: Python<'py>,
        of: Option<&Bound<'py, PyAny>>,
        start: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = Options::new("sensitivity", options).beside(&["of", "start"]);
        analyses::sensitivity::sensitivities(py, &self.entry, of, start, options)
    }

    /// The values of parameters and entries of the start with the least sum of squares, a `Fit`.
    ///
    /// vary: the parameters, coordinates and rates to fit; the search begins with their values in
    /// the run.
    /// data: measured series, a dict or a frame with `t` and columns named by outputs, or the path
    /// of a file of values separated by commas; `"phi ±"` has the standard deviations of `"phi"`;
    /// what is no number is left out.
    /// of: columns to fit, by default all. sd: standard deviations of columns.
    /// events: measured times of events, `{"first open": 0.4531}`, and outputs after them,
    /// `{"2nd impact phi": 0.3}`; a pair has the standard deviation too.
    /// All others as in `simulate`.
    #[pyo3(
        signature = (vary, start=None, **options),
        text_signature = "($self, vary, start=None, *, data=None, of=None, sd=None, events=None, set=None, until=None, energy_of=None, hold=None, release=None, cut=None, \
                          impulses=None, stop_at_impacts=None, limit=None, tolerance=None, method=None)"
    )]
    fn fit<'py>(
        &self,
        py: Python<'py>,
        vary: &Bound<'py, PyAny>,
        start: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = Options::new("fit", options).beside(&["vary", "start"]);
        analyses::fit::fit(py, &self.entry, vary, start, options)
    }

    /// The values of parameters and entries of the start with which an output is least or greatest,
    /// an `Optimum`.
    ///
    /// of: the time of an event, `"first open"`, an output after one, `"first impact x"`, or at the
    /// end, `"end phi"`.
    /// vary: parameters, coordinates and rates, or a dict with their bounds,
    /// `{"release": (0.1, 1)}`; the search begins with their values in the run.
    /// greatest: whether the greatest value is sought.
    /// All others as in `simulate`.
    #[pyo3(
        signature = (of, vary, start=None, **options),
        text_signature = "($self, of, vary, start=None, *, greatest=False, set=None, until=None, energy_of=None, hold=None, release=None, cut=None, \
                          impulses=None, stop_at_impacts=None, limit=None, tolerance=None, method=None)"
    )]
    fn optimise<'py>(
        &self,
        py: Python<'py>,
        of: &str,
        vary: &Bound<'py, PyAny>,
        start: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = Options::new("optimise", options).beside(&["of", "vary", "start"]);
        analyses::optimum::optimise(py, &self.entry, (of, vary), start, options)
    }

    /// The curves in the plane of two names across which what is observed changes, a list of
    /// `Boundary`.
    ///
    /// vary: two parameters, coordinates or rates at the start, or names that settings use, with
    /// their ranges:
    /// `{"phi": (0.5, 1.5)}`; a third number is the size of the grid on which curves are found.
    /// observe: what changes, `"first open"`, `"last impact"`, `"end"`, or a number that reaches a
    /// value, `"first open phi = 0.4"`.
    /// start, set, energy_of, release: as in `simulate`, or texts: expressions of the varied names.
    /// accuracy: of the curves, in parts of the ranges; by default 1e-10.
    /// All others as in `sweep`.
    #[pyo3(
        signature = (vary, **options),
        text_signature = "($self, vary, *, observe='first open', start=None, set=None, energy_of=None, release=None, \
                          accuracy=1e-10, until=None, hold=None, cut=None, \
                          impulses=None, stop_at_impacts=None, limit=None, tolerance=None, threads=None)"
    )]
    fn boundary<'py>(
        &self,
        py: Python<'py>,
        vary: &Bound<'py, PyAny>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        sweep::boundary::boundaries(py, &self.entry, vary, options)
    }

    /// The equations that were derived, of the system and of each set of contacts: as `"text"`,
    /// `"latex"` or `"html"`.
    #[pyo3(signature = (format="text"))]
    fn explain<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyAny>> {
        explain::explained(py, &self.entry, format)
    }

    /// When each reaction vanishes, as a formula, and what stays constant: as `"text"`, `"latex"`
    /// or `"html"`.
    ///
    /// phase: only the phase with these supports closed, `"A, E"`, or `"free"`.
    /// start: coordinates and rates at the start, for its energy; without it the motion starts at
    /// rest anywhere.
    /// set: values of parameters.
    #[pyo3(
        signature = (phase=None, start=None, **options),
        text_signature = "($self, phase=None, start=None, *, set=None, format='text')"
    )]
    fn conditions<'py>(
        &self,
        py: Python<'py>,
        phase: Option<&str>,
        start: Option<&Bound<'py, PyAny>>,
        options: Option<Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = Options::new("conditions", options).beside(&["phase", "start"]);
        explain::conditions(py, &self.entry, phase, start, options)
    }

    /// The equations as source text for other programs: `"sympy"`, a module of Python, or `"c"`, a
    /// dict of the files of a library.
    #[pyo3(signature = (target="sympy"))]
    fn export<'py>(&self, py: Python<'py>, target: &str) -> PyResult<Bound<'py, PyAny>> {
        explain::exported(py, &self.entry, target)
    }

    /// M(q) a + h(q, v) = Q(q, v, t) of the motion without contacts as functions of numbers,
    /// `Functions`; needs SymPy.
    #[pyo3(signature = (set=None))]
    fn functions<'py>(&self, py: Python<'py>, set: Option<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        let options = PyDict::new(py);
        options.set_item("set", set)?;
        let spec = pose(&self.entry, None, &mut Options::new("functions", Some(options)))?;
        let model = self.entry.model(&spec.parameters).map_err(|error| errors::request(&error))?;
        let source = explain::exported(py, &self.entry, "sympy")?;
        let compiled = py.import("liftoff._functions")?.getattr("compiled")?;
        compiled.call1((source, self.coordinates(), model.parameters))
    }

    /// The model as a drawing, SVG: at a start, with values of its parameters.
    #[pyo3(signature = (start=None, set=None))]
    fn drawing<'py>(
        &self,
        py: Python<'py>,
        start: Option<&Bound<'py, PyAny>>,
        set: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let options = PyDict::new(py);
        options.set_item("set", set)?;
        let spec = pose(&self.entry, start, &mut Options::new("drawing", Some(options)))?;
        crate::pictures::svg(py, explain::drawn(&self.entry, &spec, start.is_some())?)
    }

    fn _repr_svg_(&self) -> Option<String> {
        explain::drawn(&self.entry, &self.entry.default_run(), false).ok()
    }

    fn _repr_latex_(&self) -> String {
        explain::latex(&self.entry)
    }

    fn _repr_html_(&self) -> String {
        explain::html(&self.entry, self._repr_svg_().as_deref())
    }

    fn __repr__(&self) -> String {
        let Self { entry, .. } = self;
        let (parameters, coordinates) = (self.parameters().join(", "), self.coordinates().join(", "));
        format!("<Model {}: parameters {parameters}; coordinates {coordinates}>", entry.layout().name)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        let same = |other: &Self| {
            other.text == self.text
                && other.name() == self.name()
                && other.entry.default_run() == self.entry.default_run()
        };
        other.cast::<Self>().is_ok_and(|other| same(other.get()))
    }

    fn __hash__(&self) -> u64 {
        use std::hash::{DefaultHasher, Hash, Hasher};
        let mut hasher = DefaultHasher::new();
        (&self.text, self.name()).hash(&mut hasher);
        hasher.finish()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let class = py.get_type::<Self>();
        Ok(match self.entry.source() {
            Some(_) => (class.getattr("built_in")?, (self.entry.name(),).into_pyobject(py)?),
            None => (class.into_any(), (&self.text, self.name()).into_pyobject(py)?),
        })
    }
}

/// The motion, or why there is none, or only a part of it; what a signal raises goes first.
fn run(
    py: Python<'_>,
    entry: &Entry,
    request: &Request,
) -> PyResult<Result<liftoff::Trajectory, MotionError>> {
    let stop = Arc::default();
    let mut watch = Watch::new(Arc::clone(&stop));
    let options = RunOptions::by(request.method).cancel(stop);
    let motion = py.detach(|| entry.observe_by(options, &request.spec, &mut watch));
    watch.signal().map_or(Ok(motion), Err)
}

fn file_text(path: &Path) -> PyResult<String> {
    let told = |error: Error| Error::new(error.kind(), format!("cannot read {}: {error}", path.display()));
    Ok(read_text(path, LARGEST).map_err(told)?)
}

/// The models of a text.
fn declared(py: Python<'_>, path: &str, text: &str) -> PyResult<Vec<Entry>> {
    if !text.contains("BarSystem") {
        return Err(undeclared(path));
    }
    let found = py.detach(|| source::models(text));
    found.map_err(|mistakes| errors::declaration(path, text, &mistakes))
}

fn undeclared(path: &str) -> PyErr {
    errors::invalid(format!(
        "nothing in {path} derives `BarSystem`: a model is a struct of Rust below `#[derive(BarSystem)]`, as \
         `Model.built_in(\"pendulum\").text`; `Model.from_file(\"ladder.rs\")` reads a file"
    ))
}

fn chosen(path: &str, mut found: Vec<Entry>, name: Option<&str>) -> PyResult<Entry> {
    let names: Vec<&str> = found.iter().map(|entry| entry.layout().name).collect();
    let place = match name {
        _ if found.is_empty() => {
            return Err(undeclared(path));
        }
        None if found.len() == 1 => 0,
        None => {
            let text = format!("{path} has several models; choose one: model=\"{}\"", names.join("\", \""));
            return Err(errors::invalid(text));
        }
        Some(name) => {
            let missing = || errors::unknown(&NameError::new("model", name, names.iter().copied()));
            let is_it = |entry: &Entry| [entry.layout().name, entry.name()].contains(&name);
            found.iter().position(is_it).ok_or_else(missing)?
        }
    };
    Ok(found.swap_remove(place))
}
