//! Numbers that parameters determine: measures and restitution.

use proc_macro2::TokenStream;

use super::body::{self, Body};
use super::constants::Parameters;
use super::{count, settled};
use crate::Analysis;
use crate::algebra::Series;
use crate::program::{Id, Lowering, Program};
use crate::system::{Guide, Spring, Support};

/// Lowers series of parameters and gives their expressions over `self` in `f64`.
pub(super) fn numbers(analysis: &Analysis, lower: impl FnOnce(&mut Lowering) -> Vec<Id>) -> Body {
    let mut program = Program::default();
    let ids = lower(&mut Lowering::new(&mut program, &analysis.system, &[], []));
    let inputs = Parameters { system: &analysis.system, scalar: quote!(f64) };
    body::write(&program, &ids, &inputs, &quote!(f64))
}

/// Only where some contact is not plastic.
pub(super) fn restitution(analysis: &Analysis) -> Option<TokenStream> {
    let supports = analysis.motion.contacts.iter().map(|contact| contact.support(&analysis.system));
    let frictions = analysis.motion.frictions().map(|(contact, _)| {
        let support = analysis.motion.contacts[contact].support(&analysis.system);
        support.friction.as_ref()?.tangential.clone()
    });
    let restitution = supports.map(|support| support.restitution.clone()).chain(frictions);
    let restitution: Vec<Option<Series>> = restitution.collect();
    if restitution.iter().all(Option::is_none) {
        return None;
    }
    let zero = Series::zero();
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        restitution.iter().map(|e| lowering.series(e.as_ref().unwrap_or(&zero))).collect()
    });
    Some(quote! {
        fn restitution(&self) -> Self::Reactions<f64> {
            #statements
            [#(#results),*]
        }
    })
}

/// `measures` and its type.
pub(super) fn measures(analysis: &Analysis) -> TokenStream {
    let system = &analysis.system;
    let bodies = system.bodies.iter().flat_map(|body| {
        let of = format!("{} {}", body.kind(), body.name);
        [(&body.mass, quote!(Mass)), (&body.length, quote!(Length)), (&body.inertia, quote!(Inertia))]
            .map(|(value, kind)| (of.clone(), kind, value.clone()))
    });
    let particles = system.particles.iter().map(|particle| {
        let of = format!("mass at {}", system.points[particle.point].name);
        (of, quote!(Mass), particle.mass.clone())
    });
    let pair = |spring: &Spring| spring.ends.map(|end| system.points[end].name.as_str()).join(" and ");
    let springs = system.springs.iter().flat_map(|spring| {
        let of = format!("spring between {}", pair(spring));
        let values = [(&spring.stiffness, quote!(Stiffness)), (&spring.damping, quote!(Damping))];
        values.map(|(value, kind)| Some((of.clone(), kind, value.as_ref()?.as_series()?.clone())))
    });
    let torsions = system.torsions.iter().flat_map(|torsion| {
        let of = format!("torsion of {}", torsion.name);
        let values = [(&torsion.stiffness, quote!(TorsionalStiffness)), (&torsion.damping, quote!(Damping))];
        values.map(|(value, kind)| Some((of.clone(), kind, value.as_ref()?.as_series()?.clone())))
    });
    let extents = system.supports.iter().filter_map(Support::extent);
    let sections = system.sections.iter().flat_map(|section| {
        let rest = &system.bodies[section.body].length - &section.at;
        let of = format!("section {}", section.name);
        [(of.clone(), quote!(Margin), section.at.clone()), (of, quote!(Margin), rest)]
    });
    let discs = system.discs.iter().map(|disc| {
        let of = format!("disc about {}", system.points[disc.centre].name);
        (of, quote!(Extent), disc.radius.clone())
    });
    let circles = system.sliders.iter().filter_map(|slider| match &slider.guide {
        Guide::Circle { radius, .. } => {
            Some((format!("the radius of {}", slider.name), quote!(Extent), radius.clone()))
        }
        _ => None,
    });
    let extents = extents
        .map(|(of, value)| (of, quote!(Extent), value.clone()))
        .chain(discs)
        .chain(circles)
        .chain(sections);
    let particles = particles.chain(springs.chain(torsions).flatten()).chain(extents);
    let gravity = system.gravity.iter().flatten().filter(|component| !component.is_zero());
    let gravity = gravity.map(|component| ("gravity".to_owned(), quote!(Gravity), component.clone()));
    let all: Vec<(String, TokenStream, Series)> = bodies.chain(particles).chain(gravity).collect();
    let settled = settled::of(analysis);
    let Body { statements, results, .. } = numbers(analysis, |lowering| {
        let values = all.iter().map(|(_, _, value)| lowering.series(value));
        let values: Vec<Id> = values.collect();
        values.into_iter().chain(settled.lowered(lowering)).collect()
    });
    let (values, rest) = results.split_at(all.len());
    let (of, kinds) = (all.iter().map(|(of, _, _)| of), all.iter().map(|(_, kind, _)| kind));
    let measured = of.zip(kinds).zip(values).map(|((of, kind), value)| entry(of, kind, value));
    let entries: Vec<TokenStream> = measured.chain(settled.entries(rest)).collect();
    let (length, nominal) = (count(entries.len()), settled.nominal());
    quote! {
        type Measures = [Measure; #length];
        fn measures(&self) -> Self::Measures {
            #statements
            #nominal
            [#(#entries),*]
        }
    }
}

pub(super) fn entry(of: &str, kind: &TokenStream, value: &TokenStream) -> TokenStream {
    quote!(Measure { of: #of, kind: MeasureKind::#kind, value: #value })
}
