//! Bar systems with their equations written by hand: independent of the generator.

#![allow(dead_code, reason = "each test binary uses some of the systems")]

pub mod a_frame;
pub mod falling_pair;
pub mod ladder;
pub mod rod_on_supports;
