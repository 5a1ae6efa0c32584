//! Impacts with friction against closed forms, and random ones against the conditions of their law.

mod angles;
mod closed_forms;
mod limits;
mod paths;
mod random;
mod rest;
