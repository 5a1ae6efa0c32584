//! The detector on guards that are given as functions of time: no mechanics in between.

mod arrivals;
mod corners;
mod flights;
mod given;
mod kept;
mod listed;
mod polynomials;
mod sampled;
mod waiting;
mod work;
