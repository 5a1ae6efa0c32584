//! The values of the event indicators, each raised by a band: what has just become zero does not
//! cross it once more by the error of a step,
//!
//! ```text
//! z + ε u (1 + K exp(−(t − t₀)/τ)),    τ = ∛(K ε) T
//! ```
//!
//! with the importer's tolerance ε, the natural unit u of z and the natural time T. The second term
//! is there for contacts that have opened, or begun to slide, at t₀ without being struck: z then
//! grows with the third power of the time, more slowly at first than the errors of some steps add
//! up; u (t/T)³ is as large as K ε u, that of K steps, at τ.

use crate::place::Instant;
use liftoff::{Output, Simulation};
use liftoff_core::model::{Layout, Slip};
use liftoff_fmu::{Guard, Interface, Quantity};

/// The indicators of a model.
#[derive(Debug, Clone)]
pub(crate) struct Indicators {
    guards: Vec<Guard>,
    /// Of each contact with an indicator: N, the gap, and with friction R, μ and v.
    outputs: Vec<Output>,
}

/// Outputs of a contact.
const EACH: usize = 5;

/// What is no guard in a phase.
const IDLE: f64 = 1.0;

/// Steps whose errors add up at first.
pub(super) const STEPS: f64 = 1e3;

/// How far indicators are raised.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bands<'a> {
    /// The importer's tolerance.
    pub(crate) tolerance: f64,
    /// When each contact has last opened or begun to slide without being struck.
    pub(crate) loose: &'a [f64],
}

impl Bands<'_> {
    /// ε (1 + K exp(−(t − t₀)/τ)), the second for what is loose.
    fn compute_band(&self, contact: usize, t: f64, time: f64) -> f64 {
        let since = self.loose.get(contact).map_or(f64::INFINITY, |begun| t - begun);
        let decay = (STEPS * self.tolerance).cbrt() * time;
        self.tolerance * (1.0 + STEPS * (-since.max(0.0) / decay).exp())
    }
}

impl Indicators {
    /// Those of a model.
    ///
    /// # Errors
    /// An expression that the model does not have, as none is.
    pub(crate) fn from_interface(interface: &Interface) -> Result<Self, String> {
        let of = |variable: &liftoff_fmu::Variable| match variable.quantity {
            Quantity::Guard(guard) => Some(guard),
            _ => None,
        };
        let layout = interface.layout;
        let texts = layout.contacts.iter().flat_map(|contact| {
            let (whole, one) = (contact.label, contact.supports[0]);
            let rubs = |text: String| if contact.friction.is_some() { text } else { "0".to_owned() };
            [
                format!("N({whole})"),
                format!("gap({one})"),
                rubs(format!("R({whole})")),
                rubs(format!("mu({one})")),
                rubs(format!("v({one})")),
            ]
        });
        let outputs: Result<_, _> = texts.map(|text| Output::parse(layout, &text)).collect();
        let outputs = outputs.map_err(|error| error.to_string())?;
        Ok(Self { guards: interface.variables.iter().filter_map(of).collect(), outputs })
    }

    /// Their values at a place.
    pub(crate) fn evaluate(&self, simulation: &Simulation, place: &Instant, bands: Bands) -> Vec<f64> {
        let (layout, scales) = (simulation.layout(), simulation.scales());
        let values = simulation.values(&place.phase, (place.t, &place.state), &self.outputs);
        let (ends, firm) = (ends(simulation, place), bands.tolerance);
        let value = |guard: &Guard| {
            let i = guard.contact();
            let [normal, gap, friction, coefficient, slip] = core::array::from_fn(|k| values[EACH * i + k]);
            let (set, end) =
                (place.phase.set, layout.contacts[i].foot.map_or(f64::INFINITY, |foot| ends[foot]));
            let loose = bands.compute_band(i, place.t, scales.time);
            let (value, band) = match guard {
                Guard::Normal(_) if set.contains(i) => {
                    (f64::from(set.side(i).sign()) * normal, firm * scales.force())
                }
                Guard::Normal(_) => (gap.max(-end), loose * layout.unit(i, scales.length)),
                Guard::Friction(_) if !set.contains(i) => return IDLE,
                Guard::Friction(_) => match set.slip(i) {
                    Slip::Stick => (coefficient * normal.abs() - friction.abs(), firm * scales.force()),
                    sliding => (f64::from(sliding.sign()) * slip, loose * scales.speed()),
                },
                Guard::End(_) if set.contains(i) => (end, firm * scales.length),
                Guard::End(_) => return IDLE,
            };
            value + band
        };
        self.guards.iter().map(value).collect()
    }

    /// The same, each with what it is.
    pub(crate) fn named(&self, simulation: &Simulation, place: &Instant, bands: Bands) -> Vec<(Guard, f64)> {
        self.guards.iter().copied().zip(self.evaluate(simulation, place, bands)).collect()
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        self.guards.len()
    }

    /// Those that are no more positive.
    pub(crate) fn crossed(&self, values: &[f64]) -> Vec<Guard> {
        self.guards.iter().zip(values).filter(|(_, value)| **value <= 0.0).map(|(guard, _)| *guard).collect()
    }
}

/// The distance of each corner under a bar to the bar's nearer end.
pub(super) fn ends(simulation: &Simulation, place: &Instant) -> Vec<f64> {
    let layout: &Layout = simulation.layout();
    let mut feet = vec![0.0; 2 * layout.feet()];
    simulation.model().system.feet(&layout.state_at(&place.state, place.t), &mut feet);
    feet.chunks_exact(2).map(|ends| ends[0].min(ends[1])).collect()
}
