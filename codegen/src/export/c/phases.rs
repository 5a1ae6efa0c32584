//! The contact sets in closed form.

use super::Library;
use super::function::{CFunction, places};
use super::text::{comment, ended, string};
use crate::algebra::Symbol;
use crate::emit::Entries;
use crate::functions::PhaseFunctions;
use crate::motion::contains;
use crate::program::Id;

impl Library<'_> {
    /// The functions of each, then the table of all.
    pub(super) fn phases(&self) -> String {
        let p = &self.names.prefix;
        let all = || self.phases.iter().zip(&self.analysis.functions.phases);
        let functions: String = all().map(|(name, phase)| self.phase(name, phase)).collect();
        let line = |(name, phase): (&String, &PhaseFunctions)| {
            let (label, entries) = (string(&self.closed(phase)), self.entries(phase).len());
            format!(
                "    {{{label}, {name}_set, {entries}, {name}_restriction, {name}_derivative,\n     {name}_reactions, \
                 {name}_embedding}},\n"
            )
        };
        let lines: String = all().map(line).collect();
        let end = "{NULL, NULL, 0, NULL, NULL, NULL, NULL}";
        format!("{functions}const {p}_phase {p}_phases[] = {{\n{lines}    {end}\n}};\n")
    }

    fn phase(&self, name: &str, phase: &PhaseFunctions) -> String {
        let motion = &self.analysis.motion;
        let entries = self.entries(phase);
        let (size, carried) = (entries.len(), motion.carried().count());
        let set = motion.contacts.iter().enumerate().map(|(contact, law)| {
            let closed = contains(phase.set.closed, contact);
            let slides = closed && law.friction.is_some() && !contains(phase.set.stick, contact);
            (usize::from(closed) + usize::from(slides)).to_string()
        });
        let kept = entries.places(motion.n).into_iter().enumerate();
        let restricted: String = kept.map(|(i, place)| format!("    out[{i}] = state[{place}];\n")).collect();
        let unread = if size == 0 { "    (void)state;\n    (void)out;\n" } else { "" };
        let function = |kind: &str, outputs: Vec<Id>, behind: String| CFunction {
            head: format!("void {name}_{kind}"),
            entries,
            takes: "double *out",
            places: places(outputs.len()),
            outputs,
            derivative: Some(format!("{name}_derivative")),
            around: [String::new(), behind],
        };
        // What stands for what else a state has: 1 of the time, 0 of switches; the same in the
        // whole state.
        let slope = |symbol| if symbol == Symbol::Time { "1.0" } else { "0.0" };
        let slopes = motion.carried().map(slope).enumerate();
        let slopes =
            slopes.map(|(j, slope)| format!("    out[{}] = {slope};\n", size - carried + j)).collect();
        let same = (0..carried)
            .map(|j| format!("    out[{}] = state[{}];\n", 2 * motion.n + j, size - carried + j))
            .collect();
        let motion_outputs: Vec<Id> = phase.rates.iter().chain(&phase.accelerations).copied().collect();
        [
            self.about(phase) + "\n",
            format!("static const int {name}_set[] = {{{}}};\n\n", ended(set, "0")),
            format!(
                "void {name}_restriction(const double *state, double *out)\n{{\n{restricted}{unread}}}\n\n"
            ),
            self.function(&function("derivative", motion_outputs, slopes)),
            self.function(&function("reactions", phase.reactions.clone(), String::new())),
            self.function(&function("embedding", phase.embedding.clone(), same)),
        ]
        .concat()
    }

    /// Which contact set it is, and what its state has.
    pub(super) fn about(&self, phase: &PhaseFunctions) -> String {
        let coordinates = &self.analysis.kinematics.coordinates;
        let kept = phase.kept.iter().map(|&i| comment(&coordinates[i].name));
        let moving = phase.moving.iter().map(|&i| format!("{}'", comment(&coordinates[i].name)));
        let carried = self.analysis.motion.carried().map(|symbol| self.names.inputs[&symbol].clone());
        let entries: Vec<String> = kept.chain(moving).chain(carried).collect();
        let entries = if entries.is_empty() { "nothing".to_owned() } else { entries.join(", ") };
        format!("/* On {}. Its state: {entries}. */\n", comment(&self.closed(phase)))
    }

    fn entries<'a>(&'a self, phase: &'a PhaseFunctions) -> Entries<'a> {
        Entries { kept: &phase.kept, moving: &phase.moving, motion: &self.analysis.motion }
    }

    /// The closed contacts by name, those that slide as such.
    fn closed(&self, phase: &PhaseFunctions) -> String {
        let contacts = self.analysis.motion.contacts.iter().enumerate();
        let closed = contacts.filter(|(i, _)| contains(phase.set.closed, *i));
        let labels = closed.map(|(i, contact)| {
            let slides = contact.friction.is_some() && !contains(phase.set.stick, i);
            format!("{}{}", if slides { "sliding " } else { "" }, contact.label(&self.analysis.system))
        });
        let labels: Vec<String> = labels.collect();
        if labels.is_empty() { "no contact".to_owned() } else { labels.join("; ") }
    }
}
