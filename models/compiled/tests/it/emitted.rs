//! Emitted Rust against the interpreter, and series against the program, at random states of every model.
//!
//! Both evaluate the same expressions in `f64` in possibly different order, so they agree to a few hundred
//! roundings of the largest term; 1e-12 relative to the largest entry leaves room for that and no more.

use approx::assert_relative_eq;
use liftoff_codegen::algebra::Symbol;
use liftoff_codegen::functions::PhaseFunctions;
use liftoff_codegen::{Analysis, analyse};
use liftoff_compiled::*;
use liftoff_core::model::{BarSystem, ClosedForm, ContactSet, Energy, Form, KernelView, Phase, PhaseVisitor};
use liftoff_tests::random::Source;

const TOLERANCE: f64 = 1e-12;

fn analysis<M: BarSystem>() -> Analysis {
    analyse(M::LAYOUT.declaration.parse().unwrap()).unwrap()
}

fn close(computed: &[f64], expected: &[f64], what: &str) {
    close_to(computed, expected, TOLERANCE, what);
}

fn close_to(computed: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    let scale = expected.iter().fold(1e-300_f64, |s, x| s.max(x.abs()));
    assert_eq!(computed.len(), expected.len(), "{what}");
    for (a, b) in computed.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance * scale, "{what}: {a:e} against {b:e}, scale {scale:e}");
    }
}

fn state<M: BarSystem>(source: &mut Source) -> M::State<f64> {
    <M::State<f64> as liftoff_core::model::Array<f64>>::from_fn(|_| source.range(-1.2, 1.2))
}

fn kernel<M: BarSystem>(analysis: &Analysis, model: &M, state: &M::State<f64>) {
    let (k, parameters) = (model.constants::<f64>(), model.parameters());
    let parameters = parameters.as_ref();
    let emitted = M::kernel(&k, state);
    let ids = &analysis.functions.kernel;
    let value = |ids: &[_]| analysis.evaluate(ids, parameters, state.as_ref());
    for (i, row) in analysis.mass(parameters, state.as_ref()).iter().enumerate() {
        close(emitted.mass(i), row, "mass");
    }
    close(emitted.force(), &value(&ids.force), "force");
    close(emitted.gap(), &value(&ids.gap), "gap");
    close(emitted.bias(), &value(&ids.bias), "bias");
    for (i, row) in ids.jacobian.iter().enumerate() {
        close(emitted.jacobian(i), &value(row), "jacobian");
    }
    let functions = &analysis.functions;
    close(M::points(&k, state).as_ref(), &value(&functions.points), "points");
    close(M::feet(&k, state).as_ref(), &value(&functions.feet), "feet");
    let Energy { kinetic, potential } = M::energy(&k, state);
    close(&[kinetic, potential], &value(&functions.energy), "energy");
    series(analysis, parameters, state.as_ref());
}

/// The symbolic M, f and gaps, evaluated term by term, against the lowered program.
fn series(analysis: &Analysis, parameters: &[f64], state: &[f64]) {
    let n = analysis.motion.n;
    let constants = |i: usize| {
        analysis
            .system
            .parameter_value(&liftoff_codegen::algebra::Series::symbol(Symbol::parameter(i)), parameters)
    };
    let value = |symbol: Symbol| match symbol {
        Symbol::Parameter(i) => constants(i.into()),
        Symbol::Coordinate { index, order } => state[usize::from(index) + n * usize::from(order)],
        Symbol::Reaction(_) | Symbol::Opaque { .. } | Symbol::Time | Symbol::Sense(_) | Symbol::Switch(_) => {
            f64::NAN
        }
    };
    let motion = &analysis.motion;
    let mass = analysis.mass(parameters, state);
    let dense = analysis.dense.as_ref().expect("small systems have all entries");
    for i in 0..n {
        let row: Vec<f64> = dense.mass[i][..=i].iter().map(|s| s.evaluate(&value)).collect();
        close(&mass[i][..=i], &row, "mass series");
    }
    let force: Vec<f64> = (0..n).map(|i| dense.force(i).evaluate(&value)).collect();
    close(&analysis.evaluate(&analysis.functions.kernel.force, parameters, state), &force, "force series");
    let gaps: Vec<f64> = motion.rows.iter().map(|r| r.gap.evaluate(&value)).collect();
    close(&analysis.evaluate(&analysis.functions.kernel.gap, parameters, state), &gaps, "gap series");
    let kinetic = dense.kinetic().evaluate(&value);
    let potential = motion.potential.evaluate(&value);
    close(
        &analysis.evaluate(&analysis.functions.energy, parameters, state),
        &[kinetic, potential],
        "energy series",
    );
}

struct Compare<'a, M: BarSystem> {
    analysis: &'a Analysis,
    functions: &'a PhaseFunctions,
    model: &'a M,
    full: &'a M::State<f64>,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Compare<'_, M> {
    type Output = ();

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) {
        panic!("{:?} is no closed form", phase.set)
    }

    fn visit_closed<const N: usize, Q: ClosedForm<M, N>>(self, phase: Phase<M, f64, N>) {
        let (k, parameters) = (self.model.constants::<f64>(), self.model.parameters());
        let (parameters, full) = (parameters.as_ref(), self.full.as_ref());
        let reduced = (phase.restrict)(self.full);
        let value = |ids: &[_]| self.analysis.evaluate(ids, parameters, full);
        let functions = self.functions;
        let pivot = value(&functions.pivots).iter().fold(1.0_f64, |least, p| least.min(p.abs()));
        // Second derivatives of an eliminated coordinate have the cube of its pivot below them: so much rounding differs
        // where one side fuses its products.
        let tolerance = TOLERANCE / pivot.powi(3);
        let derivative = (phase.derivative)(&k, &phase.set, &reduced);
        close(&derivative[..N / 2], &reduced[N / 2..], "rates");
        close_to(&derivative[N / 2..], &value(&functions.accelerations), tolerance, "accelerations");
        let mut moving = full.to_vec();
        moving.extend(full.iter().skip(full.len() / 2).map(|_| f64::NAN));
        for (i, a) in functions.kept.iter().zip(&derivative[N / 2..]) {
            moving[full.len() + i] = *a;
        }
        let reactions = self.analysis.evaluate(&functions.reactions, parameters, &moving);
        close_to((phase.reactions)(&k, &phase.set, &reduced).as_ref(), &reactions, tolerance, "reactions");
        close_to((phase.embed)(&k, &reduced).as_ref(), &value(&functions.embedding), tolerance, "embedding");
        let Energy { kinetic, potential } = Q::energy(&k, &reduced);
        close_to(&[kinetic, potential], &value(&functions.energy), tolerance, "phase energy");
        assert_relative_eq!(Q::pivots(&k, &reduced).least, pivot, max_relative = TOLERANCE);
    }
}

fn check<M: BarSystem>(model: &M) {
    let analysis = analysis::<M>();
    let mut source = Source::new(7);
    for _ in 0..20 {
        let full = state::<M>(&mut source);
        kernel(&analysis, model, &full);
        for functions in &analysis.functions.phases {
            let compare = Compare { analysis: &analysis, functions, model, full: &full };
            M::phase(ContactSet::from_bits(functions.set.closed), Form::Reduced, compare);
        }
    }
}

first_models! {}
