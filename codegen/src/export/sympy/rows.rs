//! Rows of contacts, joints and slips.

use super::Exported;
use super::python::{matrix, string};
use crate::algebra::{Series, Symbol};
use crate::motion::Row;

impl Exported<'_> {
    /// The list of all rows.
    pub(super) fn rows(&self) -> String {
        let motion = &self.analysis.motion;
        let rows: String = motion.rows.iter().enumerate().map(|(i, row)| self.row(i, row)).collect();
        format!("rows = [\n{rows}]\n")
    }

    fn row(&self, i: usize, row: &Row) -> String {
        let Self { analysis, formulas } = self;
        let (contacts, slips) = (&analysis.motion.contacts, analysis.motion.slips());
        let contact = |i: usize| (contacts[i].label(&analysis.system), contacts[i].two_sided);
        let (kind, (of, always), friction) = match i {
            _ if i < contacts.len() => ("contact", contact(i), None),
            _ if i < slips => {
                ("joint", (analysis.kinematics.joints[i - contacts.len()].name.clone(), true), None)
            }
            _ => {
                let of = analysis.motion.tangents[i - slips];
                ("slip", contact(of), self.friction(of))
            }
        };
        let series = |series: &Series| formulas.series(series);
        let jacobian: Vec<String> = row.jacobian.iter().map(series).collect();
        let columns = jacobian.len();
        format!(
            "    Row(\n        {}, \"{kind}\", {},\n        gap={},\n        jacobian={},\n        bias={},\n        drift={},\n        \
             friction={},\n        always={},\n    ),\n",
            string(&of),
            formulas.symbol(Symbol::reaction(i)),
            series(&row.gap),
            matrix(&[jacobian], columns),
            series(&row.bias),
            series(&row.prescribed_gap_rate),
            friction.unwrap_or_else(|| "None".to_owned()),
            if always { "True" } else { "False" },
        )
    }

    /// σμ of a contact with friction.
    pub(super) fn friction(&self, contact: usize) -> Option<String> {
        let law = self.analysis.motion.contacts[contact].friction.as_ref()?;
        let sense = self.formulas.symbol(Symbol::Sense(contact as u16));
        Some(format!("{sense}*({})", self.formulas.series(&law.kinetic)))
    }
}
