//! Axes with round ticks.

use super::format::significant;
use liftoff::__private::expression::superscript;

/// Relative differences below this are not drawn as any.
const ROUNDING: f64 = 1e-11;

/// How values are spread over an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their decimal logarithm; every tick a power of ten.
    Logarithmic,
}

/// One axis of a chart.
#[derive(Clone, PartialEq, Debug)]
pub struct Axis {
    /// Quantity with its unit: `phi, rad`.
    pub name: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// From the first value drawn to the last, in the chart's direction: a descending pair turns it
    /// round.
    pub range: [f64; 2],
    /// Values with a label; empty: chosen.
    pub ticks: Vec<f64>,
}

impl Axis {
    /// A linear axis over `range` with ticks chosen.
    pub fn linear(name: &str, range: [f64; 2]) -> Self {
        Self { name: name.into(), scale: Scale::Linear, range, ticks: Vec::new() }
    }

    /// A linear axis that holds `values` with a little room, ending on round ticks.
    pub fn holding(name: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let [low, high] = span(values);
        let step = round_step((high - low).max(f64::MIN_POSITIVE), 10.0);
        let range = [(low / step - 0.05).floor() * step, (high / step + 0.05).ceil() * step];
        Self::linear(name, range)
    }

    /// A logarithmic axis that holds `values`: over many decades it ends on powers of ten, over few
    /// on 1, 2 or 5 times one.
    pub fn decades(name: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let [low, high] = span(values.into_iter().map(f64::log10)).map(|place| 10f64.powf(place));
        let marks = logarithmic_marks([low / 1.1, high * 1.1]);
        let below = marks.iter().rfind(|&&mark| mark < low).copied();
        let above = marks.iter().find(|&&mark| mark > high).copied();
        let range = [below.unwrap_or(low), above.unwrap_or(high)];
        Self { name: name.into(), scale: Scale::Logarithmic, range, ticks: Vec::new() }
    }

    /// The same axis with these ticks.
    #[must_use]
    pub fn with_ticks(mut self, ticks: impl Into<Vec<f64>>) -> Self {
        self.ticks = ticks.into();
        self
    }

    /// Where `value` lies on an evenly divided ruler.
    fn map_value(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            Scale::Logarithmic => value.log10(),
        }
    }

    /// Where `value` lies on the axis, from 0 at its start to 1 at its end.
    pub(super) fn part(&self, value: f64) -> f64 {
        let [start, end] = self.range.map(|end| self.map_value(end));
        (self.map_value(value) - start) / (end - start)
    }

    /// The lower and the upper end.
    pub(super) fn ends(&self) -> [f64; 2] {
        let [a, b] = self.range;
        [a.min(b), a.max(b)]
    }

    /// The label that stands at the last value drawn.
    pub(super) fn label_at_end(&self) -> Option<String> {
        let is_last = |tick: &f64| (self.part(*tick) - 1.0).abs() < 0.02;
        self.labelled().into_iter().find(is_last).map(|tick| self.label(tick))
    }

    /// What is written at a value.
    pub(super) fn label(&self, value: f64) -> String {
        match self.scale {
            Scale::Linear => self.linear_label(value),
            Scale::Logarithmic if self.ends()[1] / self.ends()[0] <= 1e3 => significant(value, 6),
            Scale::Logarithmic => format!("10{}", superscript(value.log10().round() as i64)),
        }
    }

    /// With as many digits as tell two labels apart.
    fn linear_label(&self, value: f64) -> String {
        let [low, high] = self.ends();
        let size = low.abs().max(high.abs());
        if value.abs() <= 1e-9 * (high - low) {
            return "0".into();
        }
        let apart = if self.ticks.is_empty() { round_step(high - low, 5.0) } else { 1e-6 * size };
        let digits = (value.abs() / apart).log10().floor().max(0.0) as usize + 2;
        significant(value, digits)
    }

    /// The values with a label.
    pub(super) fn labelled(&self) -> Vec<f64> {
        if !self.ticks.is_empty() {
            return self.ticks.clone();
        }
        let [low, high] = self.ends();
        match self.scale {
            Scale::Linear => multiples(low, high, round_step(high - low, 5.0)),
            Scale::Logarithmic => {
                let mut marks = logarithmic_marks([low, high]);
                let decades = (high / low).log10();
                let every = (decades / 8.0).ceil().max(1.0);
                let labelled = |mark: f64| decades < 3.0 || (mark.log10() / every).fract().abs() < 1e-9;
                marks.retain(|&mark| low <= mark * 1.001 && mark <= high * 1.001 && labelled(mark));
                marks
            }
        }
    }
}

/// Least and greatest value; round a single one, or values that differ by rounding only, as much
/// again.
fn span(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let finite = values.into_iter().filter(|v| v.is_finite());
    let [low, high] = finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
    let size = low.abs().max(high.abs());
    if low > high {
        [0.0, 1.0]
    } else if high - low <= ROUNDING * size {
        let room = if size > 0.0 { size / 2.0 } else { 0.5 };
        [low - room, high + room]
    } else {
        [low, high]
    }
}

