//! Outputs of a motion against time, or against another output.

mod events;
mod panels;
#[cfg(test)]
mod tests;

use super::PictureError;
use super::quantities::{Quantities, shown};
use super::sample::{seen, traced};
use crate::catalog::Record;
use crate::plot::{Axis, Chart, Sheet};
use events::Told;
use panels::{Panel, defaults};

/// Width of a sheet, and the height of a panel, pixels.
const SIZE: (u32, u32) = (860, 230);
/// Height that words, keys and the axis below take beside the panels.
const BESIDE: u32 = 90;

/// Outputs of a motion, those of one unit in one panel, over one axis.
pub struct Charts<'a> {
    record: &'a dyn Record,
    outputs: Vec<String>,
    against: String,
    size: (Option<u32>, Option<u32>),
}

impl<'a> Charts<'a> {
    /// Of a motion: its coordinates, reactions and energies against time, if nothing else is asked for.
    pub fn new(record: &'a dyn Record) -> Self {
        Self { record, outputs: Vec::new(), against: "t".into(), size: (None, None) }
    }

    /// These outputs: expressions as of [`Output`](crate::Output).
    #[must_use]
    pub fn outputs(self, outputs: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { outputs: outputs.into_iter().map(Into::into).collect(), ..self }
    }

    /// Against this output in place of time.
    #[must_use]
    pub fn against(self, output: &str) -> Self {
        Self { against: output.into(), ..self }
    }

    /// Width and height in pixels; what is not given is chosen.
    #[must_use]
    pub fn size(self, width: Option<u32>, height: Option<u32>) -> Self {
        Self { size: (width, height), ..self }
    }

    /// As SVG text. Phases are shaded by turns and named by their closed supports, events are marked and named; a value
    /// that an event changes at once is drawn before and after it, and where it is not finite there is a gap.
    ///
    /// # Errors
    /// An output that the model does not have.
    pub fn svg(&self) -> Result<String, PictureError> {
        let quantities = Quantities::of(self.record);
        let outputs = if self.outputs.is_empty() { defaults(self.record) } else { self.outputs.clone() };
        let x = self.record.output(&self.against)?;
        let curves: Result<Vec<_>, PictureError> = outputs
            .iter()
            .map(|output| Ok((output.clone(), traced(self.record, &*x, &*self.record.output(output)?))))
            .collect();
        let panels = Panel::grouped(curves?, &quantities);
        let is_time = self.against.trim() == "t";
        let axis = self.axis(&panels, &quantities, is_time);
        let told = if is_time {
            Told::over(self.record, &axis, self.width())
        } else {
            Told::beside(self.record, self.width())
        };
        let charts: Result<Vec<Chart>, PictureError> = panels
            .iter()
            .enumerate()
            .map(|(i, panel)| {
                let mut chart = panel.chart(&axis, &quantities, i + 1 == panels.len());
                chart.marks.extend(told.marks(self.record, &*x, panel)?);
                Ok(chart)
            })
            .collect();
        let ground = told.ground();
        let height =
            self.size.1.unwrap_or(BESIDE + SIZE.1 * panels.len() as u32 + 19 * ground.notes.len() as u32);
        let sheet = Sheet { description: self.description(&outputs), size: (self.width(), height) };
        Ok(sheet.stacked(&charts?, &ground)?)
    }

    fn width(&self) -> u32 {
        self.size.0.unwrap_or(SIZE.0)
    }

    /// Time ends where the run ends; all else has a little room.
    fn axis(&self, panels: &[Panel], quantities: &Quantities, is_time: bool) -> Axis {
        let name = quantities.axis(&shown(&self.against), quantities.unit(&self.against).as_deref());
        let [start, end] = self.record.interval();
        if is_time && start < end {
            return Axis::linear(&name, [start, end]);
        }
        let points = panels.iter().flat_map(|panel| &panel.curves).flat_map(|(_, curve)| &curve.pieces);
        Axis::holding(&name, seen(points.flat_map(|piece| &piece.points).map(|point| point[0])))
    }

    fn description(&self, outputs: &[String]) -> String {
        format!("{}: {} against {}", self.record.layout().name, outputs.join(", "), self.against)
    }
}
