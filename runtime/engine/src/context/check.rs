//! The natural scales of a model, and checks of its parameters.

use super::{CLOSED, Scales, slips};
use crate::error::ModelError;
use crate::model::{Layout, Measure, MeasureKind, SlipState};
use crate::system::Model;

/// A distance that the figure wants positive may be negative by this much, relative to the natural
/// length: it counts as zero. Rounding is far smaller.
const NEAR: f64 = 1e-9;

/// A length below this part of the largest is not much above what counts as a closed gap there.
const UNRESOLVED: f64 = 10.0 * CLOSED;
/// A moment of inertia below this part of the mass at the natural length is lost in the sum of
/// both, as in W = J M⁻¹ Jᵀ.
const WEIGHTLESS: f64 = 1e-14;

/// The natural scales of a model; refuses parameters that are no numbers, negative masses and
/// lengths that are not positive.
pub(crate) fn scales_of(model: &Model) -> Result<Scales, ModelError> {
    let layout = model.layout();
    for (name, &value) in layout.parameters.iter().zip(&model.parameters) {
        if !value.is_finite() {
            return Err(ModelError::Parameter { name: (*name).to_owned(), value });
        }
    }
    model.measures.iter().try_for_each(check)?;
    check_restitution(layout, &model.restitution)?;
    let scales = Scales::natural(layout, &model.measures, &model.nominal);
    if scales.mass <= 0.0 {
        return Err(ModelError::Massless);
    }
    check_spread(model, &scales)?;
    check_figure(model)?;
    check_friction(model)?;
    model.measures.iter().try_for_each(|measure| check_settled(measure, scales.length))?;
    Ok(scales)
}

/// Refuses lengths and moments of inertia that are lost beside the largest where contacts and
/// joints relate them.
fn check_spread(model: &Model, scales: &Scales) -> Result<(), ModelError> {
    use MeasureKind::{Extent, Inertia, Length};
    let extents = || model.measures.iter().filter(|of| matches!(of.kind, Length | Extent));
    let largest = extents().map(|of| of.value).fold(scales.length, f64::max);
    let moment = scales.mass * scales.length * scales.length;
    let least = |kind: MeasureKind| match kind {
        Length | Extent => UNRESOLVED * largest,
        Inertia => WEIGHTLESS * moment,
        _ => 0.0,
    };
    let lost = |of: &&Measure| of.value > 0.0 && of.value < least(of.kind);
    match model.measures.iter().find(lost) {
        Some(measure) if model.layout().rows() > 0 => {
            let beside = if measure.kind == Inertia { moment } else { largest };
            Err(ModelError::Spread { of: named(measure), value: measure.value, beside })
        }
        _ => Ok(()),
    }
}

fn check_figure(model: &Model) -> Result<(), ModelError> {
    let layout = model.layout();
    let mut coordinates = layout.coordinates.iter().zip(&model.nominal);
    let Some((coordinate, _)) = coordinates.find(|(_, q)| !q.is_finite()) else { return Ok(()) };
    let parameters = layout.parameters.iter().zip(&model.parameters);
    let parameters: Vec<String> = parameters.map(|(name, value)| format!("{name} = {value}")).collect();
    let (coordinate, parameters) = (coordinate.name.to_owned(), parameters.join(", "));
    Err(ModelError::Figure { coordinate, parameters })
}

/// Checks that the signs and sides settled at compile time, for samples of the parameters, hold for
/// these.
fn check_settled(measure: &Measure, length: f64) -> Result<(), ModelError> {
    let unit = if measure.kind == MeasureKind::Branch { 1.0 } else { length };
    if !is_settled(measure.kind) || measure.value >= -NEAR * unit {
        return Ok(());
    }
    let (of, by) = (measure.of.to_owned(), -measure.value);
    Err(match measure.kind {
        MeasureKind::Sign => ModelError::Sign { coordinate: of, by },
        MeasureKind::Side => ModelError::Side { support: of, by },
        MeasureKind::Direction => ModelError::Direction { of, by },
        _ => ModelError::Branch { of, by },
    })
}

