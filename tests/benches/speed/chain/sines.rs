/// g over the length of a bar.
pub struct Rhs {
    gravity: f64,
}

impl Rhs {
    pub fn prepare(gravity: f64) -> Self {
        Self { gravity }
    }
}

/// x = q π/2 + r, |r| ≤ π/4, two parts of π/2 and fdlibm's polynomials, as an expert writes it for
/// angles of a few turns.
#[inline(always)]
fn sine(x: f64) -> (f64, f64) {
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let shifted = x.mul_add(core::f64::consts::FRAC_2_PI, ROUND);
    let (q, quarter) = (shifted - ROUND, shifted.to_bits());
    let r = (-q).mul_add(6.123233995736766e-17, (-q).mul_add(core::f64::consts::FRAC_PI_2, x));
    let z = r * r;
    let sine = 1.58969099521155e-10f64
        .mul_add(z, -2.5050760253406863e-8)
        .mul_add(z, 2.7557313707070068e-6)
        .mul_add(z, -0.0001984126982985795)
        .mul_add(z, 0.00833333333332249)
        .mul_add(z, -0.16666666666666632);
    let cosine = (-1.1359647557788195e-11f64)
        .mul_add(z, 2.087572321298175e-9)
        .mul_add(z, -2.7557314351390663e-7)
        .mul_add(z, 2.480158728947673e-5)
        .mul_add(z, -0.001388888888887411)
        .mul_add(z, 0.0416666666666666);
    let sin = (sine * z).mul_add(r, r);
    let cos = z.mul_add(z.mul_add(cosine, -0.5), 1.0);
    let (first, second) = if quarter & 1 == 1 { (cos, sin) } else { (sin, cos) };
    let sign = |value: f64, quarter: u64| f64::from_bits(value.to_bits() ^ ((quarter & 2) << 62));
    (sign(first, quarter), sign(second, quarter.wrapping_add(1)))
}

#[inline(always)]
fn sines<const K: usize>(x: &[f64; K]) -> ([f64; K], [f64; K]) {
    let (mut sin, mut cos) = ([0.0; K], [0.0; K]);
    for i in 0..K {
        (sin[i], cos[i]) = sine(x[i]);
    }
    (sin, cos)
}
