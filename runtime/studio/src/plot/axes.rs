//! A pair of axes on an area.

use super::figure::{Area, Drawn, lettering, px};
use super::{Axis, Colour};
use plotters::chart::ChartContext;
use plotters::coord::cartesian::Cartesian2d;
use plotters::prelude::*;

/// Pixels left of the axes, for labels.
pub(super) const LEFT: u32 = 66;
/// Pixels below the axes, for labels.
pub(super) const BELOW: u32 = 46;
/// The same where the horizontal axis has no name.
const BELOW_UNNAMED: u32 = 24;
/// Pixels round all of it.
pub(super) const MARGIN: u32 = 12;

/// Half the width of a letter, upwards, in pixels.
const HALF_LETTER: u32 = 5;

pub(super) type Axes<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;

/// Draws the axes, with grid lines at the labels if asked for.
pub(super) fn axes<'a, 'b>(
    area: &'a Area<'b>,
    [x, y]: [&Axis; 2],
    grid: bool,
) -> Result<Axes<'a, 'b>, Box<dyn std::error::Error>> {
    let mut axes = ChartBuilder::on(area)
        .margin(px(MARGIN))
        .margin_right(px(right_of(x)))
        .x_label_area_size(px(if x.name.is_empty() { BELOW_UNNAMED } else { BELOW }))
        .y_label_area_size(px(LEFT))
        .build_cartesian_2d(x.clone(), y.clone())?;
    let lines = if grid { Colour::Grey.rgb().mix(1.0) } else { TRANSPARENT };
    axes.configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(lines.stroke_width(px(1)))
        .axis_style(Colour::Black.rgb().stroke_width(px(1)))
        .label_style(lettering())
        .axis_desc_style(lettering())
        .x_desc(x.name.as_str())
        .y_desc(y.name.as_str())
        .set_all_tick_mark_size(px(5))
        .draw()?;
    Ok(axes)
}

/// Draws the lower axis alone.
pub(super) fn lower(axes: &mut Axes, x: &Axis) -> Drawn {
    axes.configure_mesh()
        .disable_mesh()
        .disable_y_axis()
        .axis_style(Colour::Black.rgb().stroke_width(px(1)))
        .label_style(lettering())
        .axis_desc_style(lettering())
        .x_desc(x.name.as_str())
        .set_all_tick_mark_size(px(5))
        .draw()?;
    Ok(())
}

/// Pixels from the left edge to the value on an axis of an area so wide.
pub(super) fn across(x: &Axis, width: u32, value: f64) -> f64 {
    let (left, right) = (f64::from(LEFT + MARGIN), f64::from(width - right_of(x)));
    let part = (value - x.range[0]) / (x.range[1] - x.range[0]);
    left + part * (right - left)
}

/// Pixels right of the axes: a label at their very end stands over it by half.
pub(super) fn right_of(x: &Axis) -> u32 {
    x.label_at_end().map_or(MARGIN, |label| MARGIN.max(HALF_LETTER * label.chars().count() as u32))
}
