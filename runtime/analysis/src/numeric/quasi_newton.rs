//! The least value of a function with its gradient,
//!
//! ```text
//! x ← x − α H ∇f,    H ← (1 − ρ s yᵀ) H (1 − ρ y sᵀ) + ρ s sᵀ,    s = δx,  y = δ∇f,  ρ = 1/sᵀy
//! ```
//!
//! with H from the last steps alone, beginning with sᵀy/yᵀy (Liu and Nocedal, *On the limited
//! memory BFGS method for large scale optimization*, Mathematical Programming 45, 1989; Nocedal and
//! Wright, *Numerical Optimization*, 2006, algorithm 7.4).

use std::collections::VecDeque;

use nalgebra::DVector;

use super::line_search::{LineEnd, Sample, search};

/// Steps that H is made of.
const REMEMBERED: usize = 8;
/// Directions at most.
const DIRECTIONS: usize = 200;

/// A point with the value of a function and its gradient.
#[derive(Debug, Clone)]
pub(crate) struct Iterate {
    pub(crate) x: DVector<f64>,
    pub(crate) value: f64,
    pub(crate) gradient: DVector<f64>,
}

/// Goes from a point, with a first step in which the steepest variable changes by `first`, to one
/// where the gradient is shorter than `flat`, or as near as steps lead that lessen the value.
/// `evaluate` gives value and gradient, and none to end the search.
pub(crate) fn minimize(
    mut at: Iterate,
    first: f64,
    flat: f64,
    mut evaluate: impl FnMut(&DVector<f64>) -> Option<(f64, DVector<f64>)>,
) -> Iterate {
    let mut steps = VecDeque::with_capacity(REMEMBERED);
    for _ in 0..DIRECTIONS {
        if at.gradient.norm() < flat {
            return at;
        }
        let begin = first / at.gradient.amax();
        let direction = -times_inverse_hessian(&steps, begin, &at.gradient);
        let slope = direction.dot(&at.gradient);
        if !(slope < 0.0 && slope.is_finite()) {
            return at;
        }
        let start = Sample { step: 0.0, value: at.value, slope };
        let mut best = at.clone();
        let mut last = None;
        let end = search(start, 1.0, |step| {
            let x = &at.x + &direction * step;
            let (value, gradient) = evaluate(&x)?;
            let slope = direction.dot(&gradient);
            if !(value.is_finite() && slope.is_finite()) {
                return None;
            }
            let tried = Iterate { x, value, gradient };
            if tried.value < best.value {
                best = tried.clone();
            }
            last = Some(tried);
            Some(Sample { step, value, slope })
        });
        let next = if end == LineEnd::Met { last.unwrap_or(best) } else { best };
        if next.value >= at.value || end == LineEnd::Exhausted {
            return next;
        }
        let step = Step { s: &next.x - &at.x, y: &next.gradient - &at.gradient };
        at = next;
        if step.s.dot(&step.y) > 0.0 {
            if steps.len() == REMEMBERED {
                steps.pop_front();
            }
            steps.push_back(step);
        }
    }
    at
}

struct Step {
    s: DVector<f64>,
    y: DVector<f64>,
}

