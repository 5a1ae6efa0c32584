//! Drawings as SVG: curves over axes, and superposed positions of a bar system.
//!
//! Everything here takes plain points; nothing knows mechanics.

mod annotations;
mod axes;
mod axis;
mod bands;
mod chart;
mod dash;
mod figure;
mod format;
mod legend;
mod map;
mod stacked;
mod superposition;
pub(crate) mod svg;

pub use annotations::{Annotations, Band, Head};
pub use axis::{Axis, Scale};
pub use bands::{Banded, Stripe};
pub use chart::{Chart, Curve, Mark};
pub use dash::Dash;
pub use figure::Figure;
pub(crate) use format::significant;
pub use legend::{LegendLine, LegendSquare};
pub use map::{Dot, Map, Patch, Shade};
pub use superposition::{Label, Stroke, Superposition};
pub use svg::{Colour, with_theme};
