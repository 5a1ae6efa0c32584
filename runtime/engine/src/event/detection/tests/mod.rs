//! The detector on guards that are given as functions of time: no mechanics in between.

mod affine;
mod arrivals;
mod corners;
mod flights;
pub(super) mod given;
mod kept;
mod listed;
mod polynomials;
mod sampled;
mod series;
mod steep;
mod waiting;
mod work;
