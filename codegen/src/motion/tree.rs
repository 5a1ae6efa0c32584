//! Systems whose bodies hang from fixed or free points as trees: each turns about a point of the
//! body before it, by a coordinate of its own that measures its direction; a free point has its
//! place for coordinates. Loops close such trees.

use super::Motion;
use super::action::{Holder, Scene};
use crate::algebra::{Series, Symbol};

/// The bodies of such a system, each after the one it hangs from.
#[derive(Clone, Debug)]
pub struct Tree {
    /// One for each body.
    pub branches: Vec<Branch>,
    /// The free points that branches begin at.
    pub bases: Vec<Base>,
}

/// A free point: its place is the values of two coordinates, each with its sign.
#[derive(Clone, Debug)]
pub struct Base {
    /// The point.
    pub point: usize,
    /// The coordinates along x and y, and ±1.
    pub coordinates: [(usize, i8); 2],
}

/// A body of a tree.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The body.
    pub body: usize,
    /// The branch it hangs from, none where the ground or a base holds it.
    pub parent: Option<usize>,
    /// The base it begins at, if it begins at one.
    pub base: Option<usize>,
    /// Its coordinate.
    pub coordinate: usize,
    /// ±1: how its direction turns with the coordinate.
    pub sign: i8,
    /// The point that it turns about, from the one that its parent turns about, in the parent's
    /// frame; on the ground or at a base from the origin.
    pub reach: [Series; 2],
    /// Its mass, and the point masses on it.
    pub lumped_masses: Vec<LumpedMass>,
}

/// A mass of a branch.
#[derive(Clone, PartialEq, Debug)]
pub struct LumpedMass {
    /// Mass.
    pub mass: Series,
    /// Its centre from the point that the branch turns about, in the body's frame.
    pub at: [Series; 2],
    /// Moment of inertia about its centre.
    pub inertia: Series,
}

impl Tree {
    /// The tree that a system is but for its joints; `None` for one with bodies that turn together,
    /// or a mirror.
    pub fn recognise(scene: &Scene, motion: &Motion) -> Option<Self> {
        let (system, kinematics) = (scene.system, scene.kinematics);
        let count = system.bodies.len();
        if system.mirror.is_some() || count == 0 {
            return None;
        }
        let mut bases = Vec::new();
        let mut placed: Vec<Option<usize>> = vec![None; count];
        let mut branches: Vec<Branch> = Vec::with_capacity(count);
        while branches.len() < count {
            let ready = |&body: &usize| {
                let above = kinematics.tree.owner[kinematics.tree.entry[body]];
                placed[body].is_none() && above.is_none_or(|above| placed[above].is_some())
            };
            let ready: Vec<usize> = (0..count).filter(ready).collect();
            for &body in &ready {
                branches.push(Branch::recognise(scene, body, &placed, &mut bases)?);
                placed[body] = Some(branches.len() - 1);
            }
            if ready.is_empty() {
                return None;
            }
        }
        for particle in &system.particles {
            let Some(Holder::Body(body)) = scene.holder(particle.point) else { return None };
            let at = between(scene, body, kinematics.tree.entry[body], particle.point);
            let lumped = LumpedMass { mass: particle.mass.clone(), at, inertia: Series::zero() };
            branches[placed[body]?].lumped_masses.push(lumped);
        }
        let complete = motion.n == count + 2 * bases.len() && branches.iter().all(Branch::has_inertia);
        complete.then_some(Self { branches, bases })
    }

    /// Masses of each branch with everything that hangs from it.
    pub fn masses(&self) -> Vec<Series> {
        let mut masses: Vec<Series> = self.branches.iter().map(Branch::mass).collect();
        for (i, branch) in self.branches.iter().enumerate().rev() {
            if let Some(parent) = branch.parent {
                let beyond = masses[i].clone();
                masses[parent] += beyond;
            }
        }
        masses
    }
}

impl Branch {
    fn recognise(
        scene: &Scene,
        body: usize,
        placed: &[Option<usize>],
        bases: &mut Vec<Base>,
    ) -> Option<Self> {
        let (system, kinematics) = (scene.system, scene.kinematics);
        let &[(Symbol::Coordinate { index, order: 0 }, sign @ (1 | -1))] =
            kinematics.directions[body].terms()
        else {
            return None;
        };
        let alone =
            |other: usize| kinematics.directions[other].coefficient(Symbol::coordinate(index.into())) == 0;
        if !(0..system.bodies.len()).filter(|&other| other != body).all(alone) {
            return None;
        }
        let entry = kinematics.tree.entry[body];
        let above = kinematics.tree.owner[entry];
        let reach = match above {
            Some(above) => between(scene, above, kinematics.tree.entry[above], entry),
            None => kinematics.points[entry].clone(),
        };
        let fixed = reach.iter().all(|part| part.symbols().iter().all(|symbol| symbol.is_parameter()));
        let base = if fixed { None } else { Some(Base::find_or_insert(entry, &reach, bases)?) };
        let parent = above.and_then(|above| placed[above]);
        let (coordinate, sign) = (index.into(), sign as i8);
        let (own, first) = (&system.bodies[body], system.local(body, entry));
        let at = [0, 1].map(|axis| &own.centre[axis] - &first[axis]);
        let lumped = LumpedMass { mass: own.mass.clone(), at, inertia: own.inertia.clone() };
        Some(Self { body, parent, base, coordinate, sign, reach, lumped_masses: vec![lumped] })
    }

    /// Its mass.
    pub fn mass(&self) -> Series {
        self.lumped_masses.iter().map(|lumped| lumped.mass.clone()).sum()
    }

    /// Its first moment about the point that it turns about, in its frame.
    pub fn first(&self) -> [Series; 2] {
        [0, 1].map(|axis| self.lumped_masses.iter().map(|lumped| &lumped.mass * &lumped.at[axis]).sum())
    }

    /// Its moment of inertia about that point.
    pub fn inertia(&self) -> Series {
        self.lumped_masses.iter().map(|lumped| &lumped.inertia + &(&lumped.mass * &square(&lumped.at))).sum()
    }

    fn has_inertia(&self) -> bool {
        !self.inertia().is_zero()
    }
}

impl Base {
    /// The base at a point that is placed by coordinates alone, entered among `bases`.
    fn find_or_insert(point: usize, place: &[Series; 2], bases: &mut Vec<Self>) -> Option<usize> {
        if let Some(known) = bases.iter().position(|base| base.point == point) {
            return Some(known);
        }
        let [x, y] = place.each_ref().map(|part| {
            let mut symbols = part.symbols().into_iter();
            let (Some(symbol @ Symbol::Coordinate { index, order: 0 }), None) =
                (symbols.next(), symbols.next())
            else {
                return None;
            };
            let value = Series::symbol(symbol);
            [(value.clone(), 1), (-value, -1)]
                .into_iter()
                .find(|(v, _)| v == part)
                .map(|(_, sign)| (index.into(), sign))
        });
        bases.push(Self { point, coordinates: [x?, y?] });
        Some(bases.len() - 1)
    }
}

/// A point of a body from another of it, in its frame.
fn between(scene: &Scene, body: usize, from: usize, to: usize) -> [Series; 2] {
    let (from, to) = (scene.system.local(body, from), scene.system.local(body, to));
    [0, 1].map(|axis| &to[axis] - &from[axis])
}

/// |v|².
pub fn square(v: &[Series; 2]) -> Series {
    &(&v[0] * &v[0]) + &(&v[1] * &v[1])
}
