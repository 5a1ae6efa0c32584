//! Hinges with Coulomb friction against closed forms and maximal coordinates.

mod cranks;
mod impacts;
mod mechanisms;
mod pairs;
mod pendulum;
mod rising_loads;
