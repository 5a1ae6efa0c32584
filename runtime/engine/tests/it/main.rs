//! Runs of small models through the whole of the crate, in one program: each of its files would compile the same
//! integrators and drivers again.

mod batch;
mod bodies;
mod bouncing;
mod budget;
mod cancelled;
mod charts;
mod closed_forms;
mod contacts;
mod driven;
mod errors;
mod falling_pair;
mod fast_guards;
mod figures;
mod flow;
mod friction;
mod gate;
mod grooves;
mod impacts;
mod impulses;
mod jacobian;
mod low_flights;
mod methods;
mod nonsmooth;
mod observed;
mod phase_functions;
mod planks;
mod random_loads;
mod rocking;
mod settling;
mod shared;
mod singular_starts;
mod split;
mod threads;
mod units;
mod until_event;
