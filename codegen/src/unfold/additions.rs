//! What the declaration of both halves says that the mirror said: places of the figure, the
//! coordinates of the mirrored model with their images, and the images of angles that are kept
//! equal.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Attribute, Expr, Ident, parse_quote};

use super::coordinates::Coordinates;
use super::equal;
use crate::kinematics::Kinematics;
use crate::syntax::{Description, ident, identifiers, plain};
use crate::system::{Mirror, System};

/// The attributes to be added.
pub(super) fn derive_attributes(
    description: &Description,
    system: &System,
    kinematics: &Kinematics,
    mirror: &Mirror,
) -> syn::Result<Vec<Attribute>> {
    let places = places(description, system, mirror);
    let mut attributes: Vec<Attribute> = Vec::new();
    if !places.is_empty() {
        attributes.push(parse_quote!(#[figure(#(#places),*)]));
    }
    let declared = system.coordinates.iter().map(|c| (c.name.clone(), c.kind.clone())).collect();
    let taken = identifiers(&description.declaration.parse::<TokenStream>()?);
    let mut names = Coordinates { system, mirror, declared, taken, attributes };
    for coordinate in &kinematics.coordinates {
        if !names.declared.iter().any(|(name, _)| plain(name) == coordinate.name) {
            names.named(&coordinate.name, &coordinate.reading);
        }
    }
    for coordinate in &kinematics.coordinates {
        let image = names.image(&coordinate.reading);
        if let Some(kind) = image.filter(|kind| names.is_free(kind, kinematics)) {
            names.named(&format!("{}_image", coordinate.name), &kind);
        }
    }
    for equal in equal::without_image(system, mirror) {
        names.equal(equal)?;
    }
    Ok(names.attributes)
}

/// The images of the figure's places that it does not give itself.
fn places(description: &Description, system: &System, mirror: &Mirror) -> Vec<TokenStream> {
    let Some(at) = description.mirror.as_ref().map(|line| &line.at) else { return Vec::new() };
    let given = |name: &str| description.figure.iter().any(|(known, _)| plain(known) == name);
    let place = |(name, [x, y]): &(Ident, [Expr; 2])| {
        let own = system.points.iter().position(|point| plain(name) == point.name)?;
        let image = &system.points[mirror.points[own]].name;
        let name = ident(image);
        let across = |x: &Expr| quote!(2 * (#at) - (#x));
        let [x, y] = if mirror.axis == 0 { [across(x), quote!(#y)] } else { [quote!(#x), across(y)] };
        (!given(image)).then(|| quote!(#name = (#x, #y)))
    };
    description.figure.iter().filter_map(place).collect()
}
