//! Minimises the sum of squares ‖r(x)‖² near a point by the method of Levenberg and Marquardt,
//!
//! ```text
//! ‖J δ + r‖² + λ ‖D δ‖² → min,    x ← x + δ
//! λ such that ‖D δ‖ ≤ Δ up to a tenth,    Dₖ the largest ‖J eₖ‖ so far
//! ρ = (‖r(x)‖² − ‖r(x + δ)‖²) / (‖r(x)‖² − ‖J δ + r(x)‖²)
//! Δ shrinks where ρ ≤ ¼ and grows where ρ ≥ ¾;    δ is taken where ρ ≥ 10⁻⁴
//! ```
//!
//! as in MINPACK's LMDER (Moré, *The Levenberg-Marquardt algorithm: implementation and theory*,
//! Lecture Notes in Mathematics 630, 1978), in the variables s = D δ. It depends neither on the
//! units of x nor on that of r.

use nalgebra::{DMatrix, DVector};

/// The first Δ, as a multiple of ‖D x‖, or of ‖r‖ if x = 0.
const FIRST: f64 = 100.0;
/// Relative tolerance of ‖s‖ = Δ.
const WITHIN: f64 = 0.1;
/// Maximum number of values of λ tried for a step.
const TRIED: usize = 10;
/// A step is accepted if it reduces the sum of squares by this fraction of the predicted reduction.
const TAKEN: f64 = 1e-4;
const POOR: f64 = 0.25;
const GOOD: f64 = 0.75;
/// Least factor by which Δ shrinks at once.
const SHRINK: f64 = 0.1;

/// Residuals r(x) with J = ∂r/∂x.
pub(crate) trait Residuals {
    /// r(x), or `None` if it does not exist; the step is then too long.
    fn residuals(&mut self, x: &DVector<f64>) -> Option<DVector<f64>>;

    /// J at the x of the last call of `residuals`.
    fn jacobian(&mut self) -> Option<DMatrix<f64>>;
}

/// When a search ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// Relative changes of the sum of squares and of x, and cosines between r and columns of J,
    /// that count as zero.
    pub(crate) tolerance: f64,
    /// Maximum number of evaluations of residuals.
    pub(crate) evaluations: usize,
}

/// Why a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Termination {
    /// The residuals are zero or orthogonal to the columns of J, or the sum of squares no longer
    /// changes.
    Least,
    /// Steps have become too short, with a sum of squares that still changes.
    Short,
    /// The maximum number of evaluations is reached.
    Exhausted,
    /// There are no derivatives, or they are not finite.
    NoDerivatives,
}

