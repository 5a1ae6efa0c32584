//! What the generator derives of random systems, by its interpreter, against the oracle: positions, energies,
//! gaps, accelerations, reactions; the full kernel and the closed forms.
//!
//! Tolerance 1e-10 relative to the largest value of the kind: both sides solve systems whose balanced pivots
//! are above 1e-4, so that a dozen digits are left.

use std::ops::Range;

use liftoff_codegen::functions::PhaseFunctions;
use liftoff_codegen::{Analysis, analyse};
use liftoff_tests::oracle::{Motion, State};
use liftoff_tests::random::{Sample, Source, sample};
use nalgebra::{DMatrix, DVector};

const TOLERANCE: f64 = 1e-10;
const LEAST_PIVOT: f64 = 1e-4;
/// Closed forms are compared where no relative pivot is below this: their reduced M̂ grows with its inverse
/// square and the error with a higher power (1e-8 was seen at 0.03); nearer, the projected form is used.
const CLEAR_PIVOT: f64 = 0.2;

/// One system, derived by both.
struct Pair {
    seed: u64,
    sample: Sample,
    analysis: Analysis,
    parameters: Vec<f64>,
}

impl Pair {
    fn new(seed: u64) -> Self {
        let sample = sample(seed);
        let tokens = sample.tokens().expect("declarations are Rust");
        let analysis = analyse(tokens).unwrap_or_else(|errors| {
            let told: Vec<_> = errors.into_iter().map(|e| e.to_string()).collect();
            panic!("seed {seed}: {told:#?}\n{}", sample.declaration)
        });
        let parameters = sample.parameters.iter().map(|(_, value)| *value).collect();
        Self { seed, sample, analysis, parameters }
    }

    fn close(&self, what: &str, computed: &[f64], expected: &[f64]) {
        assert_eq!(computed.len(), expected.len(), "seed {}: {what}", self.seed);
        let scale = expected.iter().fold(1.0, |scale: f64, x| scale.max(x.abs()));
        for (a, b) in computed.iter().zip(expected) {
            let error = (a - b).abs() / scale;
            let Self { seed, sample, .. } = self;
            assert!(
                error <= TOLERANCE,
                "seed {seed}, {what}: {computed:?} for {expected:?}\n{}",
                sample.declaration
            );
        }
    }

    /// The generator's coordinates, then their rates, of an oracle state.
    fn coordinates(&self, state: &State) -> Vec<f64> {
        let measured = self.analysis.kinematics.coordinates.iter().map(|coordinate| {
            let reading = self.sample.coordinate(&coordinate.name);
            let reading = reading.unwrap_or_else(|| panic!("no coordinate {}", coordinate.name));
            self.sample.assembly.measure(state, &reading)
        });
        let measured: Vec<_> = measured.collect();
        (0..2).flat_map(|order| measured.iter().map(move |m| m[order])).collect()
    }

    fn accelerations(&self, state: &State, motion: &Motion) -> Vec<f64> {
        let coordinates = self.analysis.kinematics.coordinates.iter();
        let readings = coordinates.filter_map(|c| self.sample.coordinate(&c.name));
        readings.map(|reading| self.sample.assembly.second_rate(state, motion, &reading)).collect()
    }

    /// Total reaction of each contact, which may unite several supports.
    fn reactions(&self, motion: &Motion) -> Vec<f64> {
        let contacts = self.analysis.motion.contacts.iter();
        contacts.map(|contact| contact.supports.iter().map(|&s| motion.reactions[s]).sum()).collect()
    }

    /// Supports of a set of contacts: one of each, or all where images act together.
    fn supports(&self, set: u64) -> Vec<usize> {
        let contacts = self.analysis.motion.contacts.iter().enumerate();
        let closed = contacts.filter(|(i, _)| set >> i & 1 == 1);
        let count = if self.sample.is_mirrored() { usize::MAX } else { 1 };
        closed.flat_map(|(_, contact)| contact.supports.iter().copied().take(count)).collect()
    }

