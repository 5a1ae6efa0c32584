//! Positions of the points: each connected component is laid out from a root point and then
//! anchored, axis by axis, by a pin, by the mirror, by a declared coordinate, or by a coordinate of
//! its own.

use super::{Coordinate, Joint, SpanningTree, offset};
use crate::algebra::{Angle, Rational, Series, Symbol};
use crate::syntax::plain;
use crate::system::{CoordinateKind, System};

/// Positions of all points, and the constraints that remain.
pub(super) struct Placed {
    pub points: Vec<[Series; 2]>,
    pub joints: Vec<Joint>,
    pub tree: SpanningTree,
}

pub(super) const AXES: [&str; 2] = ["x", "y"];

/// Points that hang together.
pub(super) struct Component {
    root: usize,
    pub members: Vec<usize>,
    pub closures: Vec<Closure>,
}

/// A point that a second body of a loop reaches, and where it puts it less where it is.
pub(super) struct Closure {
    pub point: usize,
    pub body: usize,
    pub gap: [Series; 2],
}

/// Places every point; appends the coordinates of unanchored components.
pub(super) fn place_points(
    system: &System,
    directions: &[Angle],
    coordinates: &mut Vec<Coordinate>,
) -> syn::Result<Placed> {
    let mut layout = Layout {
        system,
        relative: vec![origin(); system.points.len()],
        reached: vec![false; system.points.len()],
        points: vec![None; system.points.len()],
        joints: Vec::new(),
        tree: SpanningTree {
            entry: vec![0; system.bodies.len()],
            owner: vec![None; system.points.len()],
            root: vec![0; system.points.len()],
        },
        used: vec![false; system.coordinates.len()],
    };
    layout.fixed();
    for root in roots(system) {
        if !layout.reached[root] {
            let component = layout.walk(root, directions);
            layout.anchor(&component, coordinates)?;
        }
    }
    layout.unused()?;
    let points = layout.points.into_iter().map(|p| p.unwrap_or_else(origin)).collect();
    Ok(Placed { points, joints: layout.joints, tree: layout.tree })
}

fn origin() -> [Series; 2] {
    [Series::zero(), Series::zero()]
}

/// Pinned points first, then those with a declared position, then those on the mirror, then the
/// rest.
fn roots(system: &System) -> Vec<usize> {
    let pinned = system.pins.iter().map(|pin| pin.point);
    let declared = system.coordinates.iter().filter_map(|c| match c.kind {
        CoordinateKind::Position { point, .. } => Some(point),
        CoordinateKind::Angle { .. } => None,
    });
    let central = system
        .mirror
        .iter()
        .flat_map(|mirror| mirror.points.iter().enumerate().filter(|(p, image)| p == *image).map(|(p, _)| p));
    pinned.chain(declared).chain(central).chain(0..system.points.len()).collect()
}

/// Positions while they are found.
pub(super) struct Layout<'a> {
    pub system: &'a System,
    relative: Vec<[Series; 2]>,
    reached: Vec<bool>,
    pub points: Vec<Option<[Series; 2]>>,
    pub joints: Vec<Joint>,
    tree: SpanningTree,
    used: Vec<bool>,
}

