//! Members that fail, and sweeps that are refused.

use super::{models, run, sweep};
use crate::sweep::Cell;

fn refused(name: &str, words: &[&str]) -> String {
    let models = models();
    let sweep = sweep(&models, name, words).and_then(|sweep| sweep.run());
    sweep.err().expect("a mistake").to_string()
}

/// At e > 1 there is no impact law.
#[test]
fn members_that_fail_are_kept() {
    let table = run("ball", &["vary h=0,1", "vary e=0.5,1.5", "observe count impact"]);
    assert!(table.is_whole());
    let failed: Vec<_> = table.failed().map(|(row, _)| row.member).collect();
    assert_eq!(failed, [1, 3]);
    let csv = table.csv();
    assert!(csv.lines().nth(2).is_some_and(|line| line.starts_with("1,0,1.5,,") && line.len() > 10), "{csv}");
    let summary = table.summary();
    assert!(summary.contains("4 members of ball: 4 computed, 2 failed"), "{summary}");
    assert!(summary.contains("3  h = 1, e = 1.5: "), "{summary}");
}

/// 1e-30 beside one is rounding, alone it is a number.
#[test]
fn a_summary_shows_zero_for_what_is_rounding_beside_the_other_members() {
    let mut table = run("ball", &["vary e=0.1,0.5", "observe end E"]);
    let mut shown = |values: [f64; 2]| {
        for (row, value) in table.rows.iter_mut().zip(values) {
            row.outcome = Ok(vec![Cell::Number(value)]);
        }
        table.summary()
    };
    let summary = shown([1e-30, 1.0]);
    assert!(!summary.contains("e-30") && summary.contains("least 0 "), "{summary}");
    assert!(shown([1e-30, 1e-30]).contains("1e-30"));
}

#[test]
fn mistakes_are_reported_before_anything_runs() {
    let observe = "observe end";
    let cases: [(&[&str], &str); 21] = [
        (&["vary q=0:1:3", observe], "nothing depends on what is varied: no parameter or coordinate `q`"),
        (&["vary hh=0:1:3", observe], "did you mean `h`?"),
        (&["vary q=0:1:3", "set hh=q", observe], "no parameter `hh`; did you mean `h`?"),
        (&["vary q=0:1:3", "set h=p", observe], "`h=p`: no name `p`"),
        (&["vary q=0:1:3", "start yy=q", observe], "no coordinate `yy`; did you mean `y`?"),
        (&["vary h=0:1:3", "vary h=0:2:3", observe], "`h` is varied twice"),
        (&[observe], "nothing is varied"),
        (&["vary h=0:1:3"], "nothing is observed"),
        (&["vary h=0:1:3", "observe frist open"], "no observation `frist`; did you mean `first`?"),
        (&["vary h=0:1:3", "observe first opne"], "no event `opne`; did you mean `open`?"),
        (&["vary h=0:1:3", "observe end yy"], "`end yy`: no name `yy`; did you mean `y`?"),
        (&["vary h=0:1:3", "observe first impact Q"], "no name `Q`"),
        (&["vary h=0:1", observe], "`h` has no count"),
        (&["vary h=0:1:3", "set m=1", "set m=2", observe], "--set: `m` is given twice"),
        (&["vary h=0:1:3", "start x=1", "start x=2", observe], "--start: `x` is given twice"),
        (&["vary h=0:1:3", "set h=1", observe], "nothing depends on what is varied"),
        (&["vary h=0kg:1kg:3", observe], "--set h: measured in m, not in kg"),
        (&["vary h=0:1:3", "set g=9.81 m/s", observe], "--set g: measured in m/s², not in m/s"),
        (&["vary h=0:1:3", "start y'=3deg", observe], "--start y': measured in m/s, not in rad"),
        (&["vary h=1:2:3000", "vary e=0:1:3000", observe], "a grid of 9000000 points: 4000000 are the most"),
        (&["vary h=0:1:3", "observe end y = 2"], "needs a threshold"),
    ];
    for (words, expected) in cases {
        let error = refused("ball", words);
        assert!(error.contains(expected) && !error.contains('\n'), "{words:?}: {error}");
    }
}
