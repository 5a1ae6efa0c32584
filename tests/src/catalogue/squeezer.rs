//! Entry 13: Andrews' squeezer as published, Hairer & Wanner, Solving Ordinary Differential
//! Equations II, VII.7: seven angles β, Θ, γ, Φ, δ, Ω, ε with their mass matrix and the six
//! conditions of its loops, twice differentiated.
//!
//! The reference of the Test Set for IVP Solvers (Mazzia & Magherini, release 2.4, problem
//! `andrews`) is off by about 1e-12 s: these equations, integrated by two methods and at several
//! steps, agree with one another better than that.

use crate::numerics::extrapolated;
use nalgebra::{SMatrix, SVector};

const MASSES: [f64; 7] = [0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498];
const INERTIAS: [f64; 7] = [2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5];
const XB: f64 = -0.03635;
const YB: f64 = 0.03273;
const XC: f64 = 0.014;
const YC: f64 = 0.072;
const D: f64 = 0.028;
const DA: f64 = 0.0115;
const E: f64 = 0.02;
const EA: f64 = 0.01421;
const RR: f64 = 0.007;
const RA: f64 = 0.00092;
const SS: f64 = 0.035;
const SA: f64 = 0.01874;
const SB: f64 = 0.01043;
const SC: f64 = 0.018;
const SD: f64 = 0.02;
const TA: f64 = 0.02308;
const TB: f64 = 0.00916;
const U: f64 = 0.04;
const UA: f64 = 0.01228;
const UB: f64 = 0.00449;
const ZF: f64 = 0.02;
const ZT: f64 = 0.04;
const FA: f64 = 0.01421;
const TORQUE: f64 = 0.033;
const STIFFNESS: f64 = 4530.0;
const LENGTH: f64 = 0.07785;

type Angles = SVector<f64, 7>;

fn mass(q: &Angles) -> SMatrix<f64, 7, 7> {
    let [m1, m2, m3, m4, m5, m6, m7] = MASSES;
    let [i1, i2, i3, i4, i5, i6, i7] = INERTIAS;
    let (theta, sin_phi, sin_omega) = (q[1].cos(), q[3].sin(), q[5].sin());
    let mut m = SMatrix::<f64, 7, 7>::zeros();
    m[(0, 0)] = m1 * RA * RA + m2 * (RR * RR - 2.0 * DA * RR * theta + DA * DA) + i1 + i2;
    m[(0, 1)] = m2 * (DA * DA - DA * RR * theta) + i2;
    m[(1, 1)] = m2 * DA * DA + i2;
    m[(2, 2)] = m3 * (SA * SA + SB * SB) + i3;
    let arm = E - EA;
    m[(3, 3)] = m4 * arm * arm + i4;
    m[(3, 4)] = m4 * (arm * arm + ZT * arm * sin_phi) + i4;
    m[(4, 4)] = m4 * (ZT * ZT + 2.0 * ZT * arm * sin_phi + arm * arm) + m5 * (TA * TA + TB * TB) + i4 + i5;
    let arm = ZF - FA;
    m[(5, 5)] = m6 * arm * arm + i6;
    m[(5, 6)] = m6 * (arm * arm - U * arm * sin_omega) + i6;
    m[(6, 6)] = m6 * (arm * arm - 2.0 * U * arm * sin_omega + U * U) + m7 * (UA * UA + UB * UB) + i6 + i7;
    m.fill_lower_triangle_with_upper_triangle();
    m
}

fn forces(q: &Angles, v: &Angles) -> Angles {
    let (sin, cos) = q[2].sin_cos();
    let span = [SD * cos + SC * sin + XB - XC, SD * sin - SC * cos + YB - YC];
    let long = span[0].hypot(span[1]);
    let pull = span.map(|part| -STIFFNESS * (long - LENGTH) / long * part);
    let second = MASSES[1] * DA * RR * q[1].sin();
    let fourth = MASSES[3] * ZT * (E - EA) * q[3].cos();
    let sixth = MASSES[5] * U * (ZF - FA) * q[5].cos();
    Angles::from([
        TORQUE - second * v[1] * (v[1] + 2.0 * v[0]),
        second * v[0] * v[0],
        pull[0] * (SC * cos - SD * sin) + pull[1] * (SD * cos + SC * sin),
        fourth * v[4] * v[4],
        -fourth * v[3] * (v[3] + 2.0 * v[4]),
        -sixth * v[6] * v[6],
        sixth * v[5] * (v[5] + 2.0 * v[6]),
    ])
}

