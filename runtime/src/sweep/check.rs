//! What can be told of a sweep before any member is run.

use super::SweepError;
use super::setting::{Place, Said};
use crate::model::Layout;
use crate::names::unknown;
use crate::output::Condition;
use crate::output::resolve::{contact_of, unknown_support};
use crate::scene::Setup;

/// The setting of a name that is varied and is itself one of the model.
pub(super) fn itself(name: &str, layout: &Layout) -> Option<Said> {
    let places = [Place::Parameter, Place::Start];
    let place = places.into_iter().find(|place| place.names(layout).iter().any(|known| known == name))?;
    Some(Said { place, name: name.to_owned(), formula: name.to_owned() })
}

pub(super) fn unused(name: &str, layout: &Layout) -> SweepError {
    let known: Vec<String> =
        [Place::Parameter, Place::Start].iter().flat_map(|place| place.names(layout)).collect();
    let error = unknown("parameter or coordinate", name, known.iter().map(String::as_str));
    SweepError::Asked(format!("nothing depends on what is varied: {error}"))
}

/// Names that would make every member fail.
pub(super) fn check(setup: &Setup, layout: &'static Layout) -> Result<(), SweepError> {
    let known = |place: Place, values: &[(String, f64)]| {
        let names = place.names(layout);
        let stranger = values.iter().find(|(name, _)| !names.contains(name));
        stranger
            .map_or(Ok(()), |(name, _)| Err(unknown(place.kind(), name, names.iter().map(String::as_str))))
    };
    known(Place::Parameter, &setup.parameters)?;
    known(Place::Start, &setup.start)?;
    known(Place::EnergyOf, &setup.energy_of)?;
    let released = setup.release.iter().map(|(name, _)| name);
    let cut = setup.cut.iter().map(|(name, _)| name);
    for support in setup.hold.iter().chain(released).chain(cut) {
        contact_of(layout, support).ok_or_else(|| unknown_support(layout, support))?;
    }
    for blow in &setup.impulses {
        if !layout.points.contains(&blow.point.as_str()) {
            return Err(unknown("point", &blow.point, layout.points.iter().copied()).into());
        }
    }
    for condition in setup.until.iter().chain(setup.cut.iter().map(|(_, condition)| condition)) {
        Condition::of(layout, condition).map_err(SweepError::output(condition))?;
    }
    if !(setup.tolerance > 0.0 && setup.tolerance < 1.0) {
        return Err(SweepError::Asked(format!("a tolerance between 0 and 1, not {}", setup.tolerance)));
    }
    match setup.limit {
        Some(limit) if !(limit > 0.0 && limit.is_finite()) => {
            Err(SweepError::Asked(format!("a time limit above zero, not {limit}")))
        }
        _ => Ok(()),
    }
}
