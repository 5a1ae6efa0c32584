//! Values with a unit behind them, `75deg`, `2.5 mm`, `10 kN/m`, in SI units.

use super::si_unit::{JOULE, METRE, NEWTON, RADIAN, SECOND, SiUnit};
use crate::error::NameError;
use std::f64::consts::PI;

/// Greatest power of a unit.
const GREATEST: i8 = 9;
const KILOGRAM: SiUnit = SiUnit::new(1, 0, 0, 0);
const PER_SECOND: SiUnit = SiUnit::new(0, 0, -1, 1);

/// Units with what they are in SI units and radians.
const UNITS: [(&str, f64, SiUnit); 26] = [
    ("m", 1.0, METRE),
    ("km", 1e3, METRE),
    ("dm", 1e-1, METRE),
    ("cm", 1e-2, METRE),
    ("mm", 1e-3, METRE),
    ("um", 1e-6, METRE),
    ("µm", 1e-6, METRE),
    ("kg", 1.0, KILOGRAM),
    ("g", 1e-3, KILOGRAM),
    ("mg", 1e-6, KILOGRAM),
    ("t", 1e3, KILOGRAM),
    ("s", 1.0, SECOND),
    ("ms", 1e-3, SECOND),
    ("us", 1e-6, SECOND),
    ("µs", 1e-6, SECOND),
    ("min", 60.0, SECOND),
    ("h", 3600.0, SECOND),
    ("rad", 1.0, RADIAN),
    ("mrad", 1e-3, RADIAN),
    ("deg", PI / 180.0, RADIAN),
    ("°", PI / 180.0, RADIAN),
    ("rpm", 2.0 * PI / 60.0, PER_SECOND),
    ("N", 1.0, NEWTON),
    ("kN", 1e3, NEWTON),
    ("MN", 1e6, NEWTON),
    ("J", 1.0, JOULE),
];

/// A unit as it is written behind a number.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Unit {
    /// What it is in the coherent unit.
    pub factor: f64,
    /// The unit of the SI for the same.
    pub coherent: SiUnit,
}

/// The number before a unit, and the unit, if there is one.
pub fn split(text: &str) -> Result<(&str, Option<Unit>), String> {
    match boundary(text) {
        Some(at) => Ok((&text[..at], Some(product(&text[at..])?))),
        None => Ok((text, None)),
    }
}

/// Where a letter follows a number, a name or a bracket with no operator between them.
fn boundary(text: &str) -> Option<usize> {
    let letters: Vec<(usize, char)> = text.char_indices().collect();
    let starts = |k: usize| {
        let (before, here) = (&letters[..k], letters[k].1);
        if !(here.is_alphabetic() || here == '°') {
            return false;
        }
        match before.last() {
            Some((_, c)) if c.is_ascii_digit() || *c == '.' => {
                is_number(before) && !is_exponent(&letters[k..])
            }
            Some((_, ')')) => true,
            Some((_, c)) if c.is_whitespace() => {
                let last = before.iter().rev().find(|(_, c)| !c.is_whitespace());
                last.is_some_and(|(_, c)| c.is_alphanumeric() || matches!(c, ')' | '.' | '\''))
            }
            Some((_, c)) => here == '°' && c.is_alphanumeric(),
            None => false,
        }
    };
    (0..letters.len()).find(|&k| starts(k)).map(|k| letters[k].0)
}

/// Whether the digits at the end belong to no name, as in `m1`.
fn is_number(before: &[(usize, char)]) -> bool {
    let word = before.iter().rev().take_while(|(_, c)| c.is_alphanumeric() || matches!(c, '_' | '.'));
    word.last().is_some_and(|(_, c)| c.is_ascii_digit() || *c == '.')
}

/// Whether this is the exponent of a number: `e3`, `e-3`.
fn is_exponent(rest: &[(usize, char)]) -> bool {
    let follows = |k: usize| rest.get(k).map(|(_, c)| *c);
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    matches!(rest[0].1, 'e' | 'E')
        && (digit(follows(1)) || matches!(follows(1), Some('+' | '-')) && digit(follows(2)))
}

