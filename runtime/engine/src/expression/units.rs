//! Values with a unit behind them, `75deg`, `2.5 mm`, `10 kN/m`, in SI units.

use crate::error::NameError;
use std::f64::consts::PI;

/// Units with what they are in SI units and radians.
const UNITS: [(&str, f64); 26] = [
    ("m", 1.0),
    ("km", 1e3),
    ("dm", 1e-1),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("µm", 1e-6),
    ("kg", 1.0),
    ("g", 1e-3),
    ("mg", 1e-6),
    ("t", 1e3),
    ("s", 1.0),
    ("ms", 1e-3),
    ("us", 1e-6),
    ("µs", 1e-6),
    ("min", 60.0),
    ("h", 3600.0),
    ("rad", 1.0),
    ("mrad", 1e-3),
    ("deg", PI / 180.0),
    ("°", PI / 180.0),
    ("rpm", 2.0 * PI / 60.0),
    ("N", 1.0),
    ("kN", 1e3),
    ("MN", 1e6),
    ("J", 1.0),
];

/// The number before a unit, and the unit in SI units; 1 where there is none.
pub fn split(text: &str) -> Result<(&str, f64), String> {
    match boundary(text) {
        Some(at) => Ok((&text[..at], product(&text[at..])?)),
        None => Ok((text, 1.0)),
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
fn product(text: &str) -> Result<f64, String> {
    let text = text.replace(['·', '*'], " ").replace('²', "^2").replace('³', "^3").replace('/', " / ");
    let mut value = 1.0;
    let mut below = false;
    for word in text.split_whitespace() {
        match (word, below) {
            ("/", false) => below = true,
            ("/", true) => return Err(format!("a unit with two fractions: `{text}`")),
            (factor, below) => value *= power(factor, below)?,
        }
    }
    Ok(value)
}

fn power(factor: &str, below: bool) -> Result<f64, String> {
    let (name, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
    let exponent: i32 = exponent.parse().map_err(|_| format!("`{exponent}` is no power of a unit"))?;
    let unit = UNITS.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
    let unit = unit.ok_or_else(|| NameError::new("unit", name, UNITS.map(|(known, _)| known)).to_string())?;
    Ok(unit.powi(if below { -exponent } else { exponent }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_begins_where_no_operator_stands_before_it() {
        for plain in ["75*pi/180", "1e-3", "2.5E6", "-pi/2", "1-lambda", "m1", "2*phi_1", "inf", "sqrt(2)/l"]
        {
            assert_eq!(split(plain), Ok((plain, 1.0)));
        }
        let told = |text| split(text).map(|(number, unit)| (number.trim().to_owned(), unit));
        assert_eq!(told("75deg"), Ok(("75".into(), PI / 180.0)));
        assert_eq!(told("pi/2 rad"), Ok(("pi/2".into(), 1.0)));
        assert_eq!(told("(1 + 2)mm"), Ok(("(1 + 2)".into(), 1e-3)));
        assert_eq!(told("1e3 mm"), Ok(("1e3".into(), 1e-3)));
        assert_eq!(told("30°"), Ok(("30".into(), PI / 180.0)));
    }

    #[test]
    fn units_are_products_and_quotients_of_powers() {
        let unit = |text| split(text).map(|(_, unit)| unit);
        assert_eq!(unit("981 cm/s^2"), Ok(1e-2));
        assert_eq!(unit("10 kN/m"), Ok(1e3));
        assert_eq!(unit("2 kg m²"), Ok(1.0));
        assert_eq!(unit("3 N*s/mm"), Ok(1.0 / 1e-3));
        assert_eq!(unit("36 km/h"), Ok(1e3 / 3600.0));
        assert_eq!(unit("60 rpm"), Ok(2.0 * PI / 60.0));
    }

    #[test]
    fn a_unit_that_is_none_is_told_with_the_nearest() {
        let error = |text| split(text).expect_err("no unit");
        assert_eq!(error("75degs"), "no unit `degs`; did you mean `deg`?");
        assert!(error("3 furlong").starts_with("no unit `furlong`; known: m, km"));
        assert!(error("3 m^x").contains("`x`") && error("3 m/s/s").contains("two fractions"));
    }
}
