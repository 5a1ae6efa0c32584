//! Bar systems that several tests run: the falling pair by hand, which keeps the trait's contract implementable without
//! the derive, the others derived.

#![allow(dead_code, reason = "each test binary uses some of the systems")]

pub mod a_frame;
pub mod block;
pub mod bob;
pub mod bouncing_bar;
pub mod continuity;
pub mod double_pendulum;
pub mod falling_pair;
pub mod ladder;
pub mod pair_on_corners;
pub mod particle;
pub mod rod_on_supports;
pub mod spring_pendulum;
pub mod struck_chain;
pub mod zigzag;
