//! A random system, derived by the generator and by the oracle, and comparisons of the two.
//!
//! Tolerance relative to the largest value of the kind: 1e-10 for bars, hinges and lines, 1e-9 for
//! the whole vocabulary. Both sides solve systems whose balanced pivots are above 1e-4, so that a
//! dozen digits are left.

mod closed_form;
mod impact;
mod interpreted;

use core::f64::consts::FRAC_PI_2;
pub use impact::Met;
use liftoff_codegen::motion::ClosedSet;
use liftoff_codegen::program::Id;
use liftoff_codegen::system::{CoordinateKind, Reference};
use liftoff_codegen::{Analysis, Unfolded, analyse, kinematics};
use liftoff_tests::oracle::{Contact, Coordinate, Motion, Place, State};
use liftoff_tests::random::{Sample, Vocabulary, sample_of};
use nalgebra::{DMatrix, DVector};
use proc_macro2::TokenStream;

const LEAST_PIVOT: f64 = 1e-4;

/// One system, derived by both.
pub struct Pair {
    pub seed: u64,
    pub tolerance: f64,
    pub sample: Sample,
    pub analysis: Analysis,
    pub parameters: Vec<f64>,
}

/// The state of a model as its functions read it: coordinates, rates, accelerations, multipliers of
/// all rows, t. What is not known is not a number.
pub struct Full(Vec<f64>);

/// Accelerations and the multiplier of every row.
pub struct Solved {
    accelerations: Vec<f64>,
    multipliers: Vec<f64>,
}

impl Pair {
    /// With all closed forms.
    pub fn new(seed: u64, vocabulary: Vocabulary) -> Self {
        Self::derived(seed, vocabulary, TokenStream::new())
    }

    /// With no closed form: the full equations need none.
    pub fn without_phases(seed: u64, vocabulary: Vocabulary) -> Self {
        Self::derived(seed, vocabulary, "#[liftoff(sets = 0)]".parse().expect("an attribute"))
    }

    /// Both halves of a mirrored one; none of one without mirror.
    pub fn unfolded(seed: u64, vocabulary: Vocabulary) -> Option<Self> {
        if !sample_of(seed, vocabulary).is_mirrored() {
            return None;
        }
        let mirrored = Self::without_phases(seed, vocabulary);
        let unfolded = Unfolded::from_tokens(mirrored.analysis.system.declaration.parse().expect("tokens"));
        let unfolded =
            unfolded.unwrap_or_else(|error| panic!("seed {seed}: {error}\n{}", mirrored.sample.declaration));
        Some(Self { analysis: unfolded.analysis, sample: mirrored.sample.unfolded(), ..mirrored })
    }

    fn derived(seed: u64, vocabulary: Vocabulary, mut tokens: TokenStream) -> Self {
        let sample = sample_of(seed, vocabulary);
        tokens.extend(sample.tokens().expect("declarations are Rust"));
        let analysis = analyse(tokens).unwrap_or_else(|errors| {
            let told: Vec<_> = errors.into_iter().map(|e| e.to_string()).collect();
            panic!("seed {seed}: {told:#?}\n{}", sample.declaration)
        });
        let parameters = sample.parameters.iter().map(|(_, value)| *value).collect();
        let tolerance = if vocabulary == Vocabulary::BARS { 1e-10 } else { 1e-9 };
        Self { seed, tolerance, sample, analysis, parameters }
    }

    fn values(&self, ids: &[Id], full: &Full) -> Vec<f64> {
        self.analysis.evaluate(ids, &self.parameters, &full.0)
    }

    fn close(&self, what: &str, computed: &[f64], expected: &[f64]) {
        self.close_to(what, computed, expected, 1.0);
    }

    /// Equal within the tolerance relative to the largest expected value, or to `least` if that is
    /// larger.
    fn close_to(&self, what: &str, computed: &[f64], expected: &[f64], least: f64) {
        assert_eq!(computed.len(), expected.len(), "seed {}: {what}", self.seed);
        let scale = expected.iter().fold(least, |scale: f64, x| scale.max(x.abs()));
        for (a, b) in computed.iter().zip(expected) {
            let error = (a - b).abs() / scale;
            let Self { seed, sample, .. } = self;
            assert!(
                error <= self.tolerance,
                "seed {seed}, {what}: {computed:?} for {expected:?}\n{}",
                sample.declaration
            );
        }
    }

    /// An oracle state as the model's functions read it.
    fn full(&self, state: &State) -> Full {
        let measured = self.analysis.kinematics.coordinates.iter().map(|coordinate| {
            let reading = self.reading(coordinate);
            self.sample.assembly.measure(state, &reading)
        });
        let measured: Vec<_> = measured.collect();
        let mut full: Vec<_> = (0..2).flat_map(|order| measured.iter().map(move |m| m[order])).collect();
        full.resize(3 * self.analysis.motion.n + self.analysis.motion.rows.len(), f64::NAN);
        full.push(state.time);
        Full(full)
    }

