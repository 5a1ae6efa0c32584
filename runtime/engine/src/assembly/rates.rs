//! Rates that a pose leaves open: the least kinetic energy with the given rates and J u = 0 over
//! the joints and the closed contacts, `M u = Jᵀ μ` on the free rates. Contacts that the given
//! rates open are dropped, and those that they drive into their supports if nothing else is
//! possible: they are struck at the start.

use nalgebra::{DMatrix, DVector};

use super::problem::AssemblyProblem;
use super::{largest, worst};
use crate::assembly::StartError;
use crate::context::{CLOSED, Scales};
use crate::model::ContactSet;
use crate::numerics::decomposition::svd;
use crate::numerics::zero::SOLVED;
use crate::system::Equations;

/// Rows of J below this, in natural units, are those of a singular position: at a fold the gap is
/// quadratic in the position, so that a gap closed within [`CLOSED`] leaves position and J unknown
/// by the square root of that.
const SINGULAR: f64 = 1e-5;

/// M, J and ∂g/∂t: contacts, then joints.
struct RateRows {
    mass: DMatrix<f64>,
    jacobian: DMatrix<f64>,
    prescribed_gap_rate: DVector<f64>,
}

impl RateRows {
    fn from_equations(equations: &Equations<f64>) -> Self {
        let (n, count) = (equations.force().len(), equations.gap().len());
        Self {
            mass: DMatrix::from_fn(n, n, |i, j| equations.mass(i)[j]),
            jacobian: DMatrix::from_fn(count, n, |i, j| equations.jacobian(i)[j]),
            prescribed_gap_rate: DVector::from_row_slice(equations.prescribed_gap_rate()),
        }
    }
}

/// All rates, and those of the `closed` contacts that stay closed under them.
pub(super) fn rates(
    assembly: &AssemblyProblem<'_>,
    positions: &[f64],
    closed: ContactSet,
    given: &[Option<f64>],
) -> Result<(Vec<f64>, ContactSet), StartError> {
    let rows = RateRows::from_equations(&assembly.rows(positions));
    let scales = &assembly.context.scales;
    let size = |(rate, coordinate): (&Option<f64>, _)| {
        rate.unwrap_or(0.0).abs() * scales.length / scales.coordinate(coordinate)
    };
    let given_rates = given.iter().zip(assembly.layout().coordinates).map(size);
    let driven = (0..rows.prescribed_gap_rate.len())
        .map(|row| rows.prescribed_gap_rate[row].abs() * scales.length / assembly.unit(row));
    let fastest = given_rates.chain(driven).filter(|speed| speed.is_finite()).fold(scales.speed(), f64::max);
    // Speeds below this are rounding of the sums that they are, or of what a pose is given with.
    let small = |u: &DVector<f64>, row: usize| {
        let along = |j: usize| (rows.jacobian[(row, j)] * u[j]).abs();
        let fastest = fastest * assembly.unit(row) / scales.length;
        CLOSED * (0..u.len()).map(along).fold(fastest.max(rows.prescribed_gap_rate[row].abs()), f64::max)
    };
    let inertia = |c| scales.mass * (scales.length / scales.coordinate(c)).powi(2);
    let inertias: Vec<f64> = assembly.layout().coordinates.iter().map(inertia).collect();
    let (mut refusal, drives) = (StartError::Equilibrium, assembly.layout().drives());
    for approaching in [false, true] {
        let found = largest(closed, |set| {
            let u = least(&rows, &holding(assembly, &rows, set, given), given, &inertias);
            let speed = &rows.jacobian * &u + &rows.prescribed_gap_rate;
            let holds = |i: usize| match set.contains(i) {
                true => speed[i].abs() <= small(&u, i),
                // A drive holds from the start on, at the rates that it is given.
                false => !drives.contains(i) && (approaching || speed[i] >= -small(&u, i)),
            };
            match refuse(assembly, &speed, set, |row| small(&u, row)) {
                Ok(()) if closed.iter().all(holds) => {
                    return Ok((u.as_slice().to_vec(), set.union(assembly.layout().guides())));
                }
                Ok(()) => {}
                Err(error) => refusal = error,
            }
            Err(worst(set, |contact| speed[contact].abs() / small(&u, contact), 1.0))
        });
        if let Some(found) = found {
            return Ok(found);
        }
    }
    Err(refusal)
}