impl Layout<'_> {
    /// Points of the ground.
    fn fixed(&mut self) {
        for (point, declared) in self.system.points.iter().enumerate() {
            if let Some(at) = &declared.ground {
                self.reached[point] = true;
                self.points[point] = Some(at.clone());
            }
        }
    }

    fn walk(&mut self, root: usize, directions: &[Angle]) -> Component {
        let mut component = Component { root, members: vec![root], closures: Vec::new() };
        let mut placed = vec![false; self.system.bodies.len()];
        self.reached[root] = true;
        self.tree.root[root] = root;
        let mut next = 0;
        while next < component.members.len() {
            let point = component.members[next];
            next += 1;
            for (body, local) in &self.system.points[point].on {
                if !core::mem::replace(&mut placed[*body], true) {
                    self.tree.entry[*body] = point;
                    self.lay(point, *body, local, &directions[*body], &mut component);
                }
            }
        }
        component
    }

    fn lay(
        &mut self,
        point: usize,
        body: usize,
        local: &[Series; 2],
        direction: &Angle,
        component: &mut Component,
    ) {
        let first = offset(&self.relative[point], direction, &[-&local[0], -&local[1]]);
        for (other, declared) in self.system.points.iter().enumerate().filter(|(p, _)| *p != point) {
            for (_, local) in declared.on.iter().filter(|(b, _)| *b == body) {
                let position = offset(&first, direction, local);
                if self.reached[other] {
                    let known = &self.relative[other];
                    let gap = [&position[0] - &known[0], &position[1] - &known[1]];
                    component.closures.push(Closure { point: other, body, gap });
                } else {
                    self.relative[other] = position;
                    self.reached[other] = true;
                    self.tree.owner[other] = Some(body);
                    self.tree.root[other] = component.root;
                    component.members.push(other);
                }
            }
        }
    }

    fn anchor(&mut self, component: &Component, coordinates: &mut Vec<Coordinate>) -> syn::Result<()> {
        let pin = self.system.pins.iter().position(|pin| component.members.contains(&pin.point));
        let mut shift = Vec::new();
        for axis in 0..2 {
            shift.push(match pin {
                Some(pin) => {
                    let pin = &self.system.pins[pin];
                    &pin.at[axis] - self.relative_position(pin.point, axis)
                }
                None => match self.by_mirror(component, axis) {
                    Some(shift) => shift,
                    None => self.by_coordinate(component, axis, coordinates),
                },
            });
        }
        for &point in &component.members {
            let position = core::array::from_fn(|axis| self.relative_position(point, axis) + &shift[axis]);
            self.points[point] = Some(position);
        }
        self.close(component, pin)
    }

    fn relative_position(&self, point: usize, axis: usize) -> &Series {
        &self.relative[point][axis]
    }

    /// The image of point P is at `2 at − x_P` across the mirror and level with P along it.
    fn by_mirror(&self, component: &Component, axis: usize) -> Option<Series> {
        let mirror = self.system.mirror.as_ref()?;
        let image = mirror.points[component.root];
        let twice = mirror.at.scale(Rational::integer(2));
        if component.members.contains(&image) {
            let sum = self.relative_position(component.root, axis) + self.relative_position(image, axis);
            return (axis == mirror.axis).then(|| (&twice - &sum).scale(Rational::new(1, 2)));
        }
        let placed = self.points[image].as_ref()?;
        let target = if axis == mirror.axis { &twice - &placed[axis] } else { placed[axis].clone() };
        Some(&target - self.relative_position(component.root, axis))
    }

    fn by_coordinate(
        &mut self,
        component: &Component,
        axis: usize,
        coordinates: &mut Vec<Coordinate>,
    ) -> Series {
        let declared = self.system.coordinates.iter().enumerate().find_map(|(i, c)| match c.kind {
            CoordinateKind::Position { point, axis: a, sign }
                if a == axis && component.members.contains(&point) =>
            {
                Some((i, point, sign))
            }
            _ => None,
        });
        let symbol = Series::symbol(Symbol::coordinate(coordinates.len()));
        let (name, point, sign) = match declared {
            Some((i, point, sign)) => {
                self.used[i] = true;
                (plain(&self.system.coordinates[i].name), point, sign)
            }
            None => {
                let root = component.root;
                (format!("{}_{}", AXES[axis], self.system.points[root].name), root, 1)
            }
        };
        let reading = CoordinateKind::Position { point, axis, sign };
        coordinates.push(Coordinate { name, reading });
        &symbol.scale(Rational::integer(sign.into())) - self.relative_position(point, axis)
    }

    fn unused(&self) -> syn::Result<()> {
        let mut errors = self.system.coordinates.iter().zip(&self.used).filter_map(|(c, used)| {
            let position = matches!(c.kind, CoordinateKind::Position { .. });
            (position && !used).then(|| {
                let text = format!(
                    "`{}` is determined already by a pin, the mirror or another coordinate; remove it",
                    c.name
                );
                syn::Error::new(c.name.span(), text)
            })
        });
        let Some(mut all) = errors.next() else { return Ok(()) };
        errors.for_each(|e| all.combine(e));
        Err(all)
    }
}
