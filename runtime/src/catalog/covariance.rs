//! The dimensions of parameters, by Euler's theorem: a quantity Q of dimension D in which parameters pᵢ and state variables xₖ
//! of dimensions dᵢ and dₖ occur scales with the units, so that
//!
//! ```text
//! Σᵢ dᵢ pᵢ ∂Q/∂pᵢ = D Q − Σₖ dₖ xₖ ∂Q/∂xₖ
//! ```
//!
//! for each of length, time and mass. Energies, forces, gaps, places and measures at several states give more such equations
//! than there are parameters; the dimensions of joints, of which some are angles and some lengths, are found with those of the
//! parameters. Where the equations contradict each other, the model has numbers with a dimension in it.

use crate::model::{Array, BarSystem, Coordinate, KernelView, MeasureKind, Shape};
use crate::scales::Scales;
use nalgebra::{DMatrix, DVector};

/// Powers of length, time and mass.
pub type Dimension = [f64; 3];

const NONE: Dimension = [0.0; 3];
const LENGTH: Dimension = [1.0, 0.0, 0.0];
const TIME: Dimension = [0.0, 1.0, 0.0];
const ENERGY: Dimension = [2.0, -2.0, 1.0];

/// Step of differences relative to the variable.
const STEP: f64 = 1e-4;
/// What differences leave of an equation that holds.
const ROUNDING: f64 = 1e-5;
/// Parts in which dimensions are whole.
const PARTS: f64 = 12.0;
/// So many states.
const STATES: usize = 8;

/// The dimension of each parameter; none where the model has numbers with a dimension in it, or a parameter that nothing here
/// depends on. Of parameters that always occur as a product the product alone is determined.
pub fn dimensions<M: BarSystem>(parameters: &[f64]) -> Option<Vec<Dimension>> {
    let scales = Scales::natural(&M::from_parameters(parameters));
    let rows: Vec<Row> = (0..STATES).flat_map(|k| rows::<M>(parameters, &state::<M>(&scales, k))).collect();
    let unknowns = parameters.len() + M::LAYOUT.joints.len();
    let left = DMatrix::from_fn(rows.len(), unknowns, |i, j| rows[i].slopes[j]);
    let right = DMatrix::from_fn(rows.len(), 3, |i, b| rows[i].rest[b]);
    if parameters.iter().zip(left.column_iter()).any(|(p, column)| *p != 0.0 && column.amax() == 0.0) {
        return None;
    }
    let scale: Vec<f64> = left.column_iter().map(|column| column.amax()).collect();
    let scale =
        DVector::from_iterator(scale.len(), scale.iter().map(|&s| if s > 0.0 { 1.0 / s } else { 0.0 }));
    let balanced = &left * DMatrix::from_diagonal(&scale);
    let solved = balanced.svd(true, true).solve(&right, ROUNDING).ok()?;
    let whole = DMatrix::from_fn(unknowns, 3, |i, b| (solved[(i, b)] * scale[i] * PARTS).round() / PARTS);
    let contradicted = (&left * &whole - &right).amax() > ROUNDING;
    let whole = whole.rows(0, parameters.len());
    (!contradicted).then(|| whole.row_iter().map(|row| [row[0], row[1], row[2]]).collect())
}

/// The dimension of a coordinate.
pub fn of_coordinate(coordinate: &Coordinate) -> Dimension {
    if coordinate.is_angle { NONE } else { LENGTH }
}

/// `a` per `b`.
pub fn per(a: Dimension, b: Dimension) -> Dimension {
    core::array::from_fn(|i| a[i] - b[i])
}

/// What the dimension of a quantity is.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Known(Dimension),
    /// That of a joint's gap.
    Joint(usize),
}

impl Of {
    fn known(self) -> Dimension {
        match self {
            Self::Known(dimension) => dimension,
            Self::Joint(_) => NONE,
        }
    }
}

/// One equation, its largest term 1.
struct Row {
    /// pᵢ ∂Q/∂pᵢ, then −Q in the place of a joint whose dimension is sought.
    slopes: Vec<f64>,
    rest: Dimension,
}