/// A product and quotient of powers of units: `N*s/m`, `m/s^2`, `kg m²`.
fn product(text: &str) -> Result<Unit, String> {
    let text = text.replace(['·', '*'], " ").replace('²', "^2").replace('³', "^3").replace('/', " / ");
    let mut product = Unit { factor: 1.0, coherent: SiUnit::default() };
    let mut below = false;
    for word in text.split_whitespace() {
        match (word, below) {
            ("/", false) => below = true,
            ("/", true) => return Err(format!("a unit with two fractions: `{text}`")),
            (factor, below) => product = product.times(power(factor)?, below),
        }
    }
    Ok(product)
}

impl Unit {
    fn times(self, (factor, coherent): (f64, SiUnit), below: bool) -> Self {
        let power = if below { -1 } else { 1 };
        Self {
            factor: self.factor * factor.powi(power),
            coherent: self.coherent.times(coherent, power as i8),
        }
    }
}

fn power(factor: &str) -> Result<(f64, SiUnit), String> {
    let (name, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
    let power = exponent.parse::<i8>().ok().filter(|power| (-GREATEST..=GREATEST).contains(power));
    let power = power.ok_or_else(|| format!("`{exponent}` is no power of a unit"))?;
    let unit = UNITS.iter().find(|(known, ..)| *known == name);
    let (_, value, coherent) =
        unit.ok_or_else(|| NameError::new("unit", name, UNITS.map(|(known, ..)| known)).to_string())?;
    Ok((value.powi(power.into()), SiUnit::default().times(*coherent, power)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_begins_where_no_operator_stands_before_it() {
        for plain in ["75*pi/180", "1e-3", "2.5E6", "-pi/2", "1-lambda", "m1", "2*phi_1", "inf", "sqrt(2)/l"]
        {
            assert_eq!(split(plain), Ok((plain, None)));
        }
        let factor = |unit: Option<Unit>| unit.map_or(f64::NAN, |unit| unit.factor);
        let told = |text| split(text).map(|(number, unit)| (number.trim().to_owned(), factor(unit)));
        assert_eq!(told("75deg"), Ok(("75".into(), PI / 180.0)));
        assert_eq!(told("pi/2 rad"), Ok(("pi/2".into(), 1.0)));
        assert_eq!(told("(1 + 2)mm"), Ok(("(1 + 2)".into(), 1e-3)));
        assert_eq!(told("1e3 mm"), Ok(("1e3".into(), 1e-3)));
        assert_eq!(told("30°"), Ok(("30".into(), PI / 180.0)));
    }

    #[test]
    fn units_are_products_and_quotients_of_powers() {
        let unit = |text| split(text).map(|(_, unit)| unit.map_or(f64::NAN, |unit| unit.factor));
        assert_eq!(unit("981 cm/s^2"), Ok(1e-2));
        assert_eq!(unit("10 kN/m"), Ok(1e3));
        assert_eq!(unit("2 kg m²"), Ok(1.0));
        assert_eq!(unit("3 N*s/mm"), Ok(1.0 / 1e-3));
        assert_eq!(unit("36 km/h"), Ok(1e3 / 3600.0));
        assert_eq!(unit("60 rpm"), Ok(2.0 * PI / 60.0));
    }

    #[test]
    fn units_are_known_by_what_they_measure() {
        let measured = |text| split(text).map(|(_, unit)| unit.map(|unit| unit.coherent.symbol()));
        for (text, coherent) in
            [("9.81 m/s^2", "m/s²"), ("1 kN/mm", "N/m"), ("2 N*m*s/rad", "kg m²/s"), ("60 rpm", "rad/s")]
        {
            assert_eq!(measured(text), Ok(Some(coherent.into())), "{text}");
        }
        assert_eq!(measured("2*pi"), Ok(None));
    }

    #[test]
    fn a_unit_that_is_none_is_told_with_the_nearest() {
        let error = |text| split(text).expect_err("no unit");
        assert_eq!(error("75degs"), "no unit `degs`; did you mean `deg`?");
        assert!(error("3 furlong").starts_with("no unit `furlong`; known: m, km"));
        assert!(error("3 m^200").contains("`200`"));
        assert!(error("3 m^x").contains("`x`") && error("3 m/s/s").contains("two fractions"));
    }
}
