//! What moves: bodies, threads, springs, blocks; marks at points.

use super::contacts::solid;
use super::{
    DrawnBody, DrawnDirection, DrawnSection, DrawnSpring, DrawnThread, GeometryDraft, Look, Round, Solid,
    Spot,
};
use crate::algebra::Series;
use crate::system::{Centre, Formula, Guide, OneSided, Point};

impl GeometryDraft<'_> {
    pub(super) fn bodies(&self) -> Vec<DrawnBody> {
        let points = || self.system.points.iter().enumerate();
        let body = |(i, outline): (usize, &Vec<usize>)| {
            let is_inner = |(index, point): &(usize, &Point)| {
                point.on.iter().any(|(body, _)| *body == i) && !outline.contains(index)
            };
            let inner = points().filter(is_inner).map(|(index, _)| index).collect();
            DrawnBody { outline: outline.clone(), inner }
        };
        self.system.bodies.iter().map(|body| &body.outline).enumerate().map(body).collect()
    }

    /// Discs, then circles of supports about points, each once.
    pub(super) fn rounds(&mut self) -> Vec<Round> {
        let system = self.system;
        let mut rounds: Vec<Round> = Vec::new();
        for disc in &system.discs {
            rounds.push(self.round(disc.centre, &disc.radius, Solid::Within, disc.body));
        }
        for support in &system.supports {
            if let OneSided::Circle { centre: Centre::Point { point, body }, radius, inside, .. } =
                &support.contact
            {
                let round = self.round(*point, radius, solid(*inside), *body);
                let same = |other: &Round| {
                    (other.centre, other.radius, other.solid) == (round.centre, round.radius, round.solid)
                };
                if !rounds.iter().any(same) {
                    rounds.push(round);
                }
            }
        }
        rounds
    }

    fn round(&mut self, centre: usize, radius: &Series, solid: Solid, body: Option<usize>) -> Round {
        let along = body.map(|body| self.axis(body));
        Round { centre, radius: self.numbers.length(radius), text: self.text(radius), solid, along }
    }

    pub(super) fn threads(&mut self) -> Vec<DrawnThread> {
        let mut threads = Vec::new();
        for support in &self.system.supports {
            if let OneSided::Thread { path, length } = &support.contact {
                let (name, path) = (support.name.clone(), path.clone());
                let text = self.text(length);
                threads.push(DrawnThread { name, path, length: self.numbers.length(length), text });
            }
        }
        threads
    }

    pub(super) fn springs(&self) -> Vec<DrawnSpring> {
        let springs = self.system.springs.iter();
        springs
            .map(|spring| {
                let values = [&spring.stiffness, &spring.damping].into_iter().flatten();
                let texts = values
                    .filter_map(Formula::as_series)
                    .map(|value| self.text(value))
                    .filter(|text| !text.is_empty());
                DrawnSpring {
                    name: spring.name.clone(),
                    ends: spring.ends,
                    coil: spring.stiffness.is_some(),
                    dashpot: spring.damping.is_some(),
                    text: texts.collect::<Vec<_>>().join(", "),
                }
            })
            .collect()
    }

    /// About the point that both bodies have, if there is one.
    pub(super) fn spirals(&mut self) -> Vec<(usize, DrawnDirection)> {
        let mut spirals = Vec::new();
        for torsion in &self.system.torsions {
            let own = self.ends(torsion.body);
            let other = torsion.from.map(|other| self.ends(other));
            let shared = other.and_then(|other| own.into_iter().find(|end| other.contains(end)));
            spirals.push((shared.unwrap_or(own[0]), self.axis(torsion.body)));
        }
        spirals
    }

    pub(super) fn blocks(&mut self) -> Vec<(usize, DrawnDirection)> {
        let mut blocks = Vec::new();
        for slider in &self.system.sliders {
            let along = match &slider.guide {
                Guide::Line { direction, .. } => DrawnDirection::Fixed(self.numbers.angle(direction)),
                Guide::Circle { centre, .. } => DrawnDirection::Towards(
                    Spot::Fixed(self.numbers.position(centre)),
                    Spot::Point(slider.point),
                ),
                Guide::Axis(body) => self.axis(*body),
            };
            blocks.push((slider.point, along));
        }
        blocks
    }

    pub(super) fn sections(&mut self) -> Vec<DrawnSection> {
        let mut sections = Vec::new();
        for section in &self.system.sections {
            let (name, at) = (section.name.clone(), self.numbers.length(&section.at));
            sections.push(DrawnSection { name, ends: self.ends(section.body), at });
        }
        sections
    }

    /// Pegs, masses, then the joints point by point.
    pub(super) fn marks(&self) -> Vec<(usize, Look)> {
        let points = 0..self.system.points.len();
        let pegs = points.clone().filter(|point| self.is_peg(*point)).map(|point| (point, Look::Peg));
        let masses = self.system.particles.iter().map(|particle| (particle.point, Look::Mass));
        let joints = points.flat_map(|point| self.joint(point).iter().map(move |look| (point, *look)));
        pegs.chain(masses).chain(joints).collect()
    }

    fn joint(&self, index: usize) -> &'static [Look] {
        let point = &self.system.points[index];
        let is_hinge = point.on.len() > 1;
        match point.ground {
            _ if self.is_pinned(index) => &[Look::Foot, Look::Ring],
            Some(_) if self.is_peg(index) => &[Look::Ring],
            Some(_) => &[Look::Ring, Look::Ground],
            None if is_hinge && self.is_welded(index) => &[Look::Disc],
            None if is_hinge => &[Look::Ring],
            None => &[],
        }
    }

    /// Whether the ground holds a point.
    pub(super) fn is_pinned(&self, point: usize) -> bool {
        self.system.pins.iter().any(|pin| pin.point == point)
    }

    /// Whether two bodies are joined there without turning about each other.
    fn is_welded(&self, point: usize) -> bool {
        let on = |body: usize| self.system.points[point].on.iter().any(|(other, _)| *other == body);
        self.system.welds.iter().any(|weld| on(weld.body) && weld.to.is_some_and(on))
    }

    /// Whether a thread passes over a fixed point.
    fn is_peg(&self, point: usize) -> bool {
        let fixed = self.system.points[point].ground.is_some() || self.is_pinned(point);
        let inner = |path: &[usize]| path.len() > 2 && path[1..path.len() - 1].contains(&point);
        let over = |contact: &OneSided| matches!(contact, OneSided::Thread { path, .. } if inner(path));
        fixed && self.system.supports.iter().any(|support| over(&support.contact))
    }
}
