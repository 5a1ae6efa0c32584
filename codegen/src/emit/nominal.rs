//! The coordinates of the nominal figure.

use proc_macro2::TokenStream;

use super::body::Body;
use super::numbers::numbers;
use crate::Analysis;
use crate::program::Id;
use crate::system::{CoordinateKind, Reference};

/// The body of `nominal`.
pub(super) fn nominal(analysis: &Analysis) -> TokenStream {
    let (system, runtime) = (&analysis.system, &analysis.system.runtime);
    let frames: Vec<usize> =
        (0..system.bodies.len()).filter(|&body| system.oblique(body).is_some()).collect();
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        let mut ids: Vec<Id> = system.figure.iter().flatten().map(|s| lowering.series(s)).collect();
        for body in &frames {
            let of = system.local(*body, system.bodies[*body].from);
            let to = system.local(*body, system.bodies[*body].to);
            ids.extend(of.iter().chain(&to).map(|s| lowering.series(s)));
        }
        for coordinate in &analysis.kinematics.coordinates {
            ids.push(match &coordinate.reading {
                CoordinateKind::Angle { reference: Reference::Ground(angle), .. } => lowering.angle(angle),
                _ => lowering.program().integer(0),
            });
        }
        ids
    });
    let (figure, rest) = results.split_at(2 * system.figure.len());
    let (locals, references) = rest.split_at(4 * frames.len());
    let direction = |body: usize| {
        let at = |point: usize| {
            let (x, y) = (&figure[2 * point], &figure[2 * point + 1]);
            quote!([#x, #y])
        };
        let (from, to) = (at(system.bodies[body].from), at(system.bodies[body].to));
        let seen = quote!(#runtime::figure::direction(#from, #to));
        match frames.iter().position(|&frame| frame == body).map(|at| &locals[4 * at..4 * at + 4]) {
            Some([a, b, c, d]) => quote!(#seen - #runtime::figure::direction([#a, #b], [#c, #d])),
            _ => seen,
        }
    };
    let values = analysis.kinematics.coordinates.iter().zip(references).map(|(coordinate, constant)| {
        let (value, sign) = match &coordinate.reading {
            CoordinateKind::Position { point, axis, sign } => (figure[2 * point + axis].clone(), *sign),
            CoordinateKind::Angle { body, reference, sign } => {
                let from = match reference {
                    Reference::Ground(_) => constant.clone(),
                    Reference::Body(other) => direction(*other),
                };
                let own = direction(*body);
                (quote!(#runtime::figure::wrapped(#own - (#from))), *sign)
            }
        };
        if sign < 0 { quote!(-(#value)) } else { value }
    });
    quote! {
        #statements
        [#(#values),*]
    }
}
