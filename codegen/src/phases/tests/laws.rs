//! With `u = G u_k`, `a = G a_k + β` and `r = M a + h − Q − J_tᵀ R`: closed rows stay closed,
//! `Gᵀ r = M̂ a_k + ĥ − Q̂`, `J_eᵀ λ = r_e`, `T = ½ uᵀ M u`.

use super::super::{CoordinateValue, Phase, rows};
use crate::Analysis;
use crate::algebra::tests::random::point;
use crate::algebra::{Quotient, Series, Symbol};
use crate::tests::analysis;
use crate::tests::scenes::{OTHERS, SCENES};

/// Cranks, wheels that roll, surfaces that move, prescribed motions, guides.
pub(super) const MORE: [&str; 7] = [
    "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[bar(AB, mass = 3 * m, length = l)] #[pin(O = (0, 0))] #[support(B = floor)]
     #[figure(A = (3 * l / 5, 4 * l / 5), B = (6 * l / 5, 0))] struct Crank { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[support(A = floor, friction = mu, moving = w)]
     #[support(B = wall(0), facing = right, friction = nu)] #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
     struct Ladder { m: f64, l: f64, mu: f64, nu: f64, w: f64, g: f64 }",
    "#[gravity(g)] #[body(wheel, points(A = (0, 0), B = (r, 0)), mass = m, inertia = m * r * r / 3, centre = (r / 5, 0))]
     #[disc(A, radius = r)] #[support(A = floor, rough, moving = w)] #[figure(A = (0, r), B = (r, r))]
     struct Wheel { m: f64, r: f64, w: f64, g: f64 }",
    "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[particle(P, mass = p)] #[support(P = bar(OA), facing = left, friction = mu)]
     #[coordinate(phi = angle(OA))] #[drive(phi = a * sin(omega * t))] #[figure(A = (l, 0), P = (l / 2, 0))]
     struct Shaken { m: f64, p: f64, l: f64, a: f64, omega: f64, mu: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[bar(BC, mass = p, length = b)] #[support(A = floor, rough)]
     #[support(C = wall(2 * l), facing = left)] #[figure(A = (0, 0), B = (3 * l / 5, 4 * l / 5), C = (2 * l, 4 * l / 5))]
     struct Propped { m: f64, p: f64, l: f64, b: f64, g: f64 }",
    "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[slider(A = vertical(0))] #[slider(B = horizontal(0))]
     #[figure(A = (0, 4 * l / 5), B = (3 * l / 5, 0))] struct Trammel { m: f64, l: f64, g: f64 }",
    "#[gravity(g)] #[particle(P, mass = m)] #[support(P = slope(-gamma), rough, moving = w)] #[figure(P = (0, 0))]
     struct Carried { m: f64, gamma: f64, w: f64, g: f64 }",
];

/// A state of a phase in the coordinates of the free system.
struct Embedded<'a> {
    analysis: &'a Analysis,
    phase: &'a Phase,
    seed: u32,
}