/// 1, 2 or 5 times a power of ten, so that about `count` of them make `width`.
fn round_step(width: f64, count: f64) -> f64 {
    let rough = width / count;
    let unit = 10f64.powf(rough.log10().floor());
    let times = [1.0, 2.0, 5.0, 10.0].into_iter().find(|times| times * unit >= rough * 0.999);
    times.unwrap_or(10.0) * unit
}

/// Powers of ten from below the range to above it; over less than three decades also twice and five
/// times them.
fn logarithmic_marks([low, high]: [f64; 2]) -> Vec<f64> {
    // Numbers end soon after.
    let [low, high] = [low, high].map(|end| end.clamp(1e-300, 1e300));
    let exponents = low.log10().floor() as i32..=high.log10().ceil() as i32;
    let times: &[u32] = if high / low < 1e3 { &[1, 2, 5] } else { &[1] };
    let mark = |exponent, times| format!("{times}e{exponent}").parse().unwrap_or(f64::NAN);
    exponents.flat_map(|exponent| times.iter().map(move |&times| mark(exponent, times))).collect()
}

fn multiples(low: f64, high: f64, step: f64) -> Vec<f64> {
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last).map(|i| i as f64 * step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithmic_ticks_reach_below_1e_14() {
        let axis = Axis::decades("error", [3e-17, 2e-2]);
        let labels: Vec<_> = axis.labelled().iter().map(|tick| axis.label(*tick)).collect();
        assert_eq!(labels.first().map(String::as_str), Some("10⁻¹⁶"));
        assert!(labels.contains(&"10⁻²".to_owned()), "{labels:?}");
        assert_eq!(axis.range, [1e-17, 1e-1]);
    }

    #[test]
    fn the_least_and_the_greatest_numbers_have_an_axis() {
        for values in [[5e-324, 1.7e308], [1e-320, 1e300], [f64::NAN, 0.0], [0.0, f64::INFINITY]] {
            let axis = Axis::decades("error", values);
            assert!(axis.labelled().len() < 700, "{values:?} {axis:?}");
        }
    }

    #[test]
    fn a_short_logarithmic_axis_is_divided_within_its_decades() {
        let axis = Axis::decades("run time, ms", [0.041, 0.28]);
        assert_eq!(axis.range, [0.02, 0.5]);
        assert_eq!(axis.labelled(), [0.02, 0.05, 0.1, 0.2, 0.5]);
        assert_eq!(axis.label(0.05), "0.05");
    }

    #[test]
    fn a_logarithmic_axis_is_divided_by_ratios() {
        let axis = Axis { scale: Scale::Logarithmic, ..Axis::linear("x", [1.0, 100.0]) };
        assert_eq!([1.0, 10.0, 100.0].map(|value| axis.part(value)), [0.0, 0.5, 1.0]);
        assert_eq!(Axis::linear("x", [2.0, 0.0]).part(0.5), 0.75);
    }

    #[test]
    fn a_label_at_the_end_is_reported() {
        let label = |axis: Axis| axis.label_at_end();
        assert_eq!(label(Axis::decades("run time, µs", [3.0, 800.0])).as_deref(), Some("1000"));
        assert_eq!(label(Axis::decades("run time, µs", [3.0, 40_000.0])).as_deref(), Some("10⁵"));
        assert_eq!(label(Axis::linear("angle", [0.0, 67.0])), None);
    }

    #[test]
    fn small_and_large_values_have_powers_of_ten() {
        let labels = |axis: Axis| axis.labelled().iter().map(|tick| axis.label(*tick)).collect::<Vec<_>>();
        assert_eq!(labels(Axis::linear("x", [0.0, 4e-9])), ["0", "1·10⁻⁹", "2·10⁻⁹", "3·10⁻⁹", "4·10⁻⁹"]);
        assert_eq!(labels(Axis::linear("x", [0.0, 2e7])), ["0", "5·10⁶", "1·10⁷", "1.5·10⁷", "2·10⁷"]);
        assert_eq!(labels(Axis::decades("x", [1.5e-9, 4e-9])), ["1·10⁻⁹", "2·10⁻⁹", "5·10⁻⁹"]);
        assert_eq!(labels(Axis::linear("x", [999.9996, 1000.0004]))[0], "999.9996");
    }

    #[test]
    fn an_axis_without_a_range_of_values_has_one() {
        for values in [vec![], vec![f64::NAN], vec![3e-9], vec![-2e5; 3], vec![1.0, 1.0 + 1e-15], vec![0.0]] {
            let axis = Axis::holding("x", values.clone());
            let [low, high] = axis.range;
            assert!(low < high && low.is_finite() && high.is_finite(), "{values:?}: {low} {high}");
            assert!((2..12).contains(&axis.labelled().len()), "{values:?}: {:?}", axis.labelled());
            let held = values.into_iter().filter(|v| v.is_finite());
            assert!(held.fold(true, |inside, v| inside && low <= v && v <= high));
        }
    }

    #[test]
    fn a_linear_axis_ends_on_round_values_around_the_data() {
        let axis = Axis::holding("N, N", [-1.93, 9.81]);
        assert_eq!(axis.range, [-4.0, 10.0]);
        assert_eq!(axis.labelled(), [0.0, 5.0, 10.0]);
        assert_eq!(axis.label(-0.1 - 0.2), "−0.3");
    }
}