/// Minimises from x; returns the best x and why the search ended.
pub(crate) fn minimize(
    mut x: DVector<f64>,
    mut residuals: DVector<f64>,
    mut jacobian: DMatrix<f64>,
    limits: Limits,
    problem: &mut impl Residuals,
) -> (DVector<f64>, Termination) {
    let Limits { tolerance, evaluations } = limits;
    let mut scale = DVector::zeros(x.len());
    let mut region = None;
    let (mut lambda, mut count) = (0.0, 1);
    loop {
        let norm = residuals.norm();
        if norm == 0.0 {
            return (x, Termination::Least);
        }
        if !norm.is_finite() || jacobian.iter().any(|entry| !entry.is_finite()) {
            return (x, Termination::NoDerivatives);
        }
        let norms = DVector::from_iterator(x.len(), jacobian.column_iter().map(|column| column.norm()));
        let projections = jacobian.tr_mul(&residuals);
        if projections.iter().zip(&norms).all(|(p, size)| p.abs() <= tolerance * size * norm) {
            return (x, Termination::Least);
        }
        // A variable without influence so far keeps its scale.
        scale.zip_apply(&norms, |scale: &mut f64, norm| *scale = scale.max(norm));
        let scale = scale.map(|scale| if scale > 0.0 { scale } else { 1.0 });
        let model = Model::new(&jacobian, &residuals, &scale);
        let mut size = scale.component_mul(&x).norm();
        let radius = region.get_or_insert(FIRST * if size > 0.0 { size } else { norm });
        let taken = loop {
            let (step, damping) = model.step(*radius, lambda);
            lambda = damping;
            let length = step.norm();
            if !length.is_finite() {
                return (x, Termination::NoDerivatives);
            }
            if count == 1 {
                *radius = radius.min(length);
            }
            let [linear, damped] = [model.change(&step) / norm, lambda.sqrt() * length / norm].map(|x| x * x);
            let foreseen = linear + 2.0 * damped;
            let moved = &x + step.component_div(&scale);
            let tried = problem.residuals(&moved);
            count += 1;
            let farther = tried.as_ref().map_or(f64::INFINITY, |tried| tried.norm() / norm);
            let gain = if SHRINK * farther < 1.0 { 1.0 - farther * farther } else { -1.0 };
            let ratio = if foreseen > 0.0 { gain / foreseen } else { 0.0 };
            if ratio <= POOR {
                // Minimum of the parabola through both values and the slope.
                let slope = linear + damped;
                let part = if gain >= 0.0 { 0.5 } else { 0.5 * slope / (slope - 0.5 * gain) };
                let part = if SHRINK * farther < 1.0 { part.max(SHRINK) } else { SHRINK };
                *radius = part * radius.min(length / SHRINK);
                lambda /= part;
            } else if lambda == 0.0 || ratio >= GOOD {
                *radius = 2.0 * length;
                lambda *= 0.5;
            }
            let taken = tried.filter(|_| ratio >= TAKEN);
            if taken.is_some() {
                x = moved;
                size = scale.component_mul(&x).norm();
            }
            if farther == 0.0 || gain.abs() <= tolerance && foreseen <= tolerance && ratio <= 2.0 {
                return (x, Termination::Least);
            }
            if *radius <= tolerance * size {
                return (x, Termination::Short);
            }
            if count >= evaluations {
                return (x, Termination::Exhausted);
            }
            if let Some(taken) = taken {
                break taken;
            }
        };
        residuals = taken;
        jacobian = match problem.jacobian() {
            Some(jacobian) => jacobian,
            None => return (x, Termination::NoDerivatives),
        };
    }
}

/// ‖J D⁻¹ s + r‖ → min as R Pᵀ s ≈ c, with J D⁻¹ P = Q R and c = −Qᵀ r.
struct Model {
    triangle: DMatrix<f64>,
    right: DVector<f64>,
    /// J D⁻¹.
    matrix: DMatrix<f64>,
    /// The step without damping, permuted, and whether it is the only one.
    free: DVector<f64>,
    is_regular: bool,
    permutation: Vec<usize>,
}

impl Model {
    fn new(jacobian: &DMatrix<f64>, residuals: &DVector<f64>, scale: &DVector<f64>) -> Self {
        let n = scale.len();
        let matrix = DMatrix::from_fn(jacobian.nrows(), n, |i, k| jacobian[(i, k)] / scale[k]);
        let decomposed = matrix.clone().col_piv_qr();
        let mut right = -residuals;
        decomposed.q_tr_mul(&mut right);
        let right = right.rows(0, n).into_owned();
        let triangle = decomposed.r();
        let mut order = DMatrix::from_fn(1, n, |_, k| k);
        decomposed.p().permute_columns(&mut order);
        let none = n as f64 * f64::EPSILON * triangle.amax();
        let rank = (0..n).take_while(|&k| triangle[(k, k)].abs() > none).count();
        let mut free = DVector::zeros(n);
        let solved = triangle.view((0, 0), (rank, rank)).solve_upper_triangular(&right.rows(0, rank));
        solved.iter().for_each(|solved| free.rows_mut(0, rank).copy_from(solved));
        let permutation = order.iter().copied().collect();
        Self { triangle, right, matrix, free, is_regular: rank == n, permutation }
    }

    /// ‖J D⁻¹ s‖.
    fn change(&self, step: &DVector<f64>) -> f64 {
        (&self.matrix * step).norm()
    }

