//! Colours over two axes: cells or dots, in colours of categories or from a scale.

use super::axes::{BELOW, LEFT, MARGIN, axes};
use super::figure::{Area, DrawingError, Drawn, Figure, lettering, px};
use super::{Axis, Colour, LegendSquare, legend};
use plotters::prelude::*;

/// Pixels of the colour bar with its labels.
const BAR: u32 = 110;
/// Colours that are told apart on a scale.
const STEPS: u8 = 250;

/// A colour of a map.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Shade {
    /// That of a category.
    Colour(Colour),
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
            Self::Colour(colour) => colour.rgb(),
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
    /// Position in units of the axes.
    pub at: [f64; 2],
    /// Its colour.
    pub shade: Shade,
}

/// A map: rectangles and dots over two axes; legend and caption stand above, the colour bar to the right.
#[derive(Clone, PartialEq, Debug)]
pub struct Map {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Rectangles, from left to right and from below upwards.
    pub patches: Vec<Patch>,
    /// Dots.
    pub dots: Vec<Dot>,
    /// What the colours of categories stand for.
    pub legend: Vec<LegendSquare>,
    /// The observation, above the map.
    pub caption: String,
    /// The numbers at the ends of the scale, if it is used.
    pub bar: Option<[f64; 2]>,
}

impl Figure {
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
        let rest = legend::squares::draw(area, &self.caption, &self.legend, 1.0)?;
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
        let rectangles = rectangles(&self.patches, [&self.x, &self.y], axes.plotting_area().dim_in_pixel());
        axes.draw_series(rectangles)?;
        let dot = |dot: &Dot| Circle::new((dot.at[0], dot.at[1]), px(3), dot.shade.rgb().filled());
        axes.draw_series(self.dots.iter().map(dot))?;
        Ok(())
    }
}

/// Each reaches a pixel under those that are drawn after it, so that no line is seen between neighbours.
fn rectangles<'a>(
    patches: &'a [Patch],
    [x, y]: [&'a Axis; 2],
    (width, height): (u32, u32),
) -> impl Iterator<Item = Rectangle<(f64, f64)>> + 'a {
    let [right, up] = [width, height].map(|length| f64::from(px(1)) / f64::from(length.max(1)));
    patches.iter().map(move |patch| {
        let further = (x.onward(patch.x[1], right), y.onward(patch.y[1], up));
        Rectangle::new([(patch.x[0], patch.y[0]), further], patch.shade.rgb().filled())
    })
}

/// The scale with its numbers.
fn bar(area: &Area, [low, high]: [f64; 2]) -> Drawn {
    let (across, along) = (Axis::linear("", [0.0, 1.0]), Axis::linear("", [low, high]));
    let mut axes = ChartBuilder::on(area)
        .margin(px(MARGIN))
        .margin_left(0)
        .margin_bottom(px(MARGIN + BELOW))
        .right_y_label_area_size(px(LEFT))
        .build_cartesian_2d(across.clone(), along.clone())?;
    let part = |step: u8| low + (high - low) * f64::from(step) / f64::from(STEPS);
    let patch = |step: u8| Patch { x: [0.0, 1.0], y: [part(step), part(step + 1)], shade: Shade::Step(step) };
    let patches: Vec<Patch> = (0..STEPS).map(patch).collect();
    let rectangles = rectangles(&patches, [&across, &along], axes.plotting_area().dim_in_pixel());
    axes.draw_series(rectangles)?;
    axes.configure_mesh()
        .disable_mesh()
        .axis_style(Colour::Black.rgb().stroke_width(px(1)))
        .label_style(lettering())
        .set_all_tick_mark_size(px(5))
        .draw()?;
    Ok(())
}
