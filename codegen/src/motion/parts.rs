//! Parts of a system that a cut leaves: whole bodies, and a piece of a bar.

use super::Inertia;
use super::action::{Action, Holder, Scene};
use super::expression::{Expression, OpaqueTerms};
use super::measured::inverse;
use crate::algebra::{Rational, Series};
use crate::system::{Body, Section};

/// One side of a cut.
#[derive(Clone, Debug)]
pub(super) struct CutSide {
    /// What belongs to it, and how much: 1, or 0 or 1 by a sign that the parameters decide.
    holders: Vec<(Holder, Series)>,
    /// The bar that is cut, and where.
    pub piece: Option<BarPiece>,
}

/// A piece of a uniform bar.
#[derive(Clone, Debug)]
pub(super) struct BarPiece {
    pub body: usize,
    /// Where it is cut, from the bar's first point.
    pub at: Series,
    /// Whether it is the piece of the last point.
    pub far: bool,
}

impl CutSide {
    /// A body alone.
    pub fn alone(body: usize) -> Self {
        Self { holders: vec![(Holder::Body(body), Series::one())], piece: None }
    }

    /// A body with everything that hangs from it.
    pub fn beyond(scene: &Scene, body: usize) -> Self {
        let holders = beyond(scene, body).into_iter().map(|body| (Holder::Body(body), Series::one()));
        Self { holders: holders.collect(), piece: None }
    }

    /// The piece of a bar that is not held from the tree's root, with everything that hangs from
    /// it; both pieces where the parameters decide which that is, each with how much it counts.
    pub fn section(scene: &Scene, opaque_terms: &mut OpaqueTerms, section: &Section) -> Vec<(Self, Series)> {
        let entry = &scene.system.local(section.body, scene.kinematics.tree.entry[section.body])[0];
        let pieces = [true, false].map(|far| BarPiece { body: section.body, at: section.at.clone(), far });
        let parts = pieces.into_iter().map(|piece| {
            let held = piece.share(scene, opaque_terms, entry);
            (Self::derive(scene, opaque_terms, piece), &Series::one() - &held)
        });
        parts.filter(|(_, counts)| !counts.is_zero()).collect()
    }

    fn derive(scene: &Scene, opaque_terms: &mut OpaqueTerms, piece: BarPiece) -> Self {
        let tree = &scene.kinematics.tree;
        let mut holders = Vec::new();
        for body in hanging(scene, |point| tree.owner[point] == Some(piece.body)) {
            let share =
                piece.share(scene, opaque_terms, &scene.system.local(piece.body, tree.entry[body])[0]);
            let bodies = if share.is_zero() { Vec::new() } else { beyond(scene, body) };
            holders.extend(bodies.into_iter().map(|body| (Holder::Body(body), share.clone())));
        }
        Self { holders, piece: Some(piece) }
    }

    /// Whether some of it belongs to it.
    pub fn holds(&self, on: Holder) -> bool {
        self.share_of(on).is_some() || self.piece.as_ref().is_some_and(|p| on == Holder::Body(p.body))
    }

    fn share_of(&self, on: Holder) -> Option<&Series> {
        self.holders.iter().find(|(holder, _)| *holder == on).map(|(_, share)| share)
    }

    /// How much of an action acts on it.
    pub fn share(&self, scene: &Scene, opaque_terms: &mut OpaqueTerms, action: &Action) -> Series {
        let Some(on) = action.on else { return Series::zero() };
        if let Some(share) = self.share_of(on) {
            return share.clone();
        }
        match &self.piece {
            Some(piece) if on == Holder::Body(piece.body) => piece.share(scene, opaque_terms, &action.along),
            _ => Series::zero(),
        }
    }

    /// Everything of it that has mass.
    pub fn inertias(&self, scene: &Scene, opaque_terms: &mut OpaqueTerms, all: &[Inertia]) -> Vec<Inertia> {
        let shared = all.iter().filter_map(|inertia| Some((inertia, self.share_of(inertia.on?)?)));
        let mut inertias: Vec<Inertia> = shared.map(|(inertia, share)| times(inertia, share)).collect();
        if let Some(piece) = &self.piece {
            inertias.push(piece.inertia(scene, opaque_terms));
            inertias.extend(piece.carried(scene, opaque_terms));
        }
        inertias
    }
}

