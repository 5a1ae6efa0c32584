//! Parameters at which conditions change: where two reactions are one up to a factor, where they
//! vanish together, where one has a double root.
//!
//! N₁ = r N₂ for all positions and starts where all minors `uᵢ wⱼ − uⱼ wᵢ` of the coefficients of
//! `N₁ = u/v`, `N₂ = w/v` vanish: on the zeros of their greatest common divisor. N₁ and N₂ vanish
//! at one position where their resultant does, N touches zero where its discriminant does.

use liftoff_codegen::algebra::Symbol;
use num_integer::Integer;
use num_traits::Signed;

use crate::algebra::form::Form;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Ring;

/// Resultants of polynomials of a higher degree in their unknown, taken together, are left out:
/// they are too long to be read.
const DEGREES: u32 = 12;

/// A factor of more terms is not shown: nobody reads it.
const READABLE: usize = 16;

/// As those whose coefficients have more terms.
const TERMS: usize = 60;

/// What two reactions have to do with each other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pair {
    /// Factors on whose zeros one is a multiple of the other, with what it is a multiple by.
    pub proportional: Vec<(Polynomial, Option<[Polynomial; 2]>)>,
    /// Whether it is a multiple for all parameters.
    pub always: Option<[Polynomial; 2]>,
    /// Other factors on whose zeros both vanish at one position; `None` where that is too long.
    pub together: Option<Vec<Polynomial>>,
}

impl Pair {
    pub fn compute(ring: &Ring, coordinate: Symbol, forms: [&Form; 2]) -> Self {
        let [u, w] = over_one_denominator(ring, forms);
        let common = minors(ring, &u, &w);
        if common.is_zero() {
            return Self { always: ratio(ring, &u, &w), ..Self::default() };
        }
        let deciding: Vec<Polynomial> = deciding(ring, &common);
        let conditions = forms.map(|form| form.condition(ring, coordinate));
        let together = ring.in_one_unknown(coordinate, &conditions).filter(is_short).map(|unknown| {
            let [first, second] = [&unknown.polynomials[0], &unknown.polynomials[1]];
            let always = first.gcd(second);
            let over = |p: &Polynomial| p.divide_exact(&always).unwrap_or_else(|| p.clone());
            let resultant = over(first).resultant(&over(second), unknown.at);
            let rest = deciding.iter().fold(resultant, without);
            self::deciding(ring, &rest)
        });
        let together = together.filter(|all| all.iter().all(|factor| factor.len() <= READABLE));
        let proportional = deciding.into_iter().map(|factor| {
            let ratio = solved(ring, &factor).and_then(|(at, value)| {
                let [u, w] = [&u, &w].map(|p| on_zeros(p, at, &value));
                ratio(ring, &u, &w)
            });
            (factor, ratio)
        });
        Self { proportional: proportional.collect(), always: None, together }
    }
}

/// Factors on whose zeros a condition touches zero, or has a root where the other of sine and
/// cosine vanishes, which is double too; `None` where that is too long.
pub(crate) fn double_roots(
    ring: &Ring,
    coordinate: Symbol,
    condition: &Polynomial,
) -> Option<Vec<Polynomial>> {
    let unknown = ring.in_one_unknown(coordinate, std::slice::from_ref(condition)).filter(is_short)?;
    let [polynomial] = unknown.polynomials.as_slice() else { return None };
    let discriminant = match polynomial.degree(unknown.at) {
        0 | 1 => ring.one(),
        _ => polynomial.discriminant(unknown.at),
    };
    let ends = [1, -1].into_iter().filter(|_| unknown.folds);
    let ends =
        ends.map(|end| polynomial.substitute(unknown.at, &Polynomial::constant(ring.len(), end.into())));
    let mut found: Vec<Polynomial> = Vec::new();
    for factor in [discriminant].into_iter().chain(ends).flat_map(|part| deciding(ring, &part)) {
        if !found.contains(&factor) {
            found.push(factor);
        }
    }
    found.iter().all(|factor| factor.len() <= READABLE).then_some(found)
}

