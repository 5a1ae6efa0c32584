//! Vectors of instructions that the target need not have: AVX-512, or AVX2 with FMA.
//!
//! In a binary for any x86-64, ensembles side by side take 0.28 of the time by AVX-512, 0.48 by
//! AVX2; right-hand sides of 2 to 32 bars for many states 0.25 to 0.31, and 0.46 to 0.57.
//!
//! # Safety
//!
//! Every `unsafe` here is one of two.
//!
//! - An instruction, or a function compiled for it. Both types are private to `dispatch`, whose
//!   [`widest`](super::widest) alone hands them out, after the standard library's test: where there
//!   is such a type in running code, the processor has its instructions.
//! - Registers seen as doubles, or as the vectors of the target. All are eight doubles in their
//!   order, as the assertion on sizes and alignments has it, and any bits are doubles.
#![allow(unsafe_code, reason = "the module's proof")]

use core::arch::x86_64::*;
use core::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Shl, Shr, Sub};

use wide::f64x8;

use super::{Inside, Vector};
use super::{LANES, Lanes};
use crate::scalar::sin_cos::{Doubles, sin_cos, sin_cos_inlined};

/// A type of registers, and another of the same as integers.
macro_rules! registers {
    (
        $features:literal, $vector:ident, $bits:ident, $function:ident: [$register:ident, $integers:ident; $count:literal],
        $add:ident $sub:ident $mul:ident $div:ident $mul_add:ident $sqrt:ident $max:ident $min:ident $floor:path, $splat:ident,
        $le:path, $add_bits:ident $sub_bits:ident $and:ident $or:ident $xor:ident $left:ident $right:ident, $splat_bits:ident
    ) => {
        /// Doubles.
        #[derive(Clone, Copy, Debug)]
        #[repr(transparent)]
        pub struct $vector([$register; $count]);

        const _: () = assert!(size_of::<$vector>() == size_of::<f64x8>() && align_of::<$vector>() <= align_of::<f64x8>());

        /// Their bits.
        #[derive(Clone, Copy, Debug)]
        #[repr(transparent)]
        pub struct $bits([$integers; $count]);

        #[target_feature(enable = $features)]
        fn $function<W: Inside>(work: W) -> W::Output {
            work.run()
        }

        operators!($vector: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);
        operators!($bits: Add add $add_bits, Sub sub $sub_bits, BitAnd bitand $and, BitOr bitor $or, BitXor bitxor $xor);
        shifts!($bits: Shl shl $left, Shr shr $right);

        impl Neg for $vector {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self::from_bits(self.to_bits() ^ Self::bits(1 << 63))
            }
        }

        impl Doubles for $vector {
            type Bits = $bits;

            #[inline(always)]
            fn splat(x: f64) -> Self {
                Self([unsafe { $splat(x) }; $count])
            }

            #[inline(always)]
            fn abs(self) -> Self {
                Self::from_bits(self.to_bits() & Self::bits(!(1 << 63)))
            }

            #[inline(always)]
            fn within(self, bound: f64) -> bool {
                let (sizes, bounds) = (self.abs().0, Self::splat(bound).0);
                let mut all = true;
                for i in 0..$count {
                    all &= unsafe { $le(sizes[i], bounds[i]) };
                }
                all
            }

            #[cold]
            fn singly<const FUSED: bool>(self) -> (Self, Self) {
                let pairs = self.as_array().map(sin_cos::<FUSED, f64>);
                (Self::new(pairs.map(|(sin, _)| sin)), Self::new(pairs.map(|(_, cos)| cos)))
            }

            #[inline(always)]
            fn mul_add<const FUSED: bool>(self, a: Self, b: Self) -> Self {
                if FUSED { self.multiply_add(a, b) } else { self * a + b }
            }

            #[inline(always)]
            fn to_bits(self) -> $bits {
                unsafe { core::mem::transmute(self) }
            }

            #[inline(always)]
            fn from_bits(bits: $bits) -> Self {
                unsafe { core::mem::transmute(bits) }
            }

            #[inline(always)]
            fn bits(bits: u64) -> $bits {
                $bits([unsafe { $splat_bits(bits as i64) }; $count])
            }

            #[inline(always)]
            fn lowest_bit_everywhere(bits: $bits) -> $bits {
                Self::bits(0) - (bits & Self::bits(1))
            }
        }

        impl Vector for $vector {
            #[inline(always)]
            fn new(values: [f64; LANES]) -> Self {
                unsafe { core::mem::transmute(values) }
            }

            #[inline(always)]
            fn as_array(&self) -> &[f64; LANES] {
                unsafe { &*(&raw const *self).cast() }
            }

            #[inline(always)]
            fn as_mut_array(&mut self) -> &mut [f64; LANES] {
                unsafe { &mut *(&raw mut *self).cast() }
            }

            #[inline(always)]
            fn sqrt(mut self) -> Self {
                for i in 0..$count {
                    self.0[i] = unsafe { $sqrt(self.0[i]) };
                }
                self
            }

            #[inline(always)]
            fn max(mut self, other: Self) -> Self {
                for i in 0..$count {
                    self.0[i] = unsafe { $max(self.0[i], other.0[i]) };
                }
                self
            }

            #[inline(always)]
            fn min(mut self, other: Self) -> Self {
                for i in 0..$count {
                    self.0[i] = unsafe { $min(self.0[i], other.0[i]) };
                }
                self
            }

            #[inline(always)]
            fn floor(mut self) -> Self {
                for i in 0..$count {
                    self.0[i] = unsafe { $floor(self.0[i]) };
                }
                self
            }

            #[inline(always)]
            fn multiply_add(mut self, a: Self, b: Self) -> Self {
                for i in 0..$count {
                    self.0[i] = unsafe { $mul_add(self.0[i], a.0[i], b.0[i]) };
                }
                self
            }

            #[inline(always)]
            fn sin_cos_all<const V: usize, const K: usize>(
                angles: [[Self; V]; K],
            ) -> ([[Self; V]; K], [[Self; V]; K]) {
                sin_cos_inlined::<true, Self, V, K>(angles)
            }

            #[inline(always)]
            fn view<const V: usize>(lanes: &[Lanes<V>]) -> &[Lanes<V, Self>] {
                unsafe { core::slice::from_raw_parts(lanes.as_ptr().cast(), lanes.len()) }
            }

            #[inline(always)]
            fn view_mut<const V: usize>(lanes: &mut [Lanes<V>]) -> &mut [Lanes<V, Self>] {
                unsafe { core::slice::from_raw_parts_mut(lanes.as_mut_ptr().cast(), lanes.len()) }
            }

            #[inline(always)]
            fn inside<W: Inside>(work: W) -> W::Output {
                unsafe { $function(work) }
            }
        }
    };
}

