//! Hinges with Coulomb friction against closed forms and maximal coordinates.

mod impacts;
mod mechanisms;
mod pairs;
mod pendulum;