    /// The oracle's motion, where it is definite.
    fn motion(&self, state: &State, set: u64) -> Option<Motion> {
        let motion = self.sample.assembly.solve(state, &self.supports(set)).ok()?;
        (motion.unique && motion.pivots > LEAST_PIVOT).then_some(motion)
    }

    fn positions(&self, state: &State) {
        let full = self.coordinates(state);
        let points = self.analysis.evaluate(&self.analysis.functions.points, &self.parameters, &full);
        let names = self.analysis.system.points.iter().map(|point| &point.name);
        let marks = names.map(|name| self.sample.points[name]);
        let expected = marks.map(|mark| self.sample.assembly.position(state, mark));
        let expected: Vec<_> = expected.flat_map(|p| [p.x, p.y]).collect();
        self.close("points", &points, &expected);
    }

    fn energies(&self, state: &State) {
        let full = self.coordinates(state);
        let energy = self.analysis.evaluate(&self.analysis.functions.energy, &self.parameters, &full);
        let assembly = &self.sample.assembly;
        let expected = [assembly.kinetic_energy(state), assembly.potential_energy(state)];
        self.close("energies", &energy, &expected);
    }

    fn gaps(&self, state: &State) {
        let (full, n) = (self.coordinates(state), self.analysis.motion.n);
        let kernel = &self.analysis.functions.kernel;
        for (index, contact) in self.analysis.motion.contacts.iter().enumerate() {
            let value = |ids: &[_]| self.analysis.evaluate(ids, &self.parameters, &full);
            let rate = value(&kernel.jacobian[index]).iter().zip(&full[n..]).map(|(j, u)| j * u).sum();
            let gap = value(&kernel.gap[index..=index])[0];
            for &support in &contact.supports {
                self.close("gap", &[gap, rate], &self.sample.assembly.gap(state, support));
            }
        }
    }

    /// M a = f + Jᵀ λ, J a + b = 0 over the joints and the closed contacts, against the oracle.
    fn kernel(&self, state: &State, set: u64) -> bool {
        let Some(motion) = self.motion(state, set) else {
            return false;
        };
        let full = self.coordinates(state);
        let (kernel, n) = (&self.analysis.functions.kernel, self.analysis.motion.n);
        let value = |ids: &[_]| self.analysis.evaluate(ids, &self.parameters, &full);
        let contacts = self.analysis.motion.contacts.len();
        let closed = |row: usize| row >= contacts || set >> row & 1 == 1;
        let rows: Vec<_> = (0..kernel.gap.len()).filter(|&row| closed(row)).collect();
        let mut matrix = DMatrix::zeros(n + rows.len(), n + rows.len());
        for (i, ids) in kernel.mass.iter().enumerate() {
            for (j, entry) in value(ids).into_iter().enumerate() {
                matrix[(i, j)] = entry;
                matrix[(j, i)] = entry;
            }
        }
        let mut right = value(&kernel.force);
        for (k, &row) in rows.iter().enumerate() {
            for (j, entry) in value(&kernel.jacobian[row]).into_iter().enumerate() {
                matrix[(n + k, j)] = entry;
                matrix[(j, n + k)] = entry;
            }
            right.push(-value(&kernel.bias[row..=row])[0]);
        }
        let solution = matrix.full_piv_lu().solve(&DVector::from_vec(right)).expect("regular");
        let mut reactions = vec![0.0; contacts];
        for (k, &row) in rows.iter().enumerate().filter(|(_, row)| **row < contacts) {
            reactions[row] = -solution[n + k];
        }
        self.close("accelerations", &solution.as_slice()[..n], &self.accelerations(state, &motion));
        self.close("reactions", &reactions, &self.reactions(&motion));
        true
    }

