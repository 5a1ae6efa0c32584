//! Nothing: what is tested is the engine, by `tests/it`. The models there are compiled without the
//! engine's optimisations, since they are many and run for moments.
