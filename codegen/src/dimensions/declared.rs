//! What each expression of a declaration stands for.

use syn::{Expr, Ident};

use super::Dimension;
use super::equation::{DimensionEquation, Place};
use super::reader::{DimensionReader, LENGTH, NONE, VELOCITY, powers};
use crate::syntax::{
    Beam, CentreDeclaration, ContactLaw, Description, FrictionLaw, MassProperties, Pair, Resistance,
    ShapeDeclaration, SwitchDeclaration, Target, Track,
};

const MASS: Dimension = powers(0, 0, 1);
const INERTIA: Dimension = powers(2, 0, 1);
const ACCELERATION: Dimension = powers(1, -2, 0);
const FORCE: Dimension = powers(1, -2, 1);
const TORQUE: Dimension = powers(2, -2, 1);
/// Stiffness and damping between points.
const LINEAR: [Dimension; 2] = [powers(0, -2, 1), powers(0, -1, 1)];
/// Stiffness and damping between directions.
const TORSIONAL: [Dimension; 2] = [TORQUE, powers(2, -1, 1)];

/// What all expressions demand, in the order of the description.
pub(super) fn equations(description: &Description) -> Vec<DimensionEquation<'_>> {
    let mut reader = DimensionReader::new(description);
    reader.mass_properties(description);
    reader.places(description);
    reader.contacts(description);
    reader.loads(description);
    reader.units(description);
    reader.equations
}

impl<'d> DimensionReader<'d> {
    fn mass_properties(&mut self, d: &'d Description) {
        for beam in &d.beams {
            match beam {
                Beam::Bar(bar) => self.bar(&bar.name, &bar.mass_properties),
                Beam::Chain(chain) => self.bar(&chain.name, &chain.mass_properties),
                Beam::Body(body) => {
                    self.expect_each("the mass of", &body.name, [&body.mass], MASS);
                    self.expect_each("the inertia of", &body.name, &body.inertia, INERTIA);
                    self.expect_each("the centre of", &body.name, body.centre.iter().flatten(), LENGTH);
                    self.positions("the place on its body of", &body.points);
                }
            }
        }
        for mass in d.masses.iter().chain(&d.particles) {
            self.expect_each("the mass at", &mass.point, [&mass.mass], MASS);
        }
        let gravity = Place { what: "gravity", owner: None };
        for component in d.gravity.iter().flat_map(|gravity| &gravity.components) {
            self.expect(gravity, component, ACCELERATION);
        }
    }

    fn bar(&mut self, name: &'d Ident, mass_properties: &'d MassProperties) {
        self.expect_each("the mass of", name, [&mass_properties.mass], MASS);
        self.expect_each("the length of", name, [&mass_properties.length], LENGTH);
        self.expect_each("the inertia of", name, &mass_properties.inertia, INERTIA);
        self.expect_each("the centre of", name, mass_properties.centre.iter().flatten(), LENGTH);
    }

    fn places(&mut self, d: &'d Description) {
        for point in &d.points {
            self.expect_each("the place on its bar of", &point.name, &point.at, LENGTH);
        }
        self.positions("the place of pin", &d.pins);
        self.positions("the place of", &d.ground);
        self.positions("the place in the figure of", &d.figure);
        for disc in &d.discs {
            self.expect_each("the radius of", &disc.centre, [&disc.radius], LENGTH);
        }
        for section in &d.sections {
            self.expect_each("the place of section", &section.name, [&section.at], LENGTH);
        }
        if let Some(mirror) = &d.mirror {
            self.expect(Place { what: "the place of the mirror", owner: None }, &mirror.at, LENGTH);
        }
        for weld in &d.welds {
            self.expect_each("the weld angle of", &weld.first, &weld.angle, NONE);
        }
        for slider in &d.sliders {
            match &slider.guide {
                Track::Horizontal(at) | Track::Vertical(at) => {
                    self.expect_each("the place of slider", &slider.name, [at], LENGTH);
                }
                Track::Line(angle, through) => {
                    self.expect_each("the angle of slider", &slider.name, [angle], NONE);
                    let through = through.iter().flat_map(|pair| pair.iter());
                    self.expect_each("the place of slider", &slider.name, through, LENGTH);
                }
                Track::Circle(centre, radius) => {
                    let lengths = centre.iter().chain([radius]);
                    self.expect_each("the place of slider", &slider.name, lengths, LENGTH);
                }
                Track::Bar(_) => {}
            }
        }
    }

    fn contacts(&mut self, d: &'d Description) {
        for support in &d.supports {
            self.shape(&support.name, &support.shape);
            self.contact_law(&support.name, &support.contact_law);
            self.expect_each("the velocity of the surface of", &support.name, &support.moving, VELOCITY);
        }
        for slider in &d.sliders {
            self.friction(&slider.name, slider.friction.as_ref());
        }
        for hinge in &d.hinges {
            self.friction(&hinge.point, Some(&hinge.friction));
            self.expect_each("the radius of hinge", &hinge.point, [&hinge.radius], LENGTH);
        }
        for limit in &d.limits {
            let dimension = self.target(&limit.target);
            let bounds = limit.low.iter().chain(&limit.high);
            self.expect_each("the limit of", limit.target.ident(), bounds, dimension);
            self.contact_law(&limit.name, &limit.contact_law);
        }
        for thread in &d.threads {
            self.expect_each("the length of thread", &thread.name, [&thread.length], LENGTH);
            self.contact_law(&thread.name, &thread.contact_law);
        }
    }

