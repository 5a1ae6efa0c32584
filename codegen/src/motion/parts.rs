//! Parts of a system that a cut leaves: whole bodies, and a piece of a bar.

use super::Inertia;
use super::action::{Action, Holder, Scene};
use super::expression::{Atoms, Expression};
use super::gap::inverse;
use crate::algebra::{Rational, Series};
use crate::system::{Body, Section};

/// One side of a cut.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// What belongs to it as a whole.
    pub holders: Vec<Holder>,
    /// The bar that is cut, and where.
    pub piece: Option<Piece>,
}

/// A piece of a uniform bar.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub body: usize,
    /// Where it is cut, from the bar's first point.
    pub at: Series,
    /// Whether it is the piece of the last point.
    pub far: bool,
}

impl Part {
    /// A body alone.
    pub fn alone(body: usize) -> Self {
        Self { holders: vec![Holder::Body(body)], piece: None }
    }

    /// A body with everything that hangs from it.
    pub fn beyond(scene: &Scene, body: usize) -> Self {
        let mut holders = vec![body];
        let mut next = 0;
        while next < holders.len() {
            let here = holders[next];
            next += 1;
            holders.extend(hanging(scene, |point| scene.kinematics.tree.owner[point] == Some(here)));
        }
        Self { holders: holders.into_iter().map(Holder::Body).collect(), piece: None }
    }

    /// The piece of a bar that is not held from the tree's root, with everything that hangs from it.
    pub fn section(scene: &Scene, section: &Section) -> Self {
        let behind = |point: usize| {
            let along = &scene.system.local(section.body, point)[0];
            scene.system.nominal_number(&(along - &section.at)) > 0.0
        };
        let far = !behind(scene.kinematics.tree.entry[section.body]);
        let owned = |point: usize| scene.kinematics.tree.owner[point] == Some(section.body);
        let children = hanging(scene, |point| owned(point) && behind(point) == far);
        let holders = children.flat_map(|body| Self::beyond(scene, body).holders).collect();
        Self { holders, piece: Some(Piece { body: section.body, at: section.at.clone(), far }) }
    }

    /// How much of an action acts on it.
    pub fn share(&self, scene: &Scene, atoms: &mut Atoms, action: &Action) -> Series {
        let Some(on) = action.on else { return Series::zero() };
        if self.holders.contains(&on) {
            return Series::one();
        }
        match &self.piece {
            Some(piece) if on == Holder::Body(piece.body) => piece.share(scene, atoms, &action.along),
            _ => Series::zero(),
        }
    }

    /// Everything of it that has mass.
    pub fn inertias(&self, scene: &Scene, atoms: &mut Atoms, all: &[Inertia]) -> Vec<Inertia> {
        let whole = all.iter().filter(|inertia| inertia.on.is_some_and(|on| self.holders.contains(&on)));
        let mut inertias: Vec<Inertia> = whole.cloned().collect();
        if let Some(piece) = &self.piece {
            inertias.push(piece.inertia(scene, atoms));
            inertias.extend(piece.carried(scene));
        }
        inertias
    }
}

/// The bodies reached by points of a kind.
fn hanging<'a>(scene: &Scene<'a>, through: impl Fn(usize) -> bool + 'a) -> impl Iterator<Item = usize> + 'a {
    let entry = &scene.kinematics.tree.entry;
    entry.iter().enumerate().filter(move |(_, point)| through(**point)).map(|(body, _)| body)
}

impl Piece {
    fn bar<'a>(&self, scene: &Scene<'a>) -> &'a Body {
        &scene.system.bodies[self.body]
    }

    /// 1 for what acts on it, 0 for what acts on the other piece; of what moves along the bar `½ (1 ± x/|x|)`.
    fn share(&self, scene: &Scene, atoms: &mut Atoms, along: &Series) -> Series {
        let behind = along - &self.at;
        if behind.symbols().iter().all(|symbol| symbol.is_parameter()) {
            let far = scene.system.nominal_number(&behind) > 0.0;
            return if far == self.far { Series::one() } else { Series::zero() };
        }
        let x = || Expression::series(behind.clone());
        let sign = atoms.symbol("side", x().over(x().times(x()).sqrt()));
        let sign = if self.far { sign } else { -sign };
        (&Series::one() + &sign).scale(Rational::new(1, 2))
    }

    /// `m s/l`, its middle and `m s²/12` about it.
    fn inertia(&self, scene: &Scene, atoms: &mut Atoms) -> Inertia {
        let bar = self.bar(scene);
        let (length, start) = match self.far {
            true => (&bar.length - &self.at, self.at.clone()),
            false => (self.at.clone(), Series::zero()),
        };
        let mass = &(&bar.mass * &inverse(atoms, &bar.length)) * &length;
        let inertia = (&(&mass * &length) * &length).scale(Rational::new(1, 12));
        let middle = &start + &length.scale(Rational::new(1, 2));
        let centre = scene.kinematics.place(scene.system, self.body, &[middle, Series::zero()]);
        let spin = scene.kinematics.directions[self.body].rate();
        Inertia { on: Some(Holder::Body(self.body)), mass, inertia, centre, spin }
    }

    /// Point masses on it.
    fn carried(&self, scene: &Scene) -> Vec<Inertia> {
        let on = Some(Holder::Body(self.body));
        let mine = |point: usize| {
            let along = &scene.system.local(self.body, point)[0];
            (scene.system.nominal_number(&(along - &self.at)) > 0.0) == self.far
        };
        let particles = scene.system.particles.iter();
        let particles = particles.filter(|p| scene.holder(p.point) == on && mine(p.point));
        let inertia = |point: usize, mass: &Series| Inertia {
            on,
            mass: mass.clone(),
            inertia: Series::zero(),
            centre: scene.kinematics.points[point].clone(),
            spin: Series::zero(),
        };
        particles.map(|particle| inertia(particle.point, &particle.mass)).collect()
    }
}
