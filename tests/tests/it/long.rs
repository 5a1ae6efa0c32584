//! Emitted long trees against the oracle: chains by loops over their bars, and a tree of unequal
//! bars by straight lines.
//!
//! Tolerance: the oracle's dense solve of 5n unknowns, whose condition grows as n², beside 16
//! digits.

use liftoff::method::{Dop853, Taylor};
use liftoff::prelude::*;
use liftoff_core::model::{Array, BarSystem, ContactSet, Form, KernelView, Phase, PhaseVisitor};
use liftoff_tests::oracle::{Assembly, Body, Hinge, Mark, Pin};
use liftoff_tests::random::Source;
use nalgebra::Vector2;

const TOLERANCE: f64 = 1e-10;

#[derive(BarSystem)]
#[gravity(g)]
#[pin(O = (0, 0))]
#[chain(link, links = 12, from = O, mass = m, length = l)]
struct Twelve {
    m: f64,
    l: f64,
    g: f64,
}

#[derive(BarSystem)]
#[gravity(g)]
#[pin(O = (0, 0))]
#[chain(link, links = 40, from = O, mass = m, length = l)]
struct Forty {
    m: f64,
    l: f64,
    g: f64,
}

/// Three chains of four that begin at the end of a heavier bar.
#[derive(BarSystem)]
#[gravity(g)]
#[pin(O = (0, 0))]
#[bar(OA, mass = 3 * m, length = l)]
#[chain(left, links = 4, from = A, mass = m, length = l)]
#[chain(middle, links = 4, from = A, mass = m, length = l)]
#[chain(right, links = 4, from = A, mass = m, length = l)]
struct Tree {
    m: f64,
    l: f64,
    g: f64,
}

fn pendulum(bars: usize) -> Assembly {
    let pins = vec![Pin { at: Mark::along(0, 0.0), ground: Vector2::zeros() }];
    Assembly { pins, gravity: Vector2::new(0.0, -1.0), ..Assembly::chain(&vec![1.0; bars], 1.0) }
}

fn tree() -> Assembly {
    let mut assembly = pendulum(13);
    assembly.bodies[0] = Body::uniform("OA", 3.0, 1.0);
    let parent = |k: usize| if k % 4 == 1 { 0 } else { k - 1 };
    let hinge = |k: usize| Hinge { first: Mark::along(parent(k), 1.0), second: Mark::along(k, 0.0) };
    assembly.hinges = (1..13).map(hinge).collect();
    assembly
}

fn close(what: &str, computed: &[f64], expected: &[f64]) {
    let scale = expected.iter().fold(1.0, |scale: f64, x| scale.max(x.abs()));
    let error = computed.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / scale;
    assert!(computed.len() == expected.len() && error <= TOLERANCE, "{what}: {error:e}");
}

/// A state by its angles and rates, and what the oracle knows of it.
struct Compare<'a, M> {
    model: &'a M,
    assembly: &'a Assembly,
    angles: Vec<f64>,
    rates: Vec<f64>,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Compare<'_, M> {
    type Output = ();

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) {
        let Self { model, assembly, angles, rates } = self;
        let n = angles.len();
        let all = [&angles[..], &rates[..]].concat();
        let k = model.constants::<f64>();
        let full = M::State::<f64>::from_fn(|i| all[i]);
        let state = assembly.state(&angles, &rates, &[]).expect("pinned");
        let motion = assembly.solve(&state, &[]).expect("regular");
        let expected: Vec<f64> = (0..n).map(|body| motion.angular(body)).collect();
        let derivative = (phase.derivative)(&k, &phase.set, &(phase.restrict)(&full));
        close("rates", &derivative[..n], &rates);
        close("accelerations", &derivative[n..], &expected);
        let (mut accelerations, mut multipliers) = (vec![0.0; n], vec![0.0; M::LAYOUT.rows()]);
        M::kernel(&k, &full).solve(M::LAYOUT, &phase.set, &mut accelerations, &mut multipliers);
        close("M⁻¹ f", &accelerations, &expected);
        let energy = M::energy(&k, &full);
        let known = [assembly.kinetic_energy(&state), assembly.potential_energy(&state)];
        close("energy", &[energy.kinetic, energy.potential], &known);
        let accelerations = M::Accelerations::<f64>::from_fn(|i| expected[i]);
        let multipliers = M::Multipliers::<f64>::from_fn(|_| 0.0);
        let quantity = |name: &str| {
            let entry = M::LAYOUT.quantities.iter().position(|other| other.name == name).expect("a quantity");
            M::quantity(&k, entry, &full, &accelerations, &multipliers)
        };
        close("pin", &[quantity("fx(O)"), quantity("fy(O)")], motion.pins[0].as_slice());
        close("momenta", &["px", "py", "Lz"].map(quantity), &assembly.momenta(&state));
    }
}

fn check<M: BarSystem>(model: &M, assembly: &Assembly) {
    let mut source = Source::new(11);
    for _ in 0..10 {
        let mut values = |range: f64| assembly.bodies.iter().map(|_| source.range(-range, range)).collect();
        let (angles, rates) = (values(3.0), values(2.0));
        let compare = Compare { model, assembly, angles, rates };
        M::phase(ContactSet::EMPTY, Form::Reduced, compare);
    }
}

#[test]
fn chains_and_a_tree() {
    check(&Twelve { m: 1.0, l: 1.0, g: 1.0 }, &pendulum(12));
    check(&Forty { m: 1.0, l: 1.0, g: 1.0 }, &pendulum(40));
    check(&Tree { m: 1.0, l: 1.0, g: 1.0 }, &tree());
}

/// By Taylor's series of its straight lines, and by steps over its loops; at tolerance 1e-12 some
/// hundred steps lose that much each.
#[test]
fn a_chain_keeps_its_energy() {
    let model = Twelve { m: 1.0, l: 1.0, g: 1.0 };
    let start = || Pose::new(Twelve::LAYOUT.coordinates[0].name, 0.3);
    let prepared = || Simulation::new(&model).unwrap().tolerance(1e-12).start(start()).unwrap().limit(5.0);
    let energy = Output::parse(Twelve::LAYOUT, "T + V").unwrap();
    for run in [prepared().method(Taylor).run().unwrap(), prepared().method(Dop853).run().unwrap()] {
        let [before, after] = [0.0, 5.0].map(|t| run.value(&energy, t));
        assert!((after - before).abs() < 1e-9 * before.abs().max(1.0), "{before} {after}");
    }
}
