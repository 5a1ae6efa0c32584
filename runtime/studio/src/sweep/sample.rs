//! Which points of the varied ranges are computed.

use super::{MOST_MEMBERS, Range, Spread, SweepError, Varied};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use sobol::Sobol;
use sobol::params::JoeKuoD6;

/// Which points of the varied ranges are computed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Sample {
    /// All combinations of all values; the last name runs fastest.
    #[default]
    Grid,
    /// So many points drawn evenly at random.
    Random {
        /// Number of points.
        count: usize,
        /// What they are drawn from.
        seed: u64,
    },
    /// So many points of Sobol's sequence with the directions of Joe and Kuo, which fills the
    /// ranges more evenly.
    Sobol {
        /// Number of points.
        count: usize,
        /// What the whole sequence is shifted by, modulo its ranges; none: not at all, so that the
        /// first point is at the lower ends.
        seed: Option<u64>,
    },
}

/// Most names that a Sobol sample varies.
const MOST: usize = 100;

/// The points of a sample; each is known by its number alone.
pub(super) enum Points {
    Grid(Vec<Vec<f64>>),
    Random {
        ranges: Vec<Range>,
        count: usize,
        seed: u64,
    },
    /// Parts of the ranges.
    Listed {
        ranges: Vec<Range>,
        parts: Vec<Vec<f64>>,
    },
}

impl Sample {
    /// What a point's number says of it: how many there are says nothing.
    pub(super) fn identity(&self) -> String {
        match self {
            Self::Grid => "grid".into(),
            Self::Random { seed, .. } => format!("random, seed {seed}"),
            Self::Sobol { seed: None, .. } => "sobol".into(),
            Self::Sobol { seed: Some(seed), .. } => format!("sobol, seed {seed}"),
        }
    }

    pub(super) fn points(&self, varied: &[Varied]) -> Result<Points, SweepError> {
        match *self {
            Self::Grid => grid(varied),
            Self::Random { count, seed } => {
                Ok(Points::Random { ranges: ranges(varied, count)?, count, seed })
            }
            Self::Sobol { count, seed } => sobol(ranges(varied, count)?, count, seed),
        }
    }
}

fn grid(varied: &[Varied]) -> Result<Points, SweepError> {
    let values = |varied: &Varied| {
        let missing = || format!("`{0}` has no count: say {0}=low:high:count, or draw a sample", varied.name);
        varied.spread.values().ok_or_else(|| SweepError::Invalid(missing()))
    };
    let values: Vec<_> = varied.iter().map(values).collect::<Result<_, _>>()?;
    match values.iter().try_fold(1usize, |product, values| product.checked_mul(values.len())) {
        Some(..=MOST_MEMBERS) => Ok(Points::Grid(values)),
        count => Err(too_many("a grid", count)),
    }
}

fn too_many(what: &str, count: Option<usize>) -> SweepError {
    let count = count.map_or("countless".into(), |count| count.to_string());
    SweepError::Invalid(format!("{what} of {count} points: {MOST_MEMBERS} are the most; vary in parts"))
}

fn ranges(varied: &[Varied], count: usize) -> Result<Vec<Range>, SweepError> {
    if count == 0 {
        return Err(SweepError::Invalid("a sample of no points".into()));
    }
    if count > MOST_MEMBERS {
        return Err(too_many("a sample", Some(count)));
    }
    let range = |varied: &Varied| match &varied.spread {
        Spread::Anywhere(range) => Ok(*range),
        _ => Err(SweepError::Invalid(format!(
            "a sample is drawn from a range: say {}=low:high, without a count",
            varied.name
        ))),
    };
    varied.iter().map(range).collect()
}

fn sobol(ranges: Vec<Range>, count: usize, seed: Option<u64>) -> Result<Points, SweepError> {
    if ranges.len() > MOST {
        return Err(SweepError::Invalid(format!("a Sobol sample varies {MOST} names at most")));
    }
    let mut shift = vec![0.0; ranges.len()];
    if let Some(seed) = seed {
        shift = uniform(seed, 0, ranges.len());
    }
    let directions = JoeKuoD6::minimal();
    let sequence = Sobol::<f64>::new(ranges.len(), &directions).take(count);
    let shifted = |point: Vec<f64>| point.iter().zip(&shift).map(|(x, shift)| (x + shift).fract()).collect();
    Ok(Points::Listed { ranges, parts: sequence.map(shifted).collect() })
}

/// `count` numbers from 0 to 1 that belong to a seed and to a point's number.
fn uniform(seed: u64, point: u64, count: usize) -> Vec<f64> {
    let mut source = ChaCha8Rng::seed_from_u64(seed);
    source.set_stream(point);
    // 53 bits: every multiple of 2⁻⁵³ below 1.
    (0..count).map(|_| (source.next_u64() >> 11) as f64 * (0.5 * f64::EPSILON)).collect()
}

