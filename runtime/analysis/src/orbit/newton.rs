//! Newton's method on the return map, with steps halved where the return fails or comes out worse.

use liftoff::Trajectory;
use nalgebra::{Complex, DMatrix, DVector};

use super::surface::{OrbitParameters, Surface, solve};
use super::turn::{Turn, sequence};
use super::{Orbit, OrbitError, ReturnMap};

/// A state that comes back to within this, in natural units, is as good as runs at a tolerance of
/// 1e-12 tell.
pub(super) const FOUND: f64 = 5e-12;
/// One that stays within this where nothing improves it is found too.
pub(super) const ACCEPTED: f64 = 1e-9;
const ITERATIONS: usize = 40;
/// Halvings of a step.
const HALVINGS: usize = 8;
/// A shifted orbit misses by less: the tolerance of runs, grown over a turn.
const EQUIVARIANT: f64 = 1e-7;
/// A motion that stays as near to its start, in natural units, is none: a state is found within far
/// less.
const AT_REST: f64 = 1e-8;
/// Places of a turn at which it is looked for a motion.
const LOOKS: u32 = 16;
/// A multiplier below this is zero.
const ZERO: f64 = 1e-8;

/// A turn from a surface, and how far it is from coming back.
pub(super) struct Attempt {
    pub(super) surface: Surface,
    pub(super) turn: Turn,
    /// P(x) − x in natural units, zero in the entries that drift.
    pub(super) miss: DVector<f64>,
}

impl Attempt {
    pub(super) fn residual(&self) -> f64 {
        self.miss.amax()
    }

    /// ∂P/∂x T − T.
    pub(super) fn slopes(&self, drifting: &[usize]) -> DMatrix<f64> {
        let mut slopes = &self.turn.slopes - &self.surface.basis;
        drifting.iter().for_each(|&entry| slopes.row_mut(entry).fill(0.0));
        slopes
    }
}

