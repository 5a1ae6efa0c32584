//! The default run of every model.

mod bars;
mod bodies;
mod chains;
mod friction;
mod loops;
mod points;
mod seed;

/// One mass, one length, and gravity in SI units.
const ONE: [(&str, f64); 3] = [("m", 1.0), ("l", 1.0), ("g", 9.81)];