impl Points {
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Grid(values) => values.iter().map(Vec::len).product(),
            Self::Random { count, .. } => *count,
            Self::Listed { parts, .. } => parts.len(),
        }
    }

    /// The point of a number below their count.
    pub(super) fn compute_point(&self, number: usize) -> Vec<f64> {
        let spread = |ranges: &[Range], parts: &[f64]| {
            ranges.iter().zip(parts).map(|(r, x)| r.interpolate(*x)).collect()
        };
        match self {
            Self::Grid(values) => {
                let mut rest = number;
                let mut point: Vec<f64> = values
                    .iter()
                    .rev()
                    .map(|values| {
                        let value = values[rest % values.len()];
                        rest /= values.len();
                        value
                    })
                    .collect();
                point.reverse();
                point
            }
            Self::Random { ranges, seed, .. } => spread(ranges, &uniform(*seed, number as u64, ranges.len())),
            Self::Listed { ranges, parts } => spread(ranges, &parts[number]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(sample: Sample, varied: &[&str]) -> Vec<Vec<f64>> {
        let varied: Vec<_> = varied.iter().map(|text| Varied::parse(text).expect("a range")).collect();
        let points = sample.points(&varied).expect("points");
        (0..points.len()).map(|i| points.compute_point(i)).collect()
    }

    #[test]
    fn a_grid_has_every_combination() {
        let points = points(Sample::Grid, &["x=1,2", "y=0:2:3"]);
        assert_eq!(points, [[1.0, 0.0], [1.0, 1.0], [1.0, 2.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0]]);
    }

    /// The first points as S. Joe and F. Y. Kuo publish them (`sobol.cc`, new-joe-kuo-6).
    #[test]
    fn sobol_points_are_the_published_ones() {
        let points = points(Sample::Sobol { count: 10, seed: None }, &["x=0:1", "y=0:1", "z=0:1"]);
        let published = [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25],
            [0.25, 0.75, 0.75],
            [0.375, 0.375, 0.625],
            [0.875, 0.875, 0.125],
            [0.625, 0.125, 0.875],
            [0.125, 0.625, 0.375],
            [0.1875, 0.3125, 0.9375],
            [0.6875, 0.8125, 0.4375],
        ];
        assert_eq!(points, published);
    }

    /// Of 2ᵏ points one lies in each of 2ᵏ equal parts of a range; a shift leaves their distances.
    #[test]
    fn sobol_points_are_even_along_each_axis() {
        let sorted = |seed| {
            let points = points(Sample::Sobol { count: 64, seed }, &["x=1:2", "y=0:64"]);
            let mut values: Vec<_> = points.iter().map(|point| point[1]).collect();
            values.sort_by(f64::total_cmp);
            values
        };
        assert_eq!(sorted(None), (0..64).map(f64::from).collect::<Vec<_>>());
        let shifted = sorted(Some(3));
        assert!(shifted.windows(2).all(|pair| (pair[1] - pair[0] - 1.0).abs() < 1e-12), "{shifted:?}");
        assert_ne!(shifted[0], 0.0);
    }

    #[test]
    fn random_points_depend_on_seed_and_number_only() {
        let sample = |count, seed| points(Sample::Random { count, seed }, &["x=2:3", "k=1:100:log"]);
        let (few, many, other) = (sample(10, 1), sample(1000, 1), sample(10, 2));
        assert_eq!(few, many[..10]);
        assert_ne!(few, other);
        assert!(many.iter().all(|point| (2.0..3.0).contains(&point[0]) && (1.0..100.0).contains(&point[1])));
        // Half of the values below the middle: the geometric one of the logarithmic range; ± 4
        // standard deviations.
        let below = |i: usize, middle: f64| many.iter().filter(|point| point[i] < middle).count();
        assert!((437..563).contains(&below(0, 2.5)) && (437..563).contains(&below(1, 10.0)));
    }

    #[test]
    fn counts_belong_to_grids() {
        let error = |sample: Sample, text| match sample.points(&[Varied::parse(text).expect("a range")]) {
            Ok(_) => panic!("{text}"),
            Err(error) => error.to_string(),
        };
        assert!(error(Sample::Grid, "x=0:1").contains("x=low:high:count"));
        assert!(error(Sample::Random { count: 5, seed: 0 }, "x=0:1:5").contains("without a count"));
        assert_eq!(error(Sample::Sobol { count: 0, seed: None }, "x=0:1"), "a sample of no points");
        let told = "a sample of 4000001 points: 4000000 are the most; vary in parts";
        for sample in
            [Sample::Sobol { count: 4_000_001, seed: None }, Sample::Random { count: 4_000_001, seed: 0 }]
        {
            assert_eq!(error(sample, "x=0:1"), told);
        }
        let [wide, most] = ["x=0:1:2001", "x=0:1:4000000"].map(|text| Varied::parse(text).expect("a range"));
        let told = |varied: &[Varied]| Sample::Grid.points(varied).err().map(|error| error.to_string());
        assert_eq!(
            told(&[wide.clone(), wide.clone()]),
            Some("a grid of 4004001 points: 4000000 are the most; vary in parts".into())
        );
        assert!(told(&vec![most; 4]).is_some_and(|told| told.contains("a grid of countless points")));
        assert_eq!(told(&[wide]), None);
    }
}
