//! A pair of axes on an area.

use super::{Axis, Colour};
use crate::plot::svg::plane::{Box2, Px, add, thinned};
use crate::plot::svg::{Anchor, Lettering, Pen, Style, Svg};

/// Pixels left of the axes, for labels.
pub(super) const LEFT: f64 = 66.0;
/// Pixels below the axes, for labels.
pub(super) const BELOW: f64 = 46.0;
/// The same where the horizontal axis has no name.
const BELOW_UNNAMED: f64 = 24.0;
/// Pixels round all of it.
pub(super) const MARGIN: f64 = 12.0;

/// Width of a letter and height of a word, in pixels.
const WORD: Px = [6.6, 13.0];
/// Half the width of a letter, upwards, in pixels.
const HALF_LETTER: f64 = 5.0;
/// Length of a tick, and from the axis to the middle of a label below it and to the end of one
/// beside it, pixels.
const TICK: f64 = 5.0;
const LABEL: Px = [10.0, 14.5];
/// From the edges of the area to the middle of the names of the axes, pixels.
const NAME: Px = [17.0, 19.0];
const LINE: Pen = Pen::new(Colour::Black, 1.0);

/// A pair of axes and the frame that they span.
pub(super) struct Axes<'a> {
    x: &'a Axis,
    y: &'a Axis,
    area: Box2,
    pub frame: Box2,
}

