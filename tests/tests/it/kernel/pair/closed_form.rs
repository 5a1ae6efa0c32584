//! Closed forms against the oracle.

use liftoff_codegen::functions::{HeldSolution, PhaseFunctions};
use liftoff_tests::oracle::State;

use super::{Full, Pair};

/// Closed forms are compared where no relative pivot is below this: their reduced M̂ grows with its
/// inverse square and the error with a higher power (1e-8 was seen at 0.03); nearer, the projected
/// form is used.
const CLEAR_PIVOT: f64 = 0.2;

impl Pair {
    /// The motion with a set closed, solved by this; false where its rows nearly repeat each other,
    /// or the motion is not definite.
    pub fn held(&self, solution: &HeldSolution, set: u64, state: &State) -> bool {
        let Some(motion) = self.motion(state, set) else {
            return false;
        };
        let full = self.full(state);
        let pivots = self.values(solution.pivots.as_flattened(), &full);
        // A Schur complement loses the inverse of its relative pivot, which leaves a dozen digits.
        let clear = pivots.chunks(2).all(|pair| pair[1] > 1e-3 * pair[0]);
        if clear {
            let accelerations = self.values(&solution.accelerations, &full);
            self.close("held accelerations", &accelerations, &self.accelerations(state, &motion));
            let force = self.values(&self.analysis.functions.kernel.force, &full);
            let force = force.iter().fold(1.0, |most: f64, f| most.max(f.abs()));
            let of_contacts = |multipliers: Vec<f64>| -> Vec<f64> {
                let contacts = self.analysis.motion.contacts.len();
                let rows = self.rows(set).into_iter().zip(multipliers);
                rows.filter(|(row, _)| *row < contacts).map(|(_, lambda)| lambda).collect()
            };
            let reactions = self.totals(&motion.reactions);
            let expected = of_contacts(
                self.rows(set).iter().map(|&row| reactions.get(row).copied().unwrap_or(0.0)).collect(),
            );
            let computed = of_contacts(self.values(&solution.multipliers, &full));
            self.close_to("held reactions", &computed, &expected, force);
        }
        clear
    }

    /// A closed form at the state's kept coordinates; false where its branch is another than the
    /// state's.
    pub fn closed_form(&self, phase: &PhaseFunctions, state: &State) -> bool {
        let Some(motion) = self.motion(state, phase.set.closed) else {
            return false;
        };
        let (known, n) = (self.full(state), self.analysis.motion.n);
        let Full(full) = &known;
        let reduced = self.reduced(phase, full);
        let value = |ids: &[_]| self.values(ids, &reduced);
        let pivots = value(&phase.pivots).into_iter().all(|pivot| pivot.abs() > CLEAR_PIVOT);
        if !pivots || !self.agree(&value(&phase.embedding)[..n], &full[..n]) {
            return false;
        }
        self.close("embedded rates", &value(&phase.embedding)[n..], &full[n..2 * n]);
        let all = self.accelerations(state, &motion);
        let expected: Vec<_> = phase.moving.iter().map(|&i| all[i]).collect();
        self.close("reduced accelerations", &value(&phase.accelerations), &expected);
        self.close("reduced reactions", &value(&phase.reactions), &self.totals(&motion.reactions));
        self.interpreted_form(phase, &known, [&value(&phase.accelerations), &value(&phase.reactions)]);
        let assembly = &self.sample.assembly;
        let energy = [assembly.kinetic_energy(state), assembly.potential_energy(state)];
        self.close("reduced energies", &value(&phase.energy), &energy);
        true
    }

    /// What a closed form reads: coordinates and rates that it does not keep are not numbers.
    fn reduced(&self, phase: &PhaseFunctions, full: &[f64]) -> Full {
        let n = self.analysis.motion.n;
        let kept = |(i, &x): (usize, &f64)| {
            let held = if i < n { &phase.kept } else { &phase.moving };
            if i >= 2 * n || held.contains(&(i % n)) { x } else { f64::NAN }
        };
        let mut state = Full(full.iter().enumerate().map(kept).collect());
        for (&i, a) in phase.moving.iter().zip(self.values(&phase.accelerations, &state)) {
            state.0[2 * n + i] = a;
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
