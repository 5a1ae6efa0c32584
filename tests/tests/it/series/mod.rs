//! Compares the emitted Taylor series of random systems with the arithmetic program. The emitted
//! tokens are evaluated directly; the operations of the program do not depend on the emitted
//! series. Other tests compare the program with the oracle.

mod emitted;
mod program;
mod turned;

use std::collections::BTreeMap;

use emitted::{K, Series, Value, Variables, block, items};
use liftoff_codegen::{Analysis, analyse, expand};
use liftoff_core::scalar::Jet;
use liftoff_tests::random::{Source, Vocabulary, sample_of};
use proc_macro2::TokenStream;
use syn::{ImplItem, Item, ItemImpl, Type};

/// Both sides lose digits where a divisor or a pivot is small. A system that loses more than half
/// of 16 digits is skipped; for the others coefficients agree to the remaining digits.
const TOLERANCE: f64 = 1e-8;

/// The bodies of a model's emitted functions.
struct Emitted {
    constants: syn::Block,
    /// For each closed form, in order, its series if it has one.
    orders: Vec<Option<syn::Block>>,
}

fn method(item: &ItemImpl, name: &str) -> Option<syn::Block> {
    item.items.iter().find_map(|item| match item {
        ImplItem::Fn(function) if function.sig.ident == name => Some(function.block.clone()),
        _ => None,
    })
}

fn emitted(tokens: TokenStream) -> Emitted {
    let (mut constants, mut names, mut orders) = (None, Vec::new(), BTreeMap::new());
    for item in items(expand(tokens)) {
        let Item::Impl(item) = item else { continue };
        let Some((of, _)) = &item.trait_ else { continue };
        let Type::Path(name) = &*item.self_ty else { continue };
        let name = name.path.segments.last().expect("a name").ident.to_string();
        match of.segments.last().expect("a trait").ident.to_string().as_str() {
            "BarSystem" => constants = method(&item, "constants_of"),
            "ClosedForm" => names.push(name),
            "PhaseSeries" => orders.extend(method(&item, "order").map(|body| (name, body))),
            _ => {}
        }
    }
    let orders = names.iter().map(|name| orders.remove(name)).collect();
    Emitted { constants: constants.expect("constants"), orders }
}

/// The worst error of any coefficient relative to the largest of its kind and order or a lower one;
/// `None` if some are NaN or too large to compare.
fn error(computed: &[Series], expected: &[Series]) -> Option<f64> {
    assert_eq!(computed.len(), expected.len());
    let (mut worst, mut size) = (0.0_f64, 1.0_f64);
    for n in 0..K {
        let pair = |(a, b): (&Series, &Series)| (a.coefficient(n), b.coefficient(n));
        size = expected.iter().fold(size, |size, x| size.max(x.coefficient(n).abs()));
        for (a, b) in computed.iter().zip(expected).map(pair) {
            worst = worst.max((a - b).abs() / size);
            if !b.is_finite() {
                return None;
            }
            assert!(a.is_finite());
        }
    }
    (size < 1e6).then_some(worst)
}

/// Evaluates the series of a phase, order by order, at random values; returns the largest error.
fn compare(
    (analysis, parameters): (&Analysis, &[f64]),
    place: usize,
    body: &syn::Block,
    variables: &Variables,
    source: &mut Source,
) -> Option<f64> {
    let phase = &analysis.functions.phases[place];
    let carried = analysis.motion.carried().count();
    let mut state = vec![[0.0; K]; phase.kept.len() + phase.moving.len() + carried];
    state.iter_mut().for_each(|series| series[0] = source.range(-1.2, 1.2));
    let jets = |state: &[[f64; K]]| state.iter().map(|&series| Jet::new(series)).collect::<Vec<Series>>();
    let terms = |state: &[[f64; K]]| {
        let mut variables = variables.clone();
        variables.insert("state".into(), Value::array(jets(state)));
        let terms = block(body, &variables);
        let array = |name| terms.field(name).many().iter().map(Value::one).collect::<Vec<Series>>();
        ["rates", "reactions", "gaps", "feet"].map(array)
    };
    for n in 1..K {
        let [rates, ..] = terms(&state);
        state.iter_mut().zip(rates).for_each(|(x, rate)| x[n] = rate.coefficient(n - 1) / n as f64);
    }
    let expected = program::terms(analysis, phase, parameters, &jets(&state));
    let pairs = terms(&state).into_iter().zip(expected);
    pairs.map(|(a, b)| error(&a, &b)).try_fold(0.0, |worst: f64, error| Some(worst.max(error?)))
}

/// How many closed forms were compared.
fn check(declaration: &str, parameters: &[f64], source: &mut Source) -> usize {
    let tokens: TokenStream =
        format!("#[liftoff(sets = 3)] {declaration}").parse().expect("declarations are Rust");
    let analysis = analyse(tokens.clone()).unwrap_or_else(|errors| panic!("{errors}\n{declaration}"));
    let Emitted { constants, orders } = emitted(tokens);
    assert_eq!(orders.len(), analysis.functions.phases.len());
    let values = Value::array(parameters.iter().map(|&value| Jet::constant(value)));
    let constants = block(&constants, &Variables::from([("p".into(), values)]));
    let variables = Variables::from([("k".into(), constants)]);
    let mut compared = 0;
    for (place, body) in orders.iter().enumerate() {
        let Some(body) = body else { continue };
        let Some(error) = compare((&analysis, parameters), place, body, &variables, source) else { continue };
        assert!(error < TOLERANCE, "form {place}: {error:e}\n{declaration}");
        compared += 1;
    }
    compared
}

fn sampled(seeds: core::ops::Range<u64>, vocabulary: Vocabulary) -> usize {
    let check = |seed: u64| {
        let sample = sample_of(seed, vocabulary);
        let parameters: Vec<f64> = sample.parameters.iter().map(|(_, value)| *value).collect();
        check(&sample.declaration, &parameters, &mut Source::new(seed ^ 0x7a71))
    };
    seeds.map(check).sum()
}

#[test]
fn bars() {
    let compared = sampled(0..60, Vocabulary::BARS);
    assert!(compared >= 60, "{compared}");
}

#[test]
fn vocabulary() {
    let compared = sampled(0..60, Vocabulary::ALL);
    assert!(compared >= 60, "{compared}");
}

#[test]
fn angles_that_do_not_vary() {
    let check = |seed: u64| {
        let mut source = Source::new(seed);
        let (declaration, parameters) = turned::draw(&mut source);
        check(&declaration, &parameters, &mut source)
    };
    let compared: usize = (0..100).map(check).sum();
    assert!(compared >= 60, "{compared}");
}
