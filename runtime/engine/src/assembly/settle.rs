//! A start on the closed form of its contacts: the reduced coordinates r, near those of the
//! completed state, with
//!
//! ```text
//! embed(r) = what was given
//! ```
//!
//! by Gauss and Newton. Completion knows what was left open to within the rounding of the gaps.
//! Where these are flat, as those of sin α = sin β at cos α = 0, that is the square root of a
//! rounding, and an embedding would miss what was given by as much.

use nalgebra::{DMatrix, DVector};

use super::pose::GivenPose;
use crate::context::{CLOSED, Numbers, RunContext};
use crate::integration::chart;
use crate::model::{ContactSet, Form};
use crate::numerics::decomposition::svd;
use crate::numerics::zero::roundoff;
use crate::system::PhaseEquations;

/// Corrections, each of which squares the error.
const CORRECTIONS: usize = 3;
/// What is given is met within a rounding.
const ROUNDED: f64 = roundoff(1.0);
/// The largest correction, in natural units, is some square root of a rounding.
const NEAR: f64 = 1e-6;
/// Half the span of central differences, in natural units: nearer than where a branch may end.
const SPAN: f64 = 1e-9;

/// The start of a completed state, if the closed form of the touching contacts has what was given.
pub(super) fn settled(
    context: &RunContext,
    touching: ContactSet,
    state: &[f64],
    given: &GivenPose,
) -> Option<Vec<f64>> {
    let phase = context.phase(touching, Form::Reduced);
    let mut state = state.to_vec();
    let mut image = image_of(context, &*phase, &state)?;
    for _ in 0..CORRECTIONS {
        if given.is_kept(context, &image, ROUNDED) {
            break;
        }
        correct(context, &*phase, (&mut state, &image), given)?;
        image = image_of(context, &*phase, &state)?;
    }
    given.is_kept(context, &image, CLOSED).then(|| image.into_vec())
}

/// embed(restrict(state)) where it satisfies the contacts: its pivots may be small, as they are
/// where gaps are flat.
fn image_of(context: &RunContext, phase: &dyn PhaseEquations, state: &[f64]) -> Option<Numbers> {
    if phase.info().form == Form::Multipliers {
        return None;
    }
    let (_, image) = chart::image(phase, state);
    let gaps = context.gaps(&image);
    let bound = |contact: usize| CLOSED * context.layout().unit(contact, context.scales.length);
    let closed = phase.info().set.iter().all(|contact| gaps[contact].abs() <= bound(contact));
    (closed && image.iter().all(|x| x.is_finite())).then_some(image)
}

/// Moves the kept coordinates of a state so that its image has the given positions, if they are
/// near.
fn correct(
    context: &RunContext,
    phase: &dyn PhaseEquations,
    (state, image): (&mut [f64], &[f64]),
    given: &GivenPose,
) -> Option<()> {
    let asked: Vec<(usize, f64)> =
        given.positions.iter().enumerate().filter_map(|(i, given)| Some((i, (*given)?))).collect();
    let kept = &phase.kept()[..phase.info().coordinates];
    if asked.is_empty() || kept.is_empty() {
        return None;
    }
    let unit = |i: usize| context.scales.entry(context.layout(), i);
    let moved = |place: usize, by: f64| -> Option<Numbers> {
        let mut moved = state.to_vec();
        moved[place] += by * unit(place);
        image_of(context, phase, &moved)
    };
    let mut jacobian = DMatrix::zeros(asked.len(), kept.len());
    for (column, &place) in kept.iter().enumerate() {
        let (ahead, behind) = (moved(place, SPAN)?, moved(place, -SPAN)?);
        for (row, &(i, _)) in asked.iter().enumerate() {
            jacobian[(row, column)] = (ahead[i] - behind[i]) / (2.0 * SPAN * unit(i));
        }
    }
    let missing =
        DVector::from_iterator(asked.len(), asked.iter().map(|&(i, value)| (value - image[i]) / unit(i)));
    let change = svd(jacobian).solve(&missing, 1e-6).ok()?;
    if change.amax() > NEAR {
        return None;
    }
    for (&place, change) in kept.iter().zip(&change) {
        state[place] += change * unit(place);
    }
    Some(())
}
