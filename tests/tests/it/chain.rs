//! The loops for chains of equal bars against Newton–Euler in maximal coordinates.

use std::f64::consts::FRAC_PI_2;

use liftoff_core::chain::Chain;
use liftoff_tests::oracle::{Assembly, Body, Hinge, Mark, Pin, State};
use liftoff_tests::random::Source;
use nalgebra::Vector2;

/// Mass, length, inertia about the centre, gravity along x and y.
struct Bar {
    mass: f64,
    length: f64,
    inertia: f64,
    gravity: [f64; 2],
}

impl Bar {
    fn random(source: &mut Source) -> Self {
        let (mass, length) = (source.range(0.5, 2.0), source.range(0.5, 2.0));
        let inertia = mass * length * length * source.range(0.02, 0.3);
        Self { mass, length, inertia, gravity: [source.range(-10.0, 10.0), source.range(-10.0, 10.0)] }
    }

    fn chain(&self) -> Chain<f64> {
        Chain::new(self.mass, self.length, self.inertia, self.gravity)
    }

    fn assembly(&self, bars: usize) -> Assembly {
        let body =
            |k| Body { inertia: self.inertia, ..Body::uniform(&format!("bar{k}"), self.mass, self.length) };
        let hinge = |k| Hinge { first: Mark::along(k, self.length), second: Mark::along(k + 1, 0.0) };
        Assembly {
            bodies: (0..bars).map(body).collect(),
            hinges: (0..bars - 1).map(hinge).collect(),
            pins: vec![Pin { at: Mark::along(0, 0.0), ground: Vector2::zeros() }],
            gravity: Vector2::from(self.gravity),
            ..Assembly::default()
        }
    }
}

/// Both solve systems whose condition grows as the number of bars squared; the oracle's KKT system,
/// balanced and refined, loses two or three digits more.
fn tolerance(bars: usize) -> f64 {
    1000.0 * f64::EPSILON * (bars * bars) as f64
}

fn close(computed: &[f64], expected: &[f64]) {
    let size = expected.iter().fold(0.0f64, |size, x| size.max(x.abs()));
    for (k, (x, y)) in computed.iter().zip(expected).enumerate() {
        let error = (x - y).abs() / size;
        assert!(error <= tolerance(computed.len().max(4)), "{k} of {}: {x} for {y}", computed.len());
    }
}

fn compare<const N: usize>(bar: &Bar, angles: [f64; N], rates: [f64; N]) {
    let (chain, assembly) = (bar.chain(), bar.assembly(N));
    let state = assembly.state(&angles, &rates, &[]).expect("pinned");
    let motion = assembly.solve(&state, &[]).expect("regular");
    let turns: Vec<f64> = (0..N).map(|k| motion.angular(k)).collect();
    close(&chain.accelerations(&angles, &rates), &turns);
    let hinges = motion.hinges.iter().map(|on_first| -on_first);
    let forces: Vec<f64> = [motion.pins[0]].into_iter().chain(hinges).flat_map(|f| [f.x, f.y]).collect();
    close(chain.joint_forces(&angles, &rates).as_flattened(), &forces);
    sums(&chain, &assembly, &state, (angles, rates));
}

/// Energies and positions, and M ω̇ = f with the oracle's energy: T = ½ uᵀ M u, and f at rest is
/// −∂V/∂θ.
fn sums<const N: usize>(
    chain: &Chain<f64>,
    assembly: &Assembly,
    state: &State,
    (angles, rates): ([f64; N], [f64; N]),
) {
    let energy = chain.energy(&angles, &rates);
    close(&[energy.kinetic], &[assembly.kinetic_energy(state)]);
    let [potential, height] = [assembly.potential_energy(state), energy.potential];
    let most = 10.0 * assembly.bodies.iter().map(|body| body.mass * body.length).sum::<f64>() * N as f64;
    assert!((height - potential).abs() <= tolerance(N) * most, "{height} for {potential}");
    let mass = chain.mass_matrix(&angles);
    let momentum = |k: usize| (0..N).map(|j| mass[k][j] * rates[j]).sum::<f64>();
    let twice: f64 = (0..N).map(|k| rates[k] * momentum(k)).sum();
    close(&[0.5 * twice], &[energy.kinetic]);
    let positions: Vec<f64> = (0..N)
        .flat_map(|k| {
            let p = assembly.position(state, assembly.end(k));
            [p.x, p.y]
        })
        .collect();
    close(chain.positions(&angles).as_flattened(), &positions);
}

fn random<const N: usize>(source: &mut Source) {
    let bar = Bar::random(source);
    let angles = core::array::from_fn(|_| source.range(-4.0, 4.0));
    compare::<N>(&bar, angles, core::array::from_fn(|_| source.range(-3.0, 3.0)));
}

#[test]
fn random_states() {
    let mut source = Source::new(5);
    for _ in 0..20 {
        random::<1>(&mut source);
        random::<2>(&mut source);
        random::<3>(&mut source);
        random::<4>(&mut source);
        random::<7>(&mut source);
        random::<16>(&mut source);
    }
    random::<33>(&mut source);
    random::<64>(&mut source);
}

/// Every bar in one line, and every second folded back: the forces stay unique.
#[test]
fn stretched_and_folded() {
    let bar = Bar::random(&mut Source::new(8));
    let rates = core::array::from_fn(|k| (k as f64).sin());
    compare::<12>(&bar, [0.3; 12], rates);
    compare::<12>(&bar, core::array::from_fn(|k| 0.3 + 2.0 * FRAC_PI_2 * (k % 2) as f64), rates);
}
