//! What follows from models, in one program: each of its files would compile the same models and runs again.

mod fit;
mod optima;
mod orbits;
mod readings;
mod rest;
mod sensitivity;
mod vibration;
