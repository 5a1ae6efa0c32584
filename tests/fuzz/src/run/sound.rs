//! What every run must satisfy by itself.

use liftoff::{EventKind, LoggedDecision, Note, Output, Quantity, RunCause, Trajectory};

use super::task::Task;
use crate::Finding;

/// Times at which gaps and energy are looked at, between the ends of the run.
const SAMPLES: usize = 24;

pub(super) fn check(task: &Task, run: &Trajectory) -> Result<(), Finding> {
    finite(run)?;
    let audit = run.audit();
    // Beyond a guard that was taken for noise a reaction may have passed zero unseen: the log says
    // so.
    let noisy = run.log().iter().find(|entry| entry.decision == LoggedDecision::GuardUnresolved);
    let said = |of: &Quantity, t: f64| *of == Quantity::Pull && noisy.is_some_and(|entry| entry.t <= t);
    if let Some(finding) = audit.violations().find(|finding| !said(&finding.quantity, finding.t)) {
        return Err(Finding(format!("audit: {finding}")));
    }
    ordered(run)?;
    start_is_kept(task, run)?;
    gaps(task, run)?;
    energy(task, run)
}

/// Of a run that stopped short what it did until then: numbers that are none are told by how it
/// stopped, as is what is wrong with the state from which no motion was found.
pub(super) fn in_part(run: &Trajectory, cause: &RunCause) -> Result<(), Finding> {
    ordered(run)?;
    let told = |t: f64| !matches!(cause, RunCause::Budget { .. }) && t == run.end_time();
    match run.audit().violations().find(|finding| !finding.value.is_nan() && !told(finding.t)) {
        Some(finding) => Err(Finding(format!("audit: {finding}"))),
        None => Ok(()),
    }
}

fn finite(run: &Trajectory) -> Result<(), Finding> {
    let wrong = |text: String| Err(Finding(text));
    if run.final_state().iter().any(|x| !x.is_finite()) || !run.end_time().is_finite() {
        return wrong(format!("not finite at the end: t = {}, {:?}", run.end_time(), run.final_state()));
    }
    for event in run.events() {
        let reactions = event.reactions.iter().chain(&event.impulses).map(|reaction| reaction.value);
        if !event.t.is_finite() || event.state.iter().copied().chain(reactions).any(|x| !x.is_finite()) {
            return wrong(format!("not finite: {event}, {:?}, {:?}", event.reactions, event.impulses));
        }
    }
    Ok(())
}

fn ordered(run: &Trajectory) -> Result<(), Finding> {
    match run.events().windows(2).find(|pair| pair[1].t < pair[0].t) {
        Some(pair) => Err(Finding(format!("events out of order: {}, then {}", pair[0], pair[1]))),
        None => Ok(()),
    }
}

/// What was given is what the run starts with. Starts at contacts are put onto them: at a fold of a
/// gap by the root of how deep the run says that they are penetrated, or by as much as it says that
/// it moves. Slips that are zero to within the tolerance end, relative to the largest position or
/// rate, as the run has it.
fn start_is_kept(task: &Task, run: &Trajectory) -> Result<(), Finding> {
    let Some(start) = run.events().first().filter(|event| event.kind == EventKind::Start) else {
        return Ok(());
    };
    let coordinates = run.layout().coordinates;
    if !task.spec.energy_of.is_empty() {
        return Ok(());
    }
    let [length, time] = [run.scales().length, run.scales().time];
    let depths = run.log().iter().filter_map(|entry| match entry.decision {
        LoggedDecision::StartPenetrates(depth) => Some(depth / length),
        _ => None,
    });
    let onto_contacts = run.log().iter().find_map(|entry| match entry.decision {
        LoggedDecision::StartMoves(by) => Some(by),
        _ => None,
    });
    let moved = (1e-11 + 4.0 * depths.fold(0.0, f64::max)).sqrt()
        + onto_contacts.unwrap_or(10.0 * task.spec.tolerance);
    let belt = carried(run) * time / length;
    for (name, value) in &task.spec.start {
        let bare = name.trim_end_matches('\'');
        let Some(place) = coordinates.iter().position(|known| known.name == bare) else { continue };
        let unit = if coordinates[place].is_angle { 1.0 } else { length };
        let (place, unit) =
            if bare == name { (place, unit) } else { (place + coordinates.len(), unit / time) };
        let off = (start.state[place] - value).abs();
        let alike =
            if bare == name { 0..coordinates.len() } else { coordinates.len()..2 * coordinates.len() };
        let units = |i: usize| {
            let own = if coordinates[i % coordinates.len()].is_angle { 1.0 } else { length };
            if i < coordinates.len() { own } else { own / time }
        };
        let least = if bare == name { 1.0 } else { belt.max(1.0) };
        let largest = alike.fold(least, |most: f64, i| most.max(start.state[i].abs() / units(i)));
        if off > moved * (unit * largest).max(value.abs()) {
            let note = start.note.as_ref().map(Note::to_string).unwrap_or_default();
            return Err(Finding(format!("{name} starts at {} {note}", start.state[place])));
        }
    }
    Ok(())
}

