//! The figure while it is completed.

use super::frame::Frame;
use super::{Line, Place, Scope, Structure};
use crate::algebra::Series;
use crate::syntax::plain;

/// Places found so far.
pub(super) struct FigureDraft<'a> {
    pub structure: &'a Structure,
    pub places: Vec<Option<Place>>,
    /// Which of them hang where nothing is known.
    pub assumed: Vec<bool>,
}

impl<'a> FigureDraft<'a> {
    /// The places of the figure and of the pins.
    pub fn given(scope: &mut Scope, structure: &'a Structure) -> Self {
        let mut places = vec![None; structure.points.len()];
        for (name, at) in &scope.description.figure {
            let point = structure.point(scope, name);
            let place = scope.position(at);
            let place = scope.report.keep(place);
            match point.zip(place) {
                None => scope.placed = false,
                Some((point, _)) if places[point].is_some() => {
                    scope.report.add_message(
                        name.span(),
                        format!("point `{name}` is placed twice in the figure; remove one"),
                    );
                }
                Some((point, place)) => places[point] = Some(place),
            }
        }
        let mut draft = Self { structure, assumed: vec![false; places.len()], places };
        draft.pinned(scope);
        draft
    }

    fn pinned(&mut self, scope: &mut Scope) {
        let structure = self.structure;
        let pins = structure.pins.iter().map(|pin| (pin.point, pin.at.clone(), pin.span, "pinned"));
        let points = structure.points.iter().enumerate();
        let ground = points.filter_map(|(i, point)| Some((i, point.ground.clone()?, point.span, "fixed")));
        let mut given: Vec<_> = pins.chain(ground).collect();
        for (name, at) in &scope.description.loose_pins {
            let held = structure.points.iter().position(|point| point.name == plain(name));
            let held = held.zip(scope.position(at).ok());
            given.extend(held.map(|(point, at)| (point, at, name.span(), "pinned")));
        }
        for (point, at, span, held) in given {
            let known = self.places[point].replace(at.clone());
            if known.is_some_and(|place| place != at) {
                let name = &self.structure.points[point].name;
                let text = format!(
                    "`{name}` is {held} to another place than the figure says; leave it out of the figure"
                );
                scope.report.add_message(span, text);
            }
        }
    }

    /// Places the other points of bodies of which two are known; whether there were any.
    pub fn spread(&mut self, scope: &mut Scope) -> bool {
        let mut any = false;
        while let Some((body, frame)) = self.next_frame(scope) {
            self.lay(scope, body, &frame, false);
            any = true;
        }
        any
    }

    fn next_frame(&self, scope: &mut Scope) -> Option<(usize, Frame)> {
        (0..self.structure.bodies.len()).find_map(|body| {
            let frame = if self.lacks(body) { Frame::through(scope, &self.known(body)) } else { None };
            frame.map(|frame| (body, frame))
        })
    }

    fn lacks(&self, body: usize) -> bool {
        self.structure.members(body).iter().any(|(point, _)| self.places[*point].is_none())
    }

    fn known(&self, body: usize) -> Vec<(Place, Place)> {
        let place = |(point, z): &(usize, Place)| self.places[*point].clone().map(|w| (w, z.clone()));
        self.structure.members(body).iter().filter_map(place).collect()
    }

    fn lay(&mut self, scope: &Scope, body: usize, frame: &Frame, assumed: bool) {
        for &(point, ref z) in self.structure.members(body) {
            if self.places[point].is_none() {
                self.places[point] = Some(frame.transform(scope, z));
                self.assumed[point] = assumed;
            }
        }
    }

    /// Places what the mirror and gravity say.
    pub fn finish(&mut self, scope: &mut Scope, mirror: Option<(&Line, &[usize])>) {
        loop {
            let mirrored = mirror.is_some_and(|(line, images)| self.reflect(line, images));
            if !(mirrored | self.spread(scope) || self.hang(scope)) {
                return;
            }
        }
    }

    fn reflect(&mut self, line: &Line, images: &[usize]) -> bool {
        let mut any = false;
        for (point, &image) in images.iter().enumerate() {
            if let (None, Some(place)) = (&self.places[point], &self.places[image]) {
                self.places[point] = Some(line.image(place));
                self.assumed[point] = self.assumed[image];
                any = true;
            }
        }
        any
    }

    /// Lets the first bar of which one point is known hang from it; whether there was one.
    fn hang(&mut self, scope: &mut Scope) -> bool {
        let candidate = (0..self.structure.bodies.len()).find_map(|body| {
            if self.lacks(body) { self.known(body).pop().map(|known| (body, known)) } else { None }
        });
        let Some((body, (w, z))) = candidate else {
            return false;
        };
        let down = self.down(scope);
        let turn = match self.structure.is_bar(body) {
            true => {
                let backwards = z[0] == self.structure.bodies[body].length;
                Some(down.map(|c| Series::integer(if backwards { -c } else { c })))
            }
            false => {
                Frame::pointing(scope, &z, &self.structure.bodies[body].centre, down.map(Series::integer))
            }
        };
        // A body held by its centre of mass hangs anyhow.
        let turn = turn.unwrap_or_else(|| [Series::one(), Series::zero()]);
        self.lay(scope, body, &Frame { w, z, turn }, true);
        true
    }

    /// The direction of gravity if it is along an axis, else to the right.
    fn down(&self, scope: &Scope) -> [i64; 2] {
        let sign = |g: &Series| if scope.nominal().evaluate(g) < 0.0 { -1 } else { 1 };
        match &self.structure.gravity {
            Some([x, y]) if x.is_zero() && !y.is_zero() => [0, sign(y)],
            Some([x, y]) if y.is_zero() && !x.is_zero() => [sign(x), 0],
            _ => [1, 0],
        }
    }
}
