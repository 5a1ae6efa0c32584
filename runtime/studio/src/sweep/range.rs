//! What is varied: `lambda=0:1:201`, `k=1e-3:1:50:log`, `e=0:1`, `m=1,2,4`.

use super::{MOST_MEMBERS, SweepError};
use crate::registry::Quantity;
use liftoff::__private::expression::normalize_rate;
use liftoff::__private::expression::si_unit::SiUnit;

const MANY: usize = MOST_MEMBERS + 1;

/// A name that is varied, and over what.
#[derive(Clone, PartialEq, Debug)]
pub struct Varied {
    /// Parameter, coordinate or rate at the start, or a name that assignments use.
    pub name: String,
    /// The values that it takes.
    pub spread: Spread,
    /// The units that stand behind its values.
    pub units: Vec<SiUnit>,
}

/// Values of a varied name.
#[derive(Clone, PartialEq, Debug)]
pub enum Spread {
    /// So many over a range, its ends among them.
    Grid(Range, usize),
    /// These values, in this order.
    Listed(Vec<f64>),
    /// Anything in a range: what is drawn at random or bisected.
    Anywhere(Range),
}

/// A range of numbers.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Range {
    /// Lower end, included.
    pub low: f64,
    /// Upper end, included.
    pub high: f64,
    /// Whether equal ratios, not equal differences, are equally wide.
    pub logarithmic: bool,
}

impl Range {
    /// The value at a part of the range, from 0 to 1.
    pub fn interpolate(&self, part: f64) -> f64 {
        let Self { low, high, logarithmic } = *self;
        if part >= 1.0 {
            high
        } else if logarithmic && part > 0.0 {
            (low.ln() + part * (high.ln() - low.ln())).exp()
        } else {
            low + part * (high - low)
        }
    }
}

impl Spread {
    /// Whether equal ratios are equally wide.
    pub fn is_logarithmic(&self) -> bool {
        matches!(self, Self::Grid(range, _) | Self::Anywhere(range) if range.logarithmic)
    }

    /// The values of a grid; none where any value may be taken.
    pub(super) fn values(&self) -> Option<Vec<f64>> {
        match self {
            Self::Grid(range, count) => {
                Some((0..*count).map(|i| range.interpolate(i as f64 / (*count - 1) as f64)).collect())
            }
            Self::Listed(values) => Some(values.clone()),
            Self::Anywhere(_) => None,
        }
    }
}

impl Varied {
    /// Reads `name=low:high:count`, `name=low:high`, either with `:log` behind it, or
    /// `name=value,value,…`. Ends and values are formulas: `phi=0.1:pi/2:50`.
    ///
    /// # Errors
    /// Another form, a range that is empty or reversed, a value that is no number.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let form =
            || SweepError::syntax(text, "expected name=low:high:count, name=low:high or name=value,value,…");
        let (name, spread) = text.split_once('=').ok_or_else(form)?;
        let name = normalize_rate(name.trim()).into_owned();
        let mut units = Vec::new();
        let spread =
            if spread.contains(':') { ranged(spread, &mut units) } else { listed(spread, &mut units) };
        let spread = spread.map_err(|reason| SweepError::syntax(text, reason))?;
        if name.is_empty() { Err(form()) } else { Ok(Self { name, spread, units }) }
    }
}

fn listed(text: &str, units: &mut Vec<SiUnit>) -> Result<Spread, String> {
    text.split(',').map(|text| number(text, units)).collect::<Result<_, _>>().map(Spread::Listed)
}

fn ranged(text: &str, units: &mut Vec<SiUnit>) -> Result<Spread, String> {
    let mut parts: Vec<&str> = text.split(':').map(str::trim).collect();
    let logarithmic = parts.last() == Some(&"log");
    parts.truncate(parts.len() - usize::from(logarithmic));
    let [low, high, count @ ..] = &parts[..] else {
        return Err("expected low:high or low:high:count".into());
    };
    let range = Range { low: number(low, units)?, high: number(high, units)?, logarithmic };
    range.check()?;
    match count {
        [] => Ok(Spread::Anywhere(range)),
        [count] => match count.parse() {
            Ok(count @ MANY..) => {
                Err(format!("{count} values: {MOST_MEMBERS} members are the most; vary in parts"))
            }
            Ok(0 | 1) => Err(format!("a range has 2 values or more, its ends, not {count}")),
            Ok(count) => Ok(Spread::Grid(range, count)),
            Err(_) => Err(format!("`{count}` is no count")),
        },
        _ => Err("expected low:high:count".into()),
    }
}

