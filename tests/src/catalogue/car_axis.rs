//! The car axis of the Test Set for IVP Solvers (Mazzia & Magherini, release 2.4, problem
//! `caraxis`).

/// The reference as published, by GAMD in quadruple precision: x and y of the chassis' left and
/// right end, then their rates, at t = 3.
pub const PUBLISHED: [f64; 8] = [
    0.049_345_578_427_540_28,
    0.496_989_460_230_171_15,
    1.041_742_524_885_421_5,
    0.373_911_027_265_361_26,
    -0.077_058_368_404_097_24,
    0.007_446_866_587_237_786,
    0.017_556_815_753_723_222,
    0.770_341_043_779_251_9,
];

/// The multiplier of x_l x_b + y_l y_b = 0, published in the same place.
pub const MULTIPLIER: f64 = -0.004_736_886_590_848_933;
