//! `name=value`, `support@time`, `thread=condition` and `point=px,py@time` arguments.

use liftoff::__private::expression::normalize_rate;
use liftoff::__private::expression::si_unit::{NEWTON, RADIAN, SECOND, SiUnit};
use liftoff::OutputError;
use liftoff_studio::registry::{Quantity, QuantityError};
use liftoff_studio::run_spec::PointImpulse;
use std::ops::RangeInclusive;

/// `name=value` as it was given.
#[derive(Clone, PartialEq, Debug)]
pub struct Assignment {
    pub name: String,
    /// In SI units and radians.
    pub value: f64,
    /// The unit behind the value, if there is one.
    pub unit: Option<SiUnit>,
}

/// Reads `name=value`.
pub fn assignment(text: &str) -> Result<Assignment, String> {
    let (name, value) = text.split_once('=').ok_or("expected name=value")?;
    let formula = Quantity::parse_number(value)?;
    Ok(Assignment {
        name: normalize_rate(name.trim()).into_owned(),
        value: formula.value(&[]),
        unit: formula.unit(),
    })
}

/// `support@time` as it was given.
#[derive(Clone, PartialEq, Debug)]
pub struct Release {
    pub support: String,
    /// The time as it was given.
    pub text: String,
    /// The time, s; or why it is none, as of a formula of what a sweep varies.
    pub at: Result<f64, String>,
}

/// Reads `support@time`; the time may be a formula of names that are known later.
pub fn release(text: &str) -> Result<Release, String> {
    let (support, at) = text.split_once('@').ok_or("expected support@time")?;
    let [support, text] = [support, at].map(|part| part.trim().to_owned());
    match (time(at), Quantity::parse(at, &[])) {
        (at @ Err(_), Err(QuantityError::Formula(OutputError::Name(_)))) | (at @ Ok(_), _) => {
            Ok(Release { support, text, at })
        }
        (Err(error), _) => Err(error),
    }
}

/// Reads `thread=condition`; the condition may contain `=` itself.
pub fn cut(text: &str) -> Result<(String, String), String> {
    let (thread, condition) = text.split_once('=').ok_or("expected thread=condition")?;
    Ok((thread.trim().to_owned(), condition.trim().to_owned()))
}

/// Reads `point=px,py@time`.
pub fn blow(text: &str) -> Result<PointImpulse, String> {
    let parts = || {
        let (point, rest) = text.split_once('=')?;
        let (impulse, at) = rest.split_once('@')?;
        impulse.split_once(',').map(|(x, y)| (point, x, y, at))
    };
    let (point, x, y, at) = parts().ok_or("expected point=px,py@time")?;
    let newton_seconds = |text| in_unit(text, NEWTON.times(SECOND, 1));
    let impulse = [newton_seconds(x)?, newton_seconds(y)?];
    Ok(PointImpulse { point: point.trim().to_owned(), impulse, at: time(at)? })
}

/// A time, s.
pub fn time(text: &str) -> Result<f64, String> {
    in_unit(text, SECOND)
}

/// A number without a unit, or with one of an angle.
pub fn number(text: &str) -> Result<f64, String> {
    in_unit(text, RADIAN)
}

/// A width, in whatever it is measured.
pub fn width(text: &str) -> Result<f64, String> {
    Ok(Quantity::parse_number(text)?.value(&[]))
}

/// A number as an expression of numbers and `pi`, with or without a unit that measures the same as this one:
/// `75*pi/180`, `1 - 0.25`, `2.5 ms`.
fn in_unit(text: &str, unit: SiUnit) -> Result<f64, String> {
    let formula = Quantity::parse_number(text)?;
    match formula.unit() {
        Some(given) if !given.agrees(unit) => {
            Err(format!("`{formula}` is measured in {}, not in {}", symbol(given), symbol(unit)))
        }
        _ => Ok(formula.value(&[])),
    }
}

