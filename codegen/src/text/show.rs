//! Equations as text.

use core::fmt;

use super::{Equations, PhaseEquations};

impl fmt::Display for Equations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.name)?;
        for coordinate in &self.coordinates {
            writeln!(f, "  {}: {}", coordinate.symbol, coordinate.meaning)?;
        }
        let entries = self.energies.iter().chain(&self.mass).chain(&self.velocity_terms).chain(&self.forces);
        for equation in entries.chain(&self.definitions).chain(&self.gaps) {
            writeln!(f, "  {equation}")?;
        }
        for (name, equation) in &self.joints {
            writeln!(f, "  {name}: 0 = {equation}")?;
        }
        self.sections().try_for_each(|phase| write!(f, "\n{phase}"))
    }
}

impl fmt::Display for PhaseEquations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.title())?;
        let equations = self.eliminated.iter().chain(&self.energies).chain(&self.motion);
        for equation in equations.chain(&self.reactions) {
            writeln!(f, "  {equation}")?;
        }
        match &self.cost {
            Some(cost) => writeln!(f, "  cost: {cost}"),
            None if !self.multipliers.is_empty() => Ok(()),
            None => writeln!(f, "  cost: solved by loops"),
        }
    }
}
