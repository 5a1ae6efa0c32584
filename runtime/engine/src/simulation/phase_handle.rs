//! The equations of one phase without the integrator.

use std::sync::Arc;

use crate::context::{Numbers, reduce};
use crate::error::NameError;
use crate::expression::resolve::contact_set;
use crate::integration::phase_point::{PhasePoint, coordinate_of};
use crate::model::{ContactSet, Energy, Form};
use crate::system::{Model, PhaseEquations};

/// Phases of a model by the names of their closed supports.
pub trait Phases {
    /// The phase in which the contacts of these supports, and no others, are closed.
    ///
    /// # Errors
    /// A support has another name.
    fn phase(&self, closed: &[&str]) -> Result<PhaseHandle, NameError>;

    /// The same with all coordinates kept and multipliers for the closed contacts.
    ///
    /// # Errors
    /// A support has another name.
    fn projected_phase(&self, closed: &[&str]) -> Result<PhaseHandle, NameError>;
}

impl<T> Phases for T
where
    for<'a> &'a T: Into<Model>,
{
    fn phase(&self, closed: &[&str]) -> Result<PhaseHandle, NameError> {
        PhaseHandle::new(&self.into(), closed, Form::Reduced)
    }

    fn projected_phase(&self, closed: &[&str]) -> Result<PhaseHandle, NameError> {
        PhaseHandle::new(&self.into(), closed, Form::Multipliers)
    }
}

/// The functions of a phase. States are full, coordinates then rates, and must satisfy the closed
/// contacts; entries missing from a state that is too short are taken as not a number. Equations
/// that depend on time are those of t = 0 until [`at_time`](Self::at_time) says otherwise.
pub struct PhaseHandle {
    phase: Arc<dyn PhaseEquations>,
    t: f64,
}

impl PhaseHandle {
    fn new(model: &Model, closed: &[&str], form: Form) -> Result<Self, NameError> {
        let set: ContactSet = contact_set(model.layout(), closed)?;
        Ok(Self { phase: Arc::clone(&model.system).phase(set, form), t: 0.0 })
    }

    /// The equations at the time `t`.
    #[must_use]
    pub fn at_time(self, t: f64) -> Self {
        Self { t, ..self }
    }

    /// Closed form or projected.
    pub fn form(&self) -> Form {
        self.phase.info().form
    }

    /// Indices of the coordinates whose rates the phase keeps; [`mass_matrix`](Self::mass_matrix),
    /// [`forces`](Self::forces) and [`reduced_accelerations`](Self::reduced_accelerations) have one
    /// row for each.
    pub fn kept(&self) -> Vec<usize> {
        self.phase.info().places_of_rates().map(|place| coordinate_of(&*self.phase, place)).collect()
    }

    /// Accelerations of all coordinates.
    pub fn accelerations(&self, state: &[f64]) -> Vec<f64> {
        let (phase, set) = (Arc::clone(&self.phase), self.phase.info().set);
        PhasePoint::new(phase, set, self.t, self.reduced(state)).accelerations().to_vec()
    }

    /// Accelerations of the coordinates that the phase keeps.
    pub fn reduced_accelerations(&self, state: &[f64]) -> Vec<f64> {
        let y = self.reduced(state);
        let mut derivative = vec![0.0; y.len()];
        self.phase.derivative(&y, &mut derivative);
        derivative[self.phase.info().places_of_rates()].to_vec()
    }

    /// Reactions of all contacts, zero where open.
    pub fn reactions(&self, state: &[f64]) -> Vec<f64> {
        let mut reactions = vec![0.0; self.phase.system().layout().reactions()];
        self.phase.reactions(&self.reduced(state), &mut reactions);
        reactions
    }

    /// Mass matrix of the kept coordinates, by rows: Gᵀ M G with G = ∂u/∂v, the derivatives of all
    /// rates u by the kept rates v.
    pub fn mass_matrix(&self, state: &[f64]) -> Vec<Vec<f64>> {
        let system = self.phase.system();
        let n = system.layout().coordinates.len();
        let reduced = self.reduced(state);
        let rates = self.phase.info().places_of_rates();
        let full = |moving: Option<usize>| {
            let mut y = reduced.clone();
            rates.clone().for_each(|i| y[i] = f64::from(moving == Some(i)));
            self.embedded(&y)
        };
        let rest = full(None);
        let column = |k: usize| -> Vec<f64> {
            full(Some(k))[n..].iter().zip(&rest[n..]).map(|(a, b)| a - b).collect()
        };
        let columns: Vec<Vec<f64>> = rates.clone().map(column).collect();
        let equations = system.equations(&self.embedded(&reduced));
        let product =
            |a: &[f64], b: &[f64]| -> f64 { (0..n).map(|i| a[i] * dot(equations.mass(i), b)).sum() };
        columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect()
    }

    /// Generalised forces less velocity terms. In closed form those of the kept coordinates, the
    /// product of mass matrix and accelerations; with multipliers the full ones without the
    /// reactions.
    pub fn forces(&self, state: &[f64]) -> Vec<f64> {
        if self.form() == Form::Multipliers {
            return self.phase.system().equations(&self.full(state)).force().to_vec();
        }
        let accelerations = self.reduced_accelerations(state);
        self.mass_matrix(state).iter().map(|row| dot(row, &accelerations)).collect()
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, state: &[f64]) -> Energy<f64> {
        self.phase.energy(&self.reduced(state))
    }

    fn full(&self, state: &[f64]) -> Vec<f64> {
        self.phase.system().layout().state_at(state, self.t)
    }

    fn reduced(&self, state: &[f64]) -> Numbers {
        reduce(&*self.phase, &self.full(state))
    }

    fn embedded(&self, y: &[f64]) -> Vec<f64> {
        let mut state = vec![0.0; self.phase.system().layout().entries()];
        self.phase.embed(y, &mut state);
        state
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
