//! The capacities for which methods are compiled.

/// An integration of the first `entries` entries of `N`.
pub(super) struct Sized<T, const N: usize> {
    pub(super) stepper: T,
    pub(super) entries: usize,
}

/// Evaluates an expression of type `Option` with the constant `$N` the least capacity for `$len` entries; none beyond. Small
/// systems have nearly their own size, as their loops are unrolled. Implicit methods have fewer capacities, Radau's with its
/// matrices in place none above 64.
macro_rules! sized {
    (explicit $len:expr, $N:ident => $begin:expr) => {
        sized!(@ $len, $N => $begin; 2 4 6 8 12 16 32 64 128 1024 8192)
    };
    (gauss $len:expr, $N:ident => $begin:expr) => {
        sized!(@ $len, $N => $begin; 2 4 8 16 32 64 128 1024)
    };
    (radau $len:expr, $N:ident => $begin:expr) => {
        sized!(@ $len, $N => $begin; 2 4 6 8 12 16 32 64)
    };
    (@ $len:expr, $N:ident => $begin:expr; $($size:literal)*) => {
        match $len {
            $(len if len <= $size => {
                const $N: usize = $size;
                $begin
            })*
            _ => None,
        }
    };
}
pub(super) use sized;
