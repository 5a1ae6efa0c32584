//! Measures that no mechanical system has.

use super::Scales;
use crate::error::ModelError;
use crate::model::{BarSystem, Layout, Measure, MeasureKind};

impl Scales {
    /// Refuses parameters that are no numbers, negative masses and lengths that are not positive.
    pub(crate) fn of<M: BarSystem>(model: &M) -> Result<Self, ModelError> {
        for (name, &value) in M::LAYOUT.parameters.iter().zip(model.parameters().as_ref()) {
            if !value.is_finite() {
                return Err(ModelError::Parameter { name: (*name).to_owned(), value });
            }
        }
        model.measures().as_ref().iter().try_for_each(check)?;
        check_restitution(M::LAYOUT, model.restitution().as_ref())?;
        let scales = Self::natural(model);
        if scales.mass > 0.0 { Ok(scales) } else { Err(ModelError::Massless) }
    }
}

fn check(measure: &Measure) -> Result<(), ModelError> {
    let (of, value) = (measure.of.to_owned(), measure.value);
    if !value.is_finite() {
        return Err(ModelError::NotFinite { of: named(measure), value });
    }
    match measure.kind {
        MeasureKind::Mass if value < 0.0 => Err(ModelError::NegativeMass { of, value }),
        MeasureKind::Inertia if value < 0.0 => Err(ModelError::NegativeInertia { of, value }),
        MeasureKind::Margin if value < 0.0 => Err(ModelError::OffBar { of, beyond: -value }),
        MeasureKind::Length | MeasureKind::Extent if value <= 0.0 => Err(ModelError::Length { of, value }),
        MeasureKind::Stiffness | MeasureKind::TorsionalStiffness if value < 0.0 => {
            Err(ModelError::NegativeStiffness { of, value })
        }
        MeasureKind::Damping if value < 0.0 => Err(ModelError::NegativeDamping { of, value }),
        _ => Ok(()),
    }
}

fn named(measure: &Measure) -> String {
    match measure.kind {
        MeasureKind::Inertia => format!("moment of inertia of {}", measure.of),
        MeasureKind::Length => format!("length of {}", measure.of),
        MeasureKind::Stiffness | MeasureKind::TorsionalStiffness => format!("stiffness of {}", measure.of),
        MeasureKind::Damping => format!("damping of {}", measure.of),
        MeasureKind::Mass | MeasureKind::Extent | MeasureKind::Margin | MeasureKind::Gravity => {
            measure.of.to_owned()
        }
    }
}

fn check_restitution(layout: &Layout, values: &[f64]) -> Result<(), ModelError> {
    match layout.contacts.iter().zip(values).find(|(_, value)| !(0.0..=1.0).contains(*value)) {
        Some((contact, &value)) => Err(ModelError::Restitution { contact: contact.label.to_owned(), value }),
        None => Ok(()),
    }
}
