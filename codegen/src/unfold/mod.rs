//! Derives the model of both halves from a mirrored one. A direction δ has the mirror image
//!
//! ```text
//! x = a:  δ' = π − δ        y = a:  δ' = −δ
//! ```
//!
//! or π more if the image is named from its other end. `additions` writes the attributes that the
//! full model needs besides the declaration; `coordinates` has the coordinates of both halves;
//! `equal` finds angles that are kept equal in one half only.

mod additions;
mod coordinates;
mod equal;
#[cfg(test)]
mod tests;

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::DeriveInput;

use crate::Analysis;
use crate::algebra::{Series, Symbol};
use crate::kinematics::{Kinematics, nominal_values};
use crate::system::{CoordinateKind, Mirror, NEAR, ParameterValues, Reference, System};

/// Attributes that are valid for the mirrored model only, because the full model has other starts
/// and other equations.
const LEFT_OUT: [&str; 3] = ["mirror", "run", "budget"];

/// Both halves of a mirrored model.
#[derive(Clone, Debug)]
pub struct Unfolded {
    /// The derivation of the full model, which has no default run. Coordinates of the mirrored
    /// model keep their names; the image of `phi` is `phi_image`.
    pub analysis: Analysis,
    system: System,
    kinematics: Kinematics,
    mirror: Mirror,
}

impl Unfolded {
    /// Unfolds a mirrored model. Where it keeps angles equal, their images are kept equal too.
    ///
    /// # Errors The declaration has mistakes or no mirror, or both halves together are not a valid
    /// model with the figure of the mirrored one.
    pub fn from_tokens(input: TokenStream) -> syn::Result<Self> {
        let description = crate::parse(input.clone())?;
        let system = crate::resolve(input.clone())?;
        let Some(mirror) = system.mirror.clone() else {
            let text = format!(
                "`{}` has no mirror: its coordinates already have every motion, so there is nothing to unfold",
                system.ident
            );
            return Err(syn::Error::new(system.ident.span(), text));
        };
        let kinematics = Kinematics::derive(&system)?;
        let added = additions::derive_attributes(&description, &system, &kinematics, &mirror)?;
        let mut item: DeriveInput = syn::parse2(input)?;
        item.attrs.retain(|attribute| !LEFT_OUT.iter().any(|name| attribute.path().is_ident(name)));
        item.attrs.extend(added);
        let analysis = crate::analyse(item.into_token_stream())?;
        let unfolded = Self { analysis, system, kinematics, mirror };
        unfolded.check_figure()?;
        Ok(unfolded)
    }

    /// The coordinates of a symmetric position, given those of the mirrored model.
    pub fn position(&self, parameters: &[f64], mirrored: &[f64]) -> Vec<f64> {
        let value = values(&self.system, parameters, mirrored);
        let Kinematics { directions, points, .. } = &self.kinematics;
        let read = |reading: &CoordinateKind| match reading {
            CoordinateKind::Position { point, axis, sign } => {
                f64::from(*sign) * points[*point][*axis].evaluate(&value)
            }
            CoordinateKind::Angle { body, reference, sign } => {
                let from = match reference {
                    Reference::Ground(angle) => angle,
                    Reference::Body(other) => &directions[*other],
                };
                (&directions[*body] - from).scale(i32::from(*sign)).evaluate(&value)
            }
        };
        self.analysis.kinematics.coordinates.iter().map(|coordinate| read(&coordinate.reading)).collect()
    }

    /// Π, row by row: the mirror image of an admissible displacement δq from a symmetric position
    /// is Π δq.
    pub fn reflection(&self, parameters: &[f64], position: &[f64]) -> Vec<Vec<f64>> {
        let Analysis { system, kinematics, .. } = &self.analysis;
        let value = values(system, parameters, position);
        let turn = |body: usize, symbol: Symbol| {
            f64::from(kinematics.directions[self.mirror.bodies[body].0].coefficient(symbol))
        };
        let slope = |reading: &CoordinateKind, symbol: Symbol| match reading {
            CoordinateKind::Position { point, axis, sign } => {
                let along = if *axis == self.mirror.axis { -1.0 } else { 1.0 };
                let image = &kinematics.points[self.mirror.points[*point]][*axis];
                f64::from(*sign) * along * image.derivative(symbol).evaluate(&value)
            }
            CoordinateKind::Angle { body, reference, sign } => {
                let from = match reference {
                    Reference::Ground(_) => 0.0,
                    Reference::Body(other) => turn(*other, symbol),
                };
                f64::from(*sign) * (from - turn(*body, symbol))
            }
        };
        let row = |reading| (0..position.len()).map(|i| slope(reading, Symbol::coordinate(i))).collect();
        kinematics.coordinates.iter().map(|coordinate| row(&coordinate.reading)).collect()
    }

    /// Refuses points that only the mirror places: without the mirror the figure would place both
    /// halves alike, not as mirror images.
    fn check_figure(&self) -> syn::Result<()> {
        let Some(numbers) = self.system.samples.first() else { return Ok(()) };
        let parameters: Vec<f64> = (0..self.system.parameters.len())
            .map(|i| numbers.evaluate(&Series::symbol(Symbol::parameter(i))))
            .collect();
        let whole = ParameterValues::new(&parameters, &self.analysis.system.constants);
        let places = self.system.figure.iter().zip(&self.analysis.system.figure);
        for (point, (a, b)) in self.system.points.iter().zip(places) {
            let [a, b] = [numbers.pair(a), whole.pair(b)];
            if (a[0] - b[0]).hypot(a[1] - b[1]) > NEAR * (1.0 + a[0].hypot(a[1])) {
                let text = format!(
                    "only the mirror says where point `{}` is: to unfold it, place it or its mirror image in `#[figure(…)]`",
                    point.name
                );
                return Err(syn::Error::new(point.span, text));
            }
        }
        Ok(())
    }
}

/// Values of parameters, derived constants and coordinates.
fn values(system: &System, parameters: &[f64], coordinates: &[f64]) -> impl Fn(Symbol) -> f64 {
    let values = nominal_values(system, &ParameterValues::new(parameters, &system.constants), coordinates);
    move |symbol| values.get(&symbol).copied().unwrap_or(f64::NAN)
}
