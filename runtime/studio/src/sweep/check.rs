//! Checks of a sweep before any member is run.

use super::SweepError;
use super::setting::Assignment;
use crate::registry::Place;
use crate::run_spec::RunSpec;
use liftoff::__private::expression::{contact_of, unknown_support};
use liftoff::Condition;
use liftoff::NameError;
use liftoff_core::model::Layout;

/// The setting of a name that is varied and is itself one of the model.
pub(super) fn itself(name: &str, layout: &Layout) -> Option<Assignment> {
    let places = [Place::Parameter, Place::Start];
    let target = places.into_iter().find(|target| target.names(layout).iter().any(|known| known == name))?;
    Some(Assignment { target, name: name.to_owned(), formula: name.to_owned() })
}

pub(super) fn unused(name: &str, layout: &Layout) -> SweepError {
    let known: Vec<String> =
        [Place::Parameter, Place::Start].iter().flat_map(|target| target.names(layout)).collect();
    let error = NameError::new("parameter or coordinate", name, known.iter().map(String::as_str));
    SweepError::Invalid(format!("nothing depends on what is varied: {error}"))
}

/// Names that would make every member fail.
pub(super) fn check(spec: &RunSpec, layout: &'static Layout) -> Result<(), SweepError> {
    let known = |target: Place, values: &[(String, f64)]| {
        let names = target.names(layout);
        let stranger = values.iter().find(|(name, _)| !names.contains(name));
        stranger.map_or(Ok(()), |(name, _)| {
            Err(NameError::new(target.kind(), name, names.iter().map(String::as_str)))
        })
    };
    known(Place::Parameter, &spec.parameters)?;
    known(Place::Start, &spec.start)?;
    known(Place::EnergyOf, &spec.energy_of)?;
    let released = spec.release.iter().map(|(name, _)| name);
    let cut = spec.cut.iter().map(|(name, _)| name);
    for support in spec.hold.iter().chain(released).chain(cut) {
        contact_of(layout, support).ok_or_else(|| unknown_support(layout, support))?;
    }
    for blow in &spec.impulses {
        if !layout.points.contains(&blow.point.as_str()) {
            return Err(NameError::new("point", &blow.point, layout.points.iter().copied()).into());
        }
    }
    for condition in &spec.until {
        Condition::parse_each(layout, condition).map_err(SweepError::output(condition))?;
    }
    for (_, condition) in &spec.cut {
        Condition::parse(layout, condition).map_err(SweepError::output(condition))?;
    }
    if !(spec.tolerance > 0.0 && spec.tolerance < 1.0) {
        return Err(SweepError::Invalid(format!("a tolerance between 0 and 1, not {}", spec.tolerance)));
    }
    match spec.limit {
        Some(limit) if !(limit > 0.0 && limit.is_finite()) => {
            Err(SweepError::Invalid(format!("a time limit above zero, not {limit}")))
        }
        _ => Ok(()),
    }
}
