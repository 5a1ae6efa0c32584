//! Printed formulas read back: text and LaTeX have the value of what they print.

mod reader;

use std::collections::BTreeSet;

use liftoff_codegen::Analysis;
use liftoff_codegen::algebra::{Quotient, Series, Symbol, SymbolNames};
use liftoff_codegen::math::{Equation, Math};
use liftoff_codegen::phases::Phase;
use liftoff_codegen::text::TextWriter;
use liftoff_compiled::models;
use liftoff_conditions::{Conditions, Request};
use liftoff_tests::random::{Source, Vocabulary, sample_of};
use reader::{Values, read_latex, read_text};

/// What has a value, and the value.
type Valued<T> = Vec<(T, f64)>;

/// Long fractions are printed with seven digits.
const SEVEN_DIGITS: f64 = 1e-5;

fn assert_reads(text: &str, read: Result<f64, String>, value: f64, tolerance: f64) {
    let read = read.unwrap_or_else(|error| panic!("{error}"));
    assert!((read - value).abs() <= tolerance * (1.0 + value.abs()), "{read} for {value}: {text}");
}

fn assert_reads_back(math: &Math, values: &[Values; 2], value: f64, tolerance: f64) {
    let (text, latex) = (math.to_string(), math.latex());
    assert_reads(&text, read_text(&text, &values[0]), value, tolerance);
    assert_reads(&format!("{latex} for {text}"), read_latex(&latex, &values[1]), value, tolerance);
}

/// What symbols are printed as in text and in LaTeX.
fn printed(symbols: impl IntoIterator<Item = (Math, f64)>) -> [Values; 2] {
    let (mut texts, mut latex) = (Values::new(), Values::new());
    for (symbol, value) in symbols {
        texts.push((symbol.to_string(), value));
        latex.push((symbol.latex(), value));
    }
    [texts, latex]
}

/// A formula and its value, out of a few symbols.
fn draw(source: &mut Source, symbols: &[(Math, f64)], depth: usize) -> (Math, f64) {
    if depth == 0 || source.chance(0.15) {
        let (numerator, denominator) = (1 + source.below(12), 1 + source.below(9));
        return match source.chance(0.3) {
            true => (
                Math::Number { numerator: numerator as u128, denominator: denominator as u128 },
                numerator as f64 / denominator as f64,
            ),
            false => source.choose(symbols),
        };
    }
    let kind = source.below(7);
    let mut next = || draw(source, symbols, depth - 1);
    let (one, a) = next();
    match kind {
        0 => {
            let (other, b) = next();
            (Math::sum([one, other]), a + b)
        }
        1 => {
            let (other, b) = next();
            (Math::sum([one, other.minus()]), a - b)
        }
        2 => {
            let (other, b) = next();
            (Math::product([one, other]), a * b)
        }
        3 => {
            let (other, b) = next();
            (one.over(other), a / b)
        }
        4 => {
            let (other, b) = next();
            (one.all_over(other), a / b)
        }
        5 => (one.minus(), -a),
        _ => {
            let power = 2 + source.below(2) as i32;
            (one.power(power), a.powi(power))
        }
    }
}

#[test]
fn random_formulas() {
    let mut source = Source::new(7);
    let angle = (Math::symbol("phi_inner"), 0.7);
    let cosine = Math::Apply { function: "cos", power: 2, argument: Box::new(angle.0.clone()) };
    let double = Math::Multiple(Box::new(Math::integer(2)), Box::new(Math::symbol("beta")));
    let sine = Math::Apply { function: "sin", power: 1, argument: Box::new(double) };
    let letters =
        [angle.clone(), (Math::symbol("m1"), 1.3), (Math::symbol("l"), 0.8), (Math::symbol("lean"), 1.7)];
    let values = printed(letters.iter().cloned().chain([(Math::symbol("beta"), 0.4)]));
    let root = (Math::Root(Box::new(Math::symbol("l"))), 0.8_f64.sqrt());
    let symbols = [&letters[..], &[(cosine, 0.7_f64.cos().powi(2)), (sine, 0.8_f64.sin()), root]].concat();
    let mut read = 0;
    while read < 20_000 {
        let (math, value) = draw(&mut source, &symbols, 5);
        if value.abs() < 1e6 {
            assert_reads_back(&math, &values, value, 1e-6);
            read += 1;
        }
    }
}