    /// A closed form at the state's kept coordinates; false where its branch is another than the state's.
    fn closed_form(&self, phase: &PhaseFunctions, state: &State) -> bool {
        let Some(motion) = self.motion(state, phase.set) else {
            return false;
        };
        let (full, n) = (self.coordinates(state), self.analysis.motion.n);
        let reduced = self.reduced(phase, &full);
        let value = |ids: &[_]| self.analysis.evaluate(ids, &self.parameters, &reduced);
        let pivots = value(&phase.pivots).into_iter().all(|pivot| pivot.abs() > CLEAR_PIVOT);
        if !pivots || !self.agree(&value(&phase.embedding)[..n], &full[..n]) {
            return false;
        }
        self.close("embedded rates", &value(&phase.embedding)[n..], &full[n..]);
        let all = self.accelerations(state, &motion);
        let expected: Vec<_> = phase.kept.iter().map(|&i| all[i]).collect();
        self.close("reduced accelerations", &value(&phase.accelerations), &expected);
        self.close("reduced reactions", &value(&phase.reactions), &self.reactions(&motion));
        let assembly = &self.sample.assembly;
        let energy = [assembly.kinetic_energy(state), assembly.potential_energy(state)];
        self.close("reduced energies", &value(&phase.energy), &energy);
        true
    }

    /// Coordinates, rates and accelerations of a closed form: those it does not keep are not numbers.
    fn reduced(&self, phase: &PhaseFunctions, full: &[f64]) -> Vec<f64> {
        let n = self.analysis.motion.n;
        let kept = |(i, &x): (usize, &f64)| {
            if phase.kept.contains(&(i % n)) { x } else { f64::NAN }
        };
        let mut state: Vec<_> = full.iter().enumerate().map(kept).collect();
        let accelerations = self.analysis.evaluate(&phase.accelerations, &self.parameters, &state);
        state.resize(3 * n, f64::NAN);
        for (&i, a) in phase.kept.iter().zip(accelerations) {
            state[2 * n + i] = a;
        }
        state
    }

    /// Whether the coordinates are the same, angles up to whole turns.
    fn agree(&self, computed: &[f64], expected: &[f64]) -> bool {
        let coordinates = self.analysis.kinematics.coordinates.iter();
        coordinates.zip(computed.iter().zip(expected)).all(|(coordinate, (a, b))| {
            let turn = std::f64::consts::TAU;
            let turns = if coordinate.is_angle() { ((a - b) / turn).round() * turn } else { 0.0 };
            (a - b - turns).abs() < 1e-9
        })
    }
}

/// Checks the kernel of each system with a random contact set; how many comparisons were made.
fn kernels(seeds: Range<u64>) -> usize {
    let mut compared = 0;
    for seed in seeds {
        let pair = Pair::new(seed);
        let mut source = Source::new(seed ^ 0x5eed);
        let Some(state) = pair.sample.state(&mut source) else {
            continue;
        };
        pair.positions(&state);
        pair.energies(&state);
        pair.gaps(&state);
        let sets = 1 << pair.analysis.motion.contacts.len();
        let set = source.below(sets) as u64;
        compared += usize::from(pair.kernel(&state, 0)) + usize::from(pair.kernel(&state, set));
    }
    compared
}

/// A thousand systems in four tests, which run side by side.
fn quarter(index: u64) {
    let compared = kernels(250 * index..250 * (index + 1));
    assert!(compared >= 375, "only {compared} comparisons were made");
}

#[test]
fn kernels_of_random_systems_0_to_249() {
    quarter(0);
}

#[test]
fn kernels_of_random_systems_250_to_499() {
    quarter(1);
}

#[test]
fn kernels_of_random_systems_500_to_749() {
    quarter(2);
}

#[test]
fn kernels_of_random_systems_750_to_999() {
    quarter(3);
}

#[test]
fn closed_forms_of_random_systems() {
    let (mut compared, mut reduced) = (0, 0);
    for seed in 0..300 {
        let pair = Pair::new(seed);
        let mut source = Source::new(seed ^ 0xc105ed);
        for phase in &pair.analysis.functions.phases {
            let start = pair.sample.state(&mut source);
            let settled = start.and_then(|s| pair.sample.assembly.settle(s, &pair.supports(phase.set)));
            if settled.is_some_and(|state| pair.closed_form(phase, &state)) {
                compared += 1;
                reduced += usize::from(phase.set != 0);
            }
        }
    }
    assert!(compared >= 300 && reduced >= 150, "{compared} forms compared, {reduced} with contacts");
}