impl<'a> Axes<'a> {
    /// Axes with their labels in an area.
    pub fn within(area: Box2, [x, y]: [&'a Axis; 2]) -> Self {
        let below = if x.name.is_empty() { BELOW_UNNAMED } else { BELOW };
        let least = [area.least[0] + MARGIN + LEFT, area.least[1] + MARGIN];
        let most = [area.most[0] - right_of(x), area.most[1] - MARGIN - below];
        let frame = Box2 { least, most: [0, 1].map(|i| most[i].max(least[i])) };
        Self { x, y, area, frame }
    }

    /// Where a point stands.
    pub fn map_point(&self, [x, y]: [f64; 2]) -> Px {
        let ([left, top], [right, bottom]) = (self.frame.least, self.frame.most);
        [left + self.x.part(x) * (right - left), bottom + self.y.part(y) * (top - bottom)]
    }

    /// Both axes.
    pub fn draw(&self, svg: &mut Svg) {
        upright(svg, self.y, self.frame, -1.0);
        let at = [self.area.least[0] + NAME[0], self.frame.centre()[1]];
        svg.word(Lettering { upwards: true, ..Lettering::new(at) }, &self.y.name);
        self.lower(svg);
    }

    /// Lines at the labels.
    pub fn grid(&self, svg: &mut Svg) {
        let Box2 { least, most } = self.frame;
        let upright = ticks(self.x, [least[0], most[0]]).map(|(x, _)| [[x, least[1]], [x, most[1]]]);
        let level = ticks(self.y, [most[1], least[1]]).map(|(y, _)| [[least[0], y], [most[0], y]]);
        svg.segments(upright.chain(level), Pen::new(Colour::Grey, 1.0));
    }

    /// The lower axis.
    pub fn lower(&self, svg: &mut Svg) {
        let Box2 { least: [left, _], most: [right, y] } = self.frame;
        let marks = ticks(self.x, [left, right]).map(|(x, _)| [[x, y], [x, y + TICK]]);
        svg.segments(marks.chain([[[left, y], [right, y]]]), LINE);
        for (x, label) in ticks(self.x, [left, right]) {
            svg.word(Lettering::new([x, y + LABEL[1]]), &label);
        }
        let at = [f64::midpoint(left, right), self.area.most[1] - NAME[1]];
        svg.word(Lettering::new(at), &self.x.name);
    }

    /// The part of a line through points that is seen, broken where one is not finite.
    pub fn line(&self, svg: &mut Svg, points: &[[f64; 2]], pen: Pen) {
        let seen = self.frame.wider(0.5);
        let places: Vec<Px> = points.iter().map(|&point| self.map_point(point)).collect();
        for run in places.split(|place| !is_finite(place)) {
            seen.inside(run).iter().for_each(|part| svg.line(&thinned(part), pen));
        }
    }

    /// Those of the points that are seen.
    pub fn dots(&self, svg: &mut Svg, points: &[[f64; 2]], radius: f64, style: impl Into<Style>) {
        let (seen, style) = (self.frame.wider(0.5), style.into());
        let places = points.iter().map(|&point| self.map_point(point)).filter(|&place| seen.holds(place));
        places.for_each(|place| svg.circle(place, radius, style));
    }

    /// A word so many pixels right of and below a point: to the side it is moved to, else centred.
    pub fn word(&self, svg: &mut Svg, point: [f64; 2], (right, below): (i32, i32), text: &str) {
        let anchor = match right.signum() {
            -1 => Anchor::End,
            0 => Anchor::Middle,
            _ => Anchor::Start,
        };
        let at = add(self.map_point(point), [right, below].map(f64::from));
        svg.word(Lettering::new(at).anchored(anchor), text);
    }

    /// What a word at this place covers.
    pub fn span_of_word(&self, point: [f64; 2], (right, below): (i32, i32), text: &str) -> Box2 {
        let [x, y] = add(self.map_point(point), [right, below].map(f64::from));
        let wide = WORD[0] * text.chars().count() as f64;
        let left = match right.signum() {
            -1 => x - wide,
            0 => x - wide / 2.0,
            _ => x,
        };
        Box2 { least: [left, y - WORD[1] / 2.0], most: [left + wide, y + WORD[1] / 2.0] }
    }

    /// The part of a rectangle that is seen.
    pub fn rectangle(&self, [x, y]: [[f64; 2]; 2]) -> Box2 {
        let corners = [self.map_point([x[0], y[0]]), self.map_point([x[1], y[1]])];
        let [a, b] =
            corners.map(|corner| [0, 1].map(|i| corner[i].clamp(self.frame.least[i], self.frame.most[i])));
        Box2 { least: a, most: a }.with(Box2 { least: b, most: b })
    }

    /// A stripe over all the height.
    pub fn stripe(&self, [from, to]: [f64; 2]) -> Box2 {
        self.rectangle([[from, to], self.y.range])
    }
}

pub(super) fn is_finite(point: &Px) -> bool {
    point.iter().all(|x| x.is_finite())
}

/// Labels of an axis with their places, from its start to its end.
fn ticks(axis: &Axis, [start, end]: [f64; 2]) -> impl Iterator<Item = (f64, String)> {
    let at = move |tick: f64| (start + axis.part(tick) * (end - start), axis.label(tick));
    axis.labelled().into_iter().filter(|&tick| (-1e-9..=1.0 + 1e-9).contains(&axis.part(tick))).map(at)
}

/// An axis at the left side of a frame with its labels left of it, or at the right side with labels
/// right of it.
pub(super) fn upright(svg: &mut Svg, axis: &Axis, frame: Box2, side: f64) {
    let Box2 { least: [left, top], most: [right, bottom] } = frame;
    let (x, anchor) = if side < 0.0 { (left, Anchor::End) } else { (right, Anchor::Start) };
    let marks = ticks(axis, [bottom, top]).map(|(y, _)| [[x, y], [x + side * TICK, y]]);
    svg.segments(marks.chain([[[x, top], [x, bottom]]]), LINE);
    for (y, label) in ticks(axis, [bottom, top]) {
        svg.word(Lettering::new([x + side * LABEL[0], y]).anchored(anchor), &label);
    }
}

/// Pixels from the left edge to the value on an axis of an area so wide.
pub(super) fn across(x: &Axis, width: u32, value: f64) -> f64 {
    let (left, right) = (LEFT + MARGIN, f64::from(width) - right_of(x));
    left + x.part(value) * (right - left)
}

/// Pixels right of the axes: a label at their very end stands over it by half.
fn right_of(x: &Axis) -> f64 {
    x.label_at_end().map_or(MARGIN, |label| MARGIN.max(HALF_LETTER * label.chars().count() as f64))
}