    /// The step of length Δ with its λ, by Newton's method for φ(λ) = ‖s‖ − Δ = 0 between bounds;
    /// the one without damping if it is no longer.
    fn step(&self, radius: f64, lambda: f64) -> (DVector<f64>, f64) {
        let mut step = self.free.clone();
        let mut excess = step.norm() - radius;
        if excess <= WITHIN * radius {
            return (self.in_order(&step), 0.0);
        }
        let gradient = self.triangle.tr_mul(&self.right).norm();
        let mut low = if self.is_regular { newton(&self.triangle, &step, radius) } else { 0.0 };
        let mut high = gradient / radius;
        let mut lambda = lambda.max(low).min(high);
        if lambda == 0.0 {
            lambda = gradient / step.norm();
        }
        for tried in 1..=TRIED {
            if lambda == 0.0 {
                lambda = f64::MIN_POSITIVE.max(1e-3 * high);
            }
            let factor;
            (step, factor) = self.damped(lambda);
            let last = std::mem::replace(&mut excess, step.norm() - radius);
            let is_inside = low == 0.0 && excess <= last && last < 0.0;
            if excess.abs() <= WITHIN * radius || is_inside || tried == TRIED {
                break;
            }
            if excess > 0.0 {
                low = low.max(lambda);
            } else {
                high = high.min(lambda);
            }
            lambda = low.max(lambda + newton(&factor, &step, radius));
        }
        (self.in_order(&step), lambda)
    }

    /// ‖R s − c‖² + λ ‖s‖² → min, with the triangle L of LᵀL = RᵀR + λ.
    fn damped(&self, lambda: f64) -> (DVector<f64>, DMatrix<f64>) {
        let n = self.right.len();
        let mut stacked = DMatrix::zeros(2 * n, n);
        stacked.rows_mut(0, n).copy_from(&self.triangle);
        stacked.rows_mut(n, n).fill_diagonal(lambda.sqrt());
        let mut right = DVector::zeros(2 * n);
        right.rows_mut(0, n).copy_from(&self.right);
        let decomposed = stacked.qr();
        decomposed.q_tr_mul(&mut right);
        let factor = decomposed.unpack_r();
        let step = factor.solve_upper_triangular(&right.rows(0, n));
        (step.unwrap_or_else(|| DVector::from_element(n, f64::NAN)), factor)
    }

    /// Undoes the permutation of the variables.
    fn in_order(&self, permuted: &DVector<f64>) -> DVector<f64> {
        let mut step = DVector::zeros(permuted.len());
        self.permutation.iter().zip(permuted).for_each(|(&k, s)| step[k] = *s);
        step
    }
}

/// What Newton's method for 1/‖s‖ = 1/Δ adds to λ: φ/(Δ ‖L⁻ᵀ s/‖s‖‖²).
fn newton(factor: &DMatrix<f64>, step: &DVector<f64>, radius: f64) -> f64 {
    let length = step.norm();
    let solved = factor.tr_solve_upper_triangular(&(step / length));
    solved.map_or(0.0, |solved| (length - radius) / radius / solved.norm_squared())
}

#[cfg(test)]
mod tests {
    use super::*;

    type Function = fn(&[f64]) -> Option<Vec<(f64, Vec<f64>)>>;

    /// A function in other units of variables and residuals, and how often it was asked for.
    struct Known {
        function: Function,
        units: DVector<f64>,
        size: f64,
        last: DVector<f64>,
        count: usize,
    }

    impl Known {
        fn values(&self) -> Option<Vec<(f64, Vec<f64>)>> {
            (self.function)(self.last.component_div(&self.units).as_slice())
        }
    }

    impl Residuals for Known {
        fn residuals(&mut self, x: &DVector<f64>) -> Option<DVector<f64>> {
            self.count += 1;
            self.last = x.clone();
            let values = self.values()?;
            Some(self.size * DVector::from_iterator(values.len(), values.iter().map(|(r, _)| *r)))
        }

        fn jacobian(&mut self) -> Option<DMatrix<f64>> {
            let values = self.values()?;
            let entry = |i: usize, k: usize| self.size * values[i].1[k] / self.units[k];
            Some(DMatrix::from_fn(values.len(), self.units.len(), entry))
        }
    }

    const LIMITS: Limits = Limits { tolerance: 1e-14, evaluations: 1000 };

    fn scaled(function: Function, start: &[f64], units: &[f64], size: f64) -> (Vec<f64>, usize, Termination) {
        let units = DVector::from_row_slice(units);
        let x = DVector::from_row_slice(start).component_mul(&units);
        let mut problem = Known { function, units, size, last: x.clone(), count: 0 };
        let (r, j) = (problem.residuals(&x).unwrap(), problem.jacobian().unwrap());
        let (x, ending) = minimize(x, r, j, LIMITS, &mut problem);
        (x.component_div(&problem.units).as_slice().to_vec(), problem.count, ending)
    }