    fn accelerations(&self, state: &State, motion: &Motion) -> Vec<f64> {
        let coordinates = self.analysis.kinematics.coordinates.iter();
        coordinates
            .map(|c| self.reading(c))
            .map(|reading| self.sample.assembly.second_rate(state, motion, &reading))
            .collect()
    }

    /// What the oracle measures for a coordinate; of one that the sample has not declared, as an
    /// image, what it says.
    fn reading(&self, coordinate: &kinematics::Coordinate) -> Coordinate {
        let Self { analysis: Analysis { system, .. }, sample, .. } = self;
        let body = |body: usize| sample.assembly.body(&system.bodies[body].name).expect("a body");
        let said = || match &coordinate.reading {
            CoordinateKind::Position { point, axis, sign } => {
                let at = sample.points[&system.points[*point].name];
                Coordinate::Position { at, axis: *axis, sign: f64::from(*sign) }
            }
            CoordinateKind::Angle { body: of, reference: Reference::Ground(angle), sign } => {
                let sign = f64::from(*sign);
                let offset = sign * f64::from(angle.quarter_turns()) * FRAC_PI_2;
                Coordinate::Angle { terms: vec![(body(*of), sign)], offset }
            }
            CoordinateKind::Angle { body: of, reference: Reference::Body(from), sign } => {
                let sign = f64::from(*sign);
                Coordinate::Angle { terms: vec![(body(*of), sign), (body(*from), -sign)], offset: 0.0 }
            }
        };
        sample.coordinate(&coordinate.name).unwrap_or_else(said)
    }

    /// Sums over the members of each contact, which may unite several supports.
    fn totals(&self, of: &[f64]) -> Vec<f64> {
        let contacts = self.analysis.motion.contacts.iter();
        contacts.map(|contact| contact.supports.iter().map(|&s| of[s]).sum()).collect()
    }

