//! Formulas in three notations.

use super::{Equation, Math, Name};

fn phi(dots: u8) -> Math {
    Math::Symbol(Name::new("phi_inner"), dots)
}

fn cosine(power: u32, argument: Math) -> Math {
    Math::Apply { function: "cos", power, argument: Box::new(argument) }
}

fn half() -> Math {
    Math::Number { numerator: 1, denominator: 2 }
}

/// `T = −½ m1 l² (4 − 6/cos² φ) φ̈`, φ with an index.
fn equation() -> Equation {
    let fraction = Math::integer(6).over(cosine(2, phi(0)));
    let sum = Math::sum([Math::integer(4), fraction.minus()]);
    let product = [half(), Math::symbol("m1"), Math::symbol("l").power(2), sum.group(), phi(2)];
    Equation::new(Math::symbol("T"), Math::product(product).minus())
}

#[test]
fn as_text() {
    assert_eq!(equation().to_string(), "T = −½ m₁ l² (4 − 6/cos² φ_inner) φ_inner''");
}

#[test]
fn as_latex() {
    let expected = "T = -\\tfrac{1}{2} m_{1} l^{2} \\Bigl({4 - \\dfrac{6}{\\cos^{2} \\varphi_{\\mathrm{inner}}}}\\Bigr) \
                    \\ddot{\\varphi}_{\\mathrm{inner}}";
    assert_eq!(equation().latex(), expected);
}

#[test]
fn as_mathml() {
    let expected = "<math displaystyle=\"true\"><mi>T</mi></math> <math displaystyle=\"true\"><mo form=\"infix\">=</mo>\
                    <mn>2</mn><mo lspace=\"0\" rspace=\".17em\">\u{2062}</mo>\
                    <msub><mi>𝜑\u{307}</mi><mtext>inner</mtext></msub></math>";
    let product = Math::product([Math::integer(2), phi(1)]);
    assert_eq!(Equation::new(Math::symbol("T"), product).mathml(), expected);
}

/// Signs move in front, functions behind, brackets go where a fraction bar holds together what they
/// held.
#[test]
fn what_is_set_is_tidied() {
    let product = Math::product([
        cosine(1, Math::symbol("beta")),
        Math::product([half(), Math::symbol("lean")]).minus().group(),
        Math::ONE.over(Math::symbol("r")).group(),
    ]);
    assert_eq!(product.to_string(), "cos β (−½ lean) (1/r)");
    assert_eq!(product.latex(), "-\\tfrac{1}{2}\\,\\mathrm{lean}\\,\\dfrac{1}{r} \\cos \\beta");
    let joined = Math::product([half(), Math::ONE.over(Math::symbol("r")).group()]);
    assert_eq!(joined.latex(), "\\dfrac{1}{2 r}");
    let twice = Math::sum([Math::symbol("a"), Math::symbol("b").minus().group().minus()]);
    assert_eq!([twice.to_string(), twice.latex()], ["a − (−b)", "a + b"]);
}

/// Lines can be broken where a long numerator stands behind its fraction.
#[test]
fn long_numerators_stand_behind_the_fraction() {
    let sum = Math::sum((1..=12).map(|i| Math::symbol(&format!("l{i}"))));
    let above = Math::product([Math::symbol("m"), sum.group()]);
    let latex = above.all_over(Math::symbol("r")).latex();
    assert!(latex.starts_with("\\dfrac{m}{r}(l_{1} + l_{2}"), "{latex}");
}

/// Every row of a long equation is short, and nothing is lost where it is broken.
#[test]
fn long_equations_are_broken_before_signs() {
    let term = |i: u8| Math::product([Math::symbol(&format!("m{i}")), cosine(1, phi(0)), phi(1).power(2)]);
    let sum = Math::sum((1..=30).map(|i| term(i).signed(i % 3 == 0)));
    let product = Math::product([half(), sum.group()]);
    let equation = Equation::new(Math::symbol("V"), product);
    let rows = equation.aligned();
    let rows: Vec<&str> = rows.split("\\\\\n").collect();
    assert!(rows.len() > 5 && rows[1..].iter().all(|row| row.trim_start().starts_with("&\\quad {}")));
    let joined = rows.join("").replace("  &\\quad {}", " ").replace("& ", "");
    let spaced = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(spaced(&joined), spaced(&equation.latex()));
    assert!(rows.iter().all(|row| row.matches("\\mathrm{inner}").count() <= 10), "{rows:?}");
}

/// Short fractions as fractions, others as decimals of seven digits: what is read back is the
/// number.
#[test]
fn long_fractions_are_decimals() {
    let text = |numerator, denominator| Math::Number { numerator, denominator }.to_string();
    assert_eq!((text(1, 2), text(22, 7), text(12_345, 1)), ("½".into(), "²²⁄₇".into(), "12345".into()));
    let decimals = [text(7, 1000), text(250_001, 100), text(1, 3_000_000)];
    assert_eq!(decimals, ["0.007", "2500.01", "3.333333·10⁻⁷"]);
    for exponent in 0..12 {
        let (numerator, denominator) = (123_456_789, 10u128.pow(exponent));
        let shown = text(numerator, denominator);
        let raised =
            |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c).map(|digit| digit.to_string());
        let plain: String = shown.chars().map(|c| raised(c).unwrap_or_else(|| c.to_string())).collect();
        let value: f64 = plain.replace("·10⁻", "e-").replace("·10", "e").parse().unwrap_or(f64::NAN);
        let exact = numerator as f64 / denominator as f64;
        assert!((value / exact - 1.0).abs() < 5e-7, "{shown} {exact}");
    }
}
