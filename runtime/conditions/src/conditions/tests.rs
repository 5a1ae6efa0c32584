//! Against the paper's formula (3.18) and a balance of moments by hand, as polynomials.

use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::{Analysis, analyse};

use super::functions::Functions;
use crate::algebra::form::Form;
use crate::algebra::polynomial::Polynomial;
use crate::algebra::ring::Variable;
use crate::level::{Level, Start};
use crate::phase::Named;

/// The frame of Fig. 1b with equal angles, and with three supports.
fn frame(equal: bool) -> Analysis {
    let equal = if equal {
        "#[coordinate(phi = angle(CD), from = horizontal)] #[equal(angle(AB), angle(CD))]"
    } else {
        "#[coordinate(phi = angle(CD), from = horizontal)] #[coordinate(psi = angle(DE), from = horizontal)]"
    };
    let text = format!(
        "#[gravity(g)] #[bar(AB, mass = m2, length = l)] #[bar(BC, mass = m1, length = l)] #[bar(CD, mass = m1, length = l)] \
         #[bar(DE, mass = m2, length = l)] #[support(A = floor)] #[support(C = floor)] #[support(E = floor)] \
         #[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))] {equal} #[coordinate(y = y(C))] \
         #[mirror(x = 0)] struct Frame {{ m1: f64, m2: f64, l: f64, g: f64 }}"
    );
    analyse(text.parse().expect("tokens")).expect("a model")
}

/// The letters of a ring as polynomials.
struct Letters {
    sine: Polynomial,
    cosine: Polynomial,
    start: Polynomial,
    masses: [Polynomial; 2],
    gravity: Polynomial,
    one: Polynomial,
}

impl Letters {
    fn from_functions(functions: &Functions) -> Self {
        let variable = |v| {
            let at = functions.ring.position(v).expect("a variable");
            Polynomial::variable(functions.ring.len(), at)
        };
        let parameter = |i| variable(Variable::Plain(Symbol::parameter(i)));
        Self {
            sine: variable(Variable::Sine(functions.level.coordinate)),
            cosine: variable(Variable::Cosine(functions.level.coordinate)),
            start: variable(Variable::Sine(functions.level.start)),
            masses: [parameter(0), parameter(1)],
            gravity: parameter(3),
            one: functions.ring.one(),
        }
    }

    fn number(&self, n: i64) -> Polynomial {
        self.one.scale(&n.into())
    }

    fn total(&self) -> Polynomial {
        &self.masses[0] + &self.masses[1]
    }

    /// `3 (m₁ + m₂) (1/3 + 2 λ sin² φ)`, `λ = m₂/(m₁ + m₂)`.
    fn inertia(&self) -> Polynomial {
        &self.total() + &(&(&self.number(6) * &self.masses[1]) * &(&self.sine * &self.sine))
    }

    /// φ̇² times l/g over the first, and φ̈ times l/g over the second: (3.13) and (3.14).
    fn motion(&self) -> [[Polynomial; 2]; 2] {
        let Self { sine: s, start, masses: [_, m2], .. } = self;
        let squared = &(&self.number(3) * &self.total()) * &(start - s);
        // 9 (m₁ + m₂)² (1/6 + 2 λ sin φ₀ sin φ − λ sin² φ) cos φ, doubled below.
        let bracket = &(&self.total() + &(&(&self.number(12) * m2) * &(start * s)))
            - &(&(&self.number(6) * m2) * &(s * s));
        let acceleration = &(&(&self.number(-3) * &self.total()) * &bracket) * &self.cosine;
        let inertia = self.inertia();
        [[squared, inertia.clone()], [acceleration, &self.number(2) * &(&inertia * &inertia)]]
    }
}

/// above/below of a form is that of a formula.
fn assert_same(functions: &Functions, form: &Form, [above, below]: [Polynomial; 2]) {
    let [own, under] = form.expanded(&functions.ring);
    let difference = &(&own * &below) - &(&above * &under);
    assert!(functions.ring.normal(&difference).is_zero());
}

fn with(model: &Analysis, check: impl Fn(&Functions, &Letters)) {
    let phase = model.phases.iter().find(|phase| phase.kept.len() == 1).expect("one degree of freedom");
    let named = Named::new(model, phase);
    let level = Level::derive(model, phase, Start::Rest).expect("a level");
    let functions = Functions::new(&named, &level);
    check(&functions, &Letters::from_functions(&functions));
}

/// `N = (m₁ + m₂) g (2 − (φ̇² sin φ − φ̈ cos φ) l/g)`: not negative where (3.18) holds.
#[test]
fn the_total_reaction_is_that_of_the_paper() {
    with(&frame(true), |functions, letters| {
        let [[squared, d], [acceleration, dd]] = letters.motion();
        // Over 2 D²: φ̇² sin φ is 2 D · squared sin φ.
        let twice = &letters.number(2) * &d;
        let left = &(&(&squared * &letters.sine) * &twice) - &(&acceleration * &letters.cosine);
        let bracket = &(&letters.number(2) * &dd) - &left;
        assert_same(
            functions,
            &functions.reactions[0].1,
            [&(&letters.total() * &letters.gravity) * &bracket, dd],
        );
    });
}

/// The moments of DE about D: `cos φ N_E = m₂ (½ g cos φ − φ̈ l/12 + (½ cos φ) ÿ + (½ sin φ) ẍ)`,
/// its centre at `x = 3/2 l cos φ`, `y = ½ l sin φ`; A and E together bear twice as much, and C the
/// rest.
#[test]
fn the_strict_reactions_are_those_of_a_balance_by_hand() {
    with(&frame(false), |functions, letters| {
        let [[squared, d], [acceleration, dd]] = letters.motion();
        let Letters { sine: s, cosine: c, masses: [_, m2], gravity: g, .. } = letters;
        let squared = &squared * &(&letters.number(2) * &d);
        // ẍ and ÿ times 2/l, over 2 D².
        let x = &letters.number(-3) * &(&(s * &acceleration) + &(c * &squared));
        let y = &(c * &acceleration) - &(s * &squared);
        // Twelve times the moment over m₂ g.
        let weight = &(&letters.number(6) * c) * &dd;
        let moment = &(&weight - &acceleration) + &(&letters.number(3) * &(&(c * &y) + &(s * &x)));
        let outer = &(&(m2 * g) * &moment) * &letters.number(2);
        let below = &(&letters.number(12) * c) * &dd;
        let total = &(&letters.number(2) * &dd) - &(&(&squared * s) - &(&acceleration * c));
        let total = &(&(&letters.total() * g) * &total) * &(&letters.number(12) * c);
        for (row, form) in &functions.reactions {
            let expected = if functions.label(*row) == "C" { &total - &outer } else { outer.clone() };
            assert_same(functions, form, [expected, below.clone()]);
        }
        assert_eq!(functions.reactions.len(), 2);
    });
}
