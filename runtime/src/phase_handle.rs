//! The equations of one phase without the integrator.

use crate::error::NameError;
use crate::model::{BarSystem, ContactSet, Energy, Form, KernelView, Phase, PhaseVisitor};
use crate::moment::{At, Moment, retained, state_at};
use crate::output::resolve::{contact_of, unknown_support};

/// Phases of a model by the names of their closed supports.
pub trait Phases: BarSystem {
    /// The phase in which the contacts of these supports, and no others, are closed.
    fn phase(&self, closed: &[&str]) -> Result<PhaseHandle<Self>, NameError> {
        PhaseHandle::new(self, closed, Form::Closed)
    }

    /// The same with all coordinates kept and multipliers for the closed contacts.
    fn projected_phase(&self, closed: &[&str]) -> Result<PhaseHandle<Self>, NameError> {
        PhaseHandle::new(self, closed, Form::Projected)
    }
}

impl<M: BarSystem> Phases for M {}

/// The functions of a phase. States are full, coordinates then rates, and must satisfy the closed contacts; entries
/// missing from a state that is too short are taken as not a number. Equations that depend on time are those of t = 0
/// until [`at_time`](Self::at_time) says otherwise.
pub struct PhaseHandle<M: BarSystem> {
    constants: M::Constants<f64>,
    t: f64,
    functions: Box<dyn Functions<M>>,
}

impl<M: BarSystem> PhaseHandle<M> {
    fn new(model: &M, closed: &[&str], form: Form) -> Result<Self, NameError> {
        let mut set = ContactSet::EMPTY;
        for support in closed {
            let found = contact_of(M::LAYOUT, support);
            set = set.with(found.ok_or_else(|| unknown_support(M::LAYOUT, support))?.0);
        }
        Ok(Self { constants: model.constants(), t: 0.0, functions: M::phase(set, form, Hold) })
    }

    /// The equations at the time `t`.
    #[must_use]
    pub fn at_time(self, t: f64) -> Self {
        Self { t, ..self }
    }

    /// Closed form or projected.
    pub fn form(&self) -> Form {
        self.functions.form()
    }

    /// Indices of the coordinates whose rates the phase keeps; [`mass_matrix`](Self::mass_matrix), [`forces`](Self::forces)
    /// and [`reduced_accelerations`](Self::reduced_accelerations) have one row for each.
    pub fn kept(&self) -> Vec<usize> {
        self.functions.kept()
    }

    /// Accelerations of all coordinates.
    pub fn accelerations(&self, state: &[f64]) -> Vec<f64> {
        self.functions.accelerations(&self.constants, &self.full(state))
    }

    /// Accelerations of the coordinates that the phase keeps.
    pub fn reduced_accelerations(&self, state: &[f64]) -> Vec<f64> {
        self.functions.reduced_accelerations(&self.constants, &self.full(state))
    }

    /// Reactions of all contacts, zero where open.
    pub fn reactions(&self, state: &[f64]) -> Vec<f64> {
        self.functions.reactions(&self.constants, &self.full(state))
    }

    /// Mass matrix of the kept coordinates, by rows.
    pub fn mass_matrix(&self, state: &[f64]) -> Vec<Vec<f64>> {
        self.functions.mass_matrix(&self.constants, &self.full(state))
    }

    /// Generalised forces less velocity terms. In closed form those of the kept coordinates, the product of mass matrix
    /// and accelerations; with multipliers the full ones without the reactions.
    pub fn forces(&self, state: &[f64]) -> Vec<f64> {
        self.functions.forces(&self.constants, &self.full(state))
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, state: &[f64]) -> Energy<f64> {
        self.functions.energy(&self.constants, &self.full(state))
    }

    fn full(&self, state: &[f64]) -> M::State<f64> {
        state_at::<M>(state, self.t)
    }
}

/// [`PhaseHandle`] with its dimension forgotten.
trait Functions<M: BarSystem> {
    fn form(&self) -> Form;
    fn kept(&self) -> Vec<usize>;
    fn accelerations(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64>;
    fn reduced_accelerations(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64>;
    fn reactions(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64>;
    fn mass_matrix(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<Vec<f64>>;
    fn forces(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64>;
    fn energy(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Energy<f64>;
}

struct Hold;

impl<M: BarSystem> PhaseVisitor<M, f64> for Hold {
    type Output = Box<dyn Functions<M>>;

    fn visit<const N: usize>(self, phase: Phase<M, f64, N>) -> Self::Output {
        Box::new(phase)
    }
}

impl<M: BarSystem, const N: usize> Functions<M> for Phase<M, f64, N> {
    fn form(&self) -> Form {
        self.form
    }

    fn kept(&self) -> Vec<usize> {
        retained(self)
    }

    fn accelerations(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64> {
        At::new(self, constants, time::<M>(state), (self.restrict)(state)).accelerations().as_ref().to_vec()
    }

    fn reduced_accelerations(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64> {
        let derivative = (self.derivative)(constants, self.set, &(self.restrict)(state));
        derivative[self.coordinates..self.coordinates + self.rates].to_vec()
    }

    fn reactions(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64> {
        (self.reactions)(constants, self.set, &(self.restrict)(state)).as_ref().to_vec()
    }

    /// Gᵀ M G; the columns of G are what the kept rates' units add to the full rates.
    fn mass_matrix(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<Vec<f64>> {
        let n = M::LAYOUT.coordinates.len();
        let reduced = (self.restrict)(state);
        let rates = self.coordinates..self.coordinates + self.rates;
        let full = |moving: Option<usize>| {
            let entry = |i: usize| if rates.contains(&i) { f64::from(moving == Some(i)) } else { reduced[i] };
            (self.embed)(constants, &core::array::from_fn(entry))
        };
        let rest = full(None);
        let columns: Vec<Vec<f64>> = rates
            .clone()
            .map(|k| {
                let moved = full(Some(k));
                (n..2 * n).map(|i| moved.as_ref()[i] - rest.as_ref()[i]).collect()
            })
            .collect();
        let kernel = M::kernel(constants, &(self.embed)(constants, &reduced));
        let product = |a: &[f64], b: &[f64]| -> f64 { (0..n).map(|i| a[i] * dot(kernel.mass(i), b)).sum() };
        columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect()
    }

    fn forces(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Vec<f64> {
        if self.form == Form::Projected {
            return M::kernel(constants, state).force().to_vec();
        }
        let accelerations = self.reduced_accelerations(constants, state);
        self.mass_matrix(constants, state).iter().map(|row| dot(row, &accelerations)).collect()
    }

    fn energy(&self, constants: &M::Constants<f64>, state: &M::State<f64>) -> Energy<f64> {
        (self.energy)(constants, &(self.restrict)(state))
    }
}

/// The last entry of a state that has one for the time.
fn time<M: BarSystem>(state: &M::State<f64>) -> f64 {
    state.as_ref().get(2 * M::LAYOUT.coordinates.len()).copied().unwrap_or(0.0)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
