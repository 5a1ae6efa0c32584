//! Against 60-digit values from mpmath, given as pairs (hi, lo).

use core::f64::consts::{FRAC_PI_2, SQRT_2};

use super::{DoubleDouble, Dual, Dual4, Jet, Real, Scalar};

type Pair = (f64, f64);

fn pair((hi, lo): Pair) -> DoubleDouble {
    DoubleDouble::new(hi, lo)
}

fn distance(a: DoubleDouble, b: DoubleDouble) -> f64 {
    (a - b).abs().to_f64()
}

/// x, sin x, cos x.
const SIN_COS: [(Pair, Pair, Pair); 9] = [
    ((0.5, 0.0), (0.479425538604203, -5.103969860556013e-18), (0.8775825618903728, -4.2623149864279997e-17)),
    (
        (0.1, 1e-18),
        (0.09983341664682815, 4.075019294572946e-18),
        (0.9950041652780258, -5.5120849108484524e-17),
    ),
    ((1e-09, 0.0), (1e-09, -1.6666666666666669e-28), (1.0, -5e-19)),
    (
        (0.79, 2e-17),
        (0.7103532724176078, 3.1650322792420024e-17),
        (0.7038453156522361, -1.2389918345416262e-17),
    ),
    ((FRAC_PI_2, 0.0), (1.0, -1.874699728327322e-33), (6.123233995736766e-17, -1.4973849048591698e-33)),
    ((-7.25, 0.0), (-0.8230808790115055, 4.782695371371335e-17), (0.5679241732886948, 4.202033681904503e-17)),
    (
        (22.0, -1e-16),
        (-0.008851309290403776, -3.3302593629890027e-19),
        (-0.9999608263946371, -1.7367343090577955e-18),
    ),
    (
        (355.0, 0.0),
        (-3.014435335948845e-05, 1.3012643991046347e-21),
        (-0.999999999545659, 1.0574612846643521e-17),
    ),
    (
        (-300.3, 1e-15),
        (0.9616332315697365, -5.023974166130225e-17),
        (0.2743383457352357, 8.572003245996193e-18),
    ),
];

#[test]
fn double_double_sine_and_cosine() {
    for (x, sin, cos) in SIN_COS {
        let (s, c) = pair(x).sin_cos();
        // The bound of the module: series and reduction, then the rounding of x itself.
        let bound = 1e-31 + 1e-32 * x.0.abs();
        assert!(distance(s, pair(sin)) < bound, "sin {x:?}: {s:?}");
        assert!(distance(c, pair(cos)) < bound, "cos {x:?}: {c:?}");
    }
}

#[test]
fn double_double_root_and_ratio() {
    let ulp = DoubleDouble::EPSILON.to_f64();
    let root = DoubleDouble::from_f64(2.0).sqrt();
    assert!(distance(root, pair((SQRT_2, -9.667293313452913e-17))) < ulp);
    let seventh = DoubleDouble::ratio(1, 7);
    assert!(distance(seventh, pair((0.14285714285714285, 7.93016446160826e-18))) < ulp / 7.0);
    // 2⁵³ + 1 and 2⁶³ − 1 are no doubles.
    let ratio = DoubleDouble::ratio(9_007_199_254_740_993, i64::MAX);
    assert!(distance(ratio, pair((0.0009765625000000002, -1.0831433813014366e-19))) < ulp / 1024.0);
    assert_eq!(DoubleDouble::ZERO.sqrt(), DoubleDouble::ZERO);
}

/// π = 3.1415926535897932384626433832795028…
#[test]
fn double_double_pi() {
    let expected = pair((core::f64::consts::PI, 1.2246467991473532e-16));
    assert_eq!(DoubleDouble::pi(), expected);
    assert_eq!(Jet::<DoubleDouble, 2>::pi().coefficient(0), expected);
}

proptest::proptest! {
    /// Bounds: the module's, summed over the operations and doubled.
    #[test]
    fn double_double_inverts_its_operations(
        a in 1e-3..1e3, b in 1e-3..1e3, low in -1.0..1.0,
    ) {
        let x = DoubleDouble::new(a, low * a * 1e-17);
        let y = DoubleDouble::new(b, low * b * 1e-17);
        let ulp = DoubleDouble::EPSILON.to_f64();
        proptest::prop_assert!(distance(x / y * y, x) < 7.0 * ulp * a);
        proptest::prop_assert!(distance(x.sqrt() * x.sqrt(), x) < 6.0 * ulp * a);
        proptest::prop_assert!(distance((x - y) + y, x) < 3.0 * ulp * (a + b));
        let (s, c) = x.sin_cos();
        proptest::prop_assert!(distance(s * s + c * c, DoubleDouble::from_f64(1.0)) < 1e-30);
    }
}

