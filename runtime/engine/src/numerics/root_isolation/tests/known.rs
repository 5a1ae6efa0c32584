//! Random guards with known roots.

use super::super::TERMS;

/// splitmix64 (Steele, Lea, Flood 2014).
pub(super) struct Random(pub(super) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub(super) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    pub(super) fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Root {
    pub(super) at: f64,
    pub(super) multiplicity: usize,
    /// How far from it a change of sign, or a turning point, may be found: in the series, in the
    /// function.
    pub(super) slack: [f64; 2],
    /// How far from an even root rounding may make the series change its sign twice.
    pub(super) dip: f64,
}

/// A guard by its roots in [0, 1], its series and its values.
pub(super) struct Known {
    pub(super) roots: Vec<Root>,
    pub(super) positive: bool,
    pub(super) c: [f64; TERMS],
    pub(super) value: Box<dyn Fn(f64) -> f64>,
    pub(super) delta: f64,
}

impl Known {
    pub(super) fn random(random: &mut Random) -> Self {
        loop {
            let known = match random.below(4) {
                0 => Self::sine(random),
                1 => Self::grazing_sine(random),
                _ => Self::polynomial(random),
            };
            if known.is_distinguishable() {
                return known;
            }
        }
    }

    /// The order of the root at the start.
    pub(super) fn order(&self) -> usize {
        self.roots.first().filter(|root| root.at == 0.0).map_or(0, |root| root.multiplicity)
    }

    /// Between two roots, and at ends that are none, the guard is more than 10 δ from zero; the
    /// slack is small.
    fn is_distinguishable(&self) -> bool {
        let mut marks: Vec<f64> =
            [0.0].into_iter().chain(self.roots.iter().map(|r| r.at)).chain([1.0]).collect();
        marks.dedup();
        let rises = |pair: &[f64]| {
            let mut inner = (0..=8).map(|i| pair[0] + f64::from(i) / 8.0 * (pair[1] - pair[0]));
            inner.any(|theta| (self.value)(theta).abs() > 10.0 * self.delta)
        };
        let is_root = |theta| self.roots.iter().any(|r| r.at == theta);
        let ends = [0.0, 1.0].iter().all(|&end| is_root(end) || (self.value)(end).abs() > 10.0 * self.delta);
        let near = |pair: &[Root]| pair[1].at - pair[0].at > 4.0 * worst(&pair[0]).max(worst(&pair[1]));
        let worst_of_all = self.roots.iter().map(worst).fold(0.0, f64::max);
        ends && marks.windows(2).all(rises) && self.roots.windows(2).all(near) && worst_of_all < 1e-3
    }

    /// Π (θ − r): half of them with up to seven roots k/64, exact in `f64` as are their series.
    fn polynomial(random: &mut Random) -> Self {
        let exact = random.below(2) == 0;
        let mut all = Vec::new();
        let (most, mut degree) = (if exact { 7 } else { 12 }, 0);
        for _ in 0..=random.below(4) {
            let multiplicity = [1, 1, 1, 2, 2, 3][random.below(6) as usize].min(most - degree);
            degree += multiplicity;
            all.extend((multiplicity > 0).then(|| (draw_root(random, exact), multiplicity)));
        }
        all.sort_by(|a, b| f64::total_cmp(&a.0, &b.0));
        all.dedup_by(|a, b| a.0 == b.0);
        let scale = [1.0, -1.0][random.below(2) as usize] * 2f64.powi(random.below(60) as i32 - 30);
        let (mut c, mut size) = ([0.0; TERMS], scale.abs());
        c[0] = scale;
        for (r, multiplicity) in &all {
            for _ in 0..*multiplicity {
                c = core::array::from_fn(|k| if k == 0 { -r * c[0] } else { c[k - 1] - r * c[k] });
                size *= 1.0 + r.abs();
            }
        }
        let degree = degree as f64;
        // A rounding for each factor.
        let error = if exact { 0.0 } else { 2.0 * degree * f64::EPSILON * size };
        let delta = (4.0 * error).max(size * 10f64.powf(random.within(-15.0, -7.0)));
        let bend = if random.below(2) == 0 { 0.0 } else { 0.5 };
        let root = |&(at, multiplicity): &(f64, usize)| {
            let others = all.iter().filter(|(r, _)| *r != at);
            let lead = scale.abs() * others.map(|(r, m)| (at - r).abs().powi(*m as i32)).product::<f64>();
            // Values to ε² of the terms' size by the compensated scheme; the rate to ε, or to what
            // the fit has left.
            let value = (error + (2.0 * degree * f64::EPSILON).powi(2) * size) / lead;
            let rate = degree * degree * (error + 8.0 * f64::EPSILON * size) / lead;
            let fitted = 1e3 * (0.02 * delta + 16.0 * f64::EPSILON * size) / lead;
            let dip = 2.0 * value.powf(1.0 / multiplicity as f64);
            let slack = if multiplicity % 2 == 1 { [dip, 0.0] } else { [rate, fitted] };
            Root { at, multiplicity, slack: slack.map(|s| s + ULPS), dip }
        };
        let roots: Vec<Root> = all.iter().filter(|(r, _)| (0.0..=1.0).contains(r)).map(root).collect();
        let behind: usize = all.iter().filter(|(r, _)| *r > 0.0).map(|(_, m)| m).sum();
        let positive = (scale > 0.0) == behind.is_multiple_of(2);
        let value = move |theta: f64| {
            let product: f64 = all.iter().map(|(r, m)| (theta - r).powi(*m as i32)).product();
            scale * product * (1.0 + bend * (3.0 * theta + 1.0).sin())
        };
        Self { roots, positive, c, value: Box::new(value), delta }
    }

    /// A sin(ωθ + φ).
    fn sine(random: &mut Random) -> Self {
        let [omega, phase, height] = wave(random);
        let first = (phase / core::f64::consts::PI).floor() + 1.0;
        let at = |i: i32| ((first + f64::from(i)) * core::f64::consts::PI - phase) / omega;
        // The argument is rounded, as are the terms of the series, which sum to less than e⁴.
        let slack = [64.0 * 4.0 * f64::EPSILON / omega, 8.0 * f64::EPSILON * (phase + omega) / omega];
        let roots =
            (0..2).map(at).filter(|at| *at <= 1.0).map(|at| Root { at, multiplicity: 1, slack, dip: 0.0 });
        let c = sine_series(omega, phase).map(|c| height * c);
        let value = move |theta: f64| height * (omega * theta + phase).sin();
        Self {
            roots: roots.collect(),
            positive: phase.sin() > 0.0,
            c,
            value: Box::new(value),
            delta: 1e-13 * height,
        }
    }

    /// A (1 − cos(ωθ + φ)).
    fn grazing_sine(random: &mut Random) -> Self {
        let [omega, phase, height] = wave(random);
        let at = (2.0 * core::f64::consts::PI - phase) / omega;
        let slack = [64.0 * 4.0, 1e3].map(|e| e * f64::EPSILON * 8.0 / (omega * omega));
        // √(2E/g″) for the error E of the values.
        let dip = 1e2 * f64::EPSILON.sqrt() / omega;
        let roots = Some(Root { at, multiplicity: 2, slack, dip }).filter(|r| r.at <= 1.0).into_iter();
        let mut c = sine_series(omega, phase + 0.5 * core::f64::consts::PI).map(|c| -height * c);
        c[0] = height * (1.0 - phase.cos());
        let value = move |theta: f64| height * (1.0 - (omega * theta + phase).cos());
        Self { roots: roots.collect(), positive: true, c, value: Box::new(value), delta: 1e-13 * height }
    }
}

/// θ is found to twice the spacing of doubles below 1.
const ULPS: f64 = 4.0 * f64::EPSILON;

fn worst(root: &Root) -> f64 {
    root.slack[0].max(root.slack[1]).max(root.dip)
}

/// A root: anywhere, near an end, at an end, or near the middle so that pairs are close. One at 1
/// is so only where the series is exact.
fn draw_root(random: &mut Random, exact: bool) -> f64 {
    let small = 10f64.powf(random.within(-9.0, -1.0));
    match (random.below(8), exact) {
        (0, _) => 0.0,
        (1, true) => 1.0,
        (_, true) => (random.below(84) as f64 - 10.0) / 64.0,
        (1, _) => small,
        (2, _) => 1.0 - small,
        (3, _) => 0.5 + small,
        _ => random.within(-0.3, 1.3),
    }
}

/// Frequency, phase, amplitude. Thirty-three terms of a frequency up to 4 leave out 4³³/33! =
/// 8e-18.
fn wave(random: &mut Random) -> [f64; 3] {
    [
        random.within(0.5, 4.0),
        random.within(0.0, core::f64::consts::TAU),
        10f64.powf(random.within(-6.0, 6.0)),
    ]
}

/// ωᵏ/k! sin(φ + kπ/2).
pub(super) fn sine_series(omega: f64, phase: f64) -> [f64; TERMS] {
    let turn = [phase.sin(), phase.cos(), -phase.sin(), -phase.cos()];
    let mut power = 1.0;
    core::array::from_fn(|k| {
        power *= if k == 0 { 1.0 } else { omega / k as f64 };
        power * turn[k % 4]
    })
}
