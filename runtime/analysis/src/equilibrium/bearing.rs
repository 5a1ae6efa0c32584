//! What contacts bear at rest:
//!
//! ```text
//! f + Jᵀ λ = 0,   N ≥ 0,   |R| ≤ μₛ N
//! ```
//!
//! Where rows of J depend on each other, λ = λ₀ + B c with Jᵀ B = 0, and linear programs in c give
//! the least and the largest of each reaction.

use liftoff_core::model::{ContactSet, QuantityKind, SlipState};
use liftoff_core::scalar::{DoubleDouble, Real};
use nalgebra::{DMatrix, DVector};

use crate::Subject;
use crate::numeric::linear_program::solve_linear_program;

/// Rows of J depend on each other below this.
const RANK: f64 = 1e-9;
/// Reactions below this part of natural forces, or of the largest, are none.
const NONE: f64 = 1e-12;
/// Loads are in balance within this part of the largest.
const BALANCED: f64 = 1e-9;

/// What a contact bears: the least and the largest reaction, which are one where it is unique.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// The contact.
    pub contact: &'static str,
    /// N, N.
    pub normal: [f64; 2],
    /// R along the tangent, N, of contacts that bear along it.
    pub friction: Option<[f64; 2]>,
    /// Whether it can bear anything.
    pub bears: bool,
}