/// Taylor coefficients of sin(√(1+t²)/(2−t)) cos 3t − t/7 about t = 1/4.
/// x, eˣ, tanh x.
const EXPONENTIALS: [(Pair, Pair, Pair); 6] = [
    ((0.5, 0.0), (1.6487212707001282, -4.731568479435833e-17), (0.46211715726000974, 2.1916603238260928e-17)),
    ((1e-09, 0.0), (1.000000001, -8.224037093664211e-17), (1e-09, -3.3333333333333338e-28)),
    (
        (-7.25, 0.0),
        (0.000710174388842549, 3.546078199295509e-20),
        (-0.9999989913051835, -4.825784794213681e-17),
    ),
    (
        (0.1, 1e-18),
        (1.1051709180756477, -8.039006821520055e-17),
        (0.09966799462495582, 4.532500168488986e-18),
    ),
    ((39.0, 0.0), (8.659340042399374e+16, 2.953606932719265), (1.0, 0.0)),
    ((-300.3, 1e-15), (3.813880528480453e-131, -8.715796699401282e-148), (-1.0, 0.0)),
];

/// x, log x.
const LOGARITHMS: [(Pair, Pair); 5] = [
    ((0.5, 0.0), (-core::f64::consts::LN_2, -2.3190468138462996e-17)),
    ((1e-09, 0.0), (-20.72326583694641, -6.485730665985714e-16)),
    ((7.25, 0.0), (1.9810014688665833, 6.013262624124967e-17)),
    ((1.0, 1e-18), (1e-18, -5.0000000000000005e-37)),
    ((1e+300, 0.0), (690.7755278982137, 2.3747660028800243e-14)),
];

/// The bounds of the module: relative of eˣ and tanh x, absolute of log x.
#[test]
fn double_double_exponentials() {
    for (x, exp, tanh) in EXPONENTIALS {
        let bound = 1e-29 + 1e-32 * x.0.abs();
        let [e, t] = [pair(x).exp(), pair(x).tanh()];
        assert!(distance(e, pair(exp)) < bound * exp.0, "exp {x:?}: {e:?}");
        assert!(distance(t, pair(tanh)) < bound * tanh.0.abs(), "tanh {x:?}: {t:?}");
    }
    for (x, log) in LOGARITHMS {
        let l = pair(x).ln();
        assert!(distance(l, pair(log)) < 1e-29 + 1e-32 * log.0.abs(), "log {x:?}: {l:?}");
    }
}

const SERIES: [Pair; 7] = [
    (0.37076986862134725, -1.6754019534635703e-17),
    (-0.9898046182434224, 1.452114703730708e-17),
    (-2.3591038747282775, -1.8953743018749953e-16),
    (-0.3398249301883284, -1.932853779733456e-17),
    (1.1554370022878937, -1.3180715198025406e-17),
    (1.3820949778144085, -2.1156664004857565e-17),
    (0.6214943960324323, 4.496756087042258e-17),
];

fn series<S: Scalar>() -> Jet<S, 7> {
    let (zero, one) = (S::ZERO, S::ratio(1, 1));
    let t = Jet::new([S::ratio(1, 4), one, zero, zero, zero, zero, zero]);
    let root = t.mul_add(t, Jet::ratio(1, 1)).sqrt();
    let (sin, _) = (root / (Jet::ratio(2, 1) - t)).sin_cos();
    let (_, cos) = (Jet::from_f64(3.0) * t).sin_cos();
    sin * cos - t / Jet::ratio(7, 1)
}

#[test]
fn jets_carry_taylor_coefficients() {
    // Some ten roundings of terms up to 4.5 = 3³/3!.
    let single = series::<f64>();
    let double = series::<DoubleDouble>();
    for (k, reference) in SERIES.into_iter().enumerate() {
        assert!((single.coefficient(k) - reference.0).abs() < 45.0 * f64::EPSILON);
        assert!(distance(double.coefficient(k), pair(reference)) < 1e-30);
    }
    assert_eq!(single.derivative(4), 24.0 * single.coefficient(4));
}

/// log eˣ = x, tanh x = (e²ˣ − 1)/(e²ˣ + 1), order by order; the first derivatives are those of
/// duals.
#[test]
fn jets_of_exponentials_agree_with_each_other() {
    let x = Jet::<f64, 6>::new([0.3, 1.2, -0.7, 0.4, 0.9, -0.2]);
    let (one, back) = (Jet::ratio(1, 1), x.exp().ln());
    let power = (x + x).exp();
    let (tanh, quotient) = (x.tanh(), (power - one) / (power + one));
    for k in 0..6 {
        assert!((back.coefficient(k) - x.coefficient(k)).abs() < 40.0 * f64::EPSILON, "log, order {k}");
        let off = tanh.coefficient(k) - quotient.coefficient(k);
        assert!(off.abs() < 40.0 * f64::EPSILON, "tanh, order {k}: {off:e}");
    }
    let dual = Dual4::new(0.3, [1.2, 0.0, 0.0, 0.0]);
    let pairs = [(x.exp(), dual.exp()), (x.exp().ln(), dual.exp().ln()), (tanh, dual.tanh())];
    for (jet, dual) in pairs {
        assert!((jet.coefficient(1) - dual.gradient()[0]).abs() < 4.0 * f64::EPSILON);
    }
}

