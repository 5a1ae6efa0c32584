//! A model in its pose, as textbooks draw it.

mod angles;
mod bodies;
mod canvas;
mod frame;
mod joints;
mod labels;
mod lengths;
mod positions;
mod script;
mod springs;
mod supports;
mod svg;
#[cfg(test)]
mod tests;

use crate::plot::Colour;
use crate::plot::svg::plane;
use crate::registry::Configuration;
use canvas::{Canvas, Pen, Placement, Spot};
use frame::Frame;
use labels::{PlacedLabel, placed};
use liftoff_core::model::Geometry;
use plane::{Box2, Px, along, left_of, towards, unit};
use script::Script;

/// Size of letters, pixels.
const LETTERS: f64 = 15.0;
/// Margin, pixels.
const MARGIN: f64 = 14.0;

/// The model in its pose as SVG text: bars, joints, supports hatched on their solid side, threads,
/// springs, gravity, coordinates, and lengths with their values.
pub fn drawing(configuration: &Configuration) -> String {
    let mut draft = Draft::new(configuration);
    draft.all();
    let labels = placed(&draft.canvas);
    let area = draft.extent(&labels).wider(MARGIN);
    let description = format!("{}: {}", configuration.layout.name, configuration.layout.summary);
    svg::svg(&description, area, &draft.canvas.shapes, &labels)
}

/// A drawing in the making.
struct Draft<'a> {
    configuration: &'a Configuration,
    geometry: &'static Geometry,
    frame: Frame,
    canvas: Canvas,
}

impl<'a> Draft<'a> {
    fn new(configuration: &'a Configuration) -> Self {
        let (geometry, frame) = (configuration.geometry(), Frame::from_configuration(configuration));
        Self { configuration, geometry, frame, canvas: Canvas::default() }
    }

    /// From back to front.
    fn all(&mut self) {
        self.supports();
        self.guides();
        self.springs();
        self.threads();
        self.bodies();
        self.joints();
        self.radii();
        self.angles();
        self.lengths();
        self.positions();
        self.names_of_bodies();
        self.gravity();
    }

    /// Maps a point to the drawing.
    fn map_point(&self, point: usize) -> Px {
        self.frame.px(self.configuration.points[point])
    }

    /// Requests a label beside a point of the drawing.
    fn placement(&mut self, text: Script, at: Px, clearance: f64, side: Px) {
        self.word((text, Colour::Black), vec![Spot { at, side }], clearance);
    }

    /// Requests a label of a measure.
    fn measured(&mut self, text: Script, at: Px, clearance: f64, side: Px) {
        self.word((text, Colour::Blue), vec![Spot { at, side }], clearance);
    }

    fn word(&mut self, (text, colour): (Script, Colour), at: Vec<Spot>, clearance: f64) {
        self.canvas.placements.push(Placement { text, size: LETTERS, colour, at, clearance });
    }

    /// The gravity arrow, beside the drawing.
    fn gravity(&mut self) {
        let Some(components) = self.geometry.gravity else { return };
        let [x, y] = self.configuration.position(components);
        if x == 0.0 && y == 0.0 {
            return;
        }
        let area = self.canvas.extent().unwrap_or(self.frame.area);
        let down = towards(y.atan2(x));
        let middle = [area.most[0] + 26.0, area.least[1] + 24.0];
        let ends = [along(middle, down, -20.0), along(middle, down, 20.0)];
        self.canvas.arrow(ends.to_vec(), Pen::new(Colour::Black, 1.6), false);
        self.placement(Script::quantity("g"), middle, 7.0, unit(left_of(down)));
    }

    fn extent(&self, labels: &[PlacedLabel]) -> Box2 {
        let words = labels.iter().map(|label| label.area);
        let drawn = self.canvas.extent().unwrap_or(self.frame.area);
        words.fold(drawn, Box2::with)
    }
}
