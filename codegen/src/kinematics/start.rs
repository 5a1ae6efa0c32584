//! The start that a declaration gives is one of these coordinates.

use super::Kinematics;
use crate::syntax::{Report, unknown};
use crate::system::System;

impl Kinematics {
    /// Refuses starts of what is no coordinate or rate.
    ///
    /// # Errors
    /// Each name that is none.
    pub fn check_start(&self, system: &System) -> syn::Result<()> {
        let mut report = Report::default();
        let known = || self.coordinates.iter().map(|coordinate| coordinate.name.as_str());
        for (name, _) in &system.run.start {
            let coordinate = name.strip_suffix('\'').unwrap_or(name);
            if known().all(|known| known != coordinate) {
                let text = unknown("coordinate", &coordinate, known());
                report.at(system.run.span.unwrap_or_else(|| system.ident.span()), text);
            }
        }
        report.finish()
    }
}
