//! The conditions that a run waits for, each with what it is there for.

use super::Simulation;
use super::schedule::Trigger;
use crate::expression::Condition;

/// What a condition of a run is there for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Role {
    /// It ends the run.
    Stop,
    /// It starts this entry of the plan.
    Planned(usize),
    /// It arms or disarms what this switch has.
    Switch { switch: usize, arms: bool },
    /// It ends the run with an error: this bound of the equations has been left.
    Domain(usize),
}

/// Conditions, which guards name by their places, and the role of each.
pub(super) struct Awaited {
    pub(super) conditions: Vec<Condition>,
    roles: Vec<Role>,
}

impl Awaited {
    /// All that a simulation waits for.
    pub(super) fn from_setup(setup: &Simulation) -> Self {
        let stops = setup.ends.conditions.iter().map(|condition| (condition, Role::Stop));
        let planned = setup.plan.iter().enumerate().filter_map(|(entry, planned)| match &planned.when {
            Trigger::If(condition) => Some((condition, Role::Planned(entry))),
            Trigger::At(_) => None,
        });
        let switches = setup.rules.switches.iter().enumerate().flat_map(|(switch, it)| {
            let [armed, disarmed] = &it.conditions;
            [(armed, true), (disarmed, false)]
                .map(|(condition, arms)| (condition, Role::Switch { switch, arms }))
        });
        let domains = setup.rules.domains.iter().enumerate();
        let domains = domains.map(|(k, domain)| (&domain.left, Role::Domain(k)));
        let all = stops.chain(planned).chain(switches).chain(domains);
        let (conditions, roles) = all.map(|(condition, role)| (condition.clone(), role)).unzip();
        Self { conditions, roles }
    }

    /// The role of the condition at a place.
    pub(super) fn role(&self, condition: usize) -> Role {
        self.roles[condition]
    }

    /// The places of all conditions.
    pub(super) fn places(&self) -> core::ops::Range<usize> {
        0..self.roles.len()
    }
}
