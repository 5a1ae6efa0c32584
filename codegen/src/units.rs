//! Units behind numbers, `75deg`, `2.5 mm`, `10 kN/m`, and what they are in the SI: one table for
//! declarations and commands. An angle is a number; its power tells rad, and a torque (energy for
//! an angle) from an energy.

use core::f64::consts::PI;

use crate::nearest::nearest;

/// Greatest power of a unit.
const GREATEST: i8 = 9;
/// Prefixes with their powers of ten.
const PREFIXES: [(&str, i32); 11] = [
    ("", 0),
    ("k", 3),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("n", -9),
    ("M", 6),
    ("G", 9),
];

/// Coherent units with their powers of length, time, mass and angle.
const BASES: [(&str, [i8; 4]); 8] = [
    ("m", [1, 0, 0, 0]),
    ("s", [0, 1, 0, 0]),
    ("kg", [0, 0, 1, 0]),
    ("rad", [0, 0, 0, 1]),
    ("N", [1, -2, 1, 0]),
    ("J", [2, -2, 1, 0]),
    ("W", [2, -3, 1, 0]),
    ("Pa", [-1, -2, 1, 0]),
];

/// A unit with a name of its own: its factor, times a power of ten, and the coherent units with
/// their powers.
type Named = (&'static str, f64, i32, &'static [(&'static str, i8)]);

/// Units that take prefixes.
const PREFIXED: [Named; 9] = [
    ("m", 1.0, 0, &[("m", 1)]),
    ("g", 1.0, -3, &[("kg", 1)]),
    ("s", 1.0, 0, &[("s", 1)]),
    ("rad", 1.0, 0, &[("rad", 1)]),
    ("N", 1.0, 0, &[("N", 1)]),
    ("Nm", 1.0, 0, &[("N", 1), ("m", 1)]),
    ("J", 1.0, 0, &[("J", 1)]),
    ("W", 1.0, 0, &[("W", 1)]),
    ("Pa", 1.0, 0, &[("Pa", 1)]),
];

/// Units that take none. A hertz is none of them: of a turn or of a radian, it would be a guess.
const PLAIN: [Named; 8] = [
    ("1", 1.0, 0, &[]),
    ("t", 1.0, 3, &[("kg", 1)]),
    ("min", 60.0, 0, &[("s", 1)]),
    ("h", 3600.0, 0, &[("s", 1)]),
    ("deg", PI / 180.0, 0, &[("rad", 1)]),
    ("°", PI / 180.0, 0, &[("rad", 1)]),
    ("rev", 2.0 * PI, 0, &[("rad", 1)]),
    ("rpm", 2.0 * PI / 60.0, 0, &[("rad", 1), ("s", -1)]),
];

/// A unit as it is written behind a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// What it is in the coherent unit, without the powers of ten.
    scale: f64,
    /// The power of ten.
    exponent: i32,
    /// Coherent units with their powers.
    parts: Vec<(&'static str, i8)>,
}

impl Unit {
    /// Reads a product and quotient of powers of units: `N*s/m`, `m/s^2`, `kg m²`.
    ///
    /// # Errors
    /// It is none, in words.
    pub fn parse(text: &str) -> Result<Self, String> {
        let spaced = spell_powers(text).replace(['·', '*'], " ").replace('/', " / ");
        let mut product = Self { scale: 1.0, exponent: 0, parts: Vec::new() };
        let (mut below, mut any) = (false, false);
        for word in spaced.split_whitespace() {
            match (word, below) {
                ("/", false) => below = true,
                ("/", true) => return Err(format!("a unit with two fractions: `{}`", text.trim())),
                (factor, below) => {
                    any = true;
                    product.multiply(factor, below)?;
                }
            }
        }
        if any { Ok(product) } else { Err("the unit is missing".into()) }
    }

    fn multiply(&mut self, factor: &str, below: bool) -> Result<(), String> {
        let (name, power) = factor.split_once('^').unwrap_or((factor, "1"));
        let given = power.parse::<i8>().ok().filter(|power| (-GREATEST..=GREATEST).contains(power));
        let power = given.ok_or_else(|| format!("`{power}` is no power of a unit"))?;
        let power = if below { -power } else { power };
        let ((_, scale, exponent, parts), prefix) = find(name).ok_or_else(|| describe_unknown(name))?;
        self.scale *= scale.powi(power.into());
        self.exponent += (exponent + prefix) * i32::from(power);
        for (base, of_base) in *parts {
            let more = of_base.saturating_mul(power);
            match self.parts.iter_mut().find(|(known, _)| known == base) {
                Some((_, sum)) => *sum = sum.saturating_add(more),
                None => self.parts.push((*base, more)),
            }
        }
        self.parts.retain(|(_, power)| *power != 0);
        Ok(())
    }

    /// A value in this unit, in the coherent one; powers of ten are exact.
    pub fn convert(&self, value: f64) -> f64 {
        let ten = 10f64.powi(self.exponent.abs());
        self.scale * if self.exponent < 0 { value / ten } else { value * ten }
    }

    /// Whether it is a unit of the SI without a factor.
    pub fn is_coherent(&self) -> bool {
        self.convert(1.0) == 1.0
    }

    /// Powers of length, time, mass and angle.
    pub fn powers(&self) -> [i8; 4] {
        let mut sum = [0i8; 4];
        for (base, power) in &self.parts {
            let (_, powers) = BASES.iter().find(|(known, _)| known == base).unwrap_or(&("", [0; 4]));
            for (sum, of_base) in sum.iter_mut().zip(powers) {
                *sum = sum.saturating_add(of_base.saturating_mul(*power));
            }
        }
        sum
    }

    /// The coherent unit for the same: `N/m` of `kN/mm`.
    pub fn coherent(&self) -> String {
        let word = |(base, power): &(&str, i8)| match power.abs() {
            1 => (*base).to_owned(),
            2 => format!("{base}²"),
            3 => format!("{base}³"),
            power => format!("{base}^{power}"),
        };
        let side = |below: bool| -> Vec<String> {
            self.parts.iter().filter(|(_, power)| (*power < 0) == below).map(word).collect()
        };
        let (above, below) = (side(false).join(" "), side(true).join(" "));
        match (above.is_empty(), below.is_empty()) {
            (_, true) => above,
            (true, false) => format!("1/{below}"),
            (false, false) => format!("{above}/{below}"),
        }
    }
}

/// `m^-2` of `m⁻²`.
fn spell_powers(text: &str) -> String {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let mut spelt = String::new();
    let mut raised = false;
    for c in text.chars() {
        let plain = match RAISED.chars().position(|known| known == c) {
            Some(digit) => digit.to_string(),
            None if c == '⁻' => "-".to_owned(),
            None => {
                spelt.push(c);
                raised = false;
                continue;
            }
        };
        spelt += if raised { "" } else { "^" };
        spelt += &plain;
        raised = true;
    }
    spelt
}

/// A unit by its name, and the power of ten of its prefix.
fn find(name: &str) -> Option<(&'static Named, i32)> {
    let plain = PLAIN.iter().find(|(known, ..)| *known == name).map(|unit| (unit, 0));
    plain.or_else(|| {
        PREFIXES.iter().find_map(|(prefix, exponent)| {
            let rest = name.strip_prefix(prefix)?;
            PREFIXED.iter().find(|(known, ..)| *known == rest).map(|unit| (unit, *exponent))
        })
    })
}

/// Other spellings.
const SPELT: [(&str, &str); 8] = [
    ("sec", "s"),
    ("second", "s"),
    ("seconds", "s"),
    ("meter", "m"),
    ("metre", "m"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("radians", "rad"),
];

fn describe_unknown(name: &str) -> String {
    let bare: Vec<String> =
        PREFIXED.iter().chain(&PLAIN[1..]).map(|(known, ..)| (*known).to_owned()).collect();
    let prefixed = PREFIXES[1..]
        .iter()
        .flat_map(|(prefix, _)| PREFIXED.iter().map(move |(known, ..)| format!("{prefix}{known}")));
    let all: Vec<String> = bare.iter().cloned().chain(prefixed).collect();
    let near = nearest(name, &all.iter().map(String::as_str).collect::<Vec<_>>());
    match SPELT.iter().find(|(other, _)| *other == name).map(|(_, unit)| *unit).or(near) {
        Some(near) => format!("no unit `{name}`; did you mean `{near}`?"),
        None => format!("no unit `{name}`; known: {}, with prefixes n, u, m, c, d, k, M, G", bare.join(", ")),
    }
}

/// The number before a unit, and the unit, if there is one.
///
/// # Errors
/// What stands behind the number is no unit, in words.
pub fn split(text: &str) -> Result<(&str, Option<Unit>), String> {
    match boundary(text) {
        Some(at) => Ok((&text[..at], Some(Unit::parse(&text[at..])?))),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_begins_where_no_operator_stands_before_it() {
        for plain in ["75*pi/180", "1e-3", "2.5E6", "-pi/2", "1-lambda", "m1", "2*phi_1", "inf", "sqrt(2)/l"]
        {
            assert_eq!(split(plain), Ok((plain, None)));
        }
        let factor = |unit: Option<Unit>| unit.map_or(f64::NAN, |unit| unit.convert(1.0));
        let told = |text| split(text).map(|(number, unit)| (number.trim().to_owned(), factor(unit)));
        assert_eq!(told("75deg"), Ok(("75".into(), PI / 180.0)));
        assert_eq!(told("pi/2 rad"), Ok(("pi/2".into(), 1.0)));
        assert_eq!(told("(1 + 2)mm"), Ok(("(1 + 2)".into(), 1e-3)));
        assert_eq!(told("1e3 mm"), Ok(("1e3".into(), 1e-3)));
        assert_eq!(told("30°"), Ok(("30".into(), PI / 180.0)));
    }

    #[test]
    fn units_are_products_and_quotients_of_powers() {
        let unit = |text| split(text).map(|(_, unit)| unit.map_or(f64::NAN, |unit| unit.convert(1.0)));
        assert_eq!(unit("981 cm/s^2"), Ok(1e-2));
        assert_eq!(unit("10 kN/m"), Ok(1e3));
        assert_eq!(unit("2 kg m²"), Ok(1.0));
        assert_eq!(unit("3 N*s/mm"), Ok(1.0 / 1e-3));
        assert_eq!(unit("36 km/h"), Ok(1e3 / 3600.0));
        assert_eq!(unit("60 rpm"), Ok(2.0 * PI / 60.0));
    }

    #[test]
    fn powers_of_ten_are_exact() {
        for n in 1..1000 {
            let millimetres = split("1 mm").unwrap().1.unwrap().convert(n.into());
            assert_eq!(millimetres, format!("{n}e-3").parse::<f64>().unwrap());
        }
        assert_eq!(Unit::parse("kN/mm").unwrap().powers(), [0, -2, 1, 0]);
        assert_eq!(Unit::parse("m⁻¹²").unwrap_err(), "`-12` is no power of a unit");
    }

    #[test]
    fn units_are_known_by_what_they_measure() {
        let measured = |text| split(text).map(|(_, unit)| unit.map(|unit| unit.coherent()));
        for (text, coherent) in [
            ("9.81 m/s^2", "m/s²"),
            ("1 kN/mm", "N/m"),
            ("2 N*m*s/rad", "N m s/rad"),
            ("3 s⁻²", "1/s²"),
            ("1 mm·mm", "m²"),
            ("60 rpm", "rad/s"),
        ] {
            assert_eq!(measured(text), Ok(Some(coherent.into())), "{text}");
        }
        assert_eq!(measured("2*pi"), Ok(None));
    }

    #[test]
    fn a_unit_that_is_none_is_reported_with_the_nearest() {
        let error = |text| split(text).expect_err("no unit");
        assert_eq!(error("75degs"), "no unit `degs`; did you mean `deg`?");
        assert!(error("3 furlong").starts_with("no unit `furlong`; known: m, g, s, "));
        assert!(error("3 Hz").starts_with("no unit `Hz`; known: m, g, s, "));
        assert!(error("3 m^200").contains("`200`"));
        assert!(error("3 m^x").contains("`x`") && error("3 m/s/s").contains("two fractions"));
    }
}
