//! What is emitted for every model against other forms of the same equations, compiled without
//! optimisations.

#[macro_use]
mod each;

mod emitted;
mod taylor;
