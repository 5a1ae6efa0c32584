//! From a declaration to equations, numbers, documentation and code.

mod budgets;
mod documentation;
mod equations;
mod gears;
mod numbers;
mod outlines;
pub(crate) mod scenes;
mod useless;
mod values;

use crate::Analysis;

pub(crate) fn analysis(declaration: &str) -> Analysis {
    crate::analyse(declaration.parse().unwrap()).unwrap_or_else(|error| panic!("{declaration}: {error}"))
}

/// All mistakes of a declaration.
fn find_mistakes(declaration: &str) -> Vec<String> {
    let errors = crate::analyse(declaration.parse().unwrap()).err();
    errors.into_iter().flatten().map(|error| error.to_string()).collect()
}

/// Two bars that fall on two corners, as mirror images.
pub(crate) const PAIR: &str =
    "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(DB, mass = m, length = l)]
    #[support(P = corner(-l / 2, 0), under = AD)] #[support(Q = corner(l / 2, 0), under = DB)]
    #[figure(D = (0, 0), A = (-l, 0), B = (l, 0))] #[coordinate(phi = angle(DB), from = horizontal)]
    #[coordinate(y = -y(D))] #[mirror(x = 0)] struct Pair { m: f64, l: f64, g: f64 }";
