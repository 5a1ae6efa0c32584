//! A step α along a direction in which a function falls, φ(α) = f(x + α d), such that it falls
//! enough and its slope flattens,
//!
//! ```text
//! φ(α) ≤ φ(0) + μ α φ′(0),    |φ′(α)| ≤ η |φ′(0)|
//! ```
//!
//! by cubic and quadratic interpolation in an interval that holds such a step (Moré and Thuente,
//! *Line search algorithms with guaranteed sufficient decrease*, ACM Transactions on Mathematical
//! Software 20, 1994; cases and constants are theirs).

/// μ and η.
const DECREASE: f64 = 1e-4;
const FLATTER: f64 = 0.9;
/// A step without an upper bound grows so many times at most.
const GROWTH: f64 = 4.0;
/// The interval becomes so much shorter, in two steps.
const SHORTER: f64 = 0.66;
/// No step is shorter, beside the first one, and no interval is, beside its end.
const SHORTEST: f64 = 1e-8;
const NARROWEST: f64 = 1e-10;
/// Values asked for at most: 4^30 first steps.
const MOST: usize = 30;

/// A step with φ and φ′.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) step: f64,
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// What a search on a line ends with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LineEnd {
    /// Both conditions hold.
    Met,
    /// The interval or the step has become too short: a lower value, if there is any, is the best
    /// so far.
    Short,
    /// Values have been asked for too often, or there is one no more.
    Exhausted,
}

/// The interval with the step that is tried next.
struct Interval {
    /// The end with the least value, and the other one.
    best: Sample,
    other: Sample,
    is_bracketed: bool,
    step: f64,
    /// Between which the next step may lie.
    bounds: [f64; 2],
    /// How long the interval was, and before that.
    widths: [f64; 2],
}

/// Tries steps from `first` on, `start` being what there is at 0; `sample` gives what there is at a
/// step, and none to end the search. Comes to an end with the last step that was tried if it meets
/// the conditions; else the one with the least value may be any of them.
pub(super) fn search(start: Sample, first: f64, mut sample: impl FnMut(f64) -> Option<Sample>) -> LineEnd {
    let mut interval = Interval {
        best: start,
        other: start,
        is_bracketed: false,
        step: first,
        bounds: [0.0, (1.0 + GROWTH) * first],
        widths: [f64::INFINITY; 2],
    };
    let enough = |tried: &Sample| tried.value - (start.value + DECREASE * tried.step * start.slope);
    let mut has_flattened = false;
    for _ in 0..MOST {
        let Some(tried) = sample(interval.step) else { return LineEnd::Exhausted };
        let has_fallen = enough(&tried) <= 0.0;
        if has_fallen && tried.slope.abs() <= -FLATTER * start.slope {
            return LineEnd::Met;
        }
        has_flattened |= has_fallen && tried.slope >= 0.0;
        if interval.step <= SHORTEST * first {
            return LineEnd::Short;
        }
        // Until then ψ(α) = φ(α) − φ(0) − μ α φ′(0) is made less than nothing.
        let tilt = if !has_flattened && !has_fallen && tried.value <= interval.best.value {
            DECREASE * start.slope
        } else {
            0.0
        };
        interval.take(tried, tilt);
        interval.step = interval.step.max(SHORTEST * first);
        let [low, high] = interval.bounds;
        if interval.is_bracketed
            && (interval.step <= low || interval.step >= high || high - low <= NARROWEST * high)
        {
            return LineEnd::Short;
        }
    }
    LineEnd::Exhausted
}

impl Sample {
    fn tilted(self, tilt: f64) -> Self {
        Self { value: self.value - tilt * self.step, slope: self.slope - tilt, ..self }
    }
}

impl Interval {
    /// Makes a step that was tried one of its ends, and chooses the next one.
    fn take(&mut self, tried: Sample, tilt: f64) {
        let [best, other, tilted] = [self.best, self.other, tried].map(|sample| sample.tilted(tilt));
        let is_bracketed = self.is_bracketed || tilted.value > best.value || tilted.slope * best.slope < 0.0;
        let step = next_step(best, other, tilted, (self.is_bracketed, self.bounds));
        if tilted.value > best.value {
            self.other = tried;
        } else {
            if tilted.slope * best.slope < 0.0 {
                self.other = self.best;
            }
            self.best = tried;
        }
        self.is_bracketed = is_bracketed;
        self.step = step;
        let [from, to] = [self.best.step, self.other.step];
        if is_bracketed {
            let width = (to - from).abs();
            if width >= SHORTER * self.widths[1] {
                self.step = 0.5 * (from + to);
            }
            self.widths = [width, self.widths[0]];
            self.bounds = [from.min(to), from.max(to)];
        } else {
            self.bounds = [from, self.step + GROWTH * (self.step - from)];
        }
    }
}