/// The gradients of the conditions, and their second derivatives by time without accelerations.
fn loops(q: &Angles, v: &Angles) -> (SMatrix<f64, 6, 7>, SVector<f64, 6>) {
    let (crank, link) = ([q[0].cos(), q[0].sin()], [(q[0] + q[1]).cos(), (q[0] + q[1]).sin()]);
    let (gamma, delta, epsilon) = (q[2].sin_cos(), q[4].sin_cos(), q[6].sin_cos());
    let (fourth, sixth) = ((q[3] + q[4]).sin_cos(), (q[5] + q[6]).sin_cos());
    let mut g = SMatrix::zeros();
    for row in [0, 2, 4] {
        g[(row, 0)] = -RR * crank[1] + D * link[1];
        g[(row, 1)] = D * link[1];
        g[(row + 1, 0)] = RR * crank[0] - D * link[0];
        g[(row + 1, 1)] = -D * link[0];
    }
    (g[(0, 2)], g[(1, 2)]) = (-SS * gamma.1, -SS * gamma.0);
    (g[(2, 3)], g[(3, 3)]) = (-E * fourth.1, -E * fourth.0);
    (g[(2, 4)], g[(3, 4)]) = (-E * fourth.1 + ZT * delta.0, -E * fourth.0 - ZT * delta.1);
    (g[(4, 5)], g[(5, 5)]) = (ZF * sixth.0, -ZF * sixth.1);
    (g[(4, 6)], g[(5, 6)]) = (ZF * sixth.0 - U * epsilon.1, -ZF * sixth.1 - U * epsilon.0);
    let square = |rate: f64| rate * rate;
    let (w, w4, w6) = (square(v[0] + v[1]), square(v[3] + v[4]), square(v[5] + v[6]));
    let of_link = [0, 1].map(|axis| -RR * crank[axis] * square(v[0]) + D * link[axis] * w);
    let bias = [
        of_link[0] + SS * gamma.0 * square(v[2]),
        of_link[1] - SS * gamma.1 * square(v[2]),
        of_link[0] + E * fourth.0 * w4 + ZT * delta.1 * square(v[4]),
        of_link[1] - E * fourth.1 * w4 + ZT * delta.0 * square(v[4]),
        of_link[0] + ZF * sixth.1 * w6 + U * epsilon.0 * square(v[6]),
        of_link[1] + ZF * sixth.0 * w6 - U * epsilon.1 * square(v[6]),
    ];
    (g, bias.into())
}

/// Rates and accelerations; NaN where the loops are singular.
fn derivative(state: &[f64; 14]) -> [f64; 14] {
    let (q, v) = (Angles::from_column_slice(&state[..7]), Angles::from_column_slice(&state[7..]));
    let (g, bias) = loops(&q, &v);
    let mut matrix = SMatrix::<f64, 13, 13>::zeros();
    matrix.fixed_view_mut::<7, 7>(0, 0).copy_from(&mass(&q));
    matrix.fixed_view_mut::<6, 7>(7, 0).copy_from(&g);
    matrix.fixed_view_mut::<7, 6>(0, 7).copy_from(&g.transpose());
    let mut right = SVector::<f64, 13>::zeros();
    right.fixed_rows_mut::<7>(0).copy_from(&forces(&q, &v));
    right.fixed_rows_mut::<6>(7).copy_from(&-bias);
    let solved = matrix.lu().solve(&right);
    std::array::from_fn(|i| if i < 7 { v[i] } else { solved.map_or(f64::NAN, |x| x[i - 7]) })
}

/// The accelerations of the angles at rest in a position.
pub fn accelerations(angles: &[f64; 7]) -> [f64; 7] {
    let state = std::array::from_fn(|i| angles.get(i).copied().unwrap_or_default());
    let derivative = derivative(&state);
    std::array::from_fn(|i| derivative[i + 7])
}

/// Angles, then rates, at a time after the start.
pub fn state(t: f64, steps: usize) -> [f64; 14] {
    let start = std::array::from_fn(|i| START.get(i).copied().unwrap_or_default());
    (0..steps).fold(start, |state, _| extrapolated(derivative, &state, t / steps as f64))
}

/// The start as published, at rest.
pub const START: [f64; 7] = [
    -0.061_713_890_014_276_45,
    0.0,
    0.455_279_819_163_070_4,
    0.222_668_390_165_885_88,
    0.487_364_979_543_842_55,
    -0.222_668_390_165_885_88,
    1.230_547_444_549_821_2,
];

/// The reference as published: angles, then rates, at t = 0.03.
pub const PUBLISHED: [f64; 14] = [
    15.810_771_196_299_04,
    -15.756_371_059_842_98,
    0.040_822_240_130_731_01,
    -0.534_730_116_322_694_8,
    0.524_409_965_880_530_4,
    0.534_730_116_322_694_8,
    1.048_080_741_042_263,
    1_139.920_302_151_208,
    -1_424.379_294_994_111,
    11.032_912_219_371_34,
    19.293_374_644_213_85,
    0.573_569_928_479_080_8,
    -19.293_374_644_213_85,
    0.323_179_165_802_695_5,
];

/// Accelerations of β and Θ at the start as published; the others vanish.
pub const START_ACCELERATIONS: [f64; 2] = [14_222.443_919_954_114, -10_666.832_939_965_585];