    fn solved(function: Function, start: &[f64]) -> (Vec<f64>, usize, Termination) {
        scaled(function, start, &vec![1.0; start.len()], 1.0)
    }

    // Problems 1, 2, 4, 7, 11, 13 and 32 of Moré, Garbow and Hillstrom, *Testing unconstrained
    // optimization software*, ACM Transactions on Mathematical Software 7, 1981.

    fn rosenbrock(x: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        let slopes = [vec![-20.0 * x[0], 10.0], vec![-1.0, 0.0]];
        Some([10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]].into_iter().zip(slopes).collect())
    }

    fn freudenstein_roth(x: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        let y = x[1];
        Some(vec![
            (-13.0 + x[0] + ((5.0 - y) * y - 2.0) * y, vec![1.0, (10.0 - 3.0 * y) * y - 2.0]),
            (-29.0 + x[0] + ((y + 1.0) * y - 14.0) * y, vec![1.0, (3.0 * y + 2.0) * y - 14.0]),
        ])
    }

    fn brown(x: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        let slopes = [vec![1.0, 0.0], vec![0.0, 1.0], vec![x[1], x[0]]];
        Some([x[0] - 1e6, x[1] - 2e-6, x[0] * x[1] - 2.0].into_iter().zip(slopes).collect())
    }

    fn helical_valley(x: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        let (square, radius) = (x[0] * x[0] + x[1] * x[1], x[0].hypot(x[1]));
        let turn = x[1].atan2(x[0]) / core::f64::consts::TAU;
        let by = 100.0 / core::f64::consts::TAU / square;
        Some(vec![
            (10.0 * (x[2] - 10.0 * turn), vec![by * x[1], -by * x[0], 10.0]),
            (10.0 * (radius - 1.0), vec![10.0 * x[0] / radius, 10.0 * x[1] / radius, 0.0]),
            (x[2], vec![0.0, 0.0, 1.0]),
        ])
    }

    fn powell_singular(x: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        let [five, ten] = [5f64.sqrt(), 10f64.sqrt()];
        let (a, b) = (x[1] - 2.0 * x[2], x[0] - x[3]);
        Some(vec![
            (x[0] + 10.0 * x[1], vec![1.0, 10.0, 0.0, 0.0]),
            (five * (x[2] - x[3]), vec![0.0, 0.0, five, -five]),
            (a * a, vec![0.0, 2.0 * a, -4.0 * a, 0.0]),
            (ten * b * b, vec![2.0 * ten * b, 0.0, 0.0, -2.0 * ten * b]),
        ])
    }

    /// yᵢ = (900, …) at tᵢ = i/100, the three-parameter problem of Bard with 15 data.
    fn bard(x: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        let y = [0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39, 0.37, 0.58, 0.73, 0.96, 1.34, 2.1, 4.39];
        let residual = |(i, y): (usize, f64)| {
            let (u, v) = (1.0 + i as f64, 15.0 - i as f64);
            let w = u.min(v);
            let d = v * x[1] + w * x[2];
            (y - x[0] - u / d, vec![-1.0, u * v / (d * d), u * w / (d * d)])
        };
        Some(y.into_iter().enumerate().map(residual).collect())
    }

    /// −xᵢ sums as in the linear function of full rank with ten residuals of five variables.
    fn linear(x: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        let sum: f64 = x.iter().sum();
        let residual = |i: usize| {
            let own = if i < x.len() { 1.0 } else { 0.0 };
            let slopes = (0..x.len()).map(|k| f64::from(u8::from(i == k)) - 0.2).collect();
            (own * x.get(i).unwrap_or(&0.0) - 0.2 * sum - 1.0, slopes)
        };
        Some((0..10).map(residual).collect())
    }

    fn norm(function: Function, x: &[f64]) -> f64 {
        function(x).unwrap().iter().map(|(r, _)| r * r).sum::<f64>().sqrt()
    }

    #[test]
    fn known_problems_are_solved() {
        for factor in [1.0, 10.0, 100.0] {
            let start = [-1.2, 1.0].map(|x| factor * x);
            let (x, count, ending) = solved(rosenbrock, &start);
            assert!(
                x == [1.0, 1.0] && count < 40 && ending == Termination::Least,
                "{x:?} {count} {ending:?}"
            );
            let start = [-factor, 0.0, 0.0];
            let (x, count, _) = solved(helical_valley, &start);
            assert!((x[0] - 1.0).abs() < 1e-12 && x[1].abs() < 1e-12 && x[2].abs() < 1e-12, "{x:?}");
            assert!(count < 40, "{count}");
            let (x, count, _) = solved(freudenstein_roth, &[0.5 * factor, -2.0 * factor]);
            // The local minimum, ‖r‖² = 48.9842…
            assert!((norm(freudenstein_roth, &x).powi(2) - 48.98425367924).abs() < 1e-9, "{x:?} {count}");
            let (x, _, _) = solved(powell_singular, &[3.0, -1.0, 0.0, 1.0].map(|x| factor * x));
            assert!(norm(powell_singular, &x) < 1e-20, "{x:?}");
        }
        let (x, count, _) = solved(brown, &[1.0, 1.0]);
        assert!((x[0] / 1e6 - 1.0).abs() < 1e-14 && (x[1] / 2e-6 - 1.0).abs() < 1e-9, "{x:?} {count}");
        let (x, count, ending) = solved(bard, &[1.0; 3]);
        assert!((norm(bard, &x).powi(2) - 8.21487730657e-3).abs() < 1e-13 && count < 20, "{x:?} {ending:?}");
    }

    /// x = −1 with ‖r‖² = m − n, in one step.
    #[test]
    fn a_linear_problem_takes_one_step() {
        let (x, count, ending) = solved(linear, &[1.0; 5]);
        assert!(x.iter().all(|x| (x + 1.0).abs() < 1e-13) && count <= 3, "{x:?} {count}");
        assert_eq!(ending, Termination::Least);
    }

    /// Powers of two, so that the steps are the same to the last bit.
    #[test]
    fn units_change_nothing() {
        let [small, large] = [2f64.powi(-70), 2f64.powi(80)];
        for (function, start) in [(rosenbrock as Function, [-1.2, 1.0]), (brown, [1.0, 1.0])] {
            let expected = solved(function, &start);
            for units in [[small, large], [large, small], [large, large]] {
                for size in [small, large] {
                    assert_eq!(scaled(function, &start, &units, size), expected);
                }
            }
        }
    }

    /// Only x + y is determined, z not at all.
    #[test]
    fn undetermined_variables_stay_finite() {
        let dependent: Function = |x| {
            let sum = x[0] + x[1];
            let slopes = vec![1.0, 1.0, 0.0];
            Some(vec![
                (sum - 3.0, slopes.clone()),
                (2.0 * sum - 6.0, vec![2.0, 2.0, 0.0]),
                (sum - 3.0, slopes),
            ])
        };
        let (x, _, ending) = solved(dependent, &[1.0, 5.0, 7.0]);
        assert!((x[0] + x[1] - 3.0).abs() < 1e-13 && x[2] == 7.0 && ending == Termination::Least, "{x:?}");
    }

    /// ln x + 3 is undefined for x < 0, where the first step leads.
    #[test]
    fn steps_that_fail_are_shortened() {
        let logarithm: Function = |x| (x[0] > 0.0).then(|| vec![(x[0].ln() + 3.0, vec![1.0 / x[0]])]);
        let (x, count, ending) = solved(logarithm, &[1.0]);
        assert!((x[0] - (-3f64).exp()).abs() < 1e-14 && count < 20, "{x:?} {count}");
        assert_eq!(ending, Termination::Least);
        // √x − 2 is made undefined above 1, where the minimum is.
        let bounded: Function =
            |x| ((0.0..=1.0).contains(&x[0])).then(|| vec![(x[0].sqrt() - 2.0, vec![0.5 / x[0].sqrt()])]);
        let (x, _, ending) = solved(bounded, &[0.5]);
        assert!((x[0] - 1.0).abs() < 1e-6 && ending == Termination::Short, "{x:?} {ending:?}");
    }

    #[test]
    fn nonfinite_residuals_end_the_search() {
        let infinite: Function = |x| Some(vec![(x[0], vec![f64::NAN])]);
        assert_eq!(solved(infinite, &[1.0]).2, Termination::NoDerivatives);
    }
}
