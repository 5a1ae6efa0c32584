//! Limits: with q what a drive would prescribe, the gaps over a lower bound a and under an upper
//! one are `q − a` and `a − q`, of a distance d `(d² − a²)/2a` and its opposite. The reaction is
//! what the drive's force would be.

use super::action::Scene;
use super::driving::{actions, between};
use super::expression::{Expression, OpaqueTerms};
use super::measured::{Measured, inverse};
use super::row::Row;
use crate::algebra::{Rational, Series};
use crate::system::Driven;

pub(super) fn measure(
    scene: &Scene,
    opaque_terms: &mut OpaqueTerms,
    driven: &Driven,
    bound: &Series,
    is_upper: bool,
) -> Measured {
    let n = scene.n();
    let (over, bound, actions) = match driven {
        Driven::Distance { ends, .. } => {
            let inverse = inverse(opaque_terms, bound);
            let square = Row::from_gap(&scene.kinematics.squared_distance(*ends), n);
            let half = inverse.scale(Rational::HALF);
            (square.scaled(&half), bound.scale(Rational::HALF), between(scene, *ends, &inverse))
        }
        driven => {
            let value = Expression::series(bound.clone());
            let value = value.less_constant(driven, scene.system, scene.kinematics);
            let value = match value {
                Expression::Value(_) => bound.clone(),
                angle => {
                    let name = format!("limit{}", opaque_terms.0.len() + 1);
                    opaque_terms.motion(name, angle)
                }
            };
            let series = scene.kinematics.driven(scene.system, driven).0;
            let actions = actions(scene, driven, &Series::one());
            (Row::from_gap(&series, n), value, actions)
        }
    };
    let sign = Series::constant(Rational::integer(if is_upper { -1 } else { 1 }));
    let mut row = over.scaled(&sign);
    row.gap -= &(&bound * &sign);
    let actions = actions.iter().map(|action| action.scaled(&sign)).collect();
    Measured { row, foot: None, tangent: None, actions: [actions, Vec::new()] }
}
