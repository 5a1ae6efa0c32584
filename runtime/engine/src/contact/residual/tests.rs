//! What an outcome of an impact violates, in closed form.

use nalgebra::DMatrix;

use super::*;

/// A point mass of one in the plane with rates (v, ġ): a normal row and a tangent row, and what
/// they do.
struct Case {
    rows: [Row; 2],
    before: [f64; 2],
    /// Rates and impulses (P, P_t) at the end of each stage.
    stages: Vec<([f64; 2], [f64; 2])>,
    method: ImpulseMethod,
    factor: f64,
    /// The largest violation relative to the largest rate.
    expected: f64,
}

const NEWTON: Row = Row::Contact { restitution: 0.5, law: Law::Newton };
const POISSON: Row = Row::Contact { restitution: 0.5, law: Law::Poisson };
const STRONGE: Row = Row::Contact { restitution: 0.5, law: Law::Stronge };
const RUBS: Row = Row::Friction { of: 0, mu: 0.2, restitution: 0.0 };
const RETURNS: Row = Row::Friction { of: 0, mu: 0.2, restitution: 0.7 };
const HOLDS: Row = Row::Tangent { of: 0 };

impl Case {
    /// In other units of mass and of velocities, with rows as long as these.
    fn residual(&self, (mass, rate, lengths): (f64, f64, [f64; 2])) -> f64 {
        let vector = |entries: [f64; 2]| DVector::from_row_slice(&entries);
        let rates = |u: [f64; 2]| vector(u) * rate;
        let impulses = |p: [f64; 2]| vector([p[0] / lengths[0], p[1] / lengths[1]]) * (mass * rate);
        let bent = |row: Row| match row {
            Row::Friction { of, mu, restitution } => {
                Row::Friction { of, mu: mu * lengths[0] / lengths[1], restitution }
            }
            other => other,
        };
        let collision = Collision {
            mass: DMatrix::identity(2, 2) * mass,
            jacobian: DMatrix::from_row_slice(2, 2, &[0.0, lengths[0], lengths[1], 0.0]),
            rates: rates(self.before),
            prescribed_gap_rate: DVector::zeros(2),
            applied: DVector::zeros(2),
            rows: self.rows.map(bent).to_vec(),
        };
        let (compression, (u, p)) = match self.stages[..] {
            [end] => (None, end),
            [first, end] => (Some((rates(first.0), impulses(first.1))), end),
            _ => panic!("one stage or two"),
        };
        let law = if let Row::Contact { law, .. } = self.rows[0] { law } else { Law::Newton };
        collision.residual(&Outcome {
            rates: rates(u),
            impulses: impulses(p),
            opening: collision.speed(&rates(u)),
            acting: Vec::new(),
            law,
            compression,
            factor: self.factor,
            unique: true,
            method: self.method,
            gained: 0.0,
            solutions: 1,
            groups: Vec::new(),
        })
    }

    /// One that satisfies the equations of motion, by its impulses, in one stage or two.
    fn moved(rows: [Row; 2], before: [f64; 2], impulses: &[[f64; 2]], expected: f64) -> Self {
        let after = |p: &[f64; 2]| ([before[0] + p[1], before[1] + p[0]], *p);
        let stages = impulses.iter().map(after).collect();
        Self { rows, before, stages, method: ImpulseMethod::AtOnce, factor: 1.0, expected }
    }

    fn along_path(self) -> Self {
        Self { method: ImpulseMethod::Path, ..self }
    }

    fn reduced(self, factor: f64) -> Self {
        Self { factor, ..self }
    }
}

/// Falls with ġ = −2 without slip: P = 3 by each law, 2 of it in compression.
fn falling() -> Vec<Case> {
    let one = |row: Row, impulses: &[f64], expected: f64| {
        let impulses: Vec<[f64; 2]> = impulses.iter().map(|p| [*p, 0.0]).collect();
        Case::moved([row, Row::Open], [0.0, -2.0], &impulses, expected / 2.0)
    };
    let mut unbalanced = one(NEWTON, &[3.0], 0.01);
    unbalanced.stages[0].1[0] += 0.01;
    vec![
        one(NEWTON, &[3.0], 0.0),
        one(NEWTON, &[3.01], 0.01),
        one(NEWTON, &[2.99], 0.01),
        one(NEWTON, &[0.0], 3.0),
        unbalanced,
        one(NEWTON, &[2.5], 0.0).reduced(0.5),
        one(NEWTON, &[2.75], 0.25).reduced(0.5),
        one(POISSON, &[2.0, 3.0], 0.0),
        one(POISSON, &[2.0, 2.5], 0.0).reduced(0.5),
        one(POISSON, &[2.01, 3.015], 0.01),
        one(POISSON, &[1.99, 2.985], 0.01),
        one(POISSON, &[2.0, 3.01], 0.01),
        one(POISSON, &[2.0, 2.99], 0.01),
        one(STRONGE, &[2.0, 2.99], 0.01),
        one(STRONGE, &[2.0, 2.99], 0.0).along_path(),
        one(STRONGE, &[2.0, 3.01], 0.0).along_path(),
        one(STRONGE, &[2.01, 3.0], 0.01).along_path(),
        one(STRONGE, &[1.99, 3.0], 0.01).along_path(),
        one(STRONGE, &[2.0, 1.9], 0.1).along_path(),
        one(Row::TwoSided, &[2.0], 0.0),
        one(Row::TwoSided, &[2.01], 0.01),
        one(Row::Guide, &[1.99], 0.01),
        one(Row::Open, &[0.0], 0.0),
    ]
}