    /// Supports of a set of contacts: one of each, or all where images act together.
    pub fn supports(&self, set: u64) -> Vec<usize> {
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

    /// Whether two descriptions of a set's gaps or slips agree only where they are closed.
    fn must_touch(&self, set: u64) -> bool {
        self.supports(set).into_iter().any(|support| {
            let support = &self.sample.assembly.supports[support];
            support.rough || matches!(support.contact, Contact::Circle { .. } | Contact::Thread { .. })
        })
    }

    /// A state in which a set may be closed.
    pub fn touching(&self, state: &State, set: u64) -> Option<State> {
        match self.must_touch(set) {
            true => self.sample.assembly.settle(state.clone(), &self.supports(set)),
            false => Some(state.clone()),
        }
    }

    pub fn positions(&self, state: &State) {
        let points = self.values(&self.analysis.functions.points, &self.full(state));
        let names = self.analysis.system.points.iter().map(|point| &point.name);
        let places = names.map(|name| self.sample.points[name]);
        let expected = places.map(|place| self.sample.assembly.position(state, place));
        let expected: Vec<_> = expected.flat_map(|p| [p.x, p.y]).collect();
        self.close("points", &points, &expected);
    }

    pub fn energies(&self, state: &State) {
        let energy = self.values(&self.analysis.functions.energy, &self.full(state));
        let assembly = &self.sample.assembly;
        let expected = [assembly.kinetic_energy(state), assembly.potential_energy(state)];
        self.close("energies", &energy, &expected);
    }

    pub fn gaps(&self, state: &State) {
        let (full, n) = (self.full(state), self.analysis.motion.n);
        let kernel = &self.analysis.functions.kernel;
        for (index, contact) in self.analysis.motion.contacts.iter().enumerate() {
            let jacobian = self.values(&kernel.jacobian[index], &full);
            let rate: f64 = jacobian.iter().zip(&full.0[n..]).map(|(j, u)| j * u).sum();
            let gap = self.values(&kernel.gap[index..=index], &full)[0];
            for &support in &contact.supports {
                let forms = self.forms(state, support);
                let off = |form: &[f64; 2]| (form[0] - gap).abs() + (form[1] - rate).abs();
                let nearest = forms.iter().min_by(|a, b| off(a).total_cmp(&off(b))).expect("one at least");
                self.close("gap", &[gap, rate], nearest);
            }
        }
    }

    /// The oracle's gap and its rate, also as a model may have them: for a distance r limited by R
    /// as ± (r² − R²)/2R, which is the same where it is closed; of a thread r is a segment and the
    /// others are fixed.
    fn forms(&self, state: &State, support: usize) -> Vec<[f64; 2]> {
        let assembly = &self.sample.assembly;
        let [gap, rate] = assembly.gap(state, support);
        let distance =
            |a: Place, b: Place| (assembly.position(state, a) - assembly.position(state, b)).norm();
        let quadratic = |r: f64, limit: f64| [gap * (r + limit) / (2.0 * limit), rate * r / limit];
        match &assembly.supports[support].contact {
            Contact::Point { .. } | Contact::Corner { .. } => vec![[gap, rate]],
            Contact::Circle { point, centre, radius, .. } => {
                vec![quadratic(distance(*point, Place::Ground(*centre)), *radius)]
            }
            Contact::Thread { path, .. } => {
                let segments = path.windows(2).map(|ends| distance(ends[0], ends[1]));
                segments.map(|r| quadratic(r, r + gap)).chain([[gap, rate]]).collect()
            }
        }
    }

    /// The rows that hold in a set.
    pub fn rows(&self, set: u64) -> Vec<usize> {
        let motion = &self.analysis.motion;
        (0..motion.rows.len()).filter(|&row| motion.is_closed(row, ClosedSet::without_stick(set))).collect()
    }

    /// M, full.
    pub fn mass(&self, full: &Full) -> DMatrix<f64> {
        let n = self.analysis.motion.n;
        let mass = self.analysis.mass(&self.parameters, &full.0);
        DMatrix::from_fn(n, n, |i, j| mass[i][j])
    }

    /// M a = f + Jᵀ λ, J a + b = 0 over the joints and the closed contacts.
    fn solved(&self, full: &Full, set: u64) -> Solved {
        let (kernel, n) = (&self.analysis.functions.kernel, self.analysis.motion.n);
        let rows = self.rows(set);
        let mut matrix = DMatrix::zeros(n + rows.len(), n + rows.len());
        matrix.view_mut((0, 0), (n, n)).copy_from(&self.mass(full));
        let mut right = self.values(&kernel.force, full);
        for (k, &row) in rows.iter().enumerate() {
            for (j, entry) in self.values(&kernel.jacobian[row], full).into_iter().enumerate() {
                matrix[(n + k, j)] = entry;
                matrix[(j, n + k)] = entry;
            }
            right.push(-self.values(&kernel.bias[row..=row], full)[0]);
        }
        let solution = matrix.full_piv_lu().solve(&DVector::from_vec(right)).expect("regular");
        let mut multipliers = vec![0.0; self.analysis.motion.rows.len()];
        for (k, &row) in rows.iter().enumerate() {
            multipliers[row] = -solution[n + k];
        }
        Solved { accelerations: solution.as_slice()[..n].to_vec(), multipliers }
    }

    /// The full equations with a contact set against the oracle; false where the motion is not
    /// definite.
    pub fn kernel(&self, state: &State, set: u64) -> bool {
        let Some(motion) = self.motion(state, set) else {
            return false;
        };
        let (mut full, n) = (self.full(state), self.analysis.motion.n);
        let Solved { accelerations, multipliers } = self.solved(&full, set);
        let contacts = self.analysis.motion.contacts.len();
        self.close("accelerations", &accelerations, &self.accelerations(state, &motion));
        // Forces are differences of terms of the size of the forces on the coordinates.
        let force = self.values(&self.analysis.functions.kernel.force, &full);
        let force = force.iter().fold(1.0, |most: f64, f| most.max(f.abs()));
        self.close_to("reactions", &multipliers[..contacts], &self.totals(&motion.reactions), force);
        let tangents = &self.analysis.motion.tangents;
        let slips = multipliers.len() - tangents.len();
        let tangential = self.totals(&motion.tangential);
        let tangential: Vec<_> = tangents.iter().map(|&contact| tangential[contact]).collect();
        self.close_to("tangential reactions", &multipliers[slips..], &tangential, force);
        // It is the same arithmetic: of some that it is read rightly.
        if self.seed.is_multiple_of(4) {
            self.interpreted(&full, set, &accelerations, &multipliers, force);
        }
        full.0[2 * n..3 * n].copy_from_slice(&accelerations);
        full.0[3 * n..3 * n + multipliers.len()].copy_from_slice(&multipliers);
        self.quantities(state, &motion, &full, force);
        true
    }

    /// Joint forces, internal forces, momenta, … by name. Those of a mirrored loop are not known,
    /// nor those of bodies on supports of which only the total reaction is.
    fn quantities(&self, state: &State, motion: &Motion, full: &Full, force: f64) {
        let named = &self.analysis.functions.quantities;
        let asked = self.sample.asked.iter().filter_map(|(name, asked)| {
            let found = named.iter().find(|quantity| quantity.name == *name);
            let known = !self.sample.is_mirrored() && self.analysis.motion.contacts.iter().all(|c| c.shared);
            assert!(found.is_some() || !known, "seed {}: no {name}", self.seed);
            Some((name, found?.value, asked.value(&self.sample.assembly, state, motion)))
        });
        for (name, id, expected) in asked {
            self.close_to(name, &self.values(&[id], full), &[expected], force);
        }
    }
}