fn is_settled(kind: MeasureKind) -> bool {
    use MeasureKind::{Branch, Direction, Side, Sign};
    matches!(kind, Sign | Side | Direction | Branch)
}

fn check(measure: &Measure) -> Result<(), ModelError> {
    let (of, value) = (|| measure.of.to_owned(), measure.value);
    if !value.is_finite() && !is_settled(measure.kind) {
        return Err(ModelError::NotFinite { of: named(measure), value });
    }
    match measure.kind {
        MeasureKind::Mass if value < 0.0 => Err(ModelError::NegativeMass { of: of(), value }),
        MeasureKind::Inertia if value < 0.0 => Err(ModelError::NegativeInertia { of: of(), value }),
        MeasureKind::Margin if value < 0.0 => Err(ModelError::OffBar { of: of(), beyond: -value }),
        MeasureKind::Length | MeasureKind::Extent if value <= 0.0 => {
            Err(ModelError::Length { of: named(measure), value })
        }
        MeasureKind::Stiffness | MeasureKind::TorsionalStiffness if value < 0.0 => {
            Err(ModelError::NegativeStiffness { of: of(), value })
        }
        MeasureKind::Damping if value < 0.0 => Err(ModelError::NegativeDamping { of: of(), value }),
        _ => Ok(()),
    }
}

fn named(measure: &Measure) -> String {
    match measure.kind {
        MeasureKind::Inertia => format!("moment of inertia of {}", measure.of),
        MeasureKind::Length => format!("length of {}", measure.of),
        MeasureKind::Stiffness | MeasureKind::TorsionalStiffness => format!("stiffness of {}", measure.of),
        MeasureKind::Damping => format!("damping of {}", measure.of),
        _ => measure.of.to_owned(),
    }
}

/// Checks the coefficients of friction in the nominal figure where the slip velocity is zero; the
/// surface may move.
fn check_friction(model: &Model) -> Result<(), ModelError> {
    let layout = model.layout();
    for (entry, friction) in layout.frictions.iter().enumerate() {
        let Some(SlipState { kinetic, limit, .. }) = without_slip(model, entry) else { continue };
        let contact = || layout.contacts[friction.contact].label.to_owned();
        match [kinetic, limit].into_iter().find(|mu| !(*mu >= 0.0 && mu.is_finite())) {
            Some(value) => return Err(ModelError::NegativeFriction { contact: contact(), value }),
            None if limit < kinetic => {
                return Err(ModelError::StaticFriction { contact: contact(), limit, kinetic });
            }
            None => {}
        }
    }
    Ok(())
}

/// Friction of a contact at the rates u = −w Jᵀ/|J|² with which its point goes with the surface, J
/// u + w = 0; of one whose slip no rate changes, as of a piston at its dead centre, where nothing
/// but the surface moves.
fn without_slip(model: &Model, entry: usize) -> Option<SlipState<f64>> {
    let (layout, nominal, system) = (model.layout(), &model.nominal, &*model.system);
    let state = |rates: &[f64]| layout.state_at(&[nominal, rates].concat(), 0.0);
    let at_rest = state(&vec![0.0; nominal.len()]);
    let equations = system.equations(&at_rest);
    let row = layout.frictions[entry].row;
    let (along, drift) = (equations.jacobian(row), equations.prescribed_gap_rate()[row]);
    let square: f64 = along.iter().map(|entry| entry * entry).sum();
    let factor = if drift == 0.0 || square == 0.0 { 0.0 } else { -drift / square };
    let rates: Vec<f64> = along.iter().map(|entry| factor * entry).collect();
    let slip = slips(system, &state(&rates)).get(entry).copied();
    slip.filter(|_| drift == 0.0 || square > 0.0)
}

fn check_restitution(layout: &Layout, values: &[f64]) -> Result<(), ModelError> {
    let rubbing = layout.frictions.iter().map(|friction| &layout.contacts[friction.contact]);
    match layout.contacts.iter().chain(rubbing).zip(values).find(|(_, value)| !(0.0..=1.0).contains(*value)) {
        Some((contact, &value)) => Err(ModelError::Restitution { contact: contact.label.to_owned(), value }),
        None => Ok(()),
    }
}