/// The symbols of a model's formulas with values, and as they are printed; derived constants are
/// printed as what they are.
fn symbols(
    analysis: &Analysis,
    all: &BTreeSet<Symbol>,
    source: &mut Source,
) -> (Valued<Symbol>, Valued<Math>) {
    let writer = TextWriter::new(analysis);
    let coordinates = analysis.kinematics.coordinates.len() as u16;
    let places =
        (0..coordinates).flat_map(|index| (0..3).map(move |order| Symbol::Coordinate { index, order }));
    let parameters = (0..analysis.system.parameters.len()).map(Symbol::parameter);
    let is_derived = |symbol: &Symbol| matches!(symbol, Symbol::Parameter(i) if usize::from(*i) >= analysis.system.parameters.len());
    let own: BTreeSet<Symbol> =
        places.chain(parameters).chain(all.iter().copied().filter(|symbol| !is_derived(symbol))).collect();
    let mut values: Vec<(Symbol, f64)> =
        own.into_iter().map(|symbol| (symbol, source.range(0.3, 1.3))).collect();
    let mut shown: Vec<(Math, f64)> =
        values.iter().map(|(symbol, value)| (Series::symbol(*symbol).math(&writer), *value)).collect();
    shown.push((Math::symbol("pi"), std::f64::consts::PI));
    let [texts, _] = printed(shown.iter().cloned());
    for symbol in all.iter().filter(|symbol| is_derived(symbol)) {
        let text = Series::symbol(*symbol).math(&writer).to_string();
        values.push((*symbol, read_text(&text, &texts).unwrap_or_else(|error| panic!("{error}"))));
    }
    (values, shown)
}

fn symbols_of(quotients: &[&Quotient]) -> BTreeSet<Symbol> {
    let series = quotients.iter().flat_map(|q| q.factors().iter().map(|(f, _)| f).chain([q.numerator()]));
    series.flat_map(Series::symbols).collect()
}

fn quotients(phase: &Phase) -> Vec<&Quotient> {
    let Phase { mass, velocity_terms, forces, kinetic, potential, reactions, rates, .. } = phase;
    let all = mass.iter().flatten().chain(velocity_terms).chain(forces).chain([kinetic, potential]);
    all.chain(reactions.iter().map(|(_, reaction)| reaction)).chain(rates).collect()
}

/// Whether the value survives other symbols in the last digits: sums that cancel are not compared.
fn is_well_conditioned(quotient: &Quotient, values: &[(Symbol, f64)]) -> Option<f64> {
    let at = |shift: f64| {
        quotient.evaluate(&|symbol| {
            let (_, value) = values.iter().find(|(known, _)| *known == symbol).expect("a known symbol");
            value * (1.0 + shift)
        })
    };
    let (value, beside) = (at(0.0), at(1e-12));
    (value.is_finite() && (value - beside).abs() < 1e-9 * value.abs()).then_some(value)
}

fn check_model(analysis: &Analysis, source: &mut Source, seen: &mut usize) {
    let writer = TextWriter::new(analysis);
    for phase in &analysis.phases {
        let all = quotients(phase);
        let (values, shown) = symbols(analysis, &symbols_of(&all), source);
        let shown = printed(shown);
        for quotient in all {
            if let Some(value) = is_well_conditioned(quotient, &values) {
                assert_reads_back(&writer.quotient(quotient), &shown, value, SEVEN_DIGITS);
                *seen += 1;
            }
        }
    }
}

fn analysed(declaration: &str) -> Analysis {
    liftoff_codegen::analyse(declaration.parse().expect("tokens")).expect("a model")
}

#[test]
fn equations_of_models_and_of_random_systems() {
    let (mut source, mut seen) = (Source::new(1), 0);
    for model in models().iter() {
        check_model(&analysed(model.layout().declaration), &mut source, &mut seen);
    }
    assert!(seen > 1000, "{seen}");
    for seed in 0..150 {
        check_model(&analysed(&sample_of(seed, Vocabulary::BARS).declaration), &mut source, &mut seen);
    }
    assert!(seen > 3000, "{seen}");
}

