//! Forces in sections whose side of a load the parameters decide, against closed forms.

use liftoff_codegen::analyse;

/// `normal(S)` of a declaration at these parameters and this state with its accelerations.
fn normal(declaration: &str, parameters: &[f64], state: &[f64]) -> f64 {
    let analysis = analyse(declaration.parse().unwrap()).unwrap();
    let quantities = analysis.functions.quantities.iter();
    let ids: Vec<_> = quantities.filter(|of| of.name == "normal(S)").map(|of| of.value).collect();
    analysis.evaluate(&ids, parameters, state)[0]
}

/// A dozen operations on numbers near one.
fn close(computed: f64, expected: f64) {
    assert!((computed - expected).abs() < 1e-12, "{computed} for {expected}");
}

/// A free bar pulled at its end B, with a particle at P: what is before the section is drawn along,
/// n = a (m s/l + M).
#[test]
fn of_a_bar_that_is_pulled() {
    let bar = |at: &str, field: &str| {
        format!(
            "#[bar(AB, mass = m, length = l)] #[point(P = AB, at = p)] #[mass(P, M)]
             #[force(pull = (f, 0), at = B)] #[section(S = AB, at = {at})] #[coordinate(x = x(A))]
             #[figure(A = (0, 0), B = (l, 0))] #[coordinate(y = y(A))] #[coordinate(phi = angle(AB), from = right)]
             struct Pulled {{ m: f64, M: f64, l: f64, p: f64, f: f64, {field} }}"
        )
    };
    // Angles come before positions.
    let (m, point, l, f) = (1.3, 0.4, 3.0, 2.0);
    let a = f / (m + point);
    for s in [0.2, 1.0, 1.5, 2.9] {
        for p in [0.5, 1.2, 2.0] {
            let before = m * s / l + if p < s { point } else { 0.0 };
            let state = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, a, 0.0];
            close(normal(&bar("s", "s: f64"), &[m, point, l, p, f, s], &state), a * before);
            close(normal(&bar(&format!("{s:?}"), ""), &[m, point, l, p, f], &state), a * before);
        }
    }
}

/// A bar that turns about a pin at P, another hung from it at Q: n = ω² Σ m r beyond the section,
/// seen from the pin.
#[test]
fn of_a_bar_that_turns() {
    let declaration = "#[bar(AB, mass = m, length = l)] #[point(P = AB, at = p)] #[pin(P = (0, 0))]
         #[point(Q = AB, at = q)] #[bar(QC, mass = M, length = c)] #[section(S = AB, at = s)]
         #[coordinate(phi = angle(AB), from = right)] #[coordinate(psi = angle(QC), from = right)]
         #[figure(A = (-p, 0), B = (l - p, 0), Q = (q - p, 0), C = (q - p + c, 0))]
         struct Turning { m: f64, M: f64, l: f64, p: f64, q: f64, c: f64, s: f64 }";
    let (m, hung, l, c, pace) = (1.3, 0.4, 3.0, 0.6, 1.7);
    for s in [0.2, 1.4, 2.6] {
        for p in [0.5, 1.5, 2.5] {
            for q in [0.3, 1.8, 2.9] {
                // Both level and turning as one; the part that the pin does not hold.
                let far = p < s;
                let (length, middle) = if far { (l - s, (l + s) / 2.0) } else { (s, s / 2.0) };
                let of_bar = m * length / l * (middle - p);
                let of_other = if (q > s) == far { hung * (q + c / 2.0 - p) } else { 0.0 };
                let sign = if far { 1.0 } else { -1.0 };
                let state = [0.0, 0.0, pace, pace, 0.0, 0.0];
                let expected = sign * pace * pace * (of_bar + of_other);
                close(normal(declaration, &[m, hung, l, p, q, c, s], &state), expected);
            }
        }
    }
}
