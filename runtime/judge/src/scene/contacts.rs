//! One-sided constraints: their gaps, their slips, where a corner touches its bar.

use super::{Builder, Contact, Row, is_poisson};
use crate::tape::{Node, whole};
use liftoff_codegen::algebra::Series;
use liftoff_codegen::system::{Centre, Edge, OneSided, Support};
use liftoff_core::scalar::Scalar;

/// The angle of a body, and by how much a slip grows with it.
type Spin = Option<(usize, Node)>;

impl<S: Scalar> Builder<'_, S> {
    pub(super) fn contact(&mut self, support: &Support) -> Contact<S> {
        let (gap, slip, foot) = match &support.contact {
            OneSided::Line { point, through, direction } => {
                let height = self.height(*point, through, direction);
                let [tangent, _] = self.unit(direction);
                let (radius, rim) = self.rim(support, 1);
                let gap = self.tape.subtract(height, radius);
                (gap, Some(self.along(self.points[*point], tangent, &[rim])), None)
            }
            OneSided::Corner { body, at, side } => self.corner(*body, at, *side),
            OneSided::Edge { point, edge, side } => {
                let rim = self.rim(support, *side);
                self.edge(*point, edge, *side, rim)
            }
            OneSided::Circle { point, centre, radius, inside, .. } => {
                let (gap, slip) = self.circle(support, *point, (centre, radius), *inside);
                (gap, Some(slip), None)
            }
            OneSided::Stop { point, body, is_last } => (self.stop(*point, *body, *is_last), None, None),
            // It has friction, which is not judged.
            OneSided::Hinge { .. } => (Self::NOTHING, None, None),
            OneSided::Thread { path, length } => (self.thread(path, length), None, None),
            OneSided::Limit { driven, bound, is_upper, .. } => {
                let (value, bound) = (self.driven(driven), self.constant(bound));
                let ends = if *is_upper { [bound, value] } else { [value, bound] };
                (self.tape.subtract(ends[0], ends[1]), None, None)
            }
            // What has a condition has been refused.
            OneSided::Drive(_) => (Self::NOTHING, None, None),
        };
        Contact {
            name: support.name.clone(),
            row: self.row(gap),
            slip: slip.filter(|_| support.rough),
            foot,
            restitution: support.restitution.as_ref().map_or(S::ZERO, |e| self.values.number(e)),
            poisson: is_poisson(support.law),
            stop: support.stop,
        }
    }

    /// The radius of the disc that touches, and ± that for the angle of its body.
    fn rim(&mut self, support: &Support, sign: i8) -> (Node, Spin) {
        let Some(disc) = &support.disc else { return (Self::NOTHING, None) };
        let radius = self.constant(&disc.radius);
        let sign = self.tape.number(whole(sign.into()));
        let turned = self.tape.multiply(sign, radius);
        (radius, disc.body.map(|body| (3 * body + 2, turned)))
    }

    /// The slip of a place along a direction, d · Ṗ, and what turns beside it.
    fn along(&mut self, place: [Node; 2], direction: [Node; 2], spins: &[Spin]) -> Row {
        let slopes = place.map(|part| self.tape.gradient(part));
        let gradient = (0..self.forces.len()).filter_map(|i| {
            let of =
                |axis: usize| slopes[axis].iter().find(|(j, _)| *j == i).map_or(Self::NOTHING, |(_, n)| *n);
            let mut entry = self.tape.dot(direction, [of(0), of(1)]);
            for (_, factor) in spins.iter().flatten().filter(|(angle, _)| *angle == i) {
                entry = self.tape.add(entry, *factor);
            }
            (entry != Self::NOTHING).then_some((i, entry))
        });
        Row { value: None, gradient: gradient.collect(), prescribed_gap_rate: Self::NOTHING }
    }

    /// ± n · (A − K); e · Ċ − ω n · (K − C); e · (K − A) and what is left of the bar.
    fn corner(&mut self, body: usize, at: &[Series; 2], side: i8) -> (Node, Option<Row>, Option<[Node; 2]>) {
        let [along, across] = self.axes(body);
        let corner = self.constants(at);
        let declared = &self.system.bodies[body];
        let first = self.points_of(body, declared.from);
        let reach = self.difference(corner, first);
        let height = self.tape.dot(across, reach);
        let side = self.tape.number(whole(-i64::from(side)));
        let gap = self.tape.multiply(side, height);
        let from_first = self.tape.dot(along, reach);
        let length = self.constant(&declared.length);
        let from_last = self.tape.subtract(length, from_first);
        let centre = [self.tape.position(3 * body), self.tape.position(3 * body + 1)];
        let arm = self.difference(corner, centre);
        let lever = self.tape.dot(across, arm);
        let lever = self.tape.negate(lever);
        let gradient = vec![(3 * body, along[0]), (3 * body + 1, along[1]), (3 * body + 2, lever)];
        let slip = Row { value: None, gradient, prescribed_gap_rate: Self::NOTHING };
        (gap, Some(slip), Some([from_first, from_last]))
    }

    /// ± n · (P − A) − r; e · (Ṗ − Ȧ) ± r ω; e · (P − A) and what is left of the edge.
    fn edge(
        &mut self,
        point: usize,
        edge: &Edge,
        side: i8,
        (radius, rim): (Node, Spin),
    ) -> (Node, Option<Row>, Option<[Node; 2]>) {
        let [first, last] = edge.ends.map(|end| self.points_of(edge.body, end));
        let length = self.constant(&edge.length);
        let along = self.difference(last, first).map(|part| self.tape.divide(part, length));
        let across = [self.tape.negate(along[1]), along[0]];
        let reach = self.difference(self.points[point], first);
        let height = self.tape.dot(across, reach);
        let side = self.tape.number(whole(side.into()));
        let distance = self.tape.multiply(side, height);
        let gap = self.tape.subtract(distance, radius);
        let from_first = self.tape.dot(along, reach);
        let from_last = self.tape.subtract(length, from_first);
        (gap, Some(self.along(reach, along, &[rim])), Some([from_first, from_last]))
    }

    fn points_of(&mut self, body: usize, point: usize) -> [Node; 2] {
        let local = self.system.local(body, point);
        self.on_body(body, &local)
    }

    /// ± (d² − L²)/2L, L the sum of the radii, inside their difference; t · Ḋ ∓ r ω − R Ω.
    fn circle(
        &mut self,
        support: &Support,
        point: usize,
        (centre, radius): (&Centre, &Series),
        inside: bool,
    ) -> (Node, Row) {
        let radius = self.constant(radius);
        let (own, rim) = self.rim(support, if inside { 1 } else { -1 });
        let limit = if inside { self.tape.subtract(radius, own) } else { self.tape.add(radius, own) };
        let (centre, turns) = match centre {
            Centre::Ground(at) => (self.constants(at), None),
            Centre::Point { point, body } => {
                let back = self.tape.negate(radius);
                (self.points[*point], body.map(|body| (3 * body + 2, back)))
            }
        };
        let place = self.points[point];
        let square = self.square(centre, place);
        let least = self.tape.multiply(limit, limit);
        let bulge =
            if inside { self.tape.subtract(least, square) } else { self.tape.subtract(square, least) };
        let two = self.tape.number(whole(2));
        let twice = self.tape.multiply(two, limit);
        let gap = self.tape.divide(bulge, twice);
        let arm = self.difference(place, centre);
        let [x, y] = arm.map(|part| self.tape.divide(part, limit));
        let back = self.tape.negate(y);
        (gap, self.along(arm, [back, x], &[rim, turns]))
    }

    /// e · (P − A), or what is left of the bar.
    fn stop(&mut self, point: usize, body: usize, is_last: bool) -> Node {
        let [along, _] = self.axes(body);
        let first = self.points_of(body, self.system.bodies[body].from);
        let reach = self.difference(self.points[point], first);
        let from_first = self.tape.dot(along, reach);
        let length = self.constant(&self.system.bodies[body].length);
        if is_last { self.tape.subtract(length, from_first) } else { from_first }
    }

    /// ℓ − Σ d; (ℓ² − d²)/2ℓ where one part moves, ℓ less the others.
    fn thread(&mut self, path: &[usize], length: &Series) -> Node {
        let (mut left, mut moving) = (self.constant(length), Vec::new());
        for pair in path.windows(2) {
            let [(a, first), (b, last)] = [pair[0], pair[1]].map(|point| self.held(point));
            let square = self.square(a, b);
            if first && last {
                let distance = self.tape.root(square);
                left = self.tape.subtract(left, distance);
            } else {
                moving.push(square);
            }
        }
        if let [square] = moving[..] {
            let limit = self.tape.multiply(left, left);
            let slack = self.tape.subtract(limit, square);
            let two = self.tape.number(whole(2));
            let twice = self.tape.multiply(two, left);
            return self.tape.divide(slack, twice);
        }
        moving.into_iter().fold(left, |gap, square| {
            let distance = self.tape.root(square);
            self.tape.subtract(gap, distance)
        })
    }
}
