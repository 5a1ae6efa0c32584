//! Impacts with friction against closed forms, and random ones against the conditions of their law.

mod closed_forms;
mod random;