    fn shape(&mut self, name: &'d Ident, shape: &'d ShapeDeclaration) {
        let (angle, lengths): (Option<&Expr>, Vec<&Expr>) = match shape {
            ShapeDeclaration::Floor(height) => (None, height.iter().collect()),
            ShapeDeclaration::Wall(x) => (None, vec![x]),
            ShapeDeclaration::Slope(angle, through) => {
                (Some(angle), through.iter().flat_map(|pair| pair.iter()).collect())
            }
            ShapeDeclaration::Corner(at) => (None, at.iter().collect()),
            ShapeDeclaration::Circle(CentreDeclaration::Ground(centre), r)
            | ShapeDeclaration::Bowl(CentreDeclaration::Ground(centre), r) => {
                (None, centre.iter().chain([r]).collect())
            }
            ShapeDeclaration::Circle(_, r) | ShapeDeclaration::Bowl(_, r) => (None, vec![r]),
            ShapeDeclaration::Bar(_) | ShapeDeclaration::Edge(_) | ShapeDeclaration::Disc(_) => {
                (None, Vec::new())
            }
            ShapeDeclaration::Slot(angle, through, width) => {
                (Some(angle), through.iter().chain([width]).collect())
            }
        };
        self.expect_each("the angle of support", name, angle, NONE);
        self.expect_each("the place of support", name, lengths, LENGTH);
    }

    fn contact_law(&mut self, name: &'d Ident, contact_law: &'d ContactLaw) {
        self.expect_each("the restitution of", name, &contact_law.restitution, NONE);
        self.switch(name, &contact_law.armed);
        self.switch(name, &contact_law.breaks);
        self.friction(name, contact_law.friction.as_ref());
    }

    fn friction(&mut self, name: &'d Ident, law: Option<&'d FrictionLaw>) {
        let all =
            |law: &'d FrictionLaw| core::iter::once(&law.kinetic).chain(&law.limit).chain(&law.tangential);
        let coefficients = law.into_iter().flat_map(all);
        self.expect_each("the friction of", name, coefficients, NONE);
    }

    fn switch(&mut self, name: &'d Ident, armed: &'d Option<SwitchDeclaration>) {
        if let Some([greater, less]) = armed.as_ref().and_then(|switch| switch.sides.as_ref()) {
            self.compared("the condition of", name, [greater, less]);
        }
    }

    fn loads(&mut self, d: &'d Description) {
        for spring in &d.springs {
            self.expect_each("the natural length of", &spring.name, &spring.length, LENGTH);
            self.resistance(&spring.name, &spring.law, LINEAR);
            self.switch(&spring.name, &spring.armed);
        }
        for torsion in &d.torsions {
            self.expect_each("the angle of the torsion of", &torsion.first, &torsion.angle, NONE);
            self.resistance(&torsion.first, &torsion.law, TORSIONAL);
            self.switch(&torsion.first, &torsion.armed);
        }
        for force in &d.forces {
            self.expect_each("the force", &force.name, &force.value, FORCE);
            self.switch(&force.name, &force.armed);
        }
        for couple in &d.couples {
            self.expect_each("the couple", &couple.name, [&couple.value], TORQUE);
            self.switch(&couple.name, &couple.armed);
        }
        for drive in &d.drives {
            let dimension = self.target(&drive.target);
            self.expect_each("the drive of", drive.target.ident(), [&drive.value], dimension);
            self.switch(drive.target.ident(), &drive.armed);
            self.switch(drive.target.ident(), &drive.breaks);
        }
    }

    fn target(&self, target: &Target) -> Dimension {
        match target {
            Target::Coordinate(name) => self.coordinate(name).unwrap_or(NONE),
            Target::Angle(_) | Target::Turn(_) => NONE,
            Target::Position(..) | Target::Distance(_) | Target::Along(..) => LENGTH,
        }
    }

    fn units(&mut self, d: &'d Description) {
        for (field, value) in d.fields.iter().zip(&d.values) {
            if let Some((parameter, [length, time, mass])) = &value.measured {
                let dimension = powers((*length).into(), (*time).into(), (*mass).into());
                self.expect_each("the unit of", field, [parameter], dimension);
            }
        }
    }

    fn resistance(&mut self, name: &'d Ident, law: &'d Resistance, [stiffness, damping]: [Dimension; 2]) {
        self.expect_each("the stiffness of", name, &law.stiffness, stiffness);
        self.expect_each("the damping of", name, &law.damping, damping);
    }

    fn positions(&mut self, what: &'static str, positions: &'d [(Ident, Pair)]) {
        for (name, position) in positions {
            self.expect_each(what, name, position, LENGTH);
        }
    }

    fn expect_each(
        &mut self,
        what: &'static str,
        owner: &'d Ident,
        exprs: impl IntoIterator<Item = &'d Expr>,
        dimension: Dimension,
    ) {
        for expr in exprs {
            self.expect(Place { what, owner: Some(owner) }, expr, dimension);
        }
    }
}
