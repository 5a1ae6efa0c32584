use super::{Columns, LANES, ORDERS, SeriesOps, Tape, TaylorTape};

/// a = 1 / (1 − t/2), b = Σ (k + 1) tᵏ: their product by Cauchy's formula.
fn a_product(tape: &mut impl TaylorTape<f64>, columns: &[usize]) {
    let (a, b) = (|k: usize| 0.5_f64.powi(k as i32), |k: usize| (k + 1) as f64);
    for n in 0..ORDERS {
        let expected: f64 = (0..=n).map(|k| a(k) * b(n - k)).sum();
        for &column in columns {
            // Halves and small integers: exact.
            assert_eq!(product(tape, n, column, [a(n), b(n)]), expected, "order {n}, column {column}");
        }
    }
}

fn product(tape: &mut impl TaylorTape<f64>, n: usize, column: usize, [a, b]: [f64; 2]) -> f64 {
    if n == 0 { tape.values().product(column, a, b) } else { tape.coefficients(n).product(column, a, b) }
}

/// Orders are summed in pairs and blocks in pairs: all that begin or end one.
#[test]
fn orders_sum_all_products_of_lower_ones() {
    a_product(&mut Tape::<f64, 1>::default(), &[0, LANES - 1]);
    a_product(&mut Tape::<f64, 2>::default(), &[0, LANES - 1, LANES, 2 * LANES - 1]);
    a_product(&mut Tape::<f64, 3>::default(), &[0, LANES, 2 * LANES, 3 * LANES - 1]);
}

/// Columns are summed four at a time, and what is left.
#[test]
fn columns_sum_all_products_of_lower_orders() {
    a_product(&mut Columns::<f64, 1>::default(), &[0]);
    a_product(&mut Columns::<f64, 6>::default(), &[0, 3, 4, 5]);
    a_product(&mut Columns::<f64, 8>::default(), &[0, 3, 4, 7]);
    a_product(&mut Columns::<f64, 11>::default(), &[0, 7, 8, 10]);
}

/// |a| from a zero on: the sign is that of the first coefficient that is none, in each lane its own.
#[test]
fn magnitudes_are_one_sided() {
    let series = [[0.0, 0.0, -3.0], [0.0, -2.0, 1.0], [-1.5, 1.0, 0.0], [4.0, 0.5, -1.0]];
    let expected = [[0.0, 0.0, 3.0], [0.0, 2.0, -1.0], [1.5, -1.0, 0.0], [-4.0, -0.5, 1.0]];
    let mut tape = Tape::<f64, 1>::default();
    for (n, (row, expected)) in series.into_iter().zip(expected).enumerate() {
        for (column, a) in row.into_iter().enumerate() {
            let found = if n == 0 {
                tape.values().magnitude(column, a)
            } else {
                tape.coefficients(n).magnitude(column, a)
            };
            assert_eq!(found, expected[column], "order {n}, {column}");
        }
    }
}
