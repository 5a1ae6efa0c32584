//! Budgets: the operations of each right-hand side against what the declaration allows.

use crate::Analysis;
use crate::functions::PhaseFunctions;
use crate::motion::contains;
use crate::program::Id;
use crate::syntax::{Budget, Report, plain, unknown};

/// Refuses right-hand sides that cost more than a budget allows, and budgets that are for none.
pub(crate) fn check(budgets: &[Budget], analysis: &Analysis) -> syn::Result<()> {
    let mut report = Report::default();
    for budget in budgets {
        let phases = &analysis.functions.phases;
        let Some(set) = report.keep(closed(budget, analysis)) else { continue };
        let mut counted =
            phases.iter().filter(|phase| set.is_none_or(|set| phase.set.closed == set)).peekable();
        if counted.peek().is_none() {
            let which = if set.is_some() { "this contact set" } else { "no contact set" };
            let has = if set.is_some() { "has no code of its own" } else { "has code of its own" };
            report.add_message(budget.span, format!("nothing to count: {which} {has}"));
        }
        counted.for_each(|phase| compare(budget, analysis, phase, &mut report));
    }
    report.finish()
}

fn compare(budget: &Budget, analysis: &Analysis, phase: &PhaseFunctions, report: &mut Report) {
    let outputs: Vec<Id> = phase.rates.iter().chain(&phase.accelerations).copied().collect();
    let cost = analysis.functions.program.cost(&outputs);
    if cost.flops() > budget.flops {
        let text = format!(
            "the right-hand side {} takes {} operations, {} more than the budget of {}: {cost}",
            describe_set(analysis, phase.set.closed),
            cost.flops(),
            cost.flops() - budget.flops,
            budget.flops
        );
        report.add_message(budget.span, text);
    }
}

/// The contact set that a budget is for.
fn closed(budget: &Budget, analysis: &Analysis) -> syn::Result<Option<u64>> {
    let Some(names) = &budget.on else { return Ok(None) };
    let (system, contacts) = (&analysis.system, &analysis.motion.contacts);
    let mut set = 0;
    for name in names {
        let has = |&i: &usize| contacts[i].supports.iter().any(|&s| plain(name) == system.supports[s].name);
        let known = system.supports.iter().map(|support| support.name.as_str());
        let contact = (0..contacts.len()).find(has);
        let contact = contact.ok_or_else(|| syn::Error::new(name.span(), unknown("support", name, known)))?;
        set |=
            u32::try_from(contact).ok().and_then(|contact| 1u64.checked_shl(contact)).ok_or_else(|| {
                syn::Error::new(
                    name.span(),
                    "own code, and with it a budget, is for sets of the first 64 contacts",
                )
            })?;
    }
    Ok(Some(set))
}

/// `on P, Q`.
fn describe_set(analysis: &Analysis, set: u64) -> String {
    let closed = analysis.motion.contacts.iter().enumerate().filter(|(i, _)| contains(set, *i));
    let labels: Vec<String> = closed.map(|(_, contact)| contact.label(&analysis.system)).collect();
    if labels.is_empty() { "in free motion".to_owned() } else { format!("on {}", labels.join(", ")) }
}
