//! `name=value`, `support@time`, `thread=condition` and `point=px,py@time` arguments.

use liftoff::Formula;
use liftoff_studio::run_spec::{PointImpulse, Values};

/// Reads `name=value`.
pub fn assignment(text: &str) -> Result<(String, f64), String> {
    split(text, '=', "name=value")
}

/// Reads `support@time`.
pub fn release(text: &str) -> Result<(String, f64), String> {
    split(text, '@', "support@time")
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
    Ok(PointImpulse { point: point.trim().to_owned(), impulse: [number(x)?, number(y)?], at: number(at)? })
}

fn split(text: &str, mark: char, form: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once(mark).ok_or_else(|| format!("expected {form}"))?;
    Ok((name.trim().to_owned(), number(value)?))
}

/// A number as an expression of numbers and `pi`, with or without a unit: `75*pi/180`, `1 - 0.25`, `2.5 mm`.
pub fn number(text: &str) -> Result<f64, String> {
    let formula = Formula::parse(text, &[]).map_err(|error| format!("`{text}` is no number: {error}"))?;
    Ok(formula.value(&[]))
}

/// `values` with those `given` put in place of their namesakes, or at the end.
pub fn overridden(mut values: Values, given: &[(String, f64)]) -> Values {
    for (name, value) in given {
        match values.iter_mut().find(|(known, _)| known == name) {
            Some(entry) => entry.1 = *value,
            None => values.push((name.clone(), *value)),
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn values_are_expressions_of_numbers_and_pi() {
        assert_eq!(assignment("phi = 75*pi/180"), Ok(("phi".into(), 75.0 * PI / 180.0)));
        assert_eq!(assignment("phi'=-2.5e-3"), Ok(("phi'".into(), -2.5e-3)));
        assert_eq!(assignment("phi=-pi/2/2"), Ok(("phi".into(), -PI / 4.0)));
        assert_eq!(assignment("m=1-0.25"), Ok(("m".into(), 0.75)));
        assert_eq!(assignment("phi=pi/2-0.1"), Ok(("phi".into(), PI / 2.0 - 0.1)));
        assert_eq!(assignment("x=sqrt(2)/2"), Ok(("x".into(), 2f64.sqrt() / 2.0)));
        assert_eq!(assignment("l=250 mm"), Ok(("l".into(), 0.25)));
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
}
