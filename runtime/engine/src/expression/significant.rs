//! Numbers as text.

/// A number to so many significant digits, plain from 1e-3 to 1e5 and with an exponent beyond.
pub fn significant(x: f64, digits: usize) -> String {
    let with_exponent = format!("{x:.*e}", digits - 1);
    // That of the rounded number: of 0.9999 to three digits 0.
    let exponent = with_exponent.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    match exponent {
        _ if x == 0.0 => "0".to_owned(),
        Some(exponent @ -3..=4) => format!("{x:.*}", (digits as i32 - 1 - exponent).max(0) as usize),
        _ => with_exponent,
    }
}

/// Zero in place of what is nothing but the rounding of numbers as large as `scale`.
pub fn unrounded(x: f64, scale: f64) -> f64 {
    if x.abs() < 64.0 * f64::EPSILON * scale { 0.0 } else { x }
}

/// A whole number as an exponent: `⁻²`.
pub fn superscript(exponent: i64) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32('⁰' as u32 + (c as u32 - '0' as u32)).unwrap_or(c),
    };
    exponent.to_string().chars().map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_zero() {
        assert_eq!([1e-30, -3e-16, 1e-12, -0.5].map(|x| unrounded(x, 1.0)), [0.0, 0.0, 1e-12, -0.5]);
        assert_eq!(unrounded(1e-16, 1e-9), 1e-16);
    }

    #[test]
    fn digits_are_those_that_count() {
        let told = [0.0, 0.05, 1.0, -26972.005677, 123456.7, 1e-4].map(|x| significant(x, 3));
        assert_eq!(told, ["0", "0.0500", "1.00", "-26972", "1.23e5", "1.00e-4"]);
        let rounded = [0.999_99, -9.999_9, 9.999_9e-4, 99_999.9, f64::NAN].map(|x| significant(x, 3));
        assert_eq!(rounded, ["1.00", "-10.0", "0.00100", "1.00e5", "NaN"]);
    }
}
