//! `#[particle(P, mass = m)]`: a point mass that belongs to no bar.

use syn::parse::ParseStream;

use super::mass::PointMass;
use super::options::Options;

/// Reads a particle.
pub(super) fn parse(input: ParseStream) -> syn::Result<PointMass> {
    let point = input.parse()?;
    let mass = Options::parse(input, &["mass"])?.require("mass", &point)?;
    Ok(PointMass { point, mass })
}