/// The tangent of an arctangent, to 1e-30 of double-doubles, order by order of jets.
#[test]
fn arctangents_have_their_tangents() {
    for x in [0.0, 1e-20, 0.3, -0.7, 1.0, -25.0, 1e9] {
        let x = DoubleDouble::from_f64(x) / DoubleDouble::from_f64(3.0);
        let (sin, cos) = x.atan().sin_cos();
        let off = distance(sin, x * cos);
        assert!(off < 1e-30 * (1.0 + x.to_f64().abs()), "{x:?}: {off:e}");
    }
    for (x, sign) in [(f64::INFINITY, 1.0), (f64::NEG_INFINITY, -1.0)] {
        assert_eq!(DoubleDouble::from_f64(x).atan().to_f64(), sign * core::f64::consts::FRAC_PI_2);
    }
    let x = Jet::<f64, 6>::new([0.3, 1.2, -0.7, 0.4, 0.9, -0.2]);
    let (sin, cos) = x.atan().sin_cos();
    let back = sin / cos;
    for k in 0..6 {
        assert!((back.coefficient(k) - x.coefficient(k)).abs() < 40.0 * f64::EPSILON, "order {k}");
    }
    let dual = Dual4::new(0.3, [1.2, 0.0, 0.0, 0.0]).atan();
    assert!((x.atan().coefficient(1) - dual.gradient()[0]).abs() < 4.0 * f64::EPSILON);
}

/// √(t² + 2t³ + …) = t + t² + …, t/√(t²) = 1 and |t²| beside them, for t ≥ 0.
#[test]
fn jets_are_one_sided_at_zeros() {
    let of = |coefficients: [f64; 4]| Jet::<f64, 4>::new(coefficients);
    let found = |jet: Jet<f64, 4>| [0, 1, 2, 3].map(|k| jet.coefficient(k));
    let root = of([0.0, 0.0, 1.0, 2.0]).sqrt();
    assert_eq!(found(root), [0.0, 1.0, 1.0, 0.0]);
    assert_eq!(found(of([0.0, 2.0, 2.0, 0.0]) / root), [2.0, 0.0, 0.0, 0.0]);
    assert_eq!(found(of([0.0; 4]).sqrt()), [0.0; 4]);
    assert!(of([0.0, 1.0, 0.0, 0.0]).sqrt().coefficient(1).is_infinite());
}

/// A function of two variables that uses every operation.
fn surface<S: Scalar>(x: S, y: S) -> S {
    let (sin, cos) = (x * y).sin_cos();
    let root = x.mul_add(x, y * y).sqrt();
    (sin - root / cos).abs() + -(x.mul_add(y, root) / S::from_f64(3.0)) + S::pi() * S::ratio(2, 7) * y
}

/// The chain rule by pairs against Moore's recurrences along each axis, at some ten roundings of
/// terms of order 1.
#[test]
fn duals_carry_the_gradient() {
    let (x, y) = (0.7, -1.1);
    let dual = surface(Dual::<f64, 2>::variable(x, 0), Dual::variable(y, 1));
    let along_x = surface(Jet::new([x, 1.0]), Jet::constant(y));
    let along_y = surface(Jet::constant(x), Jet::new([y, 1.0]));
    assert!((dual.value() - surface(x, y)).abs() < 10.0 * f64::EPSILON);
    for (slope, jet) in dual.gradient().iter().zip([along_x, along_y]) {
        assert!((slope - jet.coefficient(1)).abs() < 50.0 * f64::EPSILON, "{dual:?}");
    }
    let wide = surface(
        Dual::<DoubleDouble, 2>::variable(DoubleDouble::from_f64(x), 0),
        Dual::variable(DoubleDouble::from_f64(y), 1),
    );
    for (single, double) in dual.gradient().iter().zip(wide.gradient()) {
        assert!((single - double.to_f64()).abs() < 50.0 * f64::EPSILON);
    }
    assert!(Dual::<f64, 1>::new(1.0, [f64::NAN]) < Dual::constant(2.0));
    assert!(!Dual::<f64, 1>::new(1.0, [f64::NAN]).is_finite());
}

#[test]
fn jets_are_ordered_by_value() {
    let falling = Jet::new([1.0, -9.0]);
    let rising = Jet::new([2.0, 0.0]);
    assert!(falling < rising && falling == Jet::constant(1.0));
    assert_eq!((-rising).abs().coefficient(0), 2.0);
}

#[test]
fn ratios_are_rounded_once() {
    assert_eq!(f64::ratio(1, 3), 1.0 / 3.0);
    assert_eq!(f32::ratio(1, 3), 1.0 / 3.0);
    assert_eq!(f32::ratio(16_777_213, 16_777_215), 16_777_213.0 / 16_777_215.0);
}
