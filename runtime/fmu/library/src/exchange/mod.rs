//! Model exchange: the importer integrates coordinates and rates, and the unit gives their
//! derivatives in the phase at hand, the event indicators of this phase, and at an event the phase
//! that follows.
//!
//! The states are those of the free system, so that there are as many in every phase. What is read
//! of them is a state of the phase: x̂ = embed(restrict(x)) where it has a closed form, x projected
//! on the closed contacts and joints elsewhere; ẋ = f(x̂). The importer's error in what the phase
//! does not keep, or off its constraints, thus never feeds back.

mod decision;
mod indicators;
mod landing;

use crate::place::Instant;
use decision::decide;
pub(crate) use indicators::{Bands, Indicators};
use liftoff::{Output, Segment, Simulation};
use liftoff_core::model::{ContactSet, Form};
use liftoff_fmu::Interface;
use std::cell::OnceCell;
use std::sync::Arc;

/// A motion that an importer integrates.
pub(crate) struct Exchange {
    simulation: Simulation,
    /// Rates, then accelerations.
    derivatives: Vec<Output>,
    indicators: Indicators,
    tolerance: f64,
    place: Instant,
    /// When each contact has last opened or begun to slide without being struck.
    loose: Vec<f64>,
    /// The state of the phase that the importer's state stands for.
    seen: OnceCell<Instant>,
}

/// What an event has done.
pub(crate) struct Update {
    /// Whether the states have changed.
    pub(crate) moved: bool,
    /// Whether the motion has come to its end: a stop was reached.
    pub(crate) ended: bool,
}

impl Exchange {
    /// The motion from the start of a simulation.
    ///
    /// # Errors
    /// There is no motion from there.
    pub(crate) fn begin(
        simulation: Simulation,
        (interface, indicators): (&Interface, Indicators),
        (t, tolerance): (f64, f64),
    ) -> Result<Self, String> {
        let state = simulation.start_state().map_err(|error| error.to_string())?;
        let layout = simulation.layout();
        let state = layout.public_state(&state).to_vec();
        let decision = decide(&simulation, t, &state)?;
        let place = Instant { t, state: decision.state, phase: decision.phase, events: 0 };
        let loose = vec![t; layout.contacts.len()];
        let named = interface.derivatives().into_iter();
        let named =
            named.filter_map(|reference| interface.variables[reference as usize].expression.as_deref());
        let derivatives: Result<_, _> = named.map(|name| Output::parse(layout, name)).collect();
        let derivatives = derivatives.map_err(|error| error.to_string())?;
        Ok(Self { simulation, derivatives, indicators, tolerance, place, loose, seen: OnceCell::new() })
    }

    pub(crate) fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// The time and the states of the importer.
    pub(crate) fn instant(&self) -> &Instant {
        &self.place
    }

    pub(crate) fn set_time(&mut self, t: f64) {
        self.place.t = t;
        self.seen.take();
    }

    pub(crate) fn set_states(&mut self, states: &[f64]) {
        self.place.state.copy_from_slice(states);
        self.seen.take();
    }

    /// The place that outputs are read at.
    pub(crate) fn seen(&self) -> &Instant {
        self.seen.get_or_init(|| Instant { state: seen(&self.simulation, &self.place), ..self.place.clone() })
    }

    /// ẋ: rates, then accelerations.
    pub(crate) fn derivatives(&self) -> Vec<f64> {
        let seen = self.seen();
        self.simulation.values(&seen.phase, (seen.t, &seen.state), &self.derivatives)
    }

    /// The event indicators.
    pub(crate) fn indicators(&self) -> Vec<f64> {
        self.indicators.evaluate(&self.simulation, self.seen(), self.bands())
    }

    /// How far indicators are raised.
    pub(crate) fn bands(&self) -> Bands<'_> {
        Bands { tolerance: self.tolerance, loose: &self.loose }
    }

    /// Natural values of the states.
    pub(crate) fn nominals(&self) -> Vec<f64> {
        let (layout, scales) = (self.simulation.layout(), self.simulation.scales());
        (0..2 * layout.coordinates.len()).map(|entry| scales.entry(layout, entry)).collect()
    }

    /// Notes which contacts have opened or begun to slide: those that were struck were open before.
    fn note_loose(&mut self, t: f64, after: ContactSet) {
        let before = self.place.phase.set;
        for (i, loose) in self.loose.iter_mut().enumerate() {
            let opens = before.contains(i) && !after.contains(i);
            let slides = before.contains(i) && after.sense(i) != 0 && after.sense(i) != before.sense(i);
            if opens || slides {
                *loose = t;
            }
        }
    }

    /// Decides what follows where indicators are no more positive.
    ///
    /// # Errors
    /// Nothing follows.
    pub(crate) fn update(&mut self) -> Result<Update, String> {
        let crossed = self.indicators.crossed(&self.indicators());
        if crossed.is_empty() {
            return Ok(Update { moved: false, ended: false });
        }
        let (t, simulation, tolerance) = (self.place.t, &self.simulation, self.tolerance);
        let landed = landing::land(simulation, (self.seen(), tolerance), &crossed);
        let decision = decide(simulation, t, &landed)?.settled(simulation, t, tolerance)?;
        let changes = i32::from(decision.phase.set != self.place.phase.set);
        let events = self.place.events.saturating_add(decision.events.max(changes));
        self.note_loose(t, decision.phase.set);
        self.place = Instant { t, state: decision.state, phase: decision.phase, events };
        self.seen.take();
        Ok(Update { moved: true, ended: decision.ended })
    }
}

/// The state of a phase that a state stands for.
fn seen(simulation: &Simulation, place: &Instant) -> Vec<f64> {
    let Segment { form, active_basis: bearing, .. } = place.phase;
    match form {
        Form::Reduced => embedded(simulation, bearing, place),
        Form::Multipliers => projected(simulation, bearing, place.t, &place.state),
    }
}

/// embed(restrict(x)) of a contact set.
fn embedded(simulation: &Simulation, set: ContactSet, place: &Instant) -> Vec<f64> {
    let layout = simulation.layout();
    let phase = Arc::clone(&simulation.model().system).phase(set, Form::Reduced);
    let (mut reduced, mut full) = (vec![0.0; phase.info().entries], layout.state_at(&place.state, place.t));
    phase.restrict(&full, &mut reduced);
    phase.embed(&reduced, &mut full);
    layout.public_state(&full).to_vec()
}

/// A state projected on closed contacts and joints.
fn projected(simulation: &Simulation, set: ContactSet, t: f64, state: &[f64]) -> Vec<f64> {
    let layout = simulation.layout();
    let mut full = layout.state_at(state, t);
    simulation.model().system.project(set, &mut full, simulation.scales().length);
    layout.public_state(&full).to_vec()
}