/// Three bars over two corners, mirrored; masses and lengths of the outer ones, then of the middle
/// one.
fn three_bars([a, b, c, d]: [usize; 4]) -> String {
    format!(
        "#[gravity(g)] #[bar(AC, mass = {a} * m, length = {b} * l)] #[bar(CD, mass = {c} * m, length = {d} * l)]
         #[bar(DB, mass = {a} * m, length = {b} * l)] #[support(P = corner(-w / 2, 0), under = AC)]
         #[support(Q = corner(w / 2, 0), under = DB)]
         #[figure(C = (-{d} * l / 2, 0), D = ({d} * l / 2, 0), B = ({d} * l / 2 + {b} * l, 0))]
         #[coordinate(phi = angle(DB), from = horizontal)] #[coordinate(y = -y(D))] #[mirror(x = 0)]
         struct ThreeBars {{ m: f64, l: f64, w: f64, g: f64 }}"
    )
}

/// q̇², q̈ and the reactions of a phase with one degree of freedom that began at rest where q is
/// `from`, from its equations.
fn motion(analysis: &Analysis, phase: &Phase, values: &[(Symbol, f64)], from: f64) -> Vec<f64> {
    let [kept] = phase.kept[..] else { panic!("one coordinate") };
    let at = |quotient: &Quotient, place: Option<f64>, [rate, acceleration]: [f64; 2]| {
        quotient.evaluate(&|symbol| match symbol {
            symbol if symbol == Symbol::acceleration(kept) => acceleration,
            symbol if symbol == Symbol::coordinate(kept) && place.is_some() => place.unwrap_or(from),
            symbol if symbol == Symbol::rate(kept) => rate,
            _ => values.iter().find(|(known, _)| *known == symbol).expect("a known symbol").1,
        })
    };
    let fall = at(&phase.potential, Some(from), [0.0; 2]) - at(&phase.potential, None, [0.0; 2]);
    // Rates may be imaginary: all is linear in their square.
    let mass = at(&phase.mass[0][0], None, [0.0; 2]);
    let squared = 2.0 * fall / mass;
    let linear = |quotient: &Quotient, acceleration: f64| {
        let [still, moving] = [0.0, 1.0].map(|rate| at(quotient, None, [rate, acceleration]));
        still + squared * (moving - still)
    };
    let acceleration = (linear(&phase.forces[0], 0.0) - linear(&phase.velocity_terms[0], 0.0)) / mass;
    let contacts = phase.reactions.iter().filter(|(row, _)| *row < analysis.motion.contacts.len());
    let reactions = contacts.map(|(_, reaction)| linear(reaction, acceleration));
    [squared, acceleration].into_iter().chain(reactions).collect()
}

/// Conditions of a start at rest, anywhere or at a given place, which has the formulas without the
/// symbol of the start.
fn check_conditions(analysis: &Analysis, at: Option<f64>, source: &mut Source, seen: &mut usize) {
    let writer = TextWriter::new(analysis);
    for phase in analysis.phases.iter().filter(|phase| phase.kept.len() == 1) {
        let (values, shown) = symbols(analysis, &symbols_of(&quotients(phase)), source);
        let name = writer.coordinate(phase.kept[0] as u16);
        let request = at.map_or_else(Request::default, |at| Request {
            start: vec![(name.clone(), at)],
            parameters: [("m", 1.0), ("l", 1.0), ("w", 1.6), ("g", 1.0)]
                .map(|(name, value)| (name.to_owned(), value))
                .to_vec(),
        });
        let Ok(conditions) = Conditions::derive(analysis, &writer.title(phase.set), &request) else {
            continue;
        };
        let from = at.unwrap_or_else(|| source.range(0.3, 1.3));
        let shown = printed(shown.into_iter().chain([(Math::symbol(&format!("{name}_0")), from)]));
        let reactions = conditions.reactions.iter().map(|condition| &condition.reaction);
        let equations: Vec<&Equation> = conditions.motion.iter().chain(reactions).collect();
        for (equation, value) in equations.iter().zip(motion(analysis, phase, &values, from)) {
            assert_reads_back(&equation.right, &shown, value, 1e-7);
            *seen += 1;
        }
    }
}

#[test]
fn conditions_of_models_and_of_random_frames() {
    let (mut source, mut seen) = (Source::new(3), 0);
    check_conditions(&analysed(&three_bars([1; 4])), Some(0.0), &mut source, &mut seen);
    assert_eq!(seen, 3);
    for _ in 0..12 {
        let frame = three_bars([(); 4].map(|()| 1 + source.below(5)));
        check_conditions(&analysed(&frame), None, &mut source, &mut seen);
    }
    assert!(seen >= 39, "{seen}");
    for model in models().iter() {
        check_conditions(&analysed(model.layout().declaration), None, &mut source, &mut seen);
    }
    assert!(seen >= 80, "{seen}");
}
