//! Tables: values between places by a cubic spline that is not a knot at its second place and at
//! the last but one (C. de Boor, *A Practical Guide to Splines*, 2001, ch. IV); constant beyond its
//! ends.

use core::hash::{Hash, Hasher};

use crate::algebra::Rational;

/// A spline.
#[derive(Debug)]
pub struct Spline {
    /// Where its pieces meet, exact.
    pub places: Vec<Rational>,
    /// The same, rounded.
    pub knots: Vec<f64>,
    /// c₀ to c₃ of Σ cₖ (x − a)ᵏ: before the first knot, between knots, behind the last; a is the
    /// knot before the piece, of the first that behind it.
    pub pieces: Vec<[f64; 4]>,
    /// Its derivative, if that is not zero.
    slope: Option<Table>,
}

/// A spline that lives as long as the program: one is what it is, not what it is like.
#[derive(Clone, Copy, Debug)]
pub struct Table(&'static Spline);

impl PartialEq for Table {
    fn eq(&self, other: &Self) -> bool {
        core::ptr::eq(self.0, other.0)
    }
}

impl Eq for Table {}

impl Hash for Table {
    fn hash<H: Hasher>(&self, state: &mut H) {
        core::ptr::hash(self.0, state);
    }
}

impl core::ops::Deref for Table {
    type Target = Spline;

    fn deref(&self) -> &Spline {
        self.0
    }
}

impl Table {
    /// Of rising places, two at least, with their values.
    pub fn new(places: Vec<Rational>, values: &[f64]) -> Self {
        let knots: Vec<f64> = places.iter().map(|place| place.to_f64()).collect();
        let widths: Vec<f64> = knots.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let rises: Vec<f64> =
            values.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
        let slopes = slopes(&widths, &rises);
        let last = values.len() - 1;
        let mut pieces = vec![[values[0], 0.0, 0.0, 0.0]];
        pieces.extend((0..last).map(|i| {
            let ([h, rise], [a, b]) = ([widths[i], rises[i]], [slopes[i], slopes[i + 1]]);
            let bend = (a + b - 2.0 * rise) / h;
            [values[i], a, (rise - a) / h - bend, bend / h]
        }));
        pieces.push([values[last], 0.0, 0.0, 0.0]);
        Self::of_pieces(places, knots, pieces)
    }

    /// With its derivatives.
    fn of_pieces(places: Vec<Rational>, knots: Vec<f64>, pieces: Vec<[f64; 4]>) -> Self {
        let derived: Vec<[f64; 4]> = pieces.iter().map(|c| [c[1], 2.0 * c[2], 3.0 * c[3], 0.0]).collect();
        let varies = derived.iter().flatten().any(|c| *c != 0.0);
        let slope = varies.then(|| Self::of_pieces(places.clone(), knots.clone(), derived));
        Self(Box::leak(Box::new(Spline { places, knots, pieces, slope })))
    }

    /// Its derivative, if that is not zero.
    pub fn slope(self) -> Option<Self> {
        self.0.slope
    }
}

impl Spline {
    /// Its value at x.
    pub fn evaluate(&self, x: f64) -> f64 {
        let piece = self.knots.partition_point(|knot| *knot <= x);
        let [a, b, c, d] = self.pieces[piece];
        let u = x - self.knots[piece.saturating_sub(1)];
        ((d * u + c) * u + b) * u + a
    }

    /// Its pieces as C and Python write them, of what is written as x, each with the knot where it
    /// ends.
    pub fn write_pieces(&self, x: &str) -> Vec<(Option<f64>, String)> {
        let piece = |i: usize| {
            let ([a, b, c, d], from) = (self.pieces[i], self.knots[i.saturating_sub(1)]);
            let u = format!("(({x}) - ({from:?}))");
            let text = match [b, c, d] {
                [0.0, 0.0, 0.0] => format!("{a:?}"),
                _ => format!("{a:?} + {u}*({b:?} + {u}*({c:?} + {u}*({d:?})))"),
            };
            (self.knots.get(i).copied(), text)
        };
        (0..self.pieces.len()).map(piece).collect()
    }

    /// The places at which pieces differ.
    pub fn kinks(&self) -> impl Iterator<Item = Rational> + '_ {
        let last = self.places.len() - 1;
        let joined = move |i: usize| last >= 3 && (i == 1 || i == last - 1);
        (0..=last).filter(move |i| !joined(*i)).map(|i| self.places[i])
    }
}