fn rows<M: BarSystem>(parameters: &[f64], state: &[f64]) -> Vec<Row> {
    let at = |p: &[f64], x: &[f64]| quantities::<M>(p, x);
    let here = at(parameters, state);
    let by_parameter = slopes(parameters, |p| at(p, state));
    let by_state = slopes(state, |x| at(parameters, x));
    let entries = entries::<M>();
    let row = |(k, (value, dimension)): (usize, &(f64, Of))| {
        let mut slopes: Vec<f64> = by_parameter.iter().map(|slope| slope[k]).collect();
        slopes.extend(
            (0..M::LAYOUT.joints.len()).map(|j| if *dimension == Of::Joint(j) { -value } else { 0.0 }),
        );
        let of_state =
            |b: usize| entries.iter().zip(&by_state).map(|(d, slope)| d[b] * slope[k]).sum::<f64>();
        let rest = core::array::from_fn(|b| dimension.known()[b] * value - of_state(b));
        let terms = slopes.iter().chain(&rest).chain(by_state.iter().map(|slope| &slope[k]));
        let largest = terms.fold(value.abs(), |most, term| most.max(term.abs()));
        let usable = largest > 0.0 && largest.is_finite();
        usable.then(|| Row {
            slopes: slopes.iter().map(|s| s / largest).collect(),
            rest: rest.map(|r| r / largest),
        })
    };
    here.iter().enumerate().filter_map(row).collect()
}

/// x ∂Q/∂x of all quantities, variable by variable.
fn slopes(x: &[f64], quantities: impl Fn(&[f64]) -> Vec<(f64, Of)>) -> Vec<Vec<f64>> {
    let moved = |i: usize, factor: f64| {
        let mut moved = x.to_vec();
        moved[i] *= factor;
        quantities(&moved)
    };
    let slope = |i: usize| {
        let (more, less) = (moved(i, 1.0 + STEP), moved(i, 1.0 - STEP));
        more.iter().zip(&less).map(|(a, b)| (a.0 - b.0) / (2.0 * STEP)).collect()
    };
    (0..x.len()).map(slope).collect()
}

/// The dimension of each entry of a state.
fn entries<M: BarSystem>() -> Vec<Dimension> {
    let coordinates = M::LAYOUT.coordinates.iter().map(of_coordinate);
    let rates = coordinates.clone().map(|dimension| per(dimension, TIME));
    coordinates.chain(rates).chain(M::LAYOUT.timed.then_some(TIME)).collect()
}

/// A state in general position, in natural units.
fn state<M: BarSystem>(scales: &Scales, k: usize) -> Vec<f64> {
    let golden = 0.618_033_988_749_894_9;
    let spread = |i: usize| ((i + 1) as f64 * golden + (k + 1) as f64 * golden * golden).fract();
    (0..entries::<M>().len()).map(|i| scales.entry::<M>(i) * (0.2 + spread(i))).collect()
}

/// Quantities at a state.
fn quantities<M: BarSystem>(parameters: &[f64], state: &[f64]) -> Vec<(f64, Of)> {
    let model = M::from_parameters(parameters);
    let constants = model.constants::<f64>();
    let state = M::State::from_fn(|i| state[i]);
    let kernel = M::kernel(&constants, &state);
    let energy = M::energy(&constants, &state);
    let forces = M::LAYOUT.coordinates.iter().map(|coordinate| per(ENERGY, of_coordinate(coordinate)));
    let contacts = M::LAYOUT.contacts.len();
    let mut all = vec![(energy.kinetic, ENERGY), (energy.potential, ENERGY)];
    all.extend(kernel.force().iter().copied().zip(forces));
    all.extend(kernel.gap().iter().take(contacts).map(|gap| (*gap, LENGTH)));
    all.extend(M::points(&constants, &state).as_ref().iter().map(|place| (*place, LENGTH)));
    let measures = model.measures();
    all.extend(measures.as_ref().iter().filter_map(|m| Some((m.value, of_measure(m.kind)?))));
    all.extend(model.restitution().as_ref().iter().map(|e| (*e, NONE)));
    all.extend(model.scenery().as_ref().iter().flat_map(|scenery| {
        let shape = match scenery.shape {
            Shape::Line { angle } | Shape::Guide { angle } => Some((angle, NONE)),
            Shape::Circle { radius, .. } => Some((radius, LENGTH)),
            Shape::Corner | Shape::Pin | Shape::Point => None,
        };
        scenery.at.map(|place| (place, LENGTH)).into_iter().chain(shape)
    }));
    let known = all.into_iter().map(|(value, dimension)| (value, Of::Known(dimension)));
    let joints = kernel.gap().iter().skip(contacts).take(M::LAYOUT.joints.len());
    known.chain(joints.enumerate().map(|(j, gap)| (*gap, Of::Joint(j)))).collect()
}

