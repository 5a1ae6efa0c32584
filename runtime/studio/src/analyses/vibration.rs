//! How a model moves near its start, at rest.

use super::{Failure, subject};
use crate::registry::{Entry, Unfolded};
use crate::run_spec::{RunSpec, Values};
use liftoff_analysis::{BySymmetry, Linearisation, Subject};
use liftoff_core::model::ContactSet;

/// An acceleration above this, in natural units, is none of an equilibrium.
const AT_REST: f64 = 1e-9;

/// Both halves of a mirrored model, at a symmetric position.
pub struct LinearHalves {
    /// The model of both.
    pub model: Entry,
    /// Its position.
    pub subject: Subject,
    /// What keeps the symmetry, and what breaks it.
    pub parts: BySymmetry,
}

/// The contacts of these supports, `A,E` or `free`; by default all that touch.
///
/// # Errors
/// There is no such support, or it is open.
pub fn find_contacts(subject: &Subject, closed: Option<&str>) -> Result<ContactSet, Failure> {
    Ok(match closed {
        None => subject.touching(),
        Some("free") => subject.contacts(&[])?,
        Some(names) => subject.contacts(&names.split(',').map(str::trim).collect::<Vec<_>>())?,
    })
}

/// The motion about the position of a subject, with these contacts closed.
///
/// # Errors
/// The mass matrix is singular, or the equations depend on the time.
pub fn linearise(subject: &Subject, closed: ContactSet) -> Result<Linearisation, Failure> {
    Ok(Linearisation::compute(subject, closed)?)
}

/// The motion of both halves about the position of the mirrored model, closed where that is.
///
/// # Errors
/// As for [`linearise`].
pub fn linearise_halves(
    unfolded: &Unfolded,
    parameters: &Values,
    mirrored: &Subject,
    closed: ContactSet,
) -> Result<LinearHalves, Failure> {
    let model = unfolded.model();
    let start = unfolded.position(parameters, &mirrored.positions())?;
    let spec = RunSpec { parameters: parameters.clone(), start, ..model.default_run() };
    let whole = subject(model, &spec)?;
    let supports: Vec<&str> =
        closed.iter().flat_map(|i| mirrored.layout().contacts[i].supports).copied().collect();
    let linear = Linearisation::compute(&whole, whole.contacts(&supports)?)?;
    let reflection = unfolded.reflection(parameters, &whole.positions())?;
    Ok(LinearHalves { model: model.clone(), parts: linear.by_symmetry(&reflection)?, subject: whole })
}

/// What to say where the largest acceleration at the start is none of an equilibrium.
pub fn describe_motion(residual: f64) -> Option<String> {
    (residual > AT_REST).then(|| {
        format!(
            "the start is no equilibrium: it accelerates by {residual:.1e} natural units; `equilibrium` finds one nearby"
        )
    })
}