/// What a joint or a drive transmits, with the name of that as an output.
pub type JointForce = (&'static str, f64);

/// The loads of the contacts of a set, and what joints and drives transmit where all shares give
/// the same; none if they cannot hold the system at rest.
pub(super) fn loads(
    subject: &Subject,
    set: ContactSet,
    state: &[DoubleDouble],
) -> Option<(Vec<Load>, Vec<JointForce>)> {
    let shares = Shares::compute(subject, set, state)?;
    let forces = shares.joint_forces(subject, state);
    let layout = subject.layout();
    let mut loads = Vec::new();
    for contact in set.iter() {
        let normal = shares.range(shares.find_index(contact)?)?;
        let tangent = layout.tangents.iter().position(|of| *of == contact);
        let tangent = tangent.map(|k| layout.contacts.len() + layout.joints.len() + k);
        let friction = match tangent.and_then(|row| shares.find_index(row)) {
            Some(place) => Some(shares.range(place)?),
            None => None,
        };
        let label = layout.contacts[contact].label;
        let bears = normal.iter().any(|force| force.abs() > shares.none);
        loads.push(Load { contact: label, normal, friction, bears });
    }
    Some((loads, forces))
}

/// All λ that hold the system, and what bounds them.
struct Shares {
    rows: Vec<usize>,
    /// λ₀.
    least: DVector<f64>,
    /// B.
    free: DMatrix<f64>,
    /// Combinations of λ that are not negative.
    bounds: Vec<Vec<(usize, f64)>>,
    /// What is no force.
    none: f64,
}

impl Shares {
    fn compute(subject: &Subject, set: ContactSet, state: &[DoubleDouble]) -> Option<Self> {
        let layout = subject.layout();
        let equations = subject.system.equations(state);
        let n = layout.coordinates.len();
        let rows: Vec<usize> = (0..layout.rows()).filter(|&row| layout.is_closed(row, &set)).collect();
        // Columns of as many entries as there are rows at least, so that all right singular vectors
        // are there.
        let mut matrix = DMatrix::zeros(n.max(rows.len()), rows.len());
        let mut force = DVector::zeros(n.max(rows.len()));
        for (i, coordinate) in layout.coordinates.iter().enumerate() {
            let unit = subject.scales.coordinate(coordinate);
            force[i] = -equations.force()[i].hi() * unit;
            (0..rows.len()).for_each(|k| matrix[(i, k)] = equations.jacobian(rows[k])[i].hi() * unit);
        }
        let natural = subject.scales.force();
        let work = force.amax().max(natural * subject.scales.length);
        if rows.is_empty() {
            let (least, free) = (DVector::zeros(0), DMatrix::zeros(0, 0));
            return (force.amax() <= BALANCED * work).then_some(Self {
                rows,
                least,
                free,
                bounds: Vec::new(),
                none: 0.0,
            });
        }
        let size = matrix.amax();
        let svd = matrix.clone().svd(true, true);
        let least = svd.solve(&force, RANK * size).ok()?;
        let right = svd.v_t.as_ref()?;
        let dependent: Vec<usize> =
            (0..rows.len()).filter(|&k| svd.singular_values[k] <= RANK * size).collect();
        let free = right.select_rows(&dependent).transpose();
        let none = NONE * natural.max(least.amax());
        let bounds = bounds(subject, state, &rows);
        let holds = (&matrix * &least - &force).amax() <= BALANCED * work;
        holds.then_some(Self { rows, least, free, bounds, none })
    }

    /// The forces and couples of joints and drives that no free share changes.
    fn joint_forces(&self, subject: &Subject, state: &[DoubleDouble]) -> Vec<JointForce> {
        let layout = subject.layout();
        let at_rest = vec![DoubleDouble::from_f64(0.0); layout.coordinates.len()];
        let force = |entry: usize, share: &DVector<f64>| {
            let mut multipliers = vec![DoubleDouble::from_f64(0.0); layout.rows()];
            self.rows.iter().zip(share).for_each(|(&row, x)| multipliers[row] = DoubleDouble::from_f64(*x));
            subject.system.quantity(entry, state, &at_rest, &multipliers).hi()
        };
        let held = layout.quantities.iter().enumerate().filter(|(_, quantity)| {
            use QuantityKind::{DriveForce, DriveTorque, JointCouple, JointForce};
            matches!(quantity.kind, JointForce | JointCouple | DriveForce | DriveTorque)
        });
        let found = held.filter_map(|(entry, quantity)| {
            let value = force(entry, &self.least);
            let size = self.none.max(NONE * subject.scales.force()) / NONE * BALANCED;
            let mut free = self.free.column_iter();
            let is_same = free.all(|share| {
                let largest = self.least.amax().max(subject.scales.force());
                (force(entry, &(&self.least + share * largest)) - value).abs() <= size
            });
            let value = if value.abs() <= NONE / BALANCED * size { 0.0 } else { value };
            is_same.then_some((quantity.name, value))
        });
        found.collect()
    }

    fn find_index(&self, row: usize) -> Option<usize> {
        self.rows.iter().position(|known| *known == row)
    }

    /// The least and the largest λ of a row, infinite where there is none; nothing if the bounds
    /// exclude each other.
    fn range(&self, place: usize) -> Option<[f64; 2]> {
        let [least, largest] = [1.0, -1.0].map(|sign| self.extreme(place, sign));
        let rounded = |force: f64| if force.abs() <= self.none { 0.0 } else { force };
        Some([rounded(least?), rounded(largest?)])
    }

    /// The λ of a row that is least with a sign of 1, or largest with one of −1.
    fn extreme(&self, place: usize, sign: f64) -> Option<f64> {
        let value = |terms: &[(usize, f64)]| terms.iter().map(|(k, c)| c * self.least[*k]).sum::<f64>();
        if self.free.ncols() == 0 {
            let obeyed = self.bounds.iter().all(|terms| value(terms) >= -self.none);
            return obeyed.then(|| self.least[place]);
        }
        let along = |terms: &[(usize, f64)], k: usize| -> f64 {
            let size: f64 = terms.iter().map(|(_, c)| c.abs()).sum();
            let entry = terms.iter().map(|(row, c)| c * self.free[(*row, k)]).sum::<f64>();
            if entry.abs() <= RANK * size { 0.0 } else { entry }
        };
        let unknowns = self.free.ncols();
        let values = DVector::from_fn(unknowns, |k, _| along(&[(place, sign)], k));
        let matrix = DMatrix::from_fn(self.bounds.len(), unknowns, |i, k| along(&self.bounds[i], k));
        let bound = |i: usize, _| (-self.none - value(&self.bounds[i])) / self.scale();
        let bounds = DVector::from_fn(self.bounds.len(), bound);
        let found = solve_linear_program(&values, &matrix, &bounds)?;
        Some(self.least[place] + sign * self.scale() * found)
    }

    /// The unit of c.
    fn scale(&self) -> f64 {
        self.none / NONE
    }
}

/// N of contacts that only push or pull, and μₛ N ± R of those with friction.
fn bounds(subject: &Subject, state: &[DoubleDouble], rows: &[usize]) -> Vec<Vec<(usize, f64)>> {
    let layout = subject.layout();
    let slips = slips(subject, state);
    let place = |row: usize| rows.iter().position(|known| *known == row);
    let one_sided = |contact: usize| layout.contacts[contact].kind.is_one_sided();
    let normals = (0..layout.contacts.len()).filter(|&contact| one_sided(contact));
    let mut bounds: Vec<Vec<(usize, f64)>> = normals.filter_map(|i| Some(vec![(place(i)?, 1.0)])).collect();
    for (friction, slip) in layout.frictions.iter().zip(&slips) {
        let (Some(normal), Some(tangent)) = (place(friction.contact), place(friction.row)) else { continue };
        if one_sided(friction.contact) {
            bounds.extend([1.0, -1.0].map(|sign| vec![(normal, slip.limit.hi()), (tangent, sign)]));
        }
    }
    bounds
}

fn slips(subject: &Subject, state: &[DoubleDouble]) -> Vec<SlipState<DoubleDouble>> {
    let zero = DoubleDouble::from_f64(0.0);
    let still = SlipState { velocity: zero, kinetic: zero, limit: zero };
    let mut slips = vec![still; subject.layout().frictions.len()];
    subject.system.slips(state, &mut slips);
    slips
}

impl Subject {
    /// μₛ of a contact with friction.
    pub(super) fn static_friction(&self, label: &str, state: &[DoubleDouble]) -> Option<f64> {
        let contact = self.layout().contacts.iter().find(|contact| contact.label == label)?;
        Some(slips(self, state)[contact.friction?].limit.hi())
    }
}