/// The slopes at the places: second derivatives agree, and third ones at the second place and at
/// the last but one.
fn slopes(h: &[f64], rises: &[f64]) -> Vec<f64> {
    let n = h.len();
    match n {
        1 => return vec![rises[0]; 2],
        // A parabola.
        2 => {
            let middle = (h[1] * rises[0] + h[0] * rises[1]) / (h[0] + h[1]);
            return vec![2.0 * rises[0] - middle, middle, 2.0 * rises[1] - middle];
        }
        _ => {}
    }
    let end = |[a, b]: [f64; 2], [first, second]: [f64; 2]| {
        ((a + 2.0 * (a + b)) * b * first + a * a * second) / (a + b)
    };
    let mut above = vec![h[0] + h[1]];
    let mut diagonal = vec![h[1]];
    let mut right = vec![end([h[0], h[1]], [rises[0], rises[1]])];
    for i in 1..=n {
        let (below, own, next, value) = if i < n {
            (h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1], 3.0 * (h[i] * rises[i - 1] + h[i - 1] * rises[i]))
        } else {
            (h[n - 1] + h[n - 2], h[n - 2], 0.0, end([h[n - 1], h[n - 2]], [rises[n - 1], rises[n - 2]]))
        };
        let factor = below / diagonal[i - 1];
        diagonal.push(own - factor * above[i - 1]);
        right.push(value - factor * right[i - 1]);
        above.push(next);
    }
    let mut slopes = vec![right[n] / diagonal[n]];
    for i in (0..n).rev() {
        let next = slopes[slopes.len() - 1];
        slopes.push((right[i] - above[i] * next) / diagonal[i]);
    }
    slopes.reverse();
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(places: &[(i128, i128)], values: &[f64]) -> Table {
        Table::new(places.iter().map(|&(p, q)| Rational::new(p, q)).collect(), values)
    }

    /// A line, a parabola and a cubic are what they are; beyond the ends nothing changes.
    #[test]
    fn polynomials_are_met() {
        let cubic = |x: f64| 1.0 - 2.0 * x + 0.5 * x * x + 0.25 * x * x * x;
        let places = [(-1, 1), (0, 1), (1, 2), (2, 1), (5, 1)];
        let values = places.map(|(p, q)| cubic(p as f64 / q as f64));
        let spline = table(&places, &values);
        for x in [-0.7, 0.2, 0.5, 1.3, 4.9] {
            assert!((spline.evaluate(x) - cubic(x)).abs() < 1e-13 * cubic(x).abs().max(1.0), "{x}");
            let slope = -2.0 + x + 0.75 * x * x;
            assert!((spline.slope().unwrap().evaluate(x) - slope).abs() < 1e-12, "{x}");
        }
        assert_eq!([spline.evaluate(-3.0), spline.evaluate(7.0)], [values[0], values[4]]);
        let parabola = table(&[(0, 1), (1, 1), (3, 1)], &[0.0, 1.0, 9.0]);
        assert!((parabola.evaluate(2.0) - 4.0).abs() < 1e-14);
        let line = table(&[(0, 1), (2, 1)], &[1.0, 5.0]);
        assert_eq!(line.evaluate(0.5), 2.0);
        assert_eq!(spline.kinks().map(|place| place.to_f64()).collect::<Vec<_>>(), [-1.0, 0.5, 5.0]);
    }

    /// SciPy 1.17: `CubicSpline([0, 1, 2.5, 3, 4.2, 6], [0, 1, 0.5, -1, 2, 2.5])`.
    #[test]
    fn it_is_the_spline_of_scipy() {
        let places = [(0, 1), (1, 1), (5, 2), (3, 1), (21, 5), (6, 1)];
        let spline = table(&places, &[0.0, 1.0, 0.5, -1.0, 2.0, 2.5]);
        for (x, value) in SCIPY {
            assert!((spline.evaluate(x) - value).abs() < 1e-13, "{x}: {}", spline.evaluate(x));
        }
    }

    const SCIPY: [(f64, f64); 5] = [
        (0.3, 0.17989926519706076),
        (1.7, 1.5436015141393897),
        (2.9, -0.7838582052994876),
        (3.6, -0.4532344689378758),
        (5.5, 5.136966834904375),
    ];
}
