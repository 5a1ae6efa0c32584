//! Nothing: what is tested is the derive macro, by `tests`. Dependencies that these ask for would be compiled once more, for the
//! compiler, were they in the macro's own package.
