//! Displacements along which nothing changes.

use liftoff_codegen::algebra::{Quotient, Rational, Series};

/// Vectors of coprime integers ξ with `Σ ξᵢ aᵢⱼ = 0` for each j; each has a coordinate of its own.
pub(super) fn kernel(slopes: &[Vec<Quotient>]) -> Vec<Vec<Rational>> {
    let n = slopes.len();
    let columns = slopes.first().map_or(0, Vec::len);
    let mut rows: Vec<Vec<Rational>> = Vec::new();
    for j in 0..columns {
        let factors = slopes.iter().flat_map(|row| row[j].factors());
        let common = factors.fold(Series::one(), |product, (factor, k)| {
            if product.divide_exact(&factor.pow(*k)).is_some() { product } else { product * factor.pow(*k) }
        });
        let above: Vec<Series> = slopes
            .iter()
            .map(|row| (&row[j] * &Quotient::from(common.clone())).numerator().clone())
            .collect();
        let mut terms: Vec<_> =
            above.iter().flat_map(|series| series.terms().map(|(term, _)| term)).collect();
        terms.sort();
        terms.dedup();
        let coefficient = |series: &Series, term| {
            series.terms().find(|(t, _)| *t == term).map_or(Rational::ZERO, |(_, c)| c)
        };
        rows.extend(terms.iter().map(|term| above.iter().map(|series| coefficient(series, *term)).collect()));
    }
    nullspace(rows, n)
}

/// By Gauss–Jordan elimination.
fn nullspace(mut rows: Vec<Vec<Rational>>, n: usize) -> Vec<Vec<Rational>> {
    let mut pivots = Vec::new();
    for column in 0..n {
        let done = pivots.len();
        let Some(found) = (done..rows.len()).find(|&i| !rows[i][column].is_zero()) else { continue };
        rows.swap(done, found);
        let inverse = rows[done][column].recip();
        rows[done].iter_mut().for_each(|entry| *entry = *entry * inverse);
        for i in (0..rows.len()).filter(|&i| i != done) {
            let factor = rows[i][column];
            for k in 0..n {
                let change = factor * rows[done][k];
                rows[i][k] = rows[i][k] - change;
            }
        }
        pivots.push(column);
    }
    let free = (0..n).filter(|column| !pivots.contains(column));
    let vector = |column: usize| {
        let mut vector = vec![Rational::ZERO; n];
        vector[column] = Rational::ONE;
        for (row, &pivot) in rows.iter().zip(&pivots) {
            vector[pivot] = -row[column];
        }
        let scale = vector.iter().fold(1, |scale, c| {
            let d = c.denominator();
            scale / num_integer::gcd(scale, d) * d
        });
        vector.into_iter().map(|c| c * Rational::integer(scale)).collect()
    };
    free.map(vector).collect()
}
