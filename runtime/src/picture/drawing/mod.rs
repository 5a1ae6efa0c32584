//! A model in its pose, as textbooks draw it.

mod angles;
mod bodies;
mod canvas;
mod frame;
mod joints;
mod labels;
mod lengths;
mod plane;
mod positions;
mod script;
mod springs;
mod supports;
mod svg;
#[cfg(test)]
mod tests;

use super::anatomy::Anatomy;
use crate::catalog::Still;
use crate::plot::{DrawingError, Ink};
use canvas::{Canvas, Pen, Wish};
use frame::Frame;
use labels::{Label, placed};
use plane::{Box2, Px, along, left_of, towards, unit};
use script::Script;

/// Size of letters, pixels.
const LETTERS: f64 = 15.0;
/// Free pixels round all of it.
const MARGIN: f64 = 14.0;

/// The model in its pose as SVG text: bars, joints, supports hatched on their solid side, threads, springs, gravity,
/// coordinates, and lengths with their values.
///
/// # Errors
/// A declaration that cannot be read again.
pub fn drawing(still: &Still) -> Result<String, DrawingError> {
    let mut draft = Draft::of(still)?;
    draft.all();
    let labels = placed(&draft.canvas);
    let sheet = draft.sheet(&labels).wider(MARGIN);
    let description = format!("{}: {}", still.layout.name, still.layout.summary);
    Ok(svg::svg(&description, sheet, &draft.canvas.shapes, &labels))
}

/// A drawing in the making.
struct Draft<'a> {
    anatomy: Anatomy<'a>,
    frame: Frame,
    canvas: Canvas,
}

impl<'a> Draft<'a> {
    fn of(still: &'a Still) -> Result<Self, DrawingError> {
        let anatomy = Anatomy::of(still)?;
        let frame = Frame::of(&anatomy);
        Ok(Self { anatomy, frame, canvas: Canvas::default() })
    }

    /// From back to front.
    fn all(&mut self) {
        self.supports();
        self.guides();
        self.springs();
        self.threads();
        self.bodies();
        self.joints();
        self.angles();
        self.lengths();
        self.positions();
        self.gravity();
    }

    /// Where a point is on the drawing.
    fn at(&self, point: usize) -> Px {
        self.frame.px(self.anatomy.point(point))
    }

    /// Asks for a word beside a point of the drawing.
    fn wish(&mut self, text: Script, at: Px, clearance: f64, side: Px) {
        self.canvas.wishes.push(Wish { text, size: LETTERS, ink: Ink::Black, at, clearance, side });
    }

    /// The same for a word that says what is measured.
    fn measured(&mut self, text: Script, at: Px, clearance: f64, side: Px) {
        self.canvas.wishes.push(Wish { text, size: LETTERS, ink: Ink::Blue, at, clearance, side });
    }

    /// An arrow g beside all that is drawn.
    fn gravity(&mut self) {
        let Some(components) = &self.anatomy.system.gravity else { return };
        let [x, y] = self.anatomy.place(components);
        if x == 0.0 && y == 0.0 {
            return;
        }
        let sheet = self.canvas.extent().unwrap_or(self.frame.area);
        let down = towards(y.atan2(x));
        let middle = [sheet.most[0] + 26.0, sheet.least[1] + 24.0];
        let ends = [along(middle, down, -20.0), along(middle, down, 20.0)];
        self.canvas.arrow(ends.to_vec(), Pen::of(Ink::Black, 1.6), false);
        self.wish(Script::quantity("g"), middle, 7.0, unit(left_of(down)));
    }

    fn sheet(&self, labels: &[Label]) -> Box2 {
        let words = labels.iter().map(|label| label.area);
        let drawn = self.canvas.extent().unwrap_or(self.frame.area);
        words.fold(drawn, Box2::with)
    }
}
