//! The program's values against what follows from energies and gaps by differences, which no
//! derivation enters.

use super::analysis;
use super::scenes::SCENES;
use crate::Analysis;
use crate::program::Id;

/// Third differences leave h² of each value, and roundings over h.
const H: f64 = 1e-4;
const TOLERANCE: f64 = 2e-6;

struct Model {
    analysis: Analysis,
    parameters: Vec<f64>,
    q: Vec<f64>,
    u: Vec<f64>,
}

impl Model {
    fn from_declaration(declaration: &str) -> Self {
        let analysis = analysis(declaration);
        let n = analysis.motion.n;
        let value = |i: usize, least: f64| least + (0.37 + 0.618_034 * i as f64).fract() * 0.7;
        Self {
            parameters: (0..analysis.system.parameters.len()).map(|i| value(i, 0.8)).collect(),
            q: (0..n).map(|i| value(i, 0.1)).collect(),
            u: (0..n).map(|i| value(i + 7, -0.4)).collect(),
            analysis,
        }
    }

    fn evaluate(&self, ids: &[Id], q: &[f64], u: &[f64]) -> Vec<f64> {
        self.analysis.evaluate(ids, &self.parameters, &[q, u].concat())
    }

    fn moved(x: &[f64], i: usize, by: f64) -> Vec<f64> {
        let mut x = x.to_vec();
        x[i] += by;
        x
    }

    fn energy(&self, q: &[f64], u: &[f64]) -> [f64; 2] {
        let energy = self.evaluate(&self.analysis.functions.energy, q, u);
        [energy[0], energy[1]]
    }

    /// ∂T/∂uᵢ, exact but for roundings, as T is quadratic in u.
    fn momentum(&self, i: usize, q: &[f64]) -> f64 {
        let kinetic = |by: f64| self.energy(q, &Self::moved(&self.u, i, by))[0];
        (kinetic(0.5) - kinetic(-0.5)) / 1.0
    }

    /// A slope along coordinate i.
    fn slope(&self, i: usize, f: impl Fn(&[f64]) -> f64) -> f64 {
        (f(&Self::moved(&self.q, i, H)) - f(&Self::moved(&self.q, i, -H))) / (2.0 * H)
    }
}

fn close(value: f64, expected: f64, what: &str) {
    assert!((value - expected).abs() < TOLERANCE * (1.0 + expected.abs()), "{what}: {value} for {expected}");
}

#[test]
fn masses_are_the_curvature_of_the_kinetic_energy() {
    for declaration in SCENES {
        let model = Model::from_declaration(declaration);
        let mass = model.analysis.mass(&model.parameters, &[&model.q[..], &model.u].concat());
        for (i, row) in mass.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let rates =
                    |by: [f64; 2]| Model::moved(&Model::moved(&vec![0.0; mass.len()], i, by[0]), j, by[1]);
                let kinetic = |by: [f64; 2]| model.energy(&model.q, &rates(by))[0];
                let mixed = kinetic([1.0, 1.0]) - kinetic([1.0, 0.0]) - kinetic([0.0, 1.0]);
                close(*entry, mixed, &format!("{declaration}: {i}, {j}"));
            }
        }
    }
}

/// Lagrange's equations: `f = ∂T/∂q − ∂V/∂q − Σ u ∂p/∂q`.
#[test]
fn forces_follow_from_the_energies() {
    for declaration in SCENES {
        let model = Model::from_declaration(declaration);
        let force = model.evaluate(&model.analysis.functions.kernel.force, &model.q, &model.u);
        for (i, value) in force.iter().enumerate() {
            let lagrangian = |q: &[f64]| {
                let [kinetic, potential] = model.energy(q, &model.u);
                kinetic - potential
            };
            let carried = (0..force.len()).map(|j| model.u[j] * model.slope(j, |q| model.momentum(i, q)));
            close(*value, model.slope(i, lagrangian) - carried.sum::<f64>(), &format!("{declaration}: {i}"));
        }
    }
}

/// `g̈ = J a + b` with J the slopes of the gap.
#[test]
fn rows_are_derivatives_of_gaps() {
    for declaration in SCENES {
        let model = Model::from_declaration(declaration);
        let kernel = &model.analysis.functions.kernel;
        let jacobian: Vec<Vec<f64>> =
            kernel.jacobian.iter().map(|row| model.evaluate(row, &model.q, &model.u)).collect();
        let bias = model.evaluate(&kernel.bias, &model.q, &model.u);
        // Slips have velocities only.
        for row in 0..kernel.gap.len() - model.analysis.motion.tangents.len() {
            let gap = |q: &[f64]| model.evaluate(&kernel.gap[row..=row], q, &model.u)[0];
            for (i, entry) in jacobian[row].iter().enumerate() {
                close(*entry, model.slope(i, gap), &format!("{declaration}: J {row}, {i}"));
            }
            let along = |t: f64| {
                let q: Vec<f64> = model.q.iter().zip(&model.u).map(|(q, u)| q + t * u).collect();
                gap(&q)
            };
            let curvature = (along(1e-3) - 2.0 * along(0.0) + along(-1e-3)) / 1e-6;
            close(bias[row], curvature, &format!("{declaration}: b {row}"));
        }
    }
}

/// `M_kj = m l² (N − j − ½) cos(θ_k − θ_j)` for k < j, `m l² (N − k − ⅔)` on the diagonal.
#[test]
fn a_chain_has_the_masses_of_the_books() {
    let model = Model::from_declaration(SCENES[10]);
    let mass = model.analysis.mass(&model.parameters, &[&model.q[..], &model.u].concat());
    let scale = model.parameters[0] * model.parameters[1].powi(2);
    for k in 0..10 {
        close(mass[k][k], scale * (10.0 - k as f64 - 2.0 / 3.0), "diagonal");
        for j in k + 1..10 {
            let expected = scale * (9.5 - j as f64) * (model.q[k] - model.q[j]).cos();
            close(mass[k][j], expected, "entry");
            close(mass[j][k], expected, "entry");
        }
    }
}
