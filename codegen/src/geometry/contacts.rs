//! Supports and guides as they stand, and where supports and threads push or pull.

use super::{DrawnDirection, DrawnShape, Fixture, GeometryDraft, Push, Solid, Spot};
use crate::system::{Centre, Guide, OneSided};

impl GeometryDraft<'_> {
    /// Supports, then guides.
    pub(super) fn fixtures(&mut self) -> Vec<Fixture> {
        let mut fixtures = Vec::new();
        for support in self.system.supports.iter().filter(|support| !support.two_sided) {
            let (at, shape) = match &support.contact {
                OneSided::Line { through, direction, .. } => {
                    (through, DrawnShape::Line { angle: self.numbers.angle(direction), solid: true })
                }
                OneSided::Corner { at, .. } => (at, DrawnShape::Wedge),
                OneSided::Circle { centre: Centre::Ground(centre), radius, inside, .. } => {
                    let (text, radius) = (self.text(radius), self.numbers.length(radius));
                    (centre, DrawnShape::Circle { radius, solid: solid(*inside), text })
                }
                OneSided::Circle { .. }
                | OneSided::Edge { .. }
                | OneSided::Stop { .. }
                | OneSided::Hinge { .. }
                | OneSided::Thread { .. }
                | OneSided::Limit { .. }
                | OneSided::Drive(_) => continue,
            };
            fixtures.push(Fixture { name: support.name.clone(), at: self.numbers.position(at), shape });
        }
        for slider in &self.system.sliders {
            let (at, shape) = match &slider.guide {
                Guide::Line { through, direction } => {
                    (through, DrawnShape::Line { angle: self.numbers.angle(direction), solid: false })
                }
                Guide::Circle { centre, radius, .. } => {
                    let (text, radius) = (self.text(radius), self.numbers.length(radius));
                    (centre, DrawnShape::Circle { radius, solid: Solid::Nowhere, text })
                }
                Guide::Axis(_) => continue,
            };
            fixtures.push(Fixture { name: slider.name.clone(), at: self.numbers.position(at), shape });
        }
        fixtures
    }

    /// One of each support, two of each thread.
    pub(super) fn pushes(&mut self) -> Vec<Push> {
        let mut pushes = Vec::new();
        for (i, support) in self.system.supports.iter().enumerate() {
            let sense = self.sense(i);
            let rim = support.disc.as_ref().map(|disc| self.numbers.length(&disc.radius));
            let push =
                |at, along, turns, slip| Push { support: support.name.clone(), at, rim, along, turns, slip };
            match &support.contact {
                OneSided::Line { point, direction, .. } => {
                    let along = DrawnDirection::Fixed(self.numbers.angle(direction));
                    pushes.push(push(Spot::Point(*point), along, 1, -sense));
                }
                OneSided::Corner { body, at, side } => {
                    let at = Spot::Fixed(self.numbers.position(at));
                    let turns = if *side > 0 { 1 } else { 3 };
                    pushes.push(push(at, self.axis(*body), turns, -side * sense));
                }
                OneSided::Edge { point, edge, side } => {
                    let [from, to] = edge.ends.map(Spot::Point);
                    let turns = if *side > 0 { 1 } else { 3 };
                    pushes.push(push(
                        Spot::Point(*point),
                        DrawnDirection::Towards(from, to),
                        turns,
                        -side * sense,
                    ));
                }
                OneSided::Circle { point, centre, inside, .. } => {
                    let centre = match centre {
                        Centre::Ground(at) => Spot::Fixed(self.numbers.position(at)),
                        Centre::Point { point, .. } => Spot::Point(*point),
                    };
                    let at = Spot::Point(*point);
                    let (turns, slip) = if *inside { (2, -sense) } else { (0, sense) };
                    pushes.push(push(at, DrawnDirection::Towards(centre, at), turns, slip));
                }
                OneSided::Stop { point, body, is_last } => {
                    let (along, turns) = (self.axis(*body), if *is_last { 2 } else { 0 });
                    pushes.push(push(Spot::Point(*point), along, turns, 0));
                }
                OneSided::Hinge { .. } | OneSided::Limit { .. } | OneSided::Drive(_) => {}
                OneSided::Thread { path, .. } => {
                    let last = path.len() - 1;
                    for (end, next) in [(0, 1), (last, last - 1)] {
                        let [at, to] = [path[end], path[next]].map(Spot::Point);
                        pushes.push(push(at, DrawnDirection::Towards(at, to), 0, 0));
                    }
                }
            }
        }
        pushes
    }

    /// Which way the tangent of a support points where that of the one it is the mirror image of
    /// points forwards: a mirror turns a tangent against the quarter turn from its normal; along a
    /// bar it goes as the bar's ends do.
    fn sense(&self, support: usize) -> i8 {
        let Some(mirror) = &self.system.mirror else { return 1 };
        let Some(of) = (0..support).find(|&of| mirror.supports[of] == support) else { return 1 };
        match (&self.system.supports[of].contact, &self.system.supports[support].contact) {
            (OneSided::Corner { body, .. }, _) if !mirror.bodies[*body].1 => 1,
            (OneSided::Edge { edge, .. }, OneSided::Edge { edge: image, .. })
                if edge.ends.map(|end| mirror.points[end]) == image.ends =>
            {
                1
            }
            _ => -1,
        }
    }
}

/// Where a circle is solid that keeps points inside or outside.
pub(super) fn solid(inside: bool) -> Solid {
    if inside { Solid::Around } else { Solid::Within }
}
