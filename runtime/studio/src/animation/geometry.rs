//! What joins the points of a model, and where its contacts act: indices only, read off its declaration.

use liftoff::model::Layout;
use liftoff_codegen::system::{Guide, OneSided, System};
use serde::Serialize;

/// What a drawing joins points with.
#[derive(Serialize, Default)]
pub(super) struct Geometry {
    pub bodies: Vec<Body>,
    /// Points that have a mass of their own.
    pub particles: Vec<usize>,
    pub springs: Vec<Spring>,
    /// Bars that points slide along, with the points.
    pub sleeves: Vec<Sleeve>,
    /// In order of the layout's contacts.
    pub contacts: Vec<Contact>,
}

#[derive(Serialize)]
pub(super) struct Body {
    name: String,
    /// Its points: two ends, or the corners of a polygon.
    outline: Vec<usize>,
}

#[derive(Serialize)]
pub(super) struct Spring {
    name: String,
    ends: [usize; 2],
    elastic: bool,
    damped: bool,
}

#[derive(Serialize)]
pub(super) struct Sleeve {
    point: usize,
    /// Ends of the bar.
    bar: [usize; 2],
}

#[derive(Serialize)]
pub(super) struct Contact {
    label: &'static str,
    /// Whether each place bears an equal share; else only the total is known.
    shared: bool,
    pub places: Vec<Place>,
}

/// Where a support acts. Its shape is the scenery of its name.
#[derive(Serialize)]
pub(super) struct Place {
    support: String,
    #[serde(flatten)]
    kind: Kind,
    /// ±1: along the tangent, or against it, where the tangential reaction is positive.
    pub slip: i8,
}

#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Kind {
    /// On a line or a circle.
    Point { point: usize },
    /// Bar over a corner: pushed along `side` times the bar's left normal.
    Corner { bar: [usize; 2], side: i8 },
    /// Points that a thread passes.
    Thread { path: Vec<usize> },
}

impl Geometry {
    /// Of a layout; empty if its declaration cannot be read again.
    pub fn of(layout: &'static Layout) -> Self {
        let tokens = layout.declaration.parse().ok();
        let system = tokens.and_then(|tokens| liftoff_codegen::resolve(tokens).ok());
        system.map_or_else(Self::default, |system| Self::read(layout, &system))
    }

    fn read(layout: &'static Layout, system: &System) -> Self {
        let bodies = system.bodies.iter();
        let bodies = bodies.map(|body| Body { name: body.name.clone(), outline: body.outline.clone() });
        let springs = system.springs.iter().map(|spring| Spring {
            name: spring.name.clone(),
            ends: spring.ends,
            elastic: spring.stiffness.is_some(),
            damped: spring.damping.is_some(),
        });
        let sleeves = system.sliders.iter().filter_map(|slider| match slider.guide {
            Guide::Axis(body) => Some(Sleeve { point: slider.point, bar: ends(system, body) }),
            Guide::Line { .. } => None,
        });
        Self {
            bodies: bodies.collect(),
            particles: system.particles.iter().map(|particle| particle.point).collect(),
            springs: springs.collect(),
            sleeves: sleeves.collect(),
            contacts: layout.contacts.iter().map(|contact| Contact::of(contact, system)).collect(),
        }
    }
}

impl Contact {
    fn of(contact: &'static liftoff::model::Contact, system: &System) -> Self {
        let index = |name: &&str| system.supports.iter().position(|support| support.name == **name);
        let supports: Vec<usize> = contact.supports.iter().filter_map(index).collect();
        let places = supports.iter().map(|&i| Place {
            support: system.supports[i].name.clone(),
            kind: Kind::of(&system.supports[i].contact, system),
            slip: if i == supports[0] { 1 } else { image(system, supports[0], i) },
        });
        Self { label: contact.label, shared: contact.shared, places: places.collect() }
    }
}

impl Kind {
    fn of(contact: &OneSided, system: &System) -> Self {
        match contact {
            OneSided::Line { point, .. } | OneSided::Circle { point, .. } => Self::Point { point: *point },
            OneSided::Corner { body, side, .. } => Self::Corner { bar: ends(system, *body), side: *side },
            OneSided::Thread { path, .. } => Self::Thread { path: path.clone() },
        }
    }
}

fn ends(system: &System, body: usize) -> [usize; 2] {
    [system.bodies[body].from, system.bodies[body].to]
}

/// Which way the tangent of a support points where that of its mirror image points forwards: a mirror turns a tangent
/// against the quarter turn from its normal; along a bar it goes as the bar's ends do.
fn image(system: &System, of: usize, support: usize) -> i8 {
    let Some(mirror) = system.mirror.as_ref().filter(|mirror| mirror.supports[of] == support) else {
        return 1;
    };
    match &system.supports[of].contact {
        OneSided::Corner { body, .. } if !mirror.bodies[*body].1 => 1,
        _ => -1,
    }
}