fn times(inertia: &Inertia, share: &Series) -> Inertia {
    Inertia { mass: &inertia.mass * share, inertia: &inertia.inertia * share, ..inertia.clone() }
}

/// A body with everything that hangs from it.
fn beyond(scene: &Scene, body: usize) -> Vec<usize> {
    let mut bodies = vec![body];
    let mut next = 0;
    while next < bodies.len() {
        let here = bodies[next];
        next += 1;
        bodies.extend(hanging(scene, |point| scene.kinematics.tree.owner[point] == Some(here)));
    }
    bodies
}

/// The bodies reached by points of a kind.
fn hanging<'a>(scene: &Scene<'a>, through: impl Fn(usize) -> bool + 'a) -> impl Iterator<Item = usize> + 'a {
    let entry = &scene.kinematics.tree.entry;
    entry.iter().enumerate().filter(move |(_, point)| through(**point)).map(|(body, _)| body)
}

impl BarPiece {
    fn bar<'a>(&self, scene: &Scene<'a>) -> &'a Body {
        &scene.system.bodies[self.body]
    }

    /// 1 for what acts on it, 0 for what acts on the other piece; `½ (1 ± x/|x|)` of what moves
    /// along the bar, or stands where the parameters decide.
    fn share(&self, scene: &Scene, opaque_terms: &mut OpaqueTerms, along: &Series) -> Series {
        if let Some(far) = self.is_beyond(scene, along) {
            return if far == self.far { Series::one() } else { Series::zero() };
        }
        let behind = along - &self.at;
        let x = || Expression::series(behind.clone());
        let sign = opaque_terms.symbol("side", x().over(x().times(x()).sqrt()));
        let sign = if self.far { sign } else { -sign };
        (&Series::one() + &sign).scale(Rational::new(1, 2))
    }

    /// Whether a place along the bar is beyond the section, where that is so for all parameters.
    /// The section lies within the bar, between its ends, as every model is asked when it is built.
    fn is_beyond(&self, scene: &Scene, along: &Series) -> Option<bool> {
        let length = &self.bar(scene).length;
        let of_length = |x: &Series| x.divide_exact(length).and_then(|ratio| ratio.as_constant());
        let behind = along - &self.at;
        match of_length(along) {
            Some(ratio) if ratio.signum() <= 0 => Some(false),
            Some(ratio) if (ratio - Rational::ONE).signum() >= 0 => Some(true),
            _ => of_length(&behind).or_else(|| behind.as_constant()).map(|x| x.signum() > 0),
        }
    }

    /// `m s/l`, its middle and `m s²/12` about it.
    fn inertia(&self, scene: &Scene, opaque_terms: &mut OpaqueTerms) -> Inertia {
        let bar = self.bar(scene);
        let (length, start) = match self.far {
            true => (&bar.length - &self.at, self.at.clone()),
            false => (self.at.clone(), Series::zero()),
        };
        let mass = &(&bar.mass * &inverse(opaque_terms, &bar.length)) * &length;
        let inertia = (&(&mass * &length) * &length).scale(Rational::new(1, 12));
        let middle = &start + &length.scale(Rational::new(1, 2));
        let centre = scene.kinematics.compute_position(scene.system, self.body, &[middle, Series::zero()]);
        let spin = scene.kinematics.directions[self.body].rate();
        Inertia { on: Some(Holder::Body(self.body)), mass, inertia, centre, spin }
    }

    /// Point masses on it.
    fn carried(&self, scene: &Scene, opaque_terms: &mut OpaqueTerms) -> Vec<Inertia> {
        let on = Some(Holder::Body(self.body));
        let particles = scene.system.particles.iter().filter(|particle| scene.holder(particle.point) == on);
        let inertias = particles.map(|particle| {
            let share = self.share(scene, opaque_terms, &scene.system.local(self.body, particle.point)[0]);
            let (mass, inertia) = (&particle.mass * &share, Series::zero());
            Inertia {
                on,
                mass,
                inertia,
                centre: scene.kinematics.points[particle.point].clone(),
                spin: Series::zero(),
            }
        });
        inertias.filter(|inertia| !inertia.mass.is_zero()).collect()
    }
}