/// The unit as it is told.
fn symbol(unit: SiUnit) -> String {
    if unit == RADIAN { "rad or nothing".into() } else { unit.symbol() }
}

/// A whole number within a range, `1e3` as well as `1000`.
pub fn whole(range: RangeInclusive<usize>) -> impl Fn(&str) -> Result<usize, String> + Clone {
    move |text| {
        let value = number(text)?;
        let whole = (0.0..=2f64.powi(53)).contains(&value) && value.fract() == 0.0;
        let found = whole.then_some(value as usize).filter(|value| range.contains(value));
        let [least, most] = [range.start(), range.end()];
        found.ok_or_else(|| format!("`{}` is no whole number from {least} to {most}", text.trim()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use liftoff::__private::expression::si_unit::METRE;
    use std::f64::consts::PI;

    #[test]
    fn values_are_expressions_of_numbers_and_pi() {
        let told = |text| assignment(text).map(|given| (given.name, given.value));
        assert_eq!(told("phi = 75*pi/180"), Ok(("phi".into(), 75.0 * PI / 180.0)));
        assert_eq!(told("phi'=-2.5e-3"), Ok(("phi'".into(), -2.5e-3)));
        assert_eq!(told("phi=-pi/2/2"), Ok(("phi".into(), -PI / 4.0)));
        assert_eq!(told("m=1-0.25"), Ok(("m".into(), 0.75)));
        assert_eq!(told("phi=pi/2-0.1"), Ok(("phi".into(), PI / 2.0 - 0.1)));
        assert_eq!(told("x=sqrt(2)/2"), Ok(("x".into(), 2f64.sqrt() / 2.0)));
        assert_eq!(told("l=250 mm"), Ok(("l".into(), 0.25)));
        assert_eq!(assignment("l=250 mm").map(|given| given.unit), Ok(Some(METRE)));
        assert!(assignment("phi=two").is_err_and(|text| text.contains("`two`")));
        assert!(assignment("phi").is_err());
        assert!(release("A=1").is_err());
    }

    #[test]
    fn cuts_and_blows_have_their_own_forms() {
        assert_eq!(cut("BD=t = 0.5"), Ok(("BD".into(), "t = 0.5".into())));
        let expected = PointImpulse { point: "C".into(), impulse: [0.0, -PI], at: 0.5 };
        assert_eq!(blow("C=0,-pi@0.5"), Ok(expected));
        assert!(cut("BD").is_err() && blow("C=1@2").is_err() && blow("C=1,x@2").is_err());
    }

    #[test]
    fn times_angles_and_impulses_have_their_units() {
        assert_eq!((time("3 ms"), time("2")), (Ok(3e-3), Ok(2.0)));
        assert_eq!(time("3 mm"), Err("`3 mm` is measured in m, not in s".into()));
        assert_eq!(number("1 kg"), Err("`1 kg` is measured in kg, not in rad or nothing".into()));
        assert_eq!(number("180deg"), Ok(PI));
        assert_eq!(blow("C=1 N*s,2 kg*m/s@3ms").map(|blow| (blow.impulse, blow.at)), Ok(([1.0, 2.0], 3e-3)));
        assert!(blow("C=1 N,0@0.5").is_err_and(|text| text.contains("measured in N, not in kg m/s")));
        assert!(release("A@3m").is_err());
    }

    #[test]
    fn whole_numbers_are_numbers() {
        let width = whole(240..=10_000);
        assert_eq!((width("1e3"), width("240"), width("2*200")), (Ok(1000), Ok(240), Ok(400)));
        for text in ["239", "1.5", "-1", "1e300", "18446744073709551616", "0/0"] {
            let told = format!("`{text}` is no whole number from 240 to 10000");
            assert_eq!(width(text), Err(told), "{text}");
        }
        assert!(width("wide").is_err_and(|text| text.starts_with("`wide` is no number: ")));
    }
}