macro_rules! operators {
    ($type:ident: $($operator:ident $method:ident $instruction:ident),*) => {$(
        impl $operator for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for i in 0..self.0.len() {
                    self.0[i] = unsafe { $instruction(self.0[i], other.0[i]) };
                }
                self
            }
        }
    )*};
}

macro_rules! shifts {
    ($type:ident: $($operator:ident $method:ident $instruction:ident),*) => {$(
        impl $operator<u32> for $type {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, by: u32) -> Self {
                for i in 0..self.0.len() {
                    self.0[i] = unsafe { $instruction(self.0[i], _mm_cvtsi64_si128(i64::from(by))) };
                }
                self
            }
        }
    )*};
}

registers! {
    "avx512f", Avx512, Bits512, with_avx512: [__m512d, __m512i; 1],
    _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd _mm512_fmadd_pd _mm512_sqrt_pd _mm512_max_pd _mm512_min_pd
    floor_512, _mm512_set1_pd, all_512, _mm512_add_epi64 _mm512_sub_epi64 _mm512_and_si512 _mm512_or_si512 _mm512_xor_si512
    _mm512_sll_epi64 _mm512_srl_epi64, _mm512_set1_epi64
}
registers! {
    "avx2,fma", Avx2, Bits256, with_avx2: [__m256d, __m256i; 2],
    _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_fmadd_pd _mm256_sqrt_pd _mm256_max_pd _mm256_min_pd
    _mm256_floor_pd, _mm256_set1_pd, all_256, _mm256_add_epi64 _mm256_sub_epi64 _mm256_and_si256 _mm256_or_si256
    _mm256_xor_si256 _mm256_sll_epi64 _mm256_srl_epi64, _mm256_set1_epi64x
}

/// Whether all are at most as large as the others.
#[target_feature(enable = "avx512f")]
#[inline]
fn all_512(a: __m512d, b: __m512d) -> bool {
    _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b) == u8::MAX
}

#[target_feature(enable = "avx512f")]
#[inline]
fn floor_512(x: __m512d) -> __m512d {
    _mm512_roundscale_pd::<_MM_FROUND_TO_NEG_INF>(x)
}

/// Whether all are at most as large as the others.
#[target_feature(enable = "avx2")]
#[inline]
fn all_256(a: __m256d, b: __m256d) -> bool {
    _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b)) == 0b1111
}