/// Refuses rates that break a two-sided row: a joint, a guide, a drive that holds, or the tangent
/// of a closed contact.
fn refuse(
    assembly: &AssemblyProblem<'_>,
    speed: &DVector<f64>,
    set: ContactSet,
    small: impl Fn(usize) -> f64,
) -> Result<(), StartError> {
    let layout = assembly.layout();
    let held = layout.guides().union(layout.drives());
    let two_sided = |row: &usize| *row >= layout.contacts.len() || held.contains(*row);
    for row in assembly.tied(set).into_iter().filter(two_sided) {
        if speed[row].abs() > small(row) {
            return Err(StartError::BreaksJoint { joint: assembly.joint(row), speed: speed[row] });
        }
    }
    Ok(())
}

/// The rows closed with `set` that hold free rates. A row whose derivatives by them are negligible
/// against its others, or against those of a gap of natural size, does not determine them: the
/// given rates satisfy it or nothing does.
fn holding(
    assembly: &AssemblyProblem<'_>,
    rows: &RateRows,
    set: ContactSet,
    given: &[Option<f64>],
) -> Vec<usize> {
    let Scales { length, .. } = assembly.context.scales;
    let size = |row: usize, j: usize| {
        (rows.jacobian[(row, j)] * assembly.context.scales.coordinate(&assembly.layout().coordinates[j]))
            .abs()
    };
    let largest = |row: usize, free: bool| {
        let columns = (0..given.len()).filter(|&j| !free || given[j].is_none());
        columns.fold(0.0, |most: f64, j| most.max(size(row, j)))
    };
    let natural = |row: usize| if row < assembly.layout().contacts.len() { length } else { 0.0 };
    let holds = |row: &usize| largest(*row, true) > SINGULAR * largest(*row, false).max(natural(*row));
    assembly.tied(set).into_iter().filter(holds).collect()
}

/// The least kinetic energy; `inertias` are natural ones of the coordinates.
fn least(rows: &RateRows, closed: &[usize], given: &[Option<f64>], inertias: &[f64]) -> DVector<f64> {
    let n = given.len();
    let free: Vec<usize> = (0..n).filter(|&i| given[i].is_none()).collect();
    let mut u = DVector::from_fn(n, |i, _| given[i].unwrap_or(0.0));
    if free.is_empty() || u.iter().chain(&rows.prescribed_gap_rate).all(|rate| *rate == 0.0) {
        return u;
    }
    let (f, c) = (free.len(), closed.len());
    let jacobian = rows.jacobian.select_rows(closed);
    let tied = jacobian.select_columns(&free);
    let mut matrix = DMatrix::zeros(f + c, f + c);
    matrix.view_mut((0, 0), (f, f)).copy_from(&rows.mass.select_rows(&free).select_columns(&free));
    matrix.view_mut((f, 0), (c, f)).copy_from(&tied);
    matrix.view_mut((0, f), (f, c)).copy_from(&tied.transpose());
    let mut right = DVector::zeros(f + c);
    right.rows_mut(0, f).copy_from(&-(&rows.mass * &u).select_rows(&free));
    right.rows_mut(f, c).copy_from(&-(jacobian * &u + rows.prescribed_gap_rate.select_rows(closed)));
    let inertias: Vec<f64> = free.iter().map(|&i| inertias[i]).collect();
    let balance = balance(&matrix, &inertias);
    let balanced = DMatrix::from_fn(f + c, f + c, |i, j| matrix[(i, j)] * balance[i] * balance[j]);
    let scaled = right.component_mul(&balance);
    if let Ok(x) = svd(balanced).solve(&scaled, SOLVED) {
        for (k, &i) in free.iter().enumerate() {
            u[i] = x[k] * balance[k];
        }
    }
    u
}

/// Scale factors that give the mass matrix a unit diagonal, but for coordinates of negligible
/// inertia, which have natural units, and each row of J a largest entry of one.
fn balance(matrix: &DMatrix<f64>, inertias: &[f64]) -> DVector<f64> {
    let free = inertias.len();
    let mut balance = DVector::from_element(matrix.nrows(), 1.0);
    for (j, &natural) in inertias.iter().enumerate() {
        let own = matrix[(j, j)];
        let inertia = if own > SOLVED * natural { own } else { natural };
        if inertia > 0.0 {
            balance[j] = 1.0 / inertia.sqrt();
        }
    }
    for row in free..matrix.nrows() {
        let largest = (0..free).fold(0.0, |most: f64, j| most.max((matrix[(row, j)] * balance[j]).abs()));
        if largest > 0.0 {
            balance[row] = 1.0 / largest;
        }
    }
    balance
}
