//! The equations of the whole system.

use super::Exported;
use super::python::{bracketed, column, dictionary, matrix, string, tuple};
use crate::algebra::Series;
use crate::motion::Dense;
use crate::syntax::plain;

impl Exported<'_> {
    /// What the module is, and its imports.
    pub(super) fn head(&self) -> String {
        let system = &self.analysis.system;
        let summary = system.summary.replace('\\', "\\\\").replace('"', "'");
        let summary = if summary.is_empty() { String::new() } else { format!("\n{summary}\n") };
        format!(
            "\"\"\"Equations of motion of {}, derived by liftoff {}, for SymPy.\n{summary}\n\
             mass_matrix*accelerations + velocity_terms = forces + sum of jacobian.T*multiplier over the rows that hold\n\
             \"\"\"\n\
             from typing import NamedTuple\n\n\
             import sympy\n\
             from sympy import Expr, Matrix, Rational, Symbol, cos, pi, sin, sqrt, tan, zeros\n\n",
            plain(&system.ident),
            env!("CARGO_PKG_VERSION"),
        )
    }

    /// T, V, M, h, Q and the points.
    pub(super) fn system(&self, dense: &Dense) -> String {
        let Self { analysis, formulas } = self;
        let motion = &analysis.motion;
        let n = motion.n;
        let list = |series: &[Series]| series.iter().map(|s| formulas.series(s)).collect::<Vec<String>>();
        let mass: Vec<Vec<String>> = dense.mass.iter().map(|row| list(row)).collect();
        let rows = motion
            .rows
            .iter()
            .flat_map(|row| row.jacobian.iter().chain([&row.gap, &row.bias, &row.prescribed_gap_rate]));
        let laws = motion.contacts.iter().filter_map(|contact| Some(&contact.friction.as_ref()?.kinetic));
        let symbols = dense.forces.iter().chain([&motion.potential]).chain(rows).chain(laws);
        let symbols = symbols.flat_map(Series::symbols).collect();
        let energy = |name, energy: &Series| format!("{name} = {}\n", bracketed(&formulas.series(energy)));
        let mut text = self.definitions(&motion.opaque_terms, symbols, "");
        text += &energy("kinetic", &dense.kinetic());
        text += &energy("potential", &motion.potential);
        text += &format!("mass_matrix = {}\n", matrix(&mass, n));
        text += &format!("velocity_terms = {}\n", column(list(&dense.velocity_terms)));
        text += &format!("forces = {}\n", column(list(&dense.forces)));
        let points = analysis.system.points.iter().zip(&analysis.kinematics.points);
        let points = points.map(|(point, place)| (string(&point.name), tuple(list(place))));
        text += &format!("points = {}\n", dictionary(points, ""));
        text
    }
}
