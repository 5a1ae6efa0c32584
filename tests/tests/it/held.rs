//! Code that contact sets without a closed form have of their own, against the full equations: by
//! LU with complete pivoting, and where these determine no single reaction, by the runtime's
//! elimination.

use core::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use liftoff_codegen::analyse;
use liftoff_codegen::functions::HeldMotion;
use liftoff_compiled::models;
use liftoff_core::model::{ContactSet, Form, Layout};
use liftoff_core::system::{Equations, Model};
use liftoff_interpreter::Interpreted;
use liftoff_tests::random::Source;
use nalgebra::{DMatrix, DVector};

/// K = [M −Jᵀ; J 0] over the closed rows, balanced to unit inertias and unit rows, and r = (f, −b);
/// the balance.
fn balanced(equations: &Equations<f64>, rows: &[usize]) -> (DMatrix<f64>, DVector<f64>, Vec<f64>) {
    let n = equations.force().len();
    let size = n + rows.len();
    let mut matrix = DMatrix::zeros(size, size);
    let mut right = DVector::zeros(size);
    for i in 0..n {
        right[i] = equations.force()[i];
        (0..n).for_each(|j| matrix[(i, j)] = equations.mass(i)[j]);
    }
    for (k, &row) in rows.iter().enumerate() {
        right[n + k] = -equations.bias()[row];
        for (j, &entry) in equations.jacobian(row).iter().enumerate() {
            (matrix[(n + k, j)], matrix[(j, n + k)]) = (entry, -entry);
        }
    }
    let mut scale: Vec<f64> = (0..n).map(|i| 1.0 / matrix[(i, i)].sqrt()).collect();
    for k in n..size {
        let largest = (0..n).map(|j| (matrix[(k, j)] * scale[j]).abs()).fold(0.0, f64::max);
        scale.push(if largest > 0.0 { 1.0 / largest } else { 1.0 });
    }
    let scaled = DMatrix::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
    (scaled, DVector::from_fn(size, |i, _| right[i] * scale[i]), scale)
}

fn condition(matrix: &DMatrix<f64>) -> f64 {
    let values = matrix.singular_values();
    values.max() / values.min()
}

/// What rounding is multiplied by where M is eliminated first: its condition, and that of J M⁻¹ Jᵀ.
fn in_parts(matrix: &DMatrix<f64>, n: usize) -> f64 {
    let mass = matrix.view((0, 0), (n, n)).into_owned();
    let rows = matrix.view((n, 0), (matrix.nrows() - n, n)).into_owned();
    let compliance = &rows * mass.clone().try_inverse().expect("definite") * rows.transpose();
    condition(&mass) * condition(&compliance)
}

/// Angles are drawn among these too: entries vanish there.
const TURNS: [f64; 4] = [0.0, FRAC_PI_2, PI, -FRAC_PI_2];

fn state(layout: &Layout, source: &mut Source) -> Vec<f64> {
    let mut entry = |i: usize| match layout.coordinates.get(i) {
        Some(coordinate) if coordinate.is_angle && source.chance(0.4) => TURNS[source.below(4)],
        _ => source.range(-1.5, 1.5),
    };
    (0..layout.entries()).map(&mut entry).collect()
}

/// Poses with one motion, and without.
#[derive(Debug, Default)]
struct Tally {
    regular: usize,
    singular: usize,
}

/// Beyond this condition of K rounding hides what is wrong.
const CONDITION: f64 = 1e6;

fn compare(what: &str, model: &Model, own: &Model, held: &HeldMotion, y: &[f64], tally: &mut Tally) {
    let layout = model.system.layout();
    let (n, rows) = (layout.coordinates.len(), &held.rows);
    let set = ContactSet::from_bits_and_stick(held.set.closed, held.set.stick);
    let equations = model.system.equations(y);
    let (matrix, right, scale) = balanced(&equations, rows);
    let (accelerations, multipliers, tolerance) = if condition(&matrix) < CONDITION {
        let tolerance = 100.0 * f64::EPSILON * in_parts(&matrix, n);
        tally.regular += 1;
        let solution = matrix.full_piv_lu().solve(&right).expect("regular");
        let solution: Vec<f64> = solution.iter().zip(&scale).map(|(x, scale)| x * scale).collect();
        let mut multipliers = vec![0.0; layout.rows()];
        rows.iter().zip(&solution[n..]).for_each(|(&row, &lambda)| multipliers[row] = lambda);
        (solution[..n].to_vec(), multipliers, tolerance)
    } else {
        tally.singular += 1;
        let (mut a, mut lambda) = (vec![0.0; n], vec![0.0; layout.rows()]);
        model.system.solve(y, set, &mut a, &mut lambda);
        (a, lambda, 1e-12)
    };
    let expected: Vec<f64> =
        (0..layout.reactions()).map(|i| multipliers[layout.row_of_reaction(i)]).collect();
    for model in [model, own] {
        let phase = Arc::clone(&model.system).phase(set, Form::Reduced);
        assert_eq!(phase.info().form, Form::Multipliers, "{what}");
        let (mut derivative, mut reactions) = (vec![0.0; y.len()], vec![0.0; layout.reactions()]);
        phase.derivative(y, &mut derivative);
        phase.reactions(y, &mut reactions);
        assert_eq!(derivative[..n], y[n..2 * n], "{what}");
        close(what, &derivative[n..2 * n], &accelerations, tolerance);
        close(what, &reactions, &expected, tolerance);
    }
}

/// Within the tolerance of the largest; nothing is a number in one alone.
fn close(what: &str, computed: &[f64], expected: &[f64], tolerance: f64) {
    let size = expected.iter().filter(|x| x.is_finite()).fold(1.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in computed.iter().zip(expected) {
        let alike = (a - b).abs() <= tolerance * size || a.is_nan() && b.is_nan();
        assert!(alike, "{what}: {computed:?} for {expected:?}, tolerance {tolerance:e}");
    }
}

#[test]
fn own_code_solves_the_full_equations() {
    let mut sets = 0;
    let mut tally = Tally::default();
    for entry in models().iter() {
        let layout = entry.layout();
        let analysis = analyse(layout.declaration.parse().unwrap()).unwrap();
        let mut source = Source::new(layout.declaration.len() as u64);
        for held in &analysis.functions.held {
            sets += 1;
            for _ in 0..60 {
                let values = entry.default_run().parameters;
                let values = values.into_iter().map(|(name, x)| (name, x * source.range(0.7, 1.4))).collect();
                let model = entry.model(&values).unwrap();
                let parameters: Vec<f64> = layout
                    .parameters
                    .iter()
                    .map(|name| values.iter().rev().find(|(given, _)| given == name).unwrap().1)
                    .collect();
                let own = Interpreted::from_analysis(&analysis).model(&parameters);
                let y = state(layout, &mut source);
                let what = format!("{} {:?} at {y:?}", entry.name(), held.set);
                compare(&what, &model, &own, held, &y, &mut tally);
            }
        }
    }
    assert!(sets >= 15 && tally.regular >= 500 && tally.singular >= 40, "{sets} sets, {tally:?}");
}