/// Times of the run, those of the events among them.
fn times(run: &Trajectory) -> Vec<f64> {
    let [from, to] = run.interval();
    let even = (0..=SAMPLES).map(|i| from + (to - from) * i as f64 / SAMPLES as f64);
    let mut times: Vec<f64> = even.chain(run.events().iter().map(|event| event.t)).collect();
    times.sort_by(f64::total_cmp);
    times
}

/// Gaps of contacts without ends, in natural lengths. What has been taken away may be anywhere, and
/// so may what was not there for a while.
fn gaps(task: &Task, run: &Trajectory) -> Result<(), Finding> {
    let taken = |support: &str| {
        let released = task.spec.release.iter().map(|(name, _)| name);
        released.chain(task.spec.cut.iter().map(|(name, _)| name)).any(|name| name == support)
    };
    let contacts = run
        .layout()
        .contacts
        .iter()
        .enumerate()
        .filter(|(_, contact)| contact.foot.is_none() && contact.armed.is_none());
    for (row, contact) in
        contacts.filter(|(_, contact)| !contact.supports.iter().any(|support| taken(support)))
    {
        let support = contact.supports[0];
        let Ok(gap) = Output::parse(run.layout(), &format!("gap({support})")) else { continue };
        for t in times(run) {
            let state = run.state(t);
            let lengths = state.iter().zip(run.layout().coordinates).filter(|(_, known)| !known.is_angle);
            let size = lengths.fold(run.scales().length, |most, (x, _)| most.max(x.abs()));
            let value = run.value(&gap, t);
            // Times are told apart by the spacing of doubles, in which a fast motion comes far.
            let equations = run.model().system.equations(&run.layout().state_at(&state, t));
            let rate = equations.gap_rate(row, &state[run.layout().coordinates.len()..]);
            let rounding = 16.0 * f64::EPSILON * (rate * t).abs();
            if value.is_nan() || value < -(1e-8_f64).max(1e3 * run.tolerance()) * size - rounding {
                return Err(Finding(format!("gap({support}) = {value:e} at t = {t}")));
            }
        }
    }
    Ok(())
}

/// How fast surfaces move along themselves at the start, and gaps by themselves: the largest
/// |∂g/∂t|.
fn carried(run: &Trajectory) -> f64 {
    let (layout, [start, _]) = (run.layout(), run.interval());
    let equations = run.model().system.equations(&layout.state_at(&run.state(start), start));
    equations.prescribed_gap_rate().iter().fold(0.0, |most, drift| most.max(drift.abs()))
}

/// Without drives, loads, moving surfaces and impulses the energy does not grow, beyond what the
/// laws of impact tell and what the audit takes for the error of the steps.
fn energy(task: &Task, run: &Trajectory) -> Result<(), Finding> {
    let layout = run.layout();
    if layout.loaded || layout.timed || carried(run) > 0.0 || !task.spec.impulses.is_empty() {
        return Ok(());
    }
    let (Ok(kinetic), Ok(potential)) = (Output::parse(layout, "T"), Output::parse(layout, "V")) else {
        return Ok(());
    };
    let error = run.tolerance().max(1e-12) * (10.0 + run.statistics().steps as f64);
    let impacts = run.events().len() as f64;
    let (mut least, mut largest) = (f64::INFINITY, 0.0_f64);
    let gains = list_energy_gains(run);
    for t in times(run) {
        let told: f64 = gains.iter().filter(|(at, _)| *at <= t).map(|(_, energy)| energy).sum();
        let [t_energy, v_energy] = [&kinetic, &potential].map(|output| run.value(output, t));
        largest = largest.max(t_energy).max(v_energy.abs());
        let energy = t_energy + v_energy - told;
        let natural = 1e-3 * run.scales().force() * run.scales().length;
        let bound = (100.0 * error + 1e4 * run.tolerance().max(1e-12) * impacts) * largest.max(natural);
        if energy.is_nan() || energy > least + bound {
            let quantity = Quantity::Energy;
            return Err(Finding(format!(
                "{quantity:?}: {least:e} has become {energy:e} at t = {t}, allowed {bound:e}"
            )));
        }
        least = least.min(energy);
    }
    Ok(())
}

/// What the laws of impact have gained, and when, by the events' notes.
fn list_energy_gains(run: &Trajectory) -> Vec<(f64, f64)> {
    let gains = run.events().iter().filter_map(|event| match event.note {
        Some(Note::EnergyGained(energy)) => Some((event.t, energy)),
        _ => None,
    });
    let mut gains: Vec<_> = gains.collect();
    gains.dedup();
    let ahead = run.log().iter().filter_map(|entry| match entry.decision {
        LoggedDecision::FrictionAhead(energy) => Some((entry.t, energy)),
        _ => None,
    });
    gains.into_iter().chain(ahead).collect()
}