/// H v, by two loops over the steps; H is `begin` before there is any.
fn times_inverse_hessian(steps: &VecDeque<Step>, begin: f64, v: &DVector<f64>) -> DVector<f64> {
    let mut product = v.clone();
    let mut parts = Vec::with_capacity(steps.len());
    for Step { s, y } in steps.iter().rev() {
        let part = s.dot(&product) / s.dot(y);
        product.axpy(-part, y, 1.0);
        parts.push(part);
    }
    product *= steps.back().map_or(begin, |Step { s, y }| s.dot(y) / y.norm_squared());
    for (Step { s, y }, part) in steps.iter().zip(parts.into_iter().rev()) {
        product.axpy(part - y.dot(&product) / s.dot(y), s, 1.0);
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Residuals, of which the sum of squares is least, with their derivatives.
    type Residuals = fn(&[f64]) -> Vec<(f64, Vec<f64>)>;

    fn square(residuals: Residuals, x: &DVector<f64>) -> (f64, DVector<f64>) {
        let mut gradient = DVector::zeros(x.len());
        let mut value = 0.0;
        for (r, slopes) in residuals(x.as_slice()) {
            value += r * r;
            gradient.axpy(2.0 * r, &DVector::from_vec(slopes), 1.0);
        }
        (value, gradient)
    }

    /// The point that is found, and how often the function was asked for, in other units of
    /// variables and values.
    fn solved(residuals: Residuals, x: &[f64], (unit, size): (f64, f64)) -> (Vec<f64>, usize) {
        let mut count = 0;
        let mut evaluate = |x: &DVector<f64>| {
            count += 1;
            let (value, gradient) = square(residuals, &(x / unit));
            Some((size * value, gradient * (size / unit)))
        };
        let x = DVector::from_row_slice(x) * unit;
        let (value, gradient) = evaluate(&x).unwrap();
        let flat = 1e-10 * gradient.amax();
        let found = minimize(Iterate { x, value, gradient }, 0.1 * unit, flat, evaluate);
        ((found.x / unit).as_slice().to_vec(), count)
    }

    fn rosenbrock(x: &[f64]) -> Vec<(f64, Vec<f64>)> {
        vec![(10.0 * (x[1] - x[0] * x[0]), vec![-20.0 * x[0], 10.0]), (1.0 - x[0], vec![-1.0, 0.0])]
    }

    /// Problem 4 of Moré, Garbow and Hillstrom, *Testing unconstrained optimization software*, ACM
    /// Transactions on Mathematical Software 7, 1981.
    fn brown(x: &[f64]) -> Vec<(f64, Vec<f64>)> {
        vec![
            (x[0] - 1e6, vec![1.0, 0.0]),
            (x[1] - 2e-6, vec![0.0, 1.0]),
            (x[0] * x[1] - 2.0, vec![x[1], x[0]]),
        ]
    }

    /// Their problem 14.
    fn wood(x: &[f64]) -> Vec<(f64, Vec<f64>)> {
        let [a, b] = [90f64.sqrt(), 10f64.sqrt()];
        vec![
            (10.0 * (x[1] - x[0] * x[0]), vec![-20.0 * x[0], 10.0, 0.0, 0.0]),
            (1.0 - x[0], vec![-1.0, 0.0, 0.0, 0.0]),
            (a * (x[3] - x[2] * x[2]), vec![0.0, 0.0, -2.0 * a * x[2], a]),
            (1.0 - x[2], vec![0.0, 0.0, -1.0, 0.0]),
            (b * (x[1] + x[3] - 2.0), vec![0.0, b, 0.0, b]),
            ((x[1] - x[3]) / b, vec![0.0, 1.0 / b, 0.0, -1.0 / b]),
        ]
    }

    #[test]
    fn known_problems_are_solved() {
        let (x, count) = solved(rosenbrock, &[-1.2, 1.0], (1.0, 1.0));
        assert!(x.iter().all(|x| (x - 1.0).abs() < 1e-8) && count < 80, "{x:?} {count}");
        let (x, count) = solved(wood, &[-3.0, -1.0, -3.0, -1.0], (1.0, 1.0));
        assert!(x.iter().all(|x| (x - 1.0).abs() < 1e-7) && count < 200, "{x:?} {count}");
        let (x, count) = solved(brown, &[1.0, 1.0], (1.0, 1.0));
        assert!((x[0] / 1e6 - 1.0).abs() < 1e-9 && (x[1] / 2e-6 - 1.0).abs() < 1e-6, "{x:?} {count}");
    }

    /// Powers of two, so that the steps are the same to the last bit.
    #[test]
    fn units_change_nothing() {
        let expected = solved(rosenbrock, &[-1.2, 1.0], (1.0, 1.0));
        for units in [(2f64.powi(60), 2f64.powi(-90)), (2f64.powi(-60), 2f64.powi(90))] {
            assert_eq!(solved(rosenbrock, &[-1.2, 1.0], units), expected);
        }
    }

    /// Of a quadratic function H becomes the inverse of its second derivatives.
    #[test]
    fn a_quadratic_function_needs_few_steps() {
        let quadratic: Residuals = |x| {
            vec![
                (x[0] + x[1] - 3.0, vec![1.0, 1.0]),
                (x[0] - x[1] - 1.0, vec![1.0, -1.0]),
                (x[0], vec![1.0, 0.0]),
            ]
        };
        // 3x = 4, 2y = 2.
        let (x, count) = solved(quadratic, &[10.0, -20.0], (1.0, 1.0));
        assert!((x[0] - 4.0 / 3.0).abs() < 1e-8 && (x[1] - 1.0).abs() < 1e-8 && count < 20, "{x:?} {count}");
    }

    #[test]
    fn a_search_without_a_minimum_comes_to_an_end() {
        let mut count = 0;
        let start = Iterate { x: DVector::zeros(2), value: 0.0, gradient: DVector::from_element(2, 1.0) };
        let found = minimize(start, 0.1, 1e-9, |x| {
            count += 1;
            Some((x.sum(), DVector::from_element(2, 1.0)))
        });
        assert!(found.value < -1e6 && count < 100, "{found:?} {count}");
    }
}
