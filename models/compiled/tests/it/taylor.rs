//! Emitted Taylor series against jets: the recurrences over a tape, in the series' own code, against those of
//! [`Jet`] arithmetic in the code of the functions.

use liftoff::prelude::*;
use liftoff_compiled::*;
use liftoff_core::integrate::{Expansion, PhaseExpansion};
use liftoff_core::model::{Array, ContactSet, Form, KernelView, Phase, PhaseSeries, PhaseVisitor};
use liftoff_core::scalar::Jet;
use liftoff_core::system::Model;
use liftoff_tests::random::Source;

/// Coefficients that are compared.
const K: usize = 13;

/// A coefficient is made of some thousand products of lower ones, whose roundings add up at random and are magnified where
/// terms cancel or a divisor is small; the worst of all below is
/// 2e-14 of the largest of its and lower orders.
const TOLERANCE: f64 = 2e-13;

/// The elimination of a random system loses more.
const PROJECTED_TOLERANCE: f64 = 1e-11;

/// Coefficients 0 … K − 1 of the state, 0 … K − 2 of each reaction, gap and foot.
struct Series {
    state: Vec<[f64; K]>,
    guards: [Vec<[f64; K]>; 3],
}

struct Emitted<'a, M: BarSystem> {
    model: &'a M,
    state: &'a M::State<f64>,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Emitted<'_, M> {
    type Output = Option<Series>;

    fn visit<const N: usize>(self, _: Phase<M, f64, N>) -> Option<Series> {
        None
    }

    fn visit_series<const N: usize, Q: PhaseSeries<M, N>>(self, phase: Phase<M, f64, N>) -> Option<Series> {
        let constants = self.model.constants::<f64>();
        let mut expansion = PhaseExpansion::<M, Q, N>::new(&constants);
        expansion.expand(&(phase.restrict)(self.state), 1.0, K - 1);
        let series = expansion.series();
        let state = (0..N).map(|i| core::array::from_fn(|k| series[k][i])).collect();
        let (contacts, feet) = (M::LAYOUT.contacts.len(), M::feet(&constants, self.state).as_ref().len() / 2);
        let padded = |terms: &[f64]| core::array::from_fn(|k| terms.get(k).copied().unwrap_or(0.0));
        let guards = expansion.guards(1.0).map(|guards| {
            [
                (0..contacts).map(|i| padded(guards.reaction(i))).collect(),
                (0..contacts).map(|i| padded(guards.gap(i))).collect(),
                (0..2 * feet).map(|i| padded(guards.foot(i / 2, i % 2))).collect(),
            ]
        });
        Some(Series { state, guards: guards? })
    }
}

struct ByJets<'a, M> {
    model: &'a M,
    series: &'a Series,
}

impl<M: BarSystem> PhaseVisitor<M, Jet<f64, K>> for ByJets<'_, M> {
    type Output = f64;

    fn visit<const N: usize>(self, phase: Phase<M, Jet<f64, K>, N>) -> f64 {
        let constants = self.model.constants::<Jet<f64, K>>();
        let state: [Jet<f64, K>; N] = core::array::from_fn(|i| Jet::new(self.series.state[i]));
        let rates = (phase.derivative)(&constants, &phase.set, &state);
        let full = (phase.embed)(&constants, &state);
        let contacts = M::LAYOUT.contacts.len();
        let mut gaps = M::kernel(&constants, &full).gap()[..contacts].to_vec();
        let open = |i: usize| !phase.set.contains(i);
        (0..contacts).filter(|&i| !open(i)).for_each(|i| gaps[i] = Jet::constant(0.0));
        let expected: [Vec<Jet<f64, K>>; 3] = [
            (phase.reactions)(&constants, &phase.set, &state).as_ref().to_vec(),
            gaps,
            M::feet(&constants, &full).as_ref().to_vec(),
        ];
        let (mut worst, mut size): (f64, f64) = (0.0, 0.0);
        for n in 0..K - 1 {
            let next = self.series.state.iter().map(|c| c[n + 1] * (n + 1) as f64);
            let guards = self.series.guards.iter().flatten().map(|c| c[n]);
            let computed: Vec<f64> = next.chain(guards).collect();
            let expected: Vec<f64> =
                rates.iter().chain(expected.iter().flatten()).map(|f| f.coefficient(n)).collect();
            assert_eq!(computed.len(), expected.len());
            size = expected.iter().fold(size, |size, x| size.max(x.abs()));
            for (a, b) in computed.iter().zip(&expected) {
                assert!(a.is_finite() && b.is_finite());
                worst = worst.max((a - b).abs() / size);
            }
        }
        worst
    }
}

