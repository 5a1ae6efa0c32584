//! Colours over two axes: cells or dots, in colours of categories or from a scale.

use super::axes::{BELOW, LEFT, MARGIN, axes};
use super::sheet::{Area, DrawingError, Drawn, Sheet, lettering, px};
use super::{Axis, Ink, Swatch, swatch};
use plotters::prelude::*;

/// Pixels of the colour bar with its labels.
const BAR: u32 = 110;
/// Colours that are told apart on a scale.
const STEPS: u8 = 250;

/// A colour of a map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shade {
    /// That of a category.
    Ink(Ink),
    /// A place on the scale viridis, in 250ths: even to the eye and in grey, told apart by colour-blind readers too.
    Step(u8),
}

impl Shade {
    /// The place on the scale of a part from 0 to 1.
    pub fn of_part(part: f64) -> Self {
        Self::Step((part.clamp(0.0, 1.0) * f64::from(STEPS)).round() as u8)
    }

    fn rgb(self) -> RGBColor {
        match self {
            Self::Ink(ink) => ink.rgb(),
            Self::Step(step) => ViridisRGB.get_color(f32::from(step) / f32::from(STEPS)),
        }
    }
}

/// A rectangle of a map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Patch {
    /// From where to where it is wide.
    pub x: [f64; 2],
    /// From where to where it is high.
    pub y: [f64; 2],
    /// Its colour.
    pub shade: Shade,
}

/// A dot of a map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Dot {
    /// Where.
    pub at: [f64; 2],
    /// Its colour.
    pub shade: Shade,
}

/// A map: rectangles and dots over two axes; key and caption stand above, the colour bar to the right.
#[derive(Clone, PartialEq, Debug)]
pub struct Map {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Rectangles.
    pub patches: Vec<Patch>,
    /// Dots.
    pub dots: Vec<Dot>,
    /// What the colours of categories stand for.
    pub key: Vec<Swatch>,
    /// What is shown.
    pub caption: String,
    /// The numbers at the ends of the scale, if it is used.
    pub bar: Option<[f64; 2]>,
}

impl Sheet {
    /// The maps one below the other, as SVG text.
    pub fn maps(&self, maps: &[Map]) -> Result<String, DrawingError> {
        self.draw(|area| {
            let strips = area.split_evenly((maps.len(), 1));
            strips.iter().zip(maps).try_for_each(|(strip, map)| map.draw(strip))
        })
    }
}

impl Map {
    fn draw(&self, area: &Area) -> Drawn {
        let rest = swatch::draw(area, &self.caption, &self.key, 1.0)?;
        let plot = match self.bar {
            None => rest,
            Some(range) => {
                let (width, _) = rest.dim_in_pixel();
                let (plot, strip) = rest.split_horizontally(width - px(BAR));
                bar(&strip, range)?;
                plot
            }
        };
        let mut axes = axes(&plot, [&self.x, &self.y], false)?;
        axes.draw_series(self.patches.iter().map(Patch::rectangle))?;
        let dot = |dot: &Dot| Circle::new((dot.at[0], dot.at[1]), px(3), dot.shade.rgb().filled());
        axes.draw_series(self.dots.iter().map(dot))?;
        Ok(())
    }
}

impl Patch {
    /// With an edge of its own colour, so that no line is seen between neighbours.
    fn rectangle(&self) -> Rectangle<(f64, f64)> {
        let corners = [(self.x[0], self.y[0]), (self.x[1], self.y[1])];
        Rectangle::new(corners, self.shade.rgb().filled().stroke_width(1))
    }
}

/// The scale with its numbers.
fn bar(area: &Area, [low, high]: [f64; 2]) -> Drawn {
    let axis = Axis::linear("", [low, high]);
    let mut axes = ChartBuilder::on(area)
        .margin(px(MARGIN))
        .margin_left(0)
        .margin_bottom(px(MARGIN + BELOW))
        .right_y_label_area_size(px(LEFT))
        .build_cartesian_2d(Axis::linear("", [0.0, 1.0]), axis)?;
    let part = |step: u8| low + (high - low) * f64::from(step) / f64::from(STEPS);
    let patch = |step: u8| Patch { x: [0.0, 1.0], y: [part(step), part(step + 1)], shade: Shade::Step(step) };
    axes.draw_series((0..STEPS).map(|step| patch(step).rectangle()))?;
    axes.configure_mesh()
        .disable_mesh()
        .axis_style(Ink::Black.rgb().stroke_width(px(1)))
        .label_style(lettering())
        .set_all_tick_mark_size(px(5))
        .draw()?;
    Ok(())
}
