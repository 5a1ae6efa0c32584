//! A bounded run of the fuzzer of runs, in this process.

use std::collections::BTreeMap;

use liftoff_fuzz::run::Runs;
use liftoff_fuzz::{Subject, judge};
use rayon::prelude::*;

/// So many cases take some seconds.
const CASES: u64 = 50;

#[test]
fn runs_are_sound_or_refused() {
    let mut fates = BTreeMap::new();
    for seed in 0..CASES {
        let case = Runs.generate(seed);
        match judge(&Runs, &case) {
            Ok(fate) => fate.into_iter().for_each(|word| *fates.entry(word).or_insert(0) += 1),
            Err(finding) => panic!("seed {seed}: {finding}\n{case}\n{}", Runs.details(&case)),
        }
    }
    let count = |word: &str| fates.get(word).copied().unwrap_or(0);
    assert!(
        count("ran") > CASES / 2 && count("compared: units") > 0 && count("compared: method") > 0,
        "{fates:?}"
    );
}

/// Seeds that were findings, with what they found.
const FOUND: [(u64, &str); 48] = [
    (52_761, "a symmetric motion that is unstable, compared with the whole one"),
    (54_351, "the rounding of a run as the only length of its second half"),
    (62_606, "digits of Radau's method that depend on the units"),
    (62_698, "bars folded upright, one of two contacts integrated"),
    (73_666, "masses of which the sum loses the lesser"),
    (79_257, "bars upright at rest, one of two contacts integrated"),
    (200_210, "rates of a start taken away where it was lifted"),
    (201_237, "a reaction audited beyond its pole"),
    (305_464, "a start beside the branch of its closed form"),
    (308_372, "a shift of a start relative to the largest position"),
    (777_000_383, "a gain of Newton's law that its event tells, taken for an error"),
    (800_005_958, "a margin of shared loads where nothing is shared"),
    (800_007_487, "a held support whose friction drives the motion"),
    (800_075_296, "a start within the bound below a corner, from which nothing came back"),
    (800_117_594, "a belt of a nanometre taken for one of a metre"),
    (950_003_666, "a body taken to be as large as its first two points are apart"),
    (950_009_351, "an end without load that a rate of 1e-49 rad/s lifts"),
    (950_021_357, "a step of Gauss's method whose last mode is small by chance"),
    (950_044_799, "a contact at rest that an impact elsewhere opens for a rate of 1e-36 m/s"),
    (970_021_350, "a plastic impact whose contact an ill-conditioned mass matrix opened again"),
    (970_027_574, "a contact at its limit of friction, opened since N = |R|/μ is small"),
    (
        980_007_405,
        "a sliding contact with much friction that stayed closed, pulling less than the bound of its reaction",
    ),
    (
        980_024_622,
        "without kinetic friction, what comes back to rest where its force is at the static limit again",
    ),
    (980_008_999, "a contact that the end of earlier flights closed again after an impact"),
    (
        1_000_000_076,
        "contacts that all but depend on each other: rounding opened one, and the run did not say so",
    ),
    (
        1_000_067_862,
        "two halves whose masses differ by a factor of 1e9, and their reactions by the rounding of that",
    ),
    (1_000_073_513, "a power by differences of an energy that is 1e15 times what it changes by over them"),
    (1_000_084_346, "an undecided impact that the other way has later"),
    (1_100_020_568, "balls that are 1e-13 apart: in a run that starts there they touch"),
    (1_100_022_863, "a thin plate that a start turned onto its contacts by 0.15 rad"),
    (1_100_027_050, "a thread as short as the tolerance, refused as a jump"),
    (1_100_030_240, "a contact that sticks, and slides since another inertia is 1e133 of its own"),
    (1_100_039_366, "a rate of 1e-14 m/s beside a belt of 0.3 m/s"),
    (1_100_039_826, "a pull beyond a guard that was taken for noise"),
    (1_200_032_908, "a friction force of rounding beside a limit of 1e-297 of the load"),
    (1_300_020_752, "a contact that the rounding of an upright pose opens in an impact elsewhere"),
    (
        1_300_024_986,
        "the last of many impacts with friction, taken for one that gains what friction takes later",
    ),
    (1_400_041_853, "a pull of 1e-17 that drives by its friction, beside a coefficient of 3e8"),
    (1_400_046_111, "the same by series, on the way to the border of Painlevé's region"),
    (1_500_001_496, "a second half that starts within the bound of a gap that is to close"),
    (1_700_000_117, "halves that start after the impact with which the run starts"),
    (
        1_700_034_659,
        "contacts a little open at a start, which the halves of a model with both close each in its way",
    ),
    (1_700_020_579, "the same, where one contact is open by what another is penetrated"),
    (1_700_069_988, "a motion of 1e-8 rad, of which tolerances know half as many digits"),
    (2_400_028_307, "a half of impacts that die away, whose natural time is shorter"),
    (2_300_016_564, "halves of a gap of 1e-11 of their length, whose start moves far to close it"),
    (2_100_012_312, "powers of a motion that takes 1e126 s"),
    (2_100_024_013, "powers of a motion that takes 1e-134 s"),
];

/// The same, a minute and more.
const FOUND_SLOWLY: [(u64, &str); 2] = [
    (950_008_443, "impacts that die away slowly, of which a method makes some more before their end"),
    (1_100_030_673, "a corner that an impact has left below its bar, taken for one from beyond the end"),
];

#[test]
fn known_findings_are_fixed() {
    all_sound(&FOUND);
}

#[test]
#[ignore = "takes minutes; `.ci/long promises hostile-runs` runs it"]
fn known_slow_findings_are_fixed() {
    all_sound(&FOUND_SLOWLY);
}

fn all_sound(seeds: &[(u64, &str)]) {
    seeds.par_iter().for_each(|(seed, found)| {
        let case = Runs.generate(*seed);
        if let Err(finding) = judge(&Runs, &case) {
            panic!("seed {seed}, {found}: {finding}\n{case}");
        }
    });
}

#[test]
fn a_seed_is_one_run() {
    assert!((0..200).all(|seed| Runs.generate(seed).to_string() == Runs.generate(seed).to_string()));
}
