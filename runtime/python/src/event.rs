//! What happened in a motion.

use liftoff::{NameError, Reaction};
use liftoff_core::model::Energy;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};
use std::collections::BTreeMap;

/// Something that happened in a motion: `event.kind` to `event.names` at `event.t`, with the state
/// and the reactions after it.
///
/// `event["phi'"]` is a coordinate, a rate or the time `t`.
#[pyclass(frozen, eq, mapping, module = "liftoff")]
#[derive(Clone, PartialEq)]
pub struct Event {
    /// When, s.
    #[pyo3(get)]
    t: f64,
    /// What: `"open"`, `"impact"`, `"stop"`, …
    #[pyo3(get)]
    kind: String,
    /// The supports it happened to, in alphabetical order.
    #[pyo3(get)]
    names: Vec<String>,
    /// What else there is to say, or None.
    #[pyo3(get)]
    note: Option<String>,
    /// The event in a line, as the command line prints it.
    #[pyo3(get)]
    text: String,
    state: Vec<(String, f64)>,
    before: Vec<(String, f64)>,
    energy: Vec<(String, f64)>,
    reactions: Vec<(String, f64)>,
    friction: Vec<(String, f64)>,
    impulses: Vec<(String, f64)>,
    joint_impulses: Vec<(String, f64)>,
}

impl Event {
    pub fn from_event(event: &liftoff::Event, motion: &liftoff::Trajectory) -> Self {
        let named = |state: &[f64]| motion.layout().names_of_motion().zip(motion.with_dependent(state));
        Self {
            t: event.t,
            kind: event.kind.name().to_owned(),
            names: event.supports.iter().map(|name| (*name).to_owned()).collect(),
            note: event.note.as_ref().map(ToString::to_string),
            text: event.to_string(),
            state: named(&event.state).collect(),
            before: event
                .before
                .as_ref()
                .map_or_else(Vec::new, |before| named(&before.state).chain(energy(before.energy)).collect()),
            energy: energy(event.energy).to_vec(),
            reactions: by_label(&event.reactions, |reaction| Some(reaction.value)),
            friction: by_label(&event.reactions, |reaction| reaction.friction),
            impulses: by_label(&event.impulses, |impulse| Some(impulse.value)),
            joint_impulses: motion
                .joint_impulses(event)
                .into_iter()
                .map(|(name, value)| (name.to_owned(), value))
                .collect(),
        }
    }
}

#[pymethods]
impl Event {
    /// Made of what `__reduce__` tells.
    #[new]
    #[pyo3(signature = (t, words, *values))]
    fn new(t: f64, words: Words, values: [Vec<(String, f64)>; 7]) -> Self {
        let (kind, names, note, text) = words;
        let [state, before, energy, reactions, friction, impulses, joint_impulses] = values;
        Self {
            t,
            kind,
            names,
            note,
            text,
            state,
            before,
            energy,
            reactions,
            friction,
            impulses,
            joint_impulses,
        }
    }

    /// Coordinates and rates after the event, by their names.
    #[getter]
    fn state<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.state.clone().into_py_dict(py)
    }

    /// Coordinates, rates and the energies `T`, `V` and `E` just before an impact or an impulse;
    /// None for events at which no velocity jumps.
    #[getter]
    fn before<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        (!self.before.is_empty()).then(|| self.before.clone().into_py_dict(py)).transpose()
    }

    /// The energies `T`, `V` and `E` after the event.
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.energy.clone().into_py_dict(py)
    }

    /// Reactions after the event, by support; positive where they push.
    #[getter]
    fn reactions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.reactions.clone().into_py_dict(py)
    }

    /// Friction forces after the event, by support.
    #[getter]
    fn friction<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.friction.clone().into_py_dict(py)
    }

    /// Impulses of the contacts, of an impact; by support.
    #[getter]
    fn impulses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.impulses.clone().into_py_dict(py)
    }

    /// Impulses of joints and drives, of an impact, by the names of their forces: `fx(O, OA)`; none
    /// where an impulse was applied.
    #[getter]
    fn joint_impulses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.joint_impulses.clone().into_py_dict(py)
    }

    fn __contains__(&self, name: &str) -> bool {
        name == "t" || self.state.iter().any(|(known, _)| known == name)
    }

    fn __getitem__(&self, name: &str) -> PyResult<f64> {
        let known: BTreeMap<&str, f64> =
            self.state.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let found = known.get(name).copied().or((name == "t").then_some(self.t));
        let missing = || crate::errors::unknown(&NameError::new("coordinate", name, known.keys().copied()));
        found.ok_or_else(missing)
    }

    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self) -> String {
        format!("<Event: {}>", self.text)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Parts)> {
        let Self {
            t,
            kind,
            names,
            note,
            text,
            state,
            before,
            energy,
            reactions,
            friction,
            impulses,
            joint_impulses,
        } = self.clone();
        let words = (kind, names, note, text);
        let event = py.get_type::<Self>().into_any();
        Ok((event, (t, words, state, before, energy, reactions, friction, impulses, joint_impulses)))
    }
}

type Words = (String, Vec<String>, Option<String>, String);
type Numbers = Vec<(String, f64)>;
type Parts = (f64, Words, Numbers, Numbers, Numbers, Numbers, Numbers, Numbers, Numbers);

fn energy(Energy { kinetic, potential }: Energy<f64>) -> [(String, f64); 3] {
    [("T", kinetic), ("V", potential), ("E", kinetic + potential)]
        .map(|(name, value)| (name.to_owned(), value))
}

fn by_label(all: &[Reaction], of: fn(&Reaction) -> Option<f64>) -> Numbers {
    all.iter().filter_map(|reaction| Some((reaction.label.to_owned(), of(reaction)?))).collect()
}