fn check<M: BarSystem>(model: &M) {
    let analysis = liftoff_codegen::analyse(M::LAYOUT.declaration.parse().unwrap()).unwrap();
    assert!(!analysis.functions.phases.is_empty());
    let mut source = Source::new(11);
    for functions in &analysis.functions.phases {
        let state = M::State::from_fn(|_| source.range(-1.2, 1.2));
        let set = ContactSet::from_bits(functions.set.closed);
        let series = M::phase(set, Form::Reduced, Emitted { model, state: &state }).expect("a closed form");
        let worst = M::phase(set, Form::Reduced, ByJets { model, series: &series });
        assert!(worst < TOLERANCE, "{:b}: {worst:e}", functions.set.closed);
    }
}

/// Every operation in one: time, a root, a quotient, a tangent, and angles that do not vary.
#[derive(BarSystem)]
#[liftoff(dimensionless)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[support(B = floor(-3 * l))]
#[force(wind = (b * sin(w * t) / sqrt(l * l + x(B) * x(B)), b * tan(t / 3)), at = B)]
#[couple(OA = b * l * cos(phi - w * t).powi(-2))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi = angle(OA), from = down)]
#[coordinate(psi = angle(AB), from = down)]
struct Forced {
    m: f64,
    l: f64,
    b: f64,
    w: f64,
    g: f64,
}

first_models! {}

models! {
    spring_pendulum: SpringPendulum { m: 1.3, k: 40.0, l: 0.7, c: 0.3, g: 9.81 };
    looping: Looping { m: 1.3, r: 0.7, g: 9.81 };
    walker: Walker { m: 1.3, l: 0.7, a: 0.2, k: 40.0, c: 0.3, g: 9.81 };
    toppling_rod: TopplingRod { m: 1.3, l: 0.7, g: 9.81 };
    forced: Forced { m: 1.3, l: 0.7, b: 0.4, w: 1.1, g: 9.81 };
    zigzag_thread: ZigzagThread { m1: 0.4, m2: 0.9, l: 0.7, s: 1.1, g: 9.81 };
}

/// The series of the full equations of phases that keep all coordinates, against the elimination on jets.
fn check_projected<M: BarSystem>(model: &M, sets: &[u64]) {
    let mut source = Source::new(12);
    let system = Model::new(model).system;
    for &set in sets {
        let set = ContactSet::from_bits(set);
        let state = M::State::from_fn(|_| source.range(-1.2, 1.2));
        let phase = system.clone().phase(set, Form::Multipliers);
        let mut expansion = phase.series().expect("series");
        expansion.expand(state.as_ref(), 1.0, K - 1);
        let entries = state.as_ref().len();
        let series = expansion.series();
        let state = (0..entries).map(|i| core::array::from_fn(|k| series[k * entries + i])).collect();
        let (contacts, feet) = (M::LAYOUT.contacts.len(), M::LAYOUT.feet());
        let padded = |terms: &[f64]| core::array::from_fn(|k| terms.get(k).copied().unwrap_or(0.0));
        let guards = expansion.guards(1.0).expect("guards");
        let guards = [
            (0..contacts).map(|i| padded(guards.reaction(i))).collect(),
            (0..contacts).map(|i| padded(guards.gap(i))).collect(),
            (0..2 * feet).map(|i| padded(guards.foot(i / 2, i % 2))).collect(),
        ];
        let series = Series { state, guards };
        let worst = M::phase(set, Form::Multipliers, ByJets { model, series: &series });
        assert!(worst < PROJECTED_TOLERANCE, "{} {set:?}: {worst:e}", M::LAYOUT.name);
    }
}

/// Loops, free and driven, threads, contacts that lean on one another, and those of which other sets have closed forms.
#[test]
fn phases_without_a_closed_form_have_the_series_of_the_full_equations() {
    check_projected(&SliderCrank { a: 1.0, b: 0.5, c: 2.0, r: 0.4, l: 0.9, omega: 1.3 }, &[0]);
    check_projected(&Parallelogram { m: 1.3, l: 0.7, c: 0.8, d: 1.1, g: 9.81 }, &[0]);
    check_projected(&NFourBar { m: 1.3, l: 0.7, g: 9.81 }, &[0]);
    check_projected(&ZigzagThread { m1: 0.4, m2: 0.9, l: 0.7, s: 1.1, g: 9.81 }, &[1, 2, 4, 3, 5]);
}
