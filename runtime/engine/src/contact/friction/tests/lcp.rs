//! Lemke's method on small linear complementarity problems, against all bases by plain elimination.

use nalgebra::{DMatrix, DVector};

use super::super::lemke;
use super::random::{Random, cases};

/// A problem `w = A z + q`, `0 ≤ w ⟂ z ≥ 0`.
struct Lcp {
    a: DMatrix<f64>,
    q: DVector<f64>,
}

impl Lcp {
    /// z with so many basic: A_bb z_b = −q_b.
    fn basic(&self, basis: &[usize]) -> Option<DVector<f64>> {
        let part = self.a.select_rows(basis).select_columns(basis);
        let right = -self.q.select_rows(basis);
        let z = if basis.is_empty() { right.clone() } else { part.clone().full_piv_lu().solve(&right)? };
        let small = basis.is_empty() || (&part * &z - &right).amax() <= 1e-9 * (1.0 + z.amax());
        let mut whole = DVector::zeros(self.q.len());
        basis.iter().zip(z.iter()).for_each(|(&k, z)| whole[k] = *z);
        small.then_some(whole)
    }

    fn is_solved_by(&self, z: &DVector<f64>) -> bool {
        let w = &self.a * z + &self.q;
        let size = 1.0 + z.amax();
        let meets =
            |(w, z): (&f64, &f64)| *w >= -1e-9 * size && *z >= -1e-9 * size && w.min(*z) <= 1e-9 * size;
        w.iter().zip(z.iter()).all(meets)
    }

    /// The first solution among those of all bases.
    fn brute_force(&self) -> Option<DVector<f64>> {
        let m = self.q.len();
        let bases = (0..1usize << m).map(|set| (0..m).filter(|k| set >> k & 1 == 1).collect::<Vec<_>>());
        bases.filter_map(|basis| self.basic(&basis)).find(|z| self.is_solved_by(z))
    }

    fn lemke(&self) -> Option<Vec<usize>> {
        let basic = lemke::solve(&self.a, &self.q, &DVector::repeat(self.q.len(), 1.0))?;
        Some((0..basic.len()).filter(|&k| basic[k]).collect())
    }
}

/// x Aᵀ x > 0: one solution for any q.
fn positive(random: &mut Random, m: usize) -> DMatrix<f64> {
    let root = DMatrix::from_fn(m, m, |_, _| random.between(-1.0, 1.0));
    let skew = DMatrix::from_fn(m, m, |_, _| random.between(-1.0, 1.0));
    &root * root.transpose() + (&skew - skew.transpose()) + DMatrix::identity(m, m) * 0.1
}

/// The solution is the only one, in the basis that is its own, whatever the units of the right-hand
/// side and of the rows.
#[test]
fn positive_matrices_have_one_solution() {
    let mut random = Random(0x1D87_2B41_99C0_37E5);
    for k in 0..cases(400) {
        let m = 1 + k % 8;
        let (a, q) = (positive(&mut random, m), DVector::from_fn(m, |_, _| random.between(-1.0, 1.0)));
        let one = Lcp { a, q };
        let expected = one.brute_force().unwrap();
        let basis = one.lemke().unwrap();
        assert_eq!(basis, (0..m).filter(|&k| expected[k] > 0.0).collect::<Vec<_>>(), "{k}");
        for unit in [2f64.powi(-90), 2f64.powi(90)] {
            let other = Lcp { a: one.a.clone(), q: &one.q * unit };
            assert_eq!(other.lemke().unwrap(), basis, "{k}");
        }
    }
}

/// z, w ≥ 0 with one of each zero, and some with both; q follows.
#[test]
fn many_rows_are_solved() {
    let mut random = Random(0x77AA_4F0C_1D2E_9B63);
    for k in 0..cases(40) {
        let m = 20 + k % 40;
        let a = positive(&mut random, m);
        let kinds: Vec<usize> = (0..m).map(|_| random.below(7)).collect();
        let value = |kind: usize, random: &mut Random| {
            DVector::from_fn(m, |k, _| {
                if kinds[k] % 2 == kind && kinds[k] < 6 { random.between(0.1, 1.0) } else { 0.0 }
            })
        };
        let (z, w) = (value(0, &mut random), value(1, &mut random));
        let one = Lcp { q: &w - &a * &z, a };
        let found = one.basic(&one.lemke().unwrap()).unwrap();
        assert!((&found - &z).amax() <= 1e-9 * (1.0 + one.a.amax()), "{k} {:e}", (&found - &z).amax());
    }
}

/// Linear programs of small whole numbers, `C x ≤ b`, `Cᵀ y ≥ c`: many ties. The matrix is skew,
/// for which the path ends in a ray only where there is no solution.
#[test]
fn ties_are_broken_without_cycles() {
    let mut random = Random(0x2C91_E0F7_5A3B_8D46);
    let mut counts = [0; 2];
    for k in 0..cases(1_500) {
        let (rows, columns) = (1 + random.below(4), 1 + random.below(4));
        let m = rows + columns;
        let mut whole = || random.below(4) as f64 - 1.0;
        let mut a = DMatrix::zeros(m, m);
        for i in 0..rows {
            for j in 0..columns {
                let entry = whole();
                (a[(i, rows + j)], a[(rows + j, i)]) = (-entry, entry);
            }
        }
        let one = Lcp { a, q: DVector::from_fn(m, |_, _| whole()) };
        let exists = one.brute_force().is_some();
        counts[usize::from(exists)] += 1;
        match one.lemke() {
            Some(basis) => assert!(one.is_solved_by(&one.basic(&basis).unwrap()), "{k}"),
            None => assert!(!exists, "{k}"),
        }
    }
    assert!(counts.iter().all(|count| *count > 300), "{counts:?}");
}

/// Nothing is basic where nothing has to be: q ≥ 0, and q < 0 by rounding of the others.
#[test]
fn what_holds_by_itself_needs_nothing() {
    let basis = |q: &[f64]| {
        let (m, q) = (q.len(), DVector::from_row_slice(q));
        Lcp { a: DMatrix::identity(m, m), q }.lemke().unwrap()
    };
    for unit in [1e-20, 1.0, 1e20] {
        let q = |least: f64| [unit, least * unit, 0.0];
        assert_eq!(basis(&q(1.0)), [0; 0]);
        assert_eq!(basis(&q(-1e-14)), [0; 0]);
        assert_eq!(basis(&q(-1e-12)), [1]);
    }
    assert_eq!(basis(&[]), [0; 0]);
    assert_eq!(basis(&[0.0, 0.0]), [0; 0]);
}