/// None of a damper: it may be one between points or a torsional one, its forces tell which.
fn of_measure(kind: MeasureKind) -> Option<Dimension> {
    match kind {
        MeasureKind::Mass => Some([0.0, 0.0, 1.0]),
        MeasureKind::Length | MeasureKind::Extent | MeasureKind::Margin => Some(LENGTH),
        MeasureKind::Sign | MeasureKind::Side | MeasureKind::Direction => Some(LENGTH),
        MeasureKind::Branch => Some(NONE),
        MeasureKind::Inertia => Some([2.0, 0.0, 1.0]),
        MeasureKind::Gravity => Some([1.0, -2.0, 0.0]),
        MeasureKind::Stiffness => Some([0.0, -2.0, 1.0]),
        MeasureKind::TorsionalStiffness => Some(ENERGY),
        MeasureKind::Damping => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::*;

    /// A bar on a spring, damped, a weight at its end.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(OA, mass = m, length = l)]
    #[mass(A, n)]
    #[pin(O = (0, 0))]
    #[torsion(OA, stiffness = k, damping = c)]
    #[force(A = (f * cos(w * t), 0))]
    #[figure(A = (0, -l))]
    #[coordinate(phi = angle(OA), from = down)]
    struct Damped {
        m: f64,
        n: f64,
        l: f64,
        k: f64,
        c: f64,
        f: f64,
        w: f64,
        g: f64,
    }

    #[test]
    fn dimensions_follow_from_what_parameters_do() {
        let found =
            dimensions::<Damped>(&[1.0, 2.0, 0.5, 3.0, 0.1, 0.7, 2.0, 9.81]).expect("no numbers in it");
        let (mass, length, gravity) = ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [1.0, -2.0, 0.0]);
        let (damping, force, frequency) = ([2.0, -1.0, 1.0], [1.0, -2.0, 1.0], [0.0, -1.0, 0.0]);
        assert_eq!(found, [mass, mass, length, ENERGY, damping, force, frequency, gravity]);
    }

    /// A crank that is driven, and a rod from it to a slider.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(OA, mass = m, length = r)]
    #[bar(AB, mass = m, length = l)]
    #[pin(O = (0, 0))]
    #[slider(B = horizontal(h))]
    #[drive(phi = w * t)]
    #[figure(A = (r, 0), B = (r + sqrt(l * l - h * h), h))]
    #[coordinate(phi = angle(OA), from = right)]
    struct Driven {
        m: f64,
        r: f64,
        l: f64,
        h: f64,
        w: f64,
        g: f64,
    }

    #[test]
    fn joints_tell_the_dimensions_of_what_only_they_depend_on() {
        let found = dimensions::<Driven>(&[1.0, 0.5, 2.0, 0.1, 3.0, 9.81]).expect("no numbers in it");
        assert_eq!(found, [[0.0, 0.0, 1.0], LENGTH, LENGTH, LENGTH, [0.0, -1.0, 0.0], [1.0, -2.0, 0.0]]);
    }

    /// A bar as long as two of whatever unit.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(OA, mass = m, length = 2)]
    #[pin(O = (0, 0))]
    #[figure(A = (0, -2))]
    #[coordinate(phi = angle(OA), from = down)]
    struct Fixed {
        m: f64,
        g: f64,
    }

    #[test]
    fn a_number_with_a_dimension_is_noticed() {
        assert_eq!(dimensions::<Fixed>(&[1.0, 9.81]), None);
    }
}
