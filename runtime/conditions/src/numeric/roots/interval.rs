//! Roots of a squarefree polynomial within (0, 1).
//!
//! In `p = Σ bₖ C(n, k) xᵏ (1 − x)ⁿ⁻ᵏ` the signs of the b change as often as p has roots in (0, 1),
//! or oftener by an even number: no change proves that there is none, one change that there is one.
//! Other intervals are halved.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use super::Univariate;

/// Each root within 2^−bits, in no order.
pub(super) fn between_zero_and_one(polynomial: &Univariate, bits: u32) -> Vec<BigRational> {
    let mut roots = Vec::new();
    let mut waiting = vec![Piece { bernstein: bernstein(polynomial), at: BigInt::zero(), depth: 0 }];
    while let Some(piece) = waiting.pop() {
        match piece.changes() {
            0 => {}
            1 => roots.push(piece.refined(bits)),
            _ => {
                let [left, right] = piece.halves();
                if right.bernstein.first().is_some_and(BigInt::is_zero) {
                    roots.push(right.start());
                }
                waiting.extend([left, right]);
            }
        }
    }
    roots
}

/// The interval from at/2^depth to (at + 1)/2^depth with the polynomial on it.
struct Piece {
    bernstein: Vec<BigInt>,
    at: BigInt,
    depth: u32,
}

impl Piece {
    fn start(&self) -> BigRational {
        BigRational::new(self.at.clone(), BigInt::from(1) << self.depth)
    }

    fn changes(&self) -> usize {
        let signs: Vec<bool> =
            self.bernstein.iter().filter(|b| !b.is_zero()).map(BigInt::is_negative).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    /// By de Casteljau's algorithm at ½, everything times 2ⁿ.
    fn halves(&self) -> [Self; 2] {
        let n = self.bernstein.len();
        let mut row = self.bernstein.clone();
        let (mut left, mut right) = (Vec::with_capacity(n), Vec::with_capacity(n));
        for k in 0..n {
            left.push(&row[0] << (n - 1 - k));
            right.push(&row[n - 1 - k] << (n - 1 - k));
            for i in 0..n - 1 - k {
                row[i] = &row[i] + &row[i + 1];
            }
        }
        right.reverse();
        let half = |bernstein, at| Self { bernstein, at, depth: self.depth + 1 };
        [half(left, &self.at * 2), half(right, &self.at * 2 + 1)]
    }

    /// The one root that it has, by halving.
    fn refined(self, bits: u32) -> BigRational {
        let mut piece = self;
        while piece.depth < bits {
            let [left, right] = piece.halves();
            if right.bernstein.first().is_some_and(BigInt::is_zero) {
                return right.start();
            }
            piece = if left.changes() == 1 { left } else { right };
        }
        (piece.start() * BigInt::from(2) + BigRational::new(1.into(), BigInt::from(1) << piece.depth))
            / BigInt::from(2)
    }
}

/// The coefficients b times n!, from those of powers: `bₖ = Σᵢ C(k, i)/C(n, i) aᵢ`.
fn bernstein(polynomial: &Univariate) -> Vec<BigInt> {
    let a = polynomial.coefficients();
    let n = a.len();
    // aᵢ/C(n, i) times n!: aᵢ i! (n − i)!.
    let mut row: Vec<BigInt> =
        a.iter().enumerate().map(|(i, a)| a * factorial(i) * factorial(n.saturating_sub(1) - i)).collect();
    // Σ C(k, i) over i is the k-th repeated sum.
    let mut b = Vec::with_capacity(n);
    while !row.is_empty() {
        b.push(row[0].clone());
        for i in 0..row.len() - 1 {
            row[i] = &row[i] + &row[i + 1];
        }
        row.pop();
    }
    b
}

fn factorial(n: usize) -> BigInt {
    (1..=n).map(BigInt::from).product()
}
