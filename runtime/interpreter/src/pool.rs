//! Memory that is lent and comes back, thread by thread.

use core::cell::RefCell;
use core::ops::{Deref, DerefMut};

use liftoff_core::scalar::{DoubleDouble, Dual4, Scalar};
use liftoff_core::system::{LongTimeSeries, TimeSeries};

use crate::code::{self, Code};

/// A type of which memory is lent.
pub(crate) trait Pooled: Copy + 'static {
    const FILLING: Self;
    fn with_pool<R>(use_it: impl FnOnce(&mut Vec<Vec<Self>>) -> R) -> R;
}

/// A number that code is interpreted on.
pub(crate) trait Number: Scalar + Pooled {
    /// Executes the instructions of code on registers.
    fn run(code: &Code, registers: &mut [Self]) {
        code::run(&code.instructions, &code.ratios, registers);
    }
}

impl Number for f64 {
    #[cfg(feature = "jit")]
    fn run(code: &Code, registers: &mut [Self]) {
        match code.native.get(|| crate::native::Straight::compile(code)) {
            Some(native) => native.call(registers),
            None => code::run(&code.instructions, &code.ratios, registers),
        }
    }
}

impl Number for DoubleDouble {}
impl Number for Dual4 {}
impl Number for TimeSeries {}
impl Number for LongTimeSeries {}

macro_rules! pooled {
    ($($number:ty = $filling:expr),* $(,)?) => {$(
        impl Pooled for $number {
            const FILLING: Self = $filling;
            fn with_pool<R>(use_it: impl FnOnce(&mut Vec<Vec<Self>>) -> R) -> R {
                thread_local! {
                    static POOL: RefCell<Vec<Vec<$number>>> = const { RefCell::new(Vec::new()) };
                }
                POOL.with_borrow_mut(use_it)
            }
        }
    )*};
}

pooled! {
    usize = 0,
    f64 = 0.0,
    DoubleDouble = <DoubleDouble as Scalar>::ZERO,
    Dual4 = <Dual4 as Scalar>::ZERO,
    TimeSeries = <TimeSeries as Scalar>::ZERO,
    LongTimeSeries = <LongTimeSeries as Scalar>::ZERO,
}

/// Memory of a certain length, whatever is in it.
pub(crate) struct Lent<T: Pooled> {
    values: Vec<T>,
    len: usize,
}

impl<T: Pooled> Lent<T> {
    pub fn new(len: usize) -> Self {
        let mut values = T::with_pool(Vec::pop).unwrap_or_default();
        if values.len() < len {
            values.resize(len, T::FILLING);
        }
        Self { values, len }
    }
}

impl<T: Pooled> Drop for Lent<T> {
    fn drop(&mut self) {
        let values = core::mem::take(&mut self.values);
        T::with_pool(|pool| pool.push(values));
    }
}

impl<T: Pooled> Deref for Lent<T> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        &self.values[..self.len]
    }
}

impl<T: Pooled> DerefMut for Lent<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.values[..self.len]
    }
}
