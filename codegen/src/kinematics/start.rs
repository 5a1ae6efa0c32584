//! The start that a declaration gives is one of these coordinates.

use super::Kinematics;
use crate::syntax::{Report, unknown};
use crate::system::{StartValue, System};

impl Kinematics {
    /// Refuses starts of what is no coordinate or rate, and units that measure something else.
    ///
    /// # Errors
    /// Each of them.
    pub fn check_start(&self, system: &System) -> syn::Result<()> {
        let mut report = Report::default();
        let all = || self.coordinates.iter().chain(self.dependent.iter().map(|angle| &angle.declared));
        let known = || all().map(|coordinate| coordinate.name.as_str());
        let span = system.run.span.unwrap_or_else(|| system.ident.span());
        for StartValue { name, powers, .. } in &system.run.start {
            let (bare, time) = name.strip_suffix('\'').map_or((name.as_str(), 0), |bare| (bare, -1));
            let Some(coordinate) = all().find(|known| known.name == bare) else {
                report.add_message(span, unknown("coordinate", &bare, known()));
                continue;
            };
            let (length, what) = if coordinate.is_angle() { (0, "an angle") } else { (1, "a length") };
            // An angle is a number.
            if let Some([given @ .., _]) = powers
                && *given != [length, time, 0]
            {
                let (what, example) = match (time, length) {
                    (0, 0) => (what.to_owned(), "80 deg"),
                    (0, _) => (what.to_owned(), "200 mm"),
                    (_, 0) => (format!("the rate of {what}"), "2 rad/s"),
                    (_, _) => (format!("the rate of {what}"), "2 mm/s"),
                };
                report.add_message(
                    span,
                    format!(
                        "`{name}` is {what}; its unit measures something else: write `{name} = {example}`"
                    ),
                );
            }
        }
        report.finish()
    }
}
