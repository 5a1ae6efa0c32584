//! Radau IIA of order 5: nodes cᵢ, the transformation T⁻¹A⁻¹T = diag(γ, [α −β; β α]) and the
//! weights of the error estimate (Hairer & Wanner II, IV.8, eqs. 8.13, 8.20; digits as in Hairer's
//! `radau5.f`).
#![expect(clippy::excessive_precision, reason = "the published digits, to be compared with the source")]

/// √6.
const ROOT: f64 = 2.449489742783178098197284;

/// c.
pub(super) const NODES: [f64; 3] = [(4.0 - ROOT) / 10.0, (4.0 + ROOT) / 10.0, 1.0];

/// γ, the real eigenvalue of A⁻¹: 3 + 3^(2/3) − 3^(1/3).
pub(super) const GAMMA: f64 = 3.637834252744495732208418513577775979782;

/// α ± iβ, the others: 3 − (3^(2/3) − 3^(1/3))/2 ± i (3^(7/6) + 3^(5/6))/2.
pub(super) const ALPHA: f64 = 2.681082873627752133895790743211112010109;
pub(super) const BETA: f64 = 3.050430199247410569426377624787569790436;

/// T.
pub(super) const FORWARD: [[f64; 3]; 3] = [
    [9.1232394870892942792e-2, -0.14125529502095420843, -3.0029194105147424492e-2],
    [0.24171793270710701896, 0.20412935229379993199, 0.38294211275726193779],
    [0.96604818261509293619, 1.0, 0.0],
];

/// T⁻¹.
pub(super) const BACK: [[f64; 3]; 3] = [
    [4.3255798900631553510, 0.33919925181580986954, 0.54177053993587487119],
    [-4.1787185915519047273, -0.32768282076106238708, 0.47662355450055045196],
    [-0.50287263494578687595, 2.5719269498556054292, -0.59603920482822492497],
];

/// −h p′(0) of the collocation polynomial p with p(cᵢ) = zᵢ, p(0) = 0.
pub(super) const DEFECT: [f64; 3] = [-(13.0 + 7.0 * ROOT) / 3.0, (-13.0 + 7.0 * ROOT) / 3.0, -1.0 / 3.0];

/// A matrix times a vector of stages.
pub(super) fn transform<const N: usize>(matrix: &[[f64; 3]; 3], x: &[[f64; N]; 3]) -> [[f64; N]; 3] {
    matrix.map(|row| core::array::from_fn(|i| row[0] * x[0][i] + row[1] * x[1][i] + row[2] * x[2][i]))
}
