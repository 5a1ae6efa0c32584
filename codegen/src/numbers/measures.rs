//! Physical quantities of a model, and what its figure settled, each as a number to be checked.

use super::ParameterProgram;
use super::measure::{Measure, MeasureKind, MeasureValue};
use super::settled::Open;
use crate::Analysis;
use crate::algebra::Series;
use crate::program::Id;
use crate::system::{Guide, Spring, Support};

/// All measures of a model.
#[derive(Clone, Debug)]
pub struct Measures {
    /// What they are made of.
    pub numbers: ParameterProgram,
    /// One by one.
    pub entries: Vec<Measure>,
    /// Whether some of them need the coordinates of the figure.
    pub reads_figure: bool,
}

impl Measures {
    pub(super) fn lower(analysis: &Analysis) -> Self {
        let all = physical(analysis);
        let open = Open::new(analysis);
        let numbers = ParameterProgram::lower(&analysis.system, |lowering| {
            let values: Vec<Id> = all.iter().map(|(_, _, value)| lowering.series(value)).collect();
            values.into_iter().chain(open.lowered(lowering)).collect()
        });
        let settled = open.entries(all.len());
        let known = all.into_iter().enumerate();
        let known = known.map(|(k, (of, kind, _))| Measure { of, kind, value: MeasureValue::Number(k) });
        let entries = known.chain(settled).collect();
        Self { numbers, entries, reads_figure: open.reads_figure() }
    }
}

/// What has a value of its own: its owner, kind and value.
fn physical(analysis: &Analysis) -> Vec<(String, MeasureKind, Series)> {
    let system = &analysis.system;
    let bodies = system.bodies.iter().flat_map(|body| {
        let of = format!("{} {}", body.kind(), body.name);
        let lengths = body.extents.iter().map(|length| (length, MeasureKind::Length));
        [
            (&body.mass, MeasureKind::Mass),
            (&body.length, MeasureKind::Length),
            (&body.inertia, MeasureKind::Inertia),
        ]
        .into_iter()
        .chain(lengths)
        .map(move |(value, kind)| (of.clone(), kind, value.clone()))
    });
    let particles = system.particles.iter().map(|particle| {
        let of = format!("mass at {}", system.points[particle.point].name);
        (of, MeasureKind::Mass, particle.mass.clone())
    });
    let pair = |spring: &Spring| spring.ends.map(|end| system.points[end].name.as_str()).join(" and ");
    let springs = system.springs.iter().flat_map(|spring| {
        let of = format!("spring between {}", pair(spring));
        let values = [(&spring.stiffness, MeasureKind::Stiffness), (&spring.damping, MeasureKind::Damping)];
        values.map(|(value, kind)| Some((of.clone(), kind, value.as_ref()?.as_series()?.clone())))
    });
    let torsions = system.torsions.iter().flat_map(|torsion| {
        let of = format!("torsion of {}", torsion.name);
        let values =
            [(&torsion.stiffness, MeasureKind::TorsionalStiffness), (&torsion.damping, MeasureKind::Damping)];
        values.map(|(value, kind)| Some((of.clone(), kind, value.as_ref()?.as_series()?.clone())))
    });
    let extents = system.supports.iter().filter_map(Support::extent);
    let sections = system.sections.iter().flat_map(|section| {
        let rest = &system.bodies[section.body].length - &section.at;
        let of = format!("section {}", section.name);
        [(of.clone(), MeasureKind::Margin, section.at.clone()), (of, MeasureKind::Margin, rest)]
    });
    let discs = system.discs.iter().map(|disc| {
        let of = format!("the radius of the disc about {}", system.points[disc.centre].name);
        (of, MeasureKind::Extent, disc.radius.clone())
    });
    let circles = system.sliders.iter().filter_map(|slider| match &slider.guide {
        Guide::Circle { radius, .. } => {
            Some((format!("the radius of {}", slider.name), MeasureKind::Extent, radius.clone()))
        }
        _ => None,
    });
    let extents = extents
        .map(|(of, value)| (of, MeasureKind::Extent, value.clone()))
        .chain(discs)
        .chain(circles)
        .chain(sections);
    let particles = particles.chain(springs.chain(torsions).flatten()).chain(extents);
    let gravity = system.gravity.iter().flatten().filter(|component| !component.is_zero());
    let gravity = gravity.map(|component| ("gravity".to_owned(), MeasureKind::Gravity, component.clone()));
    bodies.chain(particles).chain(gravity).collect()
}
