//! The power that friction and dampers take.

use crate::context::{Numbers, RunContext, slips};
use crate::expression::Variable;
use crate::integration::phase_point::PhasePoint;
use crate::model::{Layout, MeasureKind, QuantityKind};
use crate::system::Model;

/// What of a model takes energy while it moves.
pub(super) struct Losses {
    rubs: bool,
    dampers: Vec<Damper>,
}

/// A spring or torsion spring that may have a damper.
struct Damper {
    /// Its force or torque among the layout's quantities.
    quantity: usize,
    rate: Rate,
}

/// The rate ḋ that a damper opposes by c ḋ.
enum Rate {
    /// That of the distance between two points.
    Distance([usize; 2]),
    /// That of an angle, by c > 0.
    Angle(f64),
}

impl Losses {
    pub(super) fn from_model(model: &Model) -> Self {
        let is_damped = model.measures.iter().any(|measure| measure.kind == MeasureKind::Damping);
        let dampers = if is_damped { dampers(model) } else { Vec::new() };
        Self { rubs: !model.layout().frictions.is_empty(), dampers }
    }

    pub(super) fn is_empty(&self) -> bool {
        !self.rubs && self.dampers.is_empty()
    }

    /// Σ −R v + Σ c ḋ².
    pub(super) fn power(&self, context: &RunContext, point: &PhasePoint) -> f64 {
        let rubbed = if self.rubs { rubbing(context, point) } else { 0.0 };
        rubbed + self.dampers.iter().map(|damper| damper.power(context, point)).sum::<f64>()
    }
}

fn rubbing(context: &RunContext, point: &PhasePoint) -> f64 {
    let (reactions, slips) = (point.reactions(), slips(context.system(), point.state()));
    let forces = &reactions[context.layout().contacts.len()..];
    forces.iter().zip(&slips).map(|(force, slip)| -force * slip.velocity).sum()
}

impl Damper {
    /// c ḋ · ḋ or (c ḋ)²/c, where c ḋ is what the rates add to the force.
    fn power(&self, context: &RunContext, point: &PhasePoint) -> f64 {
        let (system, state, n) = (context.system(), point.state(), context.layout().coordinates.len());
        let mut still: Numbers = state.into();
        still[n..2 * n].fill(0.0);
        let [with, without] = [state, &still].map(|state| system.quantity(self.quantity, state, &[], &[]));
        let added = with - without;
        match self.rate {
            Rate::Distance(ends) if added != 0.0 => added * lengthening(context, point, ends),
            Rate::Distance(_) => 0.0,
            Rate::Angle(damping) => added * added / damping,
        }
    }
}

/// The rate of the distance between two points.
fn lengthening(context: &RunContext, point: &PhasePoint, [a, b]: [usize; 2]) -> f64 {
    let along = |axis: usize, order: usize| {
        let [a, b] = [a, b].map(|index| Variable::Point { index, axis, order }.value(context, point));
        b - a
    };
    let span = [along(0, 0), along(1, 0)];
    (span[0] * along(0, 1) + span[1] * along(1, 1)) / span[0].hypot(span[1])
}

/// Springs by their ends; torsion springs that have a damper, whose measures have their names.
fn dampers(model: &Model) -> Vec<Damper> {
    let layout = model.layout();
    let springs = layout.geometry.springs.iter().filter_map(|spring| {
        let quantity = quantity(layout, QuantityKind::SpringForce, &format!("force({})", spring.name))?;
        Some(Damper { quantity, rate: Rate::Distance(spring.ends) })
    });
    let measures = model.measures.iter().filter(|of| of.kind == MeasureKind::Damping && of.value > 0.0);
    let torsions = measures.filter_map(|measure| {
        let name = measure.of.strip_prefix("torsion of ")?;
        let quantity = quantity(layout, QuantityKind::SpringTorque, &format!("torque({name})"))?;
        Some(Damper { quantity, rate: Rate::Angle(measure.value) })
    });
    springs.chain(torsions).collect()
}

fn quantity(layout: &Layout, kind: QuantityKind, name: &str) -> Option<usize> {
    layout.quantities.iter().position(|quantity| quantity.kind == kind && quantity.name == name)
}