impl ReturnMap<'_> {
    /// The periodic orbit near the motion from a state, with these parameters.
    ///
    /// # Errors
    /// The motion does not come to the section; it has no derivatives; Newton's method finds no
    /// fixed point; what is said to drift changes the motion.
    pub fn orbit(&self, parameters: &[f64], state: &[f64]) -> Result<Orbit, OrbitError> {
        let first = self.follow(parameters, state)?;
        let units = first.scales().state(first.layout())[..state.len()].to_vec();
        let parameters = parameters.to_vec();
        let at = OrbitParameters { parameters, varied: None, unit: 1.0, units, scales: first.scales() };
        let from =
            if self.section.time(&at.parameters).is_some() { state.to_vec() } else { first.final_state() };
        let found = self.newton(&at, self.attempt(&at, &from, None)?)?;
        if is_at_rest(&at, &found.turn.run) {
            return Err(OrbitError::AtRest);
        }
        self.check_shift(&at, &found)?;
        Ok(self.orbit_of(&at, &found))
    }

    pub(super) fn attempt(
        &self,
        at: &OrbitParameters,
        state: &[f64],
        from: Option<&Surface>,
    ) -> Result<Attempt, OrbitError> {
        let surface = self.surface(at, state, from)?;
        if surface.basis.ncols() == 0 {
            return Err(OrbitError::Held { section: self.section.to_string() });
        }
        let turn = self.turn(at, &surface)?;
        let start = &turn.run.events()[0].state;
        let mut miss = DVector::from_fn(at.units.len(), |i, _| turn.end[i] - start[i] / at.units[i]);
        self.drifting.iter().for_each(|&entry| miss[entry] = 0.0);
        Ok(Attempt { surface, turn, miss })
    }

    fn newton(&self, at: &OrbitParameters, mut now: Attempt) -> Result<Attempt, OrbitError> {
        for iterations in 0..ITERATIONS {
            if now.residual() <= FOUND {
                return Ok(now);
            }
            let step = &now.surface.basis * solve(&now.slopes(&self.drifting), &-&now.miss);
            match self.improved(at, &now, &step) {
                Some(next) => now = next,
                None if now.residual() <= ACCEPTED => return Ok(now),
                None => return Err(self.not_found(&now, iterations)),
            }
        }
        Err(self.not_found(&now, ITERATIONS))
    }

    /// The first of the halved steps that comes out better; of what is found already the whole one
    /// alone.
    fn improved(&self, at: &OrbitParameters, now: &Attempt, step: &DVector<f64>) -> Option<Attempt> {
        let halvings = if now.residual() <= ACCEPTED { 1 } else { HALVINGS };
        (0..halvings).find_map(|halvings| {
            let factor = 0.5f64.powi(halvings as i32);
            let state = now.surface.state.iter().zip(step.iter().zip(&at.units));
            let state: Vec<f64> = state.map(|(x, (by, unit))| x + factor * by * unit).collect();
            let next = self.attempt(at, &state, Some(&now.surface)).ok()?;
            (next.residual() < now.residual()).then_some(next)
        })
    }

    pub(super) fn not_found(&self, now: &Attempt, iterations: usize) -> OrbitError {
        let names = now.turn.run.layout().names_of_state();
        let state = names.zip(&now.surface.state).map(|(name, x)| format!("{name} = {x}"));
        let state = state.collect::<Vec<_>>().join(", ");
        OrbitError::NotFound { iterations, residual: now.residual(), state }
    }

    /// Whether one more turn, from the shifted state, is the same.
    fn check_shift(&self, at: &OrbitParameters, found: &Attempt) -> Result<(), OrbitError> {
        if self.drifting.is_empty() {
            return Ok(());
        }
        let first: &Trajectory = &found.turn.run;
        let second = self.follow(&at.parameters, &first.final_state())?;
        let [start, end, next] = [first.events()[0].state.clone(), first.final_state(), second.final_state()];
        let apart = |i: usize| {
            let shift = if self.drifting.contains(&i) { end[i] - start[i] } else { 0.0 };
            (next[i] - end[i] - shift).abs() / at.units[i]
        };
        let worst = (0..start.len()).max_by(|&a, &b| apart(a).total_cmp(&apart(b)));
        match worst.filter(|&i| apart(i) > EQUIVARIANT) {
            Some(i) => {
                let (coordinates, n) = (first.layout().coordinates, first.layout().coordinates.len());
                let entry = format!("{}{}", coordinates[i % n].name, if i < n { "" } else { "'" });
                Err(OrbitError::NotEquivariant { entry, apart: apart(i) })
            }
            None => Ok(()),
        }
    }

    pub(super) fn orbit_of(&self, at: &OrbitParameters, found: &Attempt) -> Orbit {
        let start = &found.turn.run.events()[0].state;
        let shift = |i: usize| {
            if self.drifting.contains(&i) { found.turn.end[i] * at.units[i] - start[i] } else { 0.0 }
        };
        Orbit {
            parameters: at.parameters.clone(),
            state: start.clone(),
            period: found.turn.period,
            shift: (0..start.len() / 2).map(shift).collect(),
            multipliers: self.multipliers(found),
            residual: found.residual(),
            events: sequence(&found.turn.run),
        }
    }

    /// Eigenvalues of M = Tᵀ ∂P/∂x T, the largest first. Where the flow stays on the surface it is
    /// a direction of its own, which the section ends: its multiplier is zero and none of the
    /// orbit's.
    pub(super) fn multipliers(&self, found: &Attempt) -> Vec<Complex<f64>> {
        let map = found.surface.basis.transpose() * &found.turn.slopes;
        let mut all: Vec<Complex<f64>> = map.complex_eigenvalues().iter().copied().collect();
        all.sort_by(|a, b| b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im)));
        let surface = &found.surface;
        let along_flow = !surface.is_left
            && !surface.holds_section()
            && self.section.time(found.turn.run.parameters()).is_none();
        if along_flow && all.len() > 1 && all.last().is_some_and(|last| last.norm() < ZERO) {
            all.pop();
        }
        all
    }
}

/// Whether nothing moves in a turn.
fn is_at_rest(at: &OrbitParameters, run: &Trajectory) -> bool {
    let (from, duration) = (run.start_time(), run.end_time() - run.start_time());
    let start = &run.events()[0].state;
    let stays = |look: u32| {
        let state = run.state(from + duration * f64::from(look) / f64::from(LOOKS));
        let apart = state.iter().zip(start).zip(&at.units).map(|((x, start), unit)| (x - start).abs() / unit);
        apart.fold(0.0, f64::max) <= AT_REST
    };
    (1..=LOOKS).all(stays)
}
