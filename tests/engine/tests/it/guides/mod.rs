//! Guides with Coulomb friction against closed forms.

mod beads;
mod drawers;
mod mechanisms;
