//! Places on the circle by `t = tan ½q` where |q| ≤ ½π and by `cot ½q` beyond, on a line by x and
//! by 1/x beyond 1: both run within [−1, 1], and a polynomial stays one.

use core::f64::consts::{FRAC_PI_2, PI};

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::{Ring, Variable};
use crate::numeric::roots::{Univariate, sign, within_unit};
use crate::numeric::values::{Values, power};
use liftoff_codegen::algebra::Symbol;

/// A place within [−1, 1] of one of the two charts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Place {
    pub x: BigRational,
    pub far: bool,
    /// Whether it is on a circle.
    pub turns: bool,
}

impl Place {
    /// A value of a coordinate. The doubles nearest to quarter turns are these.
    pub fn from_value(value: f64, turns: bool) -> Option<Self> {
        let finite = value.is_finite().then_some(value)?;
        if let Some(quarters) = quarters(value).filter(|_| turns) {
            let (x, far) = [(0, false), (1, false), (0, true), (-1, false)][quarters.rem_euclid(4) as usize];
            return Some(Self { x: BigRational::from_integer(x.into()), far, turns });
        }
        let near = if turns { (0.5 * finite).tan() } else { finite };
        let far = near.abs() > 1.0;
        let near = BigRational::from_float(near)?;
        Some(Self { x: if far { near.recip() } else { near }, far, turns })
    }

    /// Its sine and cosine, of a place on a circle.
    pub fn circle(&self) -> Option<[BigRational; 2]> {
        let one = BigRational::one();
        let square = &self.x * &self.x;
        let below = &one + &square;
        let cosine = (&one - &square) / &below;
        let sine = &self.x * BigRational::from_integer(2.into()) / below;
        self.turns.then_some([sine, if self.far { -cosine } else { cosine }])
    }

    /// Its number, of a place on a line.
    pub fn number(&self) -> BigRational {
        if self.far { self.x.recip() } else { self.x.clone() }
    }

    /// The value of the coordinate, of an angle within (−π, π].
    pub fn value(&self) -> f64 {
        let x = self.x.to_f64().unwrap_or(f64::NAN);
        match (self.turns, self.far) {
            (true, false) => 2.0 * x.atan(),
            (true, true) if self.x.is_negative() => -PI - 2.0 * x.atan(),
            (true, true) => PI - 2.0 * x.atan(),
            (false, false) => x,
            (false, true) => x.recip(),
        }
    }
}

/// How many quarter turns a value is, where no double is nearer to so many.
pub(crate) fn quarters(value: f64) -> Option<i64> {
    let turns = (value / FRAC_PI_2).round();
    (turns.abs() < 1e6 && turns * FRAC_PI_2 == value).then_some(turns as i64)
}

/// A polynomial in both charts.
#[derive(Clone, Debug)]
pub(crate) struct Charted {
    near: Univariate,
    far: Univariate,
    /// Of which degree the second is the reverse of the first: even on a circle.
    degree: usize,
    turns: bool,
}

impl Charted {
    /// With all variables but the coordinate's replaced by their values; `None` where the
    /// coordinate stands beside its own sine or cosine.
    pub fn substitute(
        ring: &Ring,
        values: &Values,
        coordinate: Symbol,
        polynomial: &Polynomial,
    ) -> Option<Self> {
        let plain = ring.position(Variable::Plain(coordinate)).filter(|&at| polynomial.depends_on(at));
        match (ring.circle(coordinate), plain) {
            (Some(pair), None) => Some(on_circle(&values.coefficients(ring, polynomial, pair))),
            (None, Some(at)) => Some(on_line(&values.coefficients(ring, polynomial, [at]))),
            (None, None) => {
                let constant = values.coefficients(ring, polynomial, []).into_values();
                Some(on_line(&constant.map(|c| ([0], c)).collect()))
            }
            (Some(_), Some(_)) => None,
        }
    }

    fn new(near: Univariate, degree: usize, turns: bool) -> Self {
        Self { far: near.reversed(degree), near, degree, turns }
    }

    /// The signs right before and right after a place, in the direction of growing values.
    pub fn signs_about(&self, place: &Place) -> [i32; 2] {
        let own = if place.far { &self.far } else { &self.near };
        let (rest, k) = own.without(&place.x);
        let flipped = place.far && self.degree % 2 == 1 && place.x.is_negative();
        let above = sign(&rest.value(&place.x)) * if flipped { -1 } else { 1 };
        let below = if k % 2 == 1 { -above } else { above };
        // Where the chart's number grows the value shrinks beyond a quarter turn.
        if place.far { [above, below] } else { [below, above] }
    }

    /// Divided by what vanishes at a place, as often as it does.
    pub fn without(&self, place: &Place) -> Self {
        let own = if place.far { &self.far } else { &self.near };
        let (rest, k) = own.without(&place.x);
        let degree = self.degree - (k as usize).min(self.degree);
        let near = if place.far { rest.reversed(degree) } else { rest };
        Self::new(near, degree, self.turns)
    }

    /// All zeros with their multiplicities, by growing values.
    pub fn zeros(&self) -> Vec<(Place, u32)> {
        let place = |x: BigRational, far| Place { x, far, turns: self.turns };
        let near = within_unit(&self.near).into_iter().map(|root| (place(root.at, false), root.multiplicity));
        let far = within_unit(&self.far)
            .into_iter()
            .filter(|root| root.at.abs() < BigRational::one() && (self.turns || !root.at.is_zero()));
        let far = far.map(|root| (place(root.at, true), root.multiplicity));
        let mut zeros: Vec<(Place, u32)> = near.chain(far).collect();
        zeros.sort_by(|a, b| a.0.value().total_cmp(&b.0.value()));
        zeros
    }
}

type Coefficients<const N: usize> = std::collections::BTreeMap<[u32; N], BigRational>;

/// (1 + t²)ᵈ times Σ c sinⁱ cosʲ.
fn on_circle(coefficients: &Coefficients<2>) -> Charted {
    let degree = coefficients.keys().map(|[i, j]| i + j).max().unwrap_or(0);
    let mut sum = vec![BigRational::zero(); 2 * degree as usize + 1];
    for (&[i, j], c) in coefficients {
        let two = power(&BigRational::from_integer(2.into()), i);
        let mut product = vec![c * two];
        (0..j).for_each(|_| product = times_square(&product, -1));
        (0..degree - i - j).for_each(|_| product = times_square(&product, 1));
        product.iter().enumerate().for_each(|(k, c)| sum[k + i as usize] += c);
    }
    Charted::new(Univariate::from_coefficients(&sum), 2 * degree as usize, true)
}

/// Times 1 ± t².
fn times_square(polynomial: &[BigRational], sign: i32) -> Vec<BigRational> {
    let mut product = polynomial.to_vec();
    product.resize(polynomial.len() + 2, BigRational::zero());
    let signed = polynomial.iter().map(|c| c * BigRational::from_integer(sign.into()));
    product[2..].iter_mut().zip(signed).for_each(|(entry, c)| *entry += c);
    product
}

fn on_line(coefficients: &Coefficients<1>) -> Charted {
    let degree = coefficients.keys().map(|[k]| *k as usize).max().unwrap_or(0);
    let mut sum = vec![BigRational::zero(); degree + 1];
    coefficients.iter().for_each(|([k], c)| sum[*k as usize] += c);
    Charted::new(Univariate::from_coefficients(&sum), degree, false)
}
