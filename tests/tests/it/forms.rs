//! One contact set, two forms: the closed form against the full equations with multipliers.
//!
//! Both solve the same linear equations in `f64`; away from singular positions their condition
//! numbers stay below 1e3, so 1e-11 relative is rounding and nothing else.

use liftoff_compiled::*;
use liftoff_core::model::{BarSystem, ClosedForm, Energy, Form, Phase, PhaseVisitor};
use liftoff_tests::random::Source;

const TOLERANCE: f64 = 1e-11;

fn close(computed: &[f64], expected: &[f64], what: &str) {
    let scale = expected.iter().fold(1.0_f64, |s, x| s.max(x.abs()));
    for (a, b) in computed.iter().zip(expected) {
        assert!((a - b).abs() <= TOLERANCE * scale, "{what}: {a:e} against {b:e}, scale {scale:e}");
    }
}

/// Motion and reactions at a state: `[u, a]` of the kept coordinates is compared by the caller.
struct Motion<M: BarSystem> {
    derivative: M::State<f64>,
    reactions: Vec<f64>,
    energy: Energy<f64>,
}

struct Projected<'a, M: BarSystem> {
    model: &'a M,
    full: M::State<f64>,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Projected<'_, M> {
    type Output = Motion<M>;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Motion<M> {
        assert_eq!(phase.form, Form::Multipliers);
        let k = self.model.constants::<f64>();
        let state = (phase.restrict)(&self.full);
        Motion {
            derivative: (phase.embed)(&k, &(phase.derivative)(&k, &phase.set, &state)),
            reactions: (phase.reactions)(&k, &phase.set, &state).as_ref().to_vec(),
            energy: M::energy(&k, &(phase.embed)(&k, &state)),
        }
    }
}

struct Closed<'a, M: BarSystem> {
    model: &'a M,
    source: &'a mut Source,
}

impl<M: BarSystem> PhaseVisitor<M, f64> for Closed<'_, M> {
    type Output = ();

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) {
        panic!("{:?} is no closed form", phase.set)
    }

    fn visit_closed<const N: usize, Q: ClosedForm<M, N>>(self, phase: Phase<M, f64, N>) {
        let k = self.model.constants::<f64>();
        let state: [f64; N] = core::array::from_fn(|_| self.source.range(0.2, 1.1));
        let full = (phase.embed)(&k, &state);
        let other = M::phase(phase.set, Form::Multipliers, Projected { model: self.model, full });
        let derivative = (phase.derivative)(&k, &phase.set, &state);
        close(&derivative, &(phase.restrict)(&other.derivative), "motion");
        close((phase.reactions)(&k, &phase.set, &state).as_ref(), &other.reactions, "reactions");
        let energy = Q::energy(&k, &state);
        close(&[energy.kinetic, energy.potential], &[other.energy.kinetic, other.energy.potential], "energy");
    }
}

fn check<M: BarSystem>(model: &M, sets: usize) {
    assert_eq!(M::LAYOUT.closed_forms.len(), sets, "closed forms: {:?}", M::LAYOUT.closed_forms);
    let mut source = Source::new(11);
    for &set in M::LAYOUT.closed_forms {
        for _ in 0..20 {
            M::phase(set, Form::Reduced, Closed { model, source: &mut source });
        }
    }
}

macro_rules! models {
    ($($name:ident: $model:expr, $sets:literal;)*) => {
        $(#[test] fn $name() { check(&$model, $sets); })*
    };
}

models! {
    falling_pair: FallingPair { m: 1.3, l: 0.7, g: 9.81 }, 2;
    falling_pair_full: FallingPairFull { m: 1.3, l: 0.7, g: 9.81 }, 4;
    zigzag_published: ZigzagPublished { m1: 0.4, m2: 0.9, l: 0.7, g: 9.81 }, 4;
    zigzag: Zigzag { m1: 0.4, m2: 0.9, l: 0.7, g: 9.81 }, 8;
    zigzag_full: ZigzagFull { m1: 0.4, m2: 0.9, l: 0.7, g: 9.81 }, 27;
    ladder: Ladder { m: 1.3, l: 0.7, g: 9.81 }, 4;
    rod_on_floor: RodOnFloor { m: 1.3, l: 0.7, g: 9.81 }, 2;
    a_frame: AFrame { m: 1.3, l: 0.7, g: 9.81 }, 2;
    pendulum: Pendulum { m: 1.3, l: 0.7, g: 9.81 }, 1;
    double_pendulum: DoublePendulum { m: 1.3, l: 0.7, g: 9.81 }, 1;
}

/// A ladder whose contact sets get own code in one struct and share the full equations in the
/// other.
mod limits {
    use liftoff::prelude::*;

    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[support(A = floor)]
    #[support(B = wall(0), facing = right)]
    #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
    #[coordinate(phi = angle(AB), from = horizontal)]
    pub struct Own {
        pub m: f64,
        pub l: f64,
        pub g: f64,
    }

    #[derive(BarSystem)]
    #[liftoff(sets = 1)]
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[support(A = floor)]
    #[support(B = wall(0), facing = right)]
    #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))]
    #[coordinate(phi = angle(AB), from = horizontal)]
    pub struct Shared {
        pub m: f64,
        pub l: f64,
        pub g: f64,
    }
}

#[test]
fn own_code_and_the_masked_kernel_run_alike() {
    use liftoff::prelude::*;

    fn events<M: BarSystem>(model: &M) -> Vec<(EventKind, f64)> {
        let run = Simulation::new(model).map(|s| s.start(Pose::new("phi", 1.2)).expect("a start"));
        let run = run.expect("a model").until("phi = 0").expect("a condition").run().expect("a run");
        run.events().iter().map(|event| (event.kind, event.t)).collect()
    }

    let (own, shared) = (limits::Own { m: 1.0, l: 1.0, g: 9.81 }, limits::Shared { m: 1.0, l: 1.0, g: 9.81 });
    assert_eq!((limits::Own::LAYOUT.closed_forms.len(), limits::Shared::LAYOUT.closed_forms.len()), (4, 1));
    let (own, shared) = (events(&own), events(&shared));
    assert_eq!(own.len(), shared.len());
    for (own, shared) in own.iter().zip(&shared) {
        assert!(own.0 == shared.0 && (own.1 - shared.1).abs() < 1e-10, "{own:?} {shared:?}");
    }
}
