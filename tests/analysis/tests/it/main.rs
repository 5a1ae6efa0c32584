//! What follows from models, in one program: each of its files would compile the same models and
//! runs again.

mod fit;
mod on_the_way;
mod optima;
mod orbits;
mod readings;
mod rest;
mod sensitivity;
mod vibration;
