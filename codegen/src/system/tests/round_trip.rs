//! Values of parameters, written as declarations have them and read again.

use proptest::prelude::*;

use super::resolve;
use crate::algebra::{Angle, Rational, Series, Symbol};

const NAMES: [&str; 4] = ["m", "l", "g", "a"];

fn terms() -> impl Strategy<Value = Series> {
    let term = (
        -40..40_i128,
        1..30_i128,
        [-3..4_i32, -3..4, -3..4, -2..3],
        prop::option::of((1..4, -3..4, 0..4_i64)),
    );
    let series = term.prop_map(|(p, q, powers, wave)| {
        let number = Series::constant(Rational::new(p, q));
        let product = powers.iter().enumerate().fold(number, |product, (i, &k)| {
            let power = Series::symbol(Symbol::parameter(i)).pow(k.unsigned_abs());
            &product * &if k < 0 { power.recip_monomial().unwrap() } else { power }
        });
        let Some((k, n, quarters)) = wave else { return product };
        let angle = Angle::from_symbol(Symbol::parameter(3)).scale(k)
            + Angle::from_symbol(Symbol::parameter(1)).scale(n);
        &product * &Series::cos(&(angle + Angle::quarters(quarters)))
    });
    prop::collection::vec(series, 0..6).prop_map(|terms| terms.into_iter().sum())
}

/// A series in the syntax of declarations.
fn written(series: &Series) -> String {
    let terms = series.terms().map(|(term, c)| {
        let powers =
            term.monomial.factors().iter().map(|(symbol, k)| format!(" * {}.powi({k})", name(*symbol)));
        let angle = term.wave.argument.iter().map(|(symbol, k)| format!("{k} * {}", name(*symbol)));
        let angle = angle.collect::<Vec<_>>().join(" + ");
        let wave = match (angle.is_empty(), term.wave.sine) {
            (true, _) => String::new(),
            (false, true) => format!(" * sin({angle})"),
            (false, false) => format!(" * ({angle}).cos()"),
        };
        format!("{} / {}{}{wave}", c.numerator(), c.denominator(), powers.collect::<String>())
    });
    terms.fold("0".to_owned(), |sum, term| format!("{sum} + {term}"))
}

fn name(symbol: Symbol) -> &'static str {
    let Symbol::Parameter(i) = symbol else { return "?" };
    NAMES[usize::from(i)]
}

proptest! {
    #[test]
    fn what_is_written_is_read(series in terms()) {
        let text = written(&series);
        let system = resolve(&format!(
            "#[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))] #[figure(A = (0, 0), B = (l, 0))]
             #[constant(all = m * l * g * a)] #[gravity({text}, all)]"
        ));
        let gravity = system.map(|system| system.gravity).map_err(|error| error.to_string());
        prop_assert_eq!(gravity.map(|gravity| gravity.map(|[x, _]| x)), Ok(Some(series)), "{}", text);
    }
}
