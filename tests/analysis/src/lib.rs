//! Nothing: what is tested is the analysis, by `tests/it`. The models there are compiled without
//! optimisations, since they run for moments.