/// The same with a slip of 5, of which a contact without slip takes all and μ = 0.2 takes 0.6.
fn slipping() -> Vec<Case> {
    let one = |rows: [Row; 2], impulses: &[[f64; 2]], expected: f64| {
        Case::moved(rows, [5.0, -2.0], impulses, expected / 5.0)
    };
    vec![
        one([NEWTON, HOLDS], &[[3.0, -5.0]], 0.0),
        one([NEWTON, HOLDS], &[[3.0, -4.9]], 0.1),
        one([Row::TwoSided, HOLDS], &[[2.0, -5.1]], 0.1),
        one([NEWTON, RUBS], &[[3.0, -0.6]], 0.0),
        one([NEWTON, RUBS], &[[3.0, -0.5]], 0.1),
        one([NEWTON, RUBS], &[[3.0, -0.7]], 0.1),
        one([NEWTON, RUBS], &[[3.0, -0.5]], 0.0).along_path(),
        one([NEWTON, RUBS], &[[3.0, -0.7]], 0.1).along_path(),
        Case::moved([NEWTON, RUBS], [0.1, -2.0], &[[3.0, -0.1]], 0.0),
        Case::moved([NEWTON, RUBS], [0.1, -2.0], &[[3.0, -0.09]], 0.01 / 2.0),
        one([NEWTON, RETURNS], &[[3.0, -0.5]], 0.0),
        one([NEWTON, RETURNS], &[[3.0, -0.7]], 0.1),
        one([Row::Guide, RUBS], &[[2.0, -0.4]], 0.0),
        one([Row::Guide, RUBS], &[[2.0, -0.3]], 0.1),
        one([Row::Open, RUBS], &[[0.0, -0.3]], 0.3),
        one([Row::TwoSided, RUBS], &[[2.0, -0.3]], 0.3),
        // Friction of each stage is bounded by that stage's impulse.
        one([POISSON, RUBS], &[[2.0, -0.4], [3.0, -0.6]], 0.0),
        one([POISSON, RUBS], &[[2.0, -0.3], [3.0, -0.5]], 0.1),
        one([POISSON, RUBS], &[[2.0, -0.3], [3.0, -0.5]], 0.0).along_path(),
        one([POISSON, RUBS], &[[2.0, -0.3], [3.0, -0.6]], 0.1).along_path(),
    ]
}

/// What rises does not act; what rises from rest without slip may be held by its tangent alone.
fn not_acting() -> Vec<Case> {
    let one = |before: [f64; 2], tangential: f64, expected: f64| {
        let impulses = [[0.0, tangential]];
        Case::moved([NEWTON, HOLDS], before, &impulses, expected / before[0].abs().max(before[1]))
    };
    vec![
        one([5.0, 2.0], 0.0, 0.0),
        one([5.0, 2.0], -0.3, 0.3),
        one([5.0, 0.01], -5.0, 0.01),
        one([5.0, 0.0], -5.0, 0.0),
        one([5.0, 0.0], -4.99, 0.01),
        Case::moved([Row::TwoSided, HOLDS], [5.0, 2.0], &[[-2.0, -4.9]], 0.1 / 5.0),
        Case::moved([Row::Guide, RUBS], [5.0, 2.0], &[[-2.0, -0.4]], 0.0),
    ]
}

#[test]
fn the_largest_violation_is_reported_in_units_of_the_largest_rate() {
    for (k, case) in falling().iter().chain(&slipping()).chain(&not_acting()).enumerate() {
        for units in [(1.0, 1.0, [1.0; 2]), (3e-5, 1e7, [1e4, 0.2]), (7e8, 1e-6, [1e-3, 50.0])] {
            let found = case.residual(units);
            // The unit roundoff of some terms as large as the largest rate.
            assert!((found - case.expected).abs() < 1e-14, "{k} {units:?}: {found} {}", case.expected);
        }
    }
}