impl Range {
    fn check(&self) -> Result<(), String> {
        let Self { low, high, logarithmic } = self;
        if low == high {
            return Err(format!("the range from {low} to {high} is empty"));
        }
        if low > high {
            return Err(format!("the range from {low} to {high} is reversed"));
        }
        if !(high - low).is_finite() {
            return Err(format!("the range from {low} to {high} exceeds the range of f64"));
        }
        if *logarithmic && *low <= 0.0 {
            return Err(format!("a logarithmic range begins above zero, not at {low}"));
        }
        Ok(())
    }
}

fn number(text: &str, units: &mut Vec<SiUnit>) -> Result<f64, String> {
    let quantity = Quantity::parse(text, &[]).map_err(|error| error.to_string())?;
    units.extend(quantity.unit());
    let value = quantity.value(&[]);
    if value.is_finite() { Ok(value) } else { Err(format!("{} is no finite number", text.trim())) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Vec<f64> {
        Varied::parse(text).expect("a range").spread.values().expect("a grid")
    }

    #[test]
    fn grids_have_both_ends() {
        assert_eq!(values("x=0:1:5"), [0.0, 0.25, 0.5, 0.75, 1.0]);
        assert_eq!(
            values("phi = -pi/2 : pi/2 : 2"),
            [-core::f64::consts::FRAC_PI_2, core::f64::consts::FRAC_PI_2]
        );
        assert_eq!(values("m=1, 2*2, 1/4"), [1.0, 4.0, 0.25]);
    }

    #[test]
    fn logarithmic_grids_have_equal_ratios() {
        let values = values("k=1e-3:1:4:log");
        assert_eq!((values[0], values[3]), (1e-3, 1.0));
        // Rounding of logarithms.
        assert!(
            (values[1] / 1e-2 - 1.0).abs() < 1e-14 && (values[2] / 1e-1 - 1.0).abs() < 1e-14,
            "{values:?}"
        );
    }

    #[test]
    fn ranges_without_a_count_are_for_samples() {
        let varied = Varied::parse("e=1:2:log").expect("a range");
        assert_eq!(varied.spread, Spread::Anywhere(Range { low: 1.0, high: 2.0, logarithmic: true }));
    }

    #[test]
    fn invalid_ranges_are_reported() {
        let error = |text| Varied::parse(text).expect_err("no range").to_string();
        assert_eq!(error("x=1:1:5"), "`x=1:1:5`: the range from 1 to 1 is empty");
        assert_eq!(error("x=1:0:5"), "`x=1:0:5`: the range from 1 to 0 is reversed");
        assert_eq!(error("x=0:1:1"), "`x=0:1:1`: a range has 2 values or more, its ends, not 1");
        assert_eq!(error("x=0:1:log"), "`x=0:1:log`: a logarithmic range begins above zero, not at 0");
        assert_eq!(
            error("x=0:1:4000000000"),
            "`x=0:1:4000000000`: 4000000000 values: 4000000 members are the most; vary in parts"
        );
        assert!(error("x=0:1:18446744073709551615").contains("18446744073709551615 values"));
        assert!(error("x=0:1:18446744073709551616").contains("is no count"));
        assert!(error("x=-1e308:1e308:3").contains("exceeds the range of f64"));
        assert_eq!(error("x=0:1:many"), "`x=0:1:many`: `many` is no count");
        assert_eq!(error("x=0:p"), "`x=0:p`: no name `p`; did you mean `pi`?");
        assert_eq!(error("x=1/0,2"), "`x=1/0,2`: 1/0 is no finite number");
        assert!(error("x").contains("expected name=low:high:count"));
    }
}
