//! `name=value` and `support@time` arguments.

use crate::scene::Values;
use std::f64::consts::PI;

/// Reads `name=value`.
pub fn assignment(text: &str) -> Result<(String, f64), String> {
    split(text, '=', "name=value")
}

/// Reads `support@time`.
pub fn release(text: &str) -> Result<(String, f64), String> {
    split(text, '@', "support@time")
}

fn split(text: &str, mark: char, form: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once(mark).ok_or_else(|| format!("expected {form}"))?;
    let number =
        product(value).ok_or_else(|| format!("`{value}` is no number nor a product like 75*pi/180"))?;
    Ok((name.trim().to_owned(), number))
}

/// A product or quotient of numbers and `pi`.
fn product(text: &str) -> Option<f64> {
    let (sign, text) = match text.trim().strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text),
    };
    let factor = |text: &str| match text.trim() {
        "pi" => Some(PI),
        number => number.parse().ok(),
    };
    text.split('*').try_fold(sign, |value, quotient| {
        let mut parts = quotient.split('/');
        let value = value * factor(parts.next()?)?;
        parts.try_fold(value, |value, part| Some(value / factor(part)?))
    })
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

    #[test]
    fn values_are_products_of_numbers_and_pi() {
        assert_eq!(assignment("phi = 75*pi/180"), Ok(("phi".into(), 75.0 * PI / 180.0)));
        assert_eq!(assignment("phi'=-2.5e-3"), Ok(("phi'".into(), -2.5e-3)));
        assert_eq!(assignment("phi=-pi/2/2"), Ok(("phi".into(), -PI / 4.0)));
        assert!(assignment("phi=two").is_err_and(|text| text.contains("`two`")));
        assert!(assignment("phi").is_err());
        assert!(release("A=1").is_err());
    }
}