/// The next step by the four cases of the value and the slope at `tried`.
fn next_step(
    best: Sample,
    other: Sample,
    tried: Sample,
    (is_bracketed, [low, high]): (bool, [f64; 2]),
) -> f64 {
    let along = tried.step - best.step;
    let secant = tried.step - tried.slope / (tried.slope - best.slope) * along;
    // A higher value: a minimum lies between, nearer to the lower end.
    if tried.value > best.value {
        let cubic = cubic_minimum(best, tried);
        let fall = (best.value - tried.value) / along + best.slope;
        let quadratic = best.step + 0.5 * best.slope / fall * along;
        let is_nearer = (cubic - best.step).abs() < (quadratic - best.step).abs();
        let step = if is_nearer { cubic } else { 0.5 * (cubic + quadratic) };
        return within_part(step, best.step, tried.step);
    }
    // A slope of the other sign: it lies between.
    if tried.slope * best.slope < 0.0 {
        let cubic = cubic_minimum(best, tried);
        return if (cubic - tried.step).abs() > (secant - tried.step).abs() { cubic } else { secant };
    }
    // A flatter slope: it lies beyond, if anywhere.
    if tried.slope.abs() < best.slope.abs() {
        let beyond = if along > 0.0 { high } else { low };
        let cubic = Some(cubic_minimum(best, tried)).filter(|cubic| (cubic - tried.step) * along > 0.0);
        let cubic = cubic.unwrap_or(beyond);
        let is_nearer = (cubic - tried.step).abs() < (secant - tried.step).abs();
        let step = if is_nearer == is_bracketed { cubic } else { secant }.clamp(low, high);
        return if is_bracketed { within_part(step, tried.step, other.step) } else { step };
    }
    match is_bracketed {
        true => cubic_minimum(other, tried).clamp(low, high),
        false if along > 0.0 => high,
        false => low,
    }
}

/// A step between two ends that does not come nearer to the second than a part of their distance.
fn within_part(step: f64, from: f64, to: f64) -> f64 {
    let farthest = from + SHORTER * (to - from);
    if to > from { step.min(farthest) } else { step.max(farthest) }
}

/// Where the cubic with these values and slopes is least; beyond all bounds where it is nowhere.
fn cubic_minimum(a: Sample, b: Sample) -> f64 {
    let theta = 3.0 * (a.value - b.value) / (b.step - a.step) + a.slope + b.slope;
    let size = theta.abs().max(a.slope.abs()).max(b.slope.abs());
    let square = (theta / size).powi(2) - (a.slope / size) * (b.slope / size);
    let gamma = (size * square.max(0.0).sqrt()).copysign(a.step - b.step);
    let part = (gamma - b.slope + theta) / (2.0 * gamma - b.slope + a.slope);
    if part.is_finite() { b.step + part * (a.step - b.step) } else { b.step }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Function = fn(f64) -> [f64; 2];

    /// Number of values until the conditions are met, and the step.
    fn met(function: Function, first: f64) -> (usize, f64) {
        let sample = |step: f64| {
            let [value, slope] = function(step);
            Sample { step, value, slope }
        };
        let start = sample(0.0);
        let (mut count, mut last) = (0, start);
        let end = search(start, first, |step| {
            (count, last) = (count + 1, sample(step));
            Some(last)
        });
        assert_eq!(end, LineEnd::Met, "{first:e} {last:?}");
        assert!(last.value <= start.value + DECREASE * last.step * start.slope);
        assert!(last.slope.abs() <= -FLATTER * start.slope);
        (count, last.step)
    }

    /// Functions 5.1 and 5.2 of Moré and Thuente, and those of Yanai, Ozawa and Kaneko that they
    /// take (5.4), with φ′.
    const FUNCTIONS: [Function; 5] = [
        |a| [-a / (a * a + 2.0), (a * a - 2.0) / (a * a + 2.0).powi(2)],
        |a| {
            let b = a + 0.004;
            [b.powi(5) - 2.0 * b.powi(4), 5.0 * b.powi(4) - 8.0 * b.powi(3)]
        },
        |a| yanai(a, 0.001, 0.001),
        |a| yanai(a, 0.01, 0.001),
        |a| yanai(a, 0.001, 0.01),
    ];

    fn yanai(a: f64, p: f64, q: f64) -> [f64; 2] {
        let gamma = |b: f64| (1.0 + b * b).sqrt() - b;
        let (x, y) = ((1.0 - a).hypot(q), a.hypot(p));
        [gamma(p) * x + gamma(q) * y, gamma(p) * (a - 1.0) / x + gamma(q) * a / y]
    }

    /// In their tables I to VI from 10^±3 and 10^±1 at most 12 values are needed with conditions as
    /// these or sharper.
    #[test]
    fn functions_of_the_paper_need_few_values() {
        for (k, function) in FUNCTIONS.into_iter().enumerate() {
            for first in [1e-3, 1e-1, 1e1, 1e3] {
                let (count, step) = met(function, first);
                assert!(count <= 12, "{k} {first} {count} {step}");
            }
        }
    }

    /// The same steps in any unit of values.
    #[test]
    fn a_unit_of_values_changes_nothing() {
        for (one, other) in [
            (FUNCTIONS[0], (|a| FUNCTIONS[0](a).map(|value| value * 2f64.powi(90))) as Function),
            (FUNCTIONS[1], |a| FUNCTIONS[1](a).map(|value| value * 2f64.powi(-90))),
        ] {
            assert_eq!(met(one, 1e3), met(other, 1e3));
        }
    }

    #[test]
    fn unbounded_descent_terminates() {
        let start = Sample { step: 0.0, value: 0.0, slope: -1.0 };
        let mut far = 0.0;
        let end = search(start, 1.0, |step| {
            far = step;
            Some(Sample { step, value: -step, slope: -1.0 })
        });
        assert!(end == LineEnd::Exhausted && far > 1e9, "{far}");
    }

    /// A slope that is told wrongly, or a value that jumps: no step is better.
    #[test]
    fn a_step_that_cannot_be_better_is_short() {
        let start = Sample { step: 0.0, value: 0.0, slope: -1.0 };
        for sample in [
            |step: f64| Sample { step, value: step, slope: 1.0 },
            |step: f64| Sample { step, value: 1.0, slope: 0.0 },
            |step: f64| Sample { step, value: 1.0 - step, slope: -1.0 },
        ] {
            let mut count = 0;
            let end = search(start, 1.0, |step| {
                count += 1;
                Some(sample(step))
            });
            assert!(end != LineEnd::Met && count <= MOST, "{end:?} {count}");
        }
    }
}