impl Embedded<'_> {
    /// Of what stays.
    fn kept(&self, of: &Quotient) -> f64 {
        of.evaluate(&point(self.seed))
    }

    /// Of all coordinates, rates and accelerations.
    fn full(&self, of: &Series) -> f64 {
        of.evaluate(&|symbol| match symbol {
            Symbol::Coordinate { index, order } => self.motion(usize::from(index), order),
            other => point(self.seed)(other),
        })
    }

    fn motion(&self, i: usize, order: u8) -> f64 {
        match (order, &self.phase.coordinates[i]) {
            (0, CoordinateValue::Length(length) | CoordinateValue::Rate(length)) => self.kept(length),
            (0, CoordinateValue::Angle(angle)) => angle.evaluate(&point(self.seed)),
            (1, _) => self.kept(&self.phase.rates[i]),
            _ => self.kept(&self.phase.accelerations[i]),
        }
    }

    /// Gᵢₖ.
    fn slope(&self, i: usize, k: usize) -> f64 {
        let moving = &self.phase.moving;
        let at = |unit: f64| {
            let rate = |l: usize| if l == k { unit } else { 0.0 };
            self.phase.rates[i].evaluate(&|symbol| match moving
                .iter()
                .position(|&j| Symbol::rate(j) == symbol)
            {
                Some(l) => rate(l),
                None => point(self.seed)(symbol),
            })
        };
        at(1.0) - at(0.0)
    }

    /// r.
    fn residual(&self, i: usize) -> f64 {
        let dense = self.analysis.dense.as_ref().unwrap();
        let inertia =
            (0..dense.mass.len()).map(|j| self.full(&dense.mass[i][j]) * self.motion(j, 2)).sum::<f64>();
        let motion = &self.analysis.motion;
        let rubbed = motion.sliding(self.phase.set).map(|(_, row)| {
            self.full(&motion.rows[row].jacobian[i]) * point(self.seed)(Symbol::reaction(row))
        });
        inertia + self.full(&dense.velocity_terms[i]) - self.full(&dense.forces[i]) - rubbed.sum::<f64>()
    }

    fn check(&self, name: &str, found: f64, expected: f64) {
        let near = (found - expected).abs() <= 1e-8 * (1.0 + found.abs() + expected.abs());
        assert!(
            near,
            "{}, {:?}, {name}: {found}, not {expected}",
            self.analysis.system.ident, self.phase.set
        );
    }
}

fn every(check: fn(&Embedded)) {
    for declaration in SCENES.iter().chain(&OTHERS).chain(&MORE) {
        let analysis = analysis(declaration);
        for phase in &analysis.phases {
            (1..4).for_each(|seed| check(&Embedded { analysis: &analysis, phase, seed }));
        }
    }
}

#[test]
fn closed_rows_stay_closed() {
    every(|state| {
        let motion = &state.analysis.motion;
        for row in rows(motion, state.phase.set) {
            let row = &motion.rows[row];
            let slopes = row.jacobian.iter().enumerate();
            let along: f64 = slopes.map(|(i, slope)| state.full(slope) * state.motion(i, 2)).sum();
            state.check("gap", state.full(&row.gap), 0.0);
            state.check("rate", state.full(&row.velocity()), 0.0);
            state.check("acceleration", along, -state.full(&row.bias));
        }
    });
}

#[test]
fn reduced_equations_are_projections_of_the_full_ones() {
    every(|state| {
        let Phase { moving, mass, velocity_terms, forces, .. } = state.phase;
        for k in 0..moving.len() {
            let full: f64 = (0..state.analysis.motion.n).map(|i| state.slope(i, k) * state.residual(i)).sum();
            let own = moving.iter().enumerate();
            let inertia: f64 = own.map(|(l, &j)| state.kept(&mass[k][l]) * state.motion(j, 2)).sum();
            let rest = state.kept(&velocity_terms[k]) - state.kept(&forces[k]);
            state.check("equation", inertia + rest, full);
        }
    });
}

#[test]
fn reactions_carry_what_is_eliminated() {
    every(|state| {
        let motion = &state.analysis.motion;
        for i in state.phase.eliminated.iter().map(|e| e.coordinate) {
            let carried = state.phase.reactions.iter();
            let carried =
                carried.map(|(row, force)| state.full(&motion.rows[*row].jacobian[i]) * state.kept(force));
            state.check("reactions", carried.sum(), state.residual(i));
        }
    });
}

#[test]
fn energies_and_coefficients_of_friction_are_those_of_the_full_system() {
    every(|state| {
        let (motion, mass) = (&state.analysis.motion, &state.analysis.dense.as_ref().unwrap().mass);
        let pairs = (0..motion.n).flat_map(|i| (0..motion.n).map(move |j| (i, j)));
        let twice: f64 =
            pairs.map(|(i, j)| state.full(&mass[i][j]) * state.motion(i, 1) * state.motion(j, 1)).sum();
        state.check("T", state.kept(&state.phase.kinetic), twice / 2.0);
        state.check("V", state.kept(&state.phase.potential), state.full(&motion.potential));
        for slides in &state.phase.sliding {
            let friction = motion.contacts[slides.contact].friction.as_ref().unwrap();
            state.check("μ", state.kept(&slides.kinetic), state.full(&friction.kinetic));
        }
    });
}
