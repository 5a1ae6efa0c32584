use super::{LANES, ORDERS, Order, Record, Tape};

/// a = 1 / (1 − t/2), b = Σ (k + 1) tᵏ in the first and last column of each block: their product by Cauchy's formula.
fn a_product<const BLOCKS: usize>() {
    let (a, b) = (|k: usize| 0.5_f64.powi(k as i32), |k: usize| (k + 1) as f64);
    let mut tape = Tape::<f64, BLOCKS>::new();
    for n in 0..ORDERS {
        let expected: f64 = (0..=n).map(|k| a(k) * b(n - k)).sum();
        for column in (0..BLOCKS).flat_map(|block| [LANES * block, LANES * block + LANES - 1]) {
            // Halves and small integers: exact.
            assert_eq!(product(&mut tape, n, column, [a(n), b(n)]), expected, "order {n}, column {column}");
        }
    }
}

fn product<const BLOCKS: usize>(
    tape: &mut Tape<f64, BLOCKS>,
    n: usize,
    column: usize,
    [a, b]: [f64; 2],
) -> f64 {
    if n == 0 { tape.values().product(column, a, b) } else { tape.coefficients(n).product(column, a, b) }
}

/// Orders are summed in pairs and blocks in pairs: all that begin or end one.
#[test]
fn orders_sum_all_products_of_lower_ones() {
    a_product::<1>();
    a_product::<2>();
    a_product::<3>();
}
