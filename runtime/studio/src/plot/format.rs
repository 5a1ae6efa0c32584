//! Numbers as they are printed.

use liftoff::__private::expression::superscript;

/// A number to so many significant digits; very small and very large ones with a power of ten.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value);
    let exponent = if rounded == 0.0 { 0.0 } else { rounded.abs().log10().floor() };
    if !rounded.is_finite() || (-3.0..6.0).contains(&exponent) {
        let text = format!("{rounded}");
        return text.replace('-', "−");
    }
    let text = format!("{rounded:e}");
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    let power = superscript(power.parse().unwrap_or(0));
    format!("{}·10{power}", mantissa.replace('-', "−"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_rounded_and_powers_are_taken_out() {
        for (value, text) in [
            (1.0, "1"),
            (1.0 / 9.0, "0.1111"),
            (-9.81, "−9.81"),
            (0.0, "0"),
            (99_999.6, "100000"),
            (1.5e-9, "1.5·10⁻⁹"),
            (-2.0e7, "−2·10⁷"),
            (0.001, "0.001"),
        ] {
            assert_eq!(significant(value, 4), text);
        }
    }
}
