//! Systems that hang from fixed points as trees: each body turns about a point of the body before it, by a
//! coordinate of its own that measures its direction.

use super::Motion;
use super::action::{Holder, Scene};
use crate::algebra::{Series, Symbol};

/// The bodies of such a system, each after the one it hangs from.
#[derive(Clone, Debug)]
pub struct Tree {
    /// One for each body.
    pub branches: Vec<Branch>,
}

/// A body of a tree.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The body.
    pub body: usize,
    /// The branch it hangs from, none where the ground holds it.
    pub parent: Option<usize>,
    /// Its coordinate.
    pub coordinate: usize,
    /// ±1: how its direction turns with the coordinate.
    pub sign: i8,
    /// The point that it turns about, from the one that its parent turns about, in the parent's frame; on the ground from the origin.
    pub reach: [Series; 2],
    /// Its mass, and the point masses on it.
    pub lumps: Vec<Lump>,
}

/// A mass of a branch.
#[derive(Clone, Debug)]
pub struct Lump {
    /// Mass.
    pub mass: Series,
    /// Its centre from the point that the branch turns about, in the body's frame.
    pub at: [Series; 2],
    /// Moment of inertia about its centre.
    pub inertia: Series,
}

impl Tree {
    /// The tree that a system is; `None` for one with loops, guides, drives, bodies that fly or turn together, or a
    /// mirror.
    pub fn of(scene: &Scene, motion: &Motion) -> Option<Self> {
        let (system, kinematics) = (scene.system, scene.kinematics);
        let count = system.bodies.len();
        if system.mirror.is_some() || !kinematics.joints.is_empty() || motion.n != count || count == 0 {
            return None;
        }
        let mut placed: Vec<Option<usize>> = vec![None; count];
        let mut branches: Vec<Branch> = Vec::with_capacity(count);
        while branches.len() < count {
            let ready = |&body: &usize| {
                let above = kinematics.tree.owner[kinematics.tree.entry[body]];
                placed[body].is_none() && above.is_none_or(|above| placed[above].is_some())
            };
            let ready: Vec<usize> = (0..count).filter(ready).collect();
            for &body in &ready {
                branches.push(Branch::of(scene, body, &placed)?);
                placed[body] = Some(branches.len() - 1);
            }
            if ready.is_empty() {
                return None;
            }
        }
        for particle in &system.particles {
            let Some(Holder::Body(body)) = scene.holder(particle.point) else { return None };
            let at = between(scene, body, kinematics.tree.entry[body], particle.point);
            let lump = Lump { mass: particle.mass.clone(), at, inertia: Series::zero() };
            branches[placed[body]?].lumps.push(lump);
        }
        branches.iter().all(Branch::has_inertia).then_some(Self { branches })
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
    fn of(scene: &Scene, body: usize, placed: &[Option<usize>]) -> Option<Self> {
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
        let parent = above.and_then(|above| placed[above]);
        let (coordinate, sign) = (index.into(), sign as i8);
        let (own, first) = (&system.bodies[body], system.local(body, entry));
        let at = [0, 1].map(|axis| &own.centre[axis] - &first[axis]);
        let lump = Lump { mass: own.mass.clone(), at, inertia: own.inertia.clone() };
        fixed.then_some(Self { body, parent, coordinate, sign, reach, lumps: vec![lump] })
    }

    /// Its mass.
    pub fn mass(&self) -> Series {
        self.lumps.iter().map(|lump| lump.mass.clone()).sum()
    }

    /// Its first moment about the point that it turns about, in its frame.
    pub fn first(&self) -> [Series; 2] {
        [0, 1].map(|axis| self.lumps.iter().map(|lump| &lump.mass * &lump.at[axis]).sum())
    }

    /// Its moment of inertia about that point.
    pub fn inertia(&self) -> Series {
        self.lumps.iter().map(|lump| &lump.inertia + &(&lump.mass * &square(&lump.at))).sum()
    }

    fn has_inertia(&self) -> bool {
        !self.inertia().is_zero()
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
