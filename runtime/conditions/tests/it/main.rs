//! Conditions of the workspace's models.

mod declared;
mod paper;
mod refusals;
