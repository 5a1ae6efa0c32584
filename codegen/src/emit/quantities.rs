//! Joint forces, tensions, internal forces, momenta: one arm each, so that only what is asked for
//! is computed; those of a long tree's joints, which follow from each other, together.

use proc_macro2::TokenStream;

use super::body;
use super::constants::UsedConstants;
use super::count;
use super::functions::{State, pattern};
use crate::Analysis;
use crate::algebra::Symbol;
use crate::motion::QuantityKind;
use crate::program::{Id, Operation};

/// The runtime's word for a kind.
pub(super) fn kind(kind: QuantityKind) -> TokenStream {
    let kind = match kind {
        QuantityKind::JointForce => quote!(JointForce),
        QuantityKind::JointCouple => quote!(JointCouple),
        QuantityKind::DriveForce => quote!(DriveForce),
        QuantityKind::DriveTorque => quote!(DriveTorque),
        QuantityKind::DrivenDistance => quote!(DrivenDistance),
        QuantityKind::SpringForce => quote!(SpringForce),
        QuantityKind::SpringTorque => quote!(SpringTorque),
        QuantityKind::SectionForce => quote!(SectionForce),
        QuantityKind::BendingMoment => quote!(BendingMoment),
        QuantityKind::Momentum => quote!(Momentum),
        QuantityKind::AngularMomentum => quote!(AngularMomentum),
    };
    quote!(QuantityKind::#kind)
}

/// The method `quantity`.
pub(super) fn method(analysis: &Analysis, constants: &UsedConstants) -> TokenStream {
    let ids: Vec<Id> = analysis.functions.quantities.iter().map(|quantity| quantity.value).collect();
    let first = |id: Id| ids.iter().position(|other| *other == id);
    let together = &analysis.functions.together;
    let alone = |entry: &usize, id: Id| first(id) == Some(*entry) && !together.contains(entry);
    let arms = ids.iter().enumerate().filter(|(entry, id)| alone(entry, **id)).map(|(entry, &id)| {
        let entries = (entry..ids.len()).filter(|&other| ids[other] == id).map(count);
        let opposite = match analysis.functions.program.operation(id) {
            Operation::Neg(other) => first(other).filter(|&other| other < entry).map(count),
            _ => None,
        };
        let value = match opposite {
            Some(other) => {
                quote!(-<Self as BarSystem>::quantity(k, #other, state, accelerations, multipliers))
            }
            None => value(analysis, constants, &[id], |results| quote!(#(#results)*)),
        };
        quote!(#(#entries)|* => { #value })
    });
    let joints = (!together.is_empty()).then(|| {
        let (start, end) = (count(together.start), count(together.end));
        let values = value(
            analysis,
            constants,
            &ids[together.clone()],
            |results| quote!([#(#results),*][entry - #start]),
        );
        quote!(#start..#end => { #values })
    });
    quote! {
        fn quantity<S: Real>(
            k: &Constants<S>,
            entry: usize,
            state: &Self::State<S>,
            accelerations: &Self::Accelerations<S>,
            multipliers: &Self::Multipliers<S>,
        ) -> S {
            match entry {
                #(#arms)*
                #joints
                _ => S::from_f64(f64::NAN),
            }
        }
    }
}

fn value(
    analysis: &Analysis,
    constants: &UsedConstants,
    ids: &[Id],
    result: impl FnOnce(&[TokenStream]) -> TokenStream,
) -> TokenStream {
    let state = State { analysis, constants };
    let written = body::write(&analysis.functions.program, ids, &state, &quote!(S));
    let n = analysis.motion.n;
    let coordinates = move |order: u8| (0..n).map(move |i| Symbol::Coordinate { index: i as u16, order });
    let rows = (0..analysis.motion.rows.len()).map(|row| Symbol::Reaction(row as u16));
    let sources: [(TokenStream, Vec<Symbol>); 3] = [
        (quote!(state), coordinates(0).chain(coordinates(1)).chain(analysis.motion.carried()).collect()),
        (quote!(accelerations), coordinates(2).collect()),
        (quote!(multipliers), rows.collect()),
    ];
    let bindings =
        sources.into_iter().filter(|(_, symbols)| symbols.iter().any(|s| written.inputs.contains(s)));
    let bindings = bindings.map(|(source, symbols)| {
        let pattern = pattern(&state, symbols.into_iter(), &written.inputs);
        quote!(let #pattern = *#source;)
    });
    let (statements, result) = (&written.statements, result(&written.results));
    quote!(#(#bindings)* #statements #result)
}
