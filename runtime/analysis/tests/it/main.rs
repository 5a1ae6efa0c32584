//! What follows from models, in one program: each of its files would compile the same models and runs again.

mod orbits;
mod rest;
mod sensitivity;
mod vibration;