fn is_short(unknown: &crate::algebra::unknown::Unknown) -> bool {
    let degrees: u32 = unknown.polynomials.iter().map(|p| p.degree(unknown.at)).sum();
    degrees <= DEGREES && unknown.polynomials.iter().all(|p| p.len() <= TERMS)
}

/// The factors that vanish for some positive parameters.
fn deciding(ring: &Ring, polynomial: &Polynomial) -> Vec<Polynomial> {
    let factors = polynomial.factors().factors.into_iter().map(|(factor, _)| factor);
    factors.filter(|factor| !ring.is_definite(factor)).collect()
}

/// The numerators of both over one denominator, without squares of cosines, so that equal functions
/// are equal polynomials.
fn over_one_denominator(ring: &Ring, [one, other]: [&Form; 2]) -> [Polynomial; 2] {
    let ([u, below], [w, under]) = (one.expanded(ring), other.expanded(ring));
    let common = below.gcd(&under);
    let over = |p: &Polynomial| p.divide_exact(&common).unwrap_or_else(|| p.clone());
    [&u * &over(&under), &w * &over(&below)].map(|p| ring.normal(&p))
}

/// The greatest common divisor of all minors.
fn minors(ring: &Ring, u: &Polynomial, w: &Polynomial) -> Polynomial {
    let varying = |x: usize| !ring.variables[x].is_parameter();
    let [us, ws] = [u, w].map(|p| p.collected(varying));
    let zero = Polynomial::zero(ring.len());
    let keys: std::collections::BTreeSet<_> = us.keys().chain(ws.keys()).collect();
    let columns: Vec<[&Polynomial; 2]> =
        keys.into_iter().map(|k| [us.get(k).unwrap_or(&zero), ws.get(k).unwrap_or(&zero)]).collect();
    let mut common = zero.clone();
    for (i, [a, b]) in columns.iter().enumerate() {
        for [c, d] in &columns[i + 1..] {
            common = common.gcd(&(&(*a * *d) - &(*c * *b)));
        }
    }
    common
}

/// u/w of parameters alone, where that is one number of them for all positions.
fn ratio(ring: &Ring, u: &Polynomial, w: &Polynomial) -> Option<[Polynomial; 2]> {
    let varying = |x: usize| !ring.variables[x].is_parameter();
    let [us, ws] = [u, w].map(|p| p.collected(varying));
    let (key, above) = us.last_key_value()?;
    let below = ws.get(key)?;
    let common = above.gcd(below);
    let over = |p: &Polynomial| p.divide_exact(&common);
    Some([over(above)?, over(below)?])
}

/// A parameter in which a factor is linear with a coefficient that is a number, and its value on
/// the zeros: numerator and denominator.
pub(crate) fn solved(ring: &Ring, factor: &Polynomial) -> Option<(usize, [Polynomial; 2])> {
    let linear = |&at: &usize| {
        ring.variables[at].is_parameter()
            && factor.degree(at) == 1
            && factor.leading_coefficient(at).as_constant().is_some()
    };
    let at = (0..ring.len()).find(linear)?;
    let number = factor.leading_coefficient(at).as_constant()?;
    let rest = factor.coefficient(at, 0);
    let common = rest.number().gcd(&number) * number.signum();
    let over = |p: Polynomial| p.divide_exact(&Polynomial::constant(ring.len(), common.clone()));
    Some((at, [over(-&rest)?, over(Polynomial::constant(ring.len(), number))?]))
}

/// A quotient in place of a variable, times the power of its denominator.
fn on_zeros(polynomial: &Polynomial, at: usize, [above, below]: &[Polynomial; 2]) -> Polynomial {
    let degree = polynomial.degree(at);
    let powers =
        (0..=degree).map(|k| &(&polynomial.coefficient(at, k) * &above.pow(k)) * &below.pow(degree - k));
    powers.fold(Polynomial::zero(polynomial.variables()), |sum, part| &sum + &part)
}

/// Divided by a factor as often as that divides it.
fn without(polynomial: Polynomial, factor: &Polynomial) -> Polynomial {
    let mut rest = polynomial;
    while let Some(quotient) = rest.divide_exact(factor).filter(|_| !rest.is_zero()) {
        rest = quotient;
    }
    rest
}
