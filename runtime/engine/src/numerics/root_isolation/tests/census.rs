//! A hundred thousand random guards with known roots: none missed, none invented.

use super::super::{Crossing, RootStart, rest, watch, watch_series};
use super::known::{Known, Random, Root};
use super::{first_root, first_root_series};

/// What is followed along one guard; after a root it goes on from there, the root known.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Event {
    Leaves,
    Crossing(f64),
    Touch(f64),
}

#[derive(Clone, Copy)]
enum Kind {
    Series,
    Function,
}

/// Of the guard with the sign that it has behind the root before: down through an odd root,
/// touching an even one; where an odd one at the end leads is the next step's.
fn expected(known: &Known) -> Vec<Event> {
    let event = |root: &Root| match root.multiplicity % 2 {
        1 if root.at == 1.0 => None,
        1 => Some(Event::Crossing(root.at)),
        _ => Some(Event::Touch(root.at)),
    };
    let start = (!known.positive).then_some(Event::Leaves).into_iter();
    start.chain(known.roots.iter().filter(|root| root.at > 0.0).filter_map(event)).collect()
}

fn verdict(known: &Known, kind: Kind, sign: f64, from: f64, start: RootStart) -> Crossing {
    match kind {
        Kind::Series => watch_series(&rest(&known.c, from).map(|c| sign * c), start, known.delta),
        Kind::Function => watch(|s| sign * (known.value)(from + (1.0 - from) * s), start, known.delta),
    }
    .expect("finite")
}

fn first(known: &Known, kind: Kind, from: f64, start: RootStart) -> Option<f64> {
    match kind {
        Kind::Series => first_root_series(&rest(&known.c, from), start, known.delta),
        Kind::Function => first_root(|s| (known.value)(from + (1.0 - from) * s), start, known.delta),
    }
    .expect("finite")
    .map(|s| from + (1.0 - from) * s)
}

/// The known root that was found.
fn nearest(known: &Known, theta: f64, slack: impl Fn(&Root) -> f64) -> Option<Root> {
    let near = |root: &&Root| (root.at - theta).abs() <= slack(root);
    known.roots.iter().find(near).copied()
}

fn at_start(known: &Known) -> RootStart {
    if known.order() > 0 { RootStart::Order(known.order()) } else { RootStart::Free }
}

fn observed(known: &Known, kind: Kind) -> Vec<Event> {
    let (mut events, mut sign, mut from, mut start) = (Vec::new(), 1.0, 0.0, at_start(known));
    while events.len() < 16 {
        let at = |s: f64| from + (1.0 - from) * s;
        let (event, theta) = match verdict(known, kind, sign, from, start) {
            Crossing::Clear => break,
            Crossing::LeavesAtStart => {
                events.push(Event::Leaves);
                sign = -sign;
                continue;
            }
            Crossing::At { theta } => (Event::Crossing as fn(f64) -> Event, at(theta)),
            Crossing::Touch { theta, .. } => (Event::Touch as fn(f64) -> Event, at(theta)),
        };
        let root = nearest(known, theta, |root| root.slack[kind as usize]);
        if root.is_some_and(|root| root.at == 1.0 && root.multiplicity % 2 == 1) {
            // From before it may look like a touch.
            break;
        }
        events.push(event(root.map_or(theta, |root| root.at)));
        let Some(root) = root.filter(|root| root.at < 1.0) else { break };
        if root.multiplicity % 2 == 1 {
            sign = -sign;
        }
        (from, start) = (root.at, RootStart::Order(root.multiplicity));
    }
    events
}

fn observed_roots(known: &Known, kind: Kind) -> Vec<f64> {
    let (mut found, mut from, mut start) = (Vec::new(), 0.0, at_start(known));
    while let Some(theta) = first(known, kind, from, start).filter(|_| found.len() < 16 && from < 1.0) {
        let Some(root) = nearest(known, theta, |root| root.slack[kind as usize] + root.dip) else {
            found.push(theta);
            break;
        };
        found.push(root.at);
        (from, start) = (root.at, RootStart::Order(root.multiplicity));
    }
    found
}

fn count(kind: Kind, seed: u64) {
    let mut random = Random(seed);
    let mut events = 0;
    for i in 0..100_000 {
        let known = Known::random(&mut random);
        let (found, wanted) = (observed(&known, kind), expected(&known));
        assert_eq!(found, wanted, "guard {i}, δ = {:e}, roots {:?}", known.delta, known.roots);
        let wanted: Vec<f64> = known.roots.iter().map(|root| root.at).filter(|at| *at > 0.0).collect();
        let found = observed_roots(&known, kind);
        if found != wanted {
            for k in 0..=40 {
                let s = k as f64 / 40.0;
                println!("{s} {:e}", (known.value)(s));
            }
        }
        assert_eq!(found, wanted, "guard {i}, δ = {:e}, roots {:?}", known.delta, known.roots);
        events += wanted.len();
    }
    assert!(events > 90_000, "{events} roots");
}

#[test]
fn a_hundred_thousand_series() {
    count(Kind::Series, 1);
}

#[test]
fn a_hundred_thousand_functions() {
    count(Kind::Function, 2);
}
