//! Curves over two axes.

use super::sheet::{Area, DrawingError, Drawn, Sheet, lettering, offset, px};
use super::{Axis, Ink, Scale};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

const KEY_STRIP: u32 = 26;

/// A line through points.
#[derive(Clone, PartialEq, Debug)]
pub struct Curve {
    /// Its name in the key; empty: not in the key.
    pub name: String,
    /// Its colour.
    pub ink: Ink,
    /// Whether it is dashed.
    pub dashed: bool,
    /// Whether every point is marked.
    pub dotted: bool,
    /// Its points.
    pub points: Vec<[f64; 2]>,
}

impl Curve {
    /// A solid line.
    pub fn solid(name: &str, ink: Ink, points: Vec<[f64; 2]>) -> Self {
        Self {
            name: name.into(),
            ink,
            dashed: false,
            dotted: false,
            points,
        }
    }

    /// The same line, dashed.
    #[must_use]
    pub fn dashed(self) -> Self {
        Self {
            dashed: true,
            ..self
        }
    }

    /// The same line with its points marked.
    #[must_use]
    pub fn dotted(self) -> Self {
        Self {
            dotted: true,
            ..self
        }
    }
}

/// A labelled point.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark {
    /// Where.
    pub at: [f64; 2],
    /// What is written beside it.
    pub label: String,
    /// Where the label stands, in pixels right of and below the point.
    pub offset: (i32, i32),
}

/// One panel: axes, curves, marks; the key stands above the axes, never over data.
#[derive(Clone, PartialEq, Debug)]
pub struct Chart {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Curves in drawing order.
    pub curves: Vec<Curve>,
    /// Labelled points.
    pub marks: Vec<Mark>,
}

impl Sheet {
    /// The panels one below the other, as SVG text.
    pub fn charts(&self, panels: &[Chart]) -> Result<String, DrawingError> {
        self.draw(panels, |chart, area| chart.draw(area))
    }
}

impl Chart {
    fn draw(&self, area: &Area) -> Drawn {
        let (key, plot) = area.split_vertically(px(KEY_STRIP));
        self.key(&key)?;
        let mut axes = ChartBuilder::on(&plot)
            .margin_right(px(24))
            .margin_top(px(4))
            .margin_left(px(6))
            .x_label_area_size(px(46))
            .y_label_area_size(px(66))
            .build_cartesian_2d(self.x.clone(), self.y.clone())?;
        axes.configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(Ink::Grey.rgb().stroke_width(px(1)))
            .axis_style(Ink::Black.rgb().stroke_width(px(1)))
            .label_style(lettering())
            .axis_desc_style(lettering())
            .x_desc(self.x.name.as_str())
            .y_desc(self.y.name.as_str())
            .set_all_tick_mark_size(px(5))
            .draw()?;
        if self.y.scale == Scale::Linear && self.y.ends()[0] < 0.0 && self.y.ends()[1] > 0.0 {
            let zero = self.x.range.map(|x| (x, 0.0));
            axes.draw_series(LineSeries::new(zero, Ink::Black.rgb().stroke_width(px(1))))?;
        }
        for curve in &self.curves {
            let line = curve.points.iter().map(|p| (p[0], p[1]));
            let style = curve.ink.rgb().stroke_width(px(2));
            if curve.dashed {
                axes.draw_series(DashedLineSeries::new(line.clone(), px(7), px(5), style))?;
            } else {
                axes.draw_series(LineSeries::new(line.clone(), style))?;
            }
            if curve.dotted {
                axes.draw_series(line.map(|p| Circle::new(p, px(3), curve.ink.rgb().filled())))?;
            }
        }
        for mark in &self.marks {
            let text = |(dx, dy)| {
                let anchor = if dx < 0 { HPos::Right } else { HPos::Left };
                let style = lettering();
                Text::new(
                    mark.label.clone(),
                    (dx, dy),
                    style.pos(Pos::new(anchor, VPos::Center)),
                )
            };
            axes.draw_series([EmptyElement::at((mark.at[0], mark.at[1]))
                + Circle::new((0, 0), px(4), Ink::Black.rgb().filled())
                + text(offset(mark.offset))])?;
        }
        Ok(())
    }

    fn key(&self, strip: &Area) -> Drawn {
        let mut left = 74;
        for curve in self.curves.iter().filter(|curve| !curve.name.is_empty()) {
            let style = curve.ink.rgb().stroke_width(px(2));
            let ends = [left, left + 26].map(|x| offset((x, 14)));
            if curve.dashed {
                strip.draw(&DashedPathElement::new(ends, px(7), px(5), style))?;
            } else {
                strip.draw(&PathElement::new(ends, style))?;
            }
            let text = lettering().pos(Pos::new(HPos::Left, VPos::Center));
            strip.draw(&Text::new(
                curve.name.clone(),
                offset((left + 32, 14)),
                text,
            ))?;
            left += 56 + 8 * curve.name.chars().count() as i32;
        }
        Ok(())
    }
}
