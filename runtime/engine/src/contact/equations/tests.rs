//! The equations along a motion, against those at states of it.

use nalgebra::{DMatrix, DVector};

use super::{SeriesEquations, TIME_ORDERS};
use crate::prelude::*;
use crate::system::Model;

/// A rod on its lower end, pulled at the other one by a load that grows.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = l)]
#[support(A = floor, rough)]
#[force(B = (f * t, 2 * f * t))]
#[coordinate(x = x(A))]
#[coordinate(y = y(A))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (0, 0), B = (0.6 * l, 0.8 * l))]
struct Pulled {
    m: f64,
    l: f64,
    g: f64,
    f: f64,
}

/// q(τ), u(τ) and t + τ with u̇ = Σ aₖ τᵏ.
fn moved(start: &[f64; 7], a: &[DVector<f64>], time: f64) -> Vec<f64> {
    let power = |k: usize| time.powi(k as i32);
    let sum = |part: &dyn Fn(usize) -> f64| (0..a.len()).map(part).sum::<f64>();
    let q = |i: usize| {
        let turned = sum(&|k| a[k][i] * power(k + 2) / ((k + 1) * (k + 2)) as f64);
        start[i] + start[3 + i] * time + turned
    };
    let u = |i: usize| start[3 + i] + sum(&|k| a[k][i] * power(k + 1) / (k + 1) as f64);
    (0..3).map(q).chain((0..3).map(u)).chain([start[6] + time]).collect()
}

/// Taylor coefficients by the polynomial through nine points.
#[test]
fn series_are_those_of_the_states_on_the_way() {
    let model = Model::new(&Pulled { m: 2.0, l: 0.7, g: 9.81, f: 3.0 });
    let start = [0.4, 0.1, -0.2, 0.9, 0.5, -0.8, 1.3];
    let all = [[0.7, -1.1, 0.6], [1.9, 0.4, -1.3], [-2.3, 1.7, 0.8]].map(|a| DVector::from_row_slice(&a));
    let (points, span) = (9, 0.04);
    let time = |k: usize| (k as f64 - 4.0) * span;
    let powers = DMatrix::from_fn(points, points, |k, power| time(k).powi(power as i32)).lu();
    for count in 0..=all.len() {
        let series = SeriesEquations::along(&model, &start, &all[..count]);
        let states = (0..points).map(|k| model.system.equations(&moved(&start, &all[..count], time(k))));
        let states: Vec<_> = states.collect();
        let rows = series.bias[0].len();
        assert!(rows > 0 && TIME_ORDERS == 4);
        let check = |found: [f64; TIME_ORDERS], at: &dyn Fn(usize) -> f64| {
            let expected = powers.solve(&DVector::from_fn(points, |k, _| at(k))).unwrap();
            for (order, found) in found.into_iter().enumerate() {
                // Nine points leave terms of the ninth order.
                let apart = (found - expected[order]).abs();
                assert!(apart < 1e-6 * (1.0 + found.abs()), "{count} {order}: {found} {}", expected[order]);
            }
        };
        for i in 0..3 {
            check(core::array::from_fn(|order| series.force[order][i]), &|k| states[k].force()[i]);
            for j in 0..3 {
                check(core::array::from_fn(|order| series.mass[order][(i, j)]), &|k| states[k].mass(i)[j]);
            }
        }
        for row in 0..rows {
            check(core::array::from_fn(|order| series.bias[order][row]), &|k| states[k].bias()[row]);
            for j in 0..3 {
                let found = core::array::from_fn(|order| series.jacobian[order][(row, j)]);
                check(found, &|k| states[k].jacobian(row)[j]);
            }
        }
    }
}

/// An entry that is no number is found wherever it is.
#[test]
fn entries_that_are_not_finite_are_found() {
    let model = Model::new(&Pulled { m: 2.0, l: 0.7, g: 9.81, f: 3.0 });
    let equations = || SeriesEquations::along(&model, &[0.4, 0.1, -0.2, 0.9, 0.5, -0.8, 1.3], &[]);
    assert!(equations().are_finite());
    let wrong: [fn(&mut SeriesEquations); 4] = [
        |it| it.mass[0][(2, 2)] = f64::NAN,
        |it| it.force[0][2] = f64::INFINITY,
        |it| it.jacobian[0][(0, 2)] = f64::NEG_INFINITY,
        |it| it.bias[0][1] = f64::NAN,
    ];
    for (k, change) in wrong.into_iter().enumerate() {
        let mut it = equations();
        change(&mut it);
        assert!(!it.are_finite(), "{k}");
    }
}
