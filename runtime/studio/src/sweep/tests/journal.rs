//! Journals cut off, damaged, busy, and of other sweeps.

use super::{models, numbers, run, sweep};
use crate::sweep::Sample;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// A journal of a test's own.
fn journal(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("liftoff-{}-{name}.journal", std::process::id()));
    let _ = std::fs::remove_file(&path);
    path
}

const JOURNEY: [&str; 3] = ["vary e=0.1:0.9:40", "observe first impact y'", "observe end"];

#[test]
fn a_journal_goes_on_where_it_was() {
    let (models, path) = (models(), journal("resume"));
    let whole = run("ball", &JOURNEY).csv();
    let (flag, expected) = (AtomicBool::new(false), AtomicUsize::new(0));
    let progress = |done: usize, total: usize| {
        expected.fetch_add(1, Ordering::Relaxed);
        assert_eq!(total, 40);
        flag.store(done >= 7, Ordering::Relaxed);
    };
    let again = || sweep(&models, "ball", &JOURNEY).unwrap().threads(2).journal(&path);
    let part = again().cancel(&flag).progress(&progress).run().unwrap();
    assert!(!part.is_whole() && part.rows.len() == expected.load(Ordering::Relaxed) && part.rows.len() < 12);
    // The last line as a program that was killed leaves it.
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, &text[..text.len() - 3]).unwrap();
    let rest = again().run().unwrap();
    assert_eq!(rest.computed, 40 - (part.rows.len() - 1));
    assert_eq!(rest.csv(), whole);
    let known = again().run().unwrap();
    assert_eq!((known.computed, known.csv()), (0, whole));
    std::fs::remove_file(path).unwrap();
}

/// What a member ended at is a name that may have been written in several lines.
#[test]
fn names_take_one_line_of_a_journal() {
    let (models, path) = (models(), journal("lines"));
    let words = ["vary e=0.1:0.9:3", "until y' =\n 0.5", "observe end"];
    let again = || sweep(&models, "ball", &words).unwrap().journal(&path).run().unwrap();
    let (first, second) = (again(), again());
    assert!(first.csv().contains("stop"), "{}", first.csv());
    assert_eq!((first.computed, second.computed, second.damaged), (3, 0, 0));
    assert_eq!(first.csv(), second.csv());
    std::fs::remove_file(path).unwrap();
}

/// Wherever a journal is cut off, what is whole of it is kept, and the outcome is the same.
#[test]
fn a_journal_may_be_cut_anywhere() {
    let (models, path) = (models(), journal("cut"));
    let words = ["vary e=0.1:1.2:4", "observe first impact y'", "observe end"];
    let again = || sweep(&models, "ball", &words).unwrap().journal(&path).run();
    let whole = again().unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let rows = text.find("member,").unwrap();
    // The head is the text of the declaration for the most part.
    for length in (0..text.len()).filter(|length| length % 7 == 0 || *length > rows) {
        std::fs::write(&path, &text.as_bytes()[..length]).unwrap();
        let table = again().unwrap_or_else(|error| panic!("{length}: {error}"));
        let lines = text[..length].matches('\n').count().saturating_sub(2);
        assert_eq!((table.computed, table.csv()), (4 - lines, whole.csv()), "{length}");
        assert_eq!(std::fs::read_to_string(&path).unwrap().lines().count(), 6, "{length}");
    }
    std::fs::remove_file(path).unwrap();
}

/// Any byte of a row that is not as it was written: the row is computed once more, the others are
/// kept.
#[test]
fn damaged_rows_of_a_journal_are_recomputed() {
    let (models, path) = (models(), journal("damaged"));
    let words = ["vary e=0.1:1.2:5", "observe first impact y'", "observe end"];
    let again = || sweep(&models, "ball", &words).unwrap().journal(&path).run();
    let whole = again().unwrap().csv();
    let text = std::fs::read(&path).unwrap();
    let ends: Vec<usize> = (0..text.len()).filter(|i| text[*i] == b'\n').collect();
    for place in ends[1] + 1..text.len() {
        let mut damaged = text.clone();
        damaged[place] ^= if place % 2 == 0 { 1 } else { 0x80 };
        std::fs::write(&path, &damaged).unwrap();
        let table = again().unwrap_or_else(|error| panic!("{place}: {error}"));
        // Without its end a line is one with the next; the last one is as one cut off.
        let [lost, told] = match ends.iter().position(|end| *end == place) {
            Some(6) => [1, 0],
            Some(_) => [2, 1],
            None => [1, 1],
        };
        // A byte that became an end parts a line in two.
        let parted = usize::from(damaged[place] == b'\n');
        assert_eq!((table.computed, table.csv()), (lost, whole.clone()), "{place}");
        assert_eq!(table.damaged, told + parted, "{place}");
        assert_eq!(table.summary().contains("damaged line"), told > 0, "{}", table.summary());
        let after = again().unwrap();
        assert_eq!((after.computed, after.damaged, after.csv()), (0, 0, whole.clone()), "{place}");
    }
    std::fs::remove_file(path).unwrap();
}

/// Rows of another sweep have other checksums, were they as well formed.
#[test]
fn rows_of_another_journal_are_not_taken() {
    let (models, [one, two]) = (models(), ["one", "two"].map(journal));
    let of = |words: &[&str], path| sweep(&models, "ball", words).unwrap().journal(path).run().unwrap();
    let [words, other] = ["vary e=0.1:0.8:4", "vary e=0.1:0.9:4"].map(|vary| [vary, "observe end y"]);
    let whole = of(&words, &one).csv();
    of(&other, &two);
    let [head, rows] = [&one, &two].map(|path| std::fs::read_to_string(path).unwrap());
    let lines = |text: &str| text.lines().map(|line| format!("{line}\n")).collect::<Vec<_>>();
    let mixed = [&lines(&head)[..4], &lines(&rows)[4..]].concat().concat();
    std::fs::write(&one, mixed).unwrap();
    let table = of(&words, &one);
    assert_eq!((table.computed, table.damaged, table.csv()), (2, 2, whole));
    for path in [one, two] {
        std::fs::remove_file(path).unwrap();
    }
}

#[test]
fn a_journal_is_written_by_one_sweep_at_a_time() {
    let (models, path) = (models(), journal("busy"));
    let of = || sweep(&models, "ball", &JOURNEY).unwrap().journal(&path);
    let refusals = std::sync::Mutex::new(Vec::new());
    let second = |done: usize, _: usize| {
        if done == 5 {
            refusals.lock().unwrap().push(of().run().err().expect("a refusal").to_string());
        }
    };
    let first = of().threads(1).progress(&second).run().unwrap();
    let refusals = refusals.into_inner().unwrap();
    assert!(refusals.len() == 1 && refusals[0].contains("of a sweep that is running"), "{refusals:?}");
    assert!(first.is_whole() && of().run().unwrap().csv() == first.csv());
    std::fs::remove_file(path).unwrap();
}

/// Bytes and lines changed, lost and doubled, as a fixed sequence has it: what is accepted has the
/// values that are right.
#[test]
fn a_mutilated_journal_is_refused_or_right() {
    let (models, path) = (models(), journal("mutilated"));
    let words = ["vary e=0.1:1.2:4", "observe first impact y'", "observe end"];
    let again = || sweep(&models, "ball", &words).unwrap().journal(&path).run();
    let whole = again().unwrap().csv();
    let text = std::fs::read(&path).unwrap();
    let mut state = 7u64;
    let mut draw = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    for round in 0..300 {
        let mut damaged = text.clone();
        for _ in 0..=draw(4) {
            let at = draw(damaged.len());
            match draw(4) {
                0 => damaged[at] = draw(256) as u8,
                1 => drop(damaged.drain(at..(at + 1 + draw(20)).min(text.len()).min(damaged.len()).max(at))),
                2 => damaged.insert(at, b"\n,\"\0"[draw(4)]),
                _ => damaged.extend_from_within(at..),
            }
            if damaged.is_empty() {
                damaged.push(b'#');
            }
        }
        std::fs::write(&path, &damaged).unwrap();
        match again() {
            Ok(table) => assert_eq!(table.csv(), whole, "{round}"),
            Err(error) => assert!(!error.to_string().contains('\n'), "{round}: {error}"),
        }
    }
    std::fs::remove_file(path).unwrap();
}

#[test]
fn a_journal_of_another_model_or_version_is_refused_by_name() {
    let (models, path) = (models(), journal("bound"));
    let words = ["vary g=1:2:3", "observe end"];
    let of = |name: &str| sweep(&models, name, &words).unwrap().journal(&path).run();
    let refused = |name: &str| of(name).err().expect("a refusal").to_string();
    of("ball").unwrap();
    let told = "another sweep: its `model` is \"ball\", not \"pendulum\"";
    assert!(refused("pendulum").contains(told), "{}", refused("pendulum"));
    let text = std::fs::read_to_string(&path).unwrap();
    let own = env!("CARGO_PKG_VERSION");
    for (from, to, told) in [
        (
            format!("\"version\":\"{own}\""),
            "\"version\":\"0.0.7\"".to_owned(),
            format!("its `version` is \"0.0.7\", not \"{own}\""),
        ),
        (
            "\"model\":\"ball\"".into(),
            "\"model\":\"bell\"".into(),
            "its `model` is \"bell\", not \"ball\"".into(),
        ),
        ("\"journal\":2,".into(), String::new(), "its `journal` is nothing, not 2".into()),
    ] {
        assert!(text.contains(&from), "{from}");
        std::fs::write(&path, text.replace(&from, &to)).unwrap();
        assert!(refused("ball").contains(&told), "{}", refused("ball"));
    }
    std::fs::remove_file(&path).unwrap();
    std::fs::create_dir(&path).unwrap();
    assert!(refused("ball").contains("is no file"), "{}", refused("ball"));
    std::fs::remove_dir(path).unwrap();
}

#[test]
fn a_journal_of_another_sweep_is_refused() {
    let (models, path) = (models(), journal("other"));
    sweep(&models, "ball", &JOURNEY).unwrap().journal(&path).run().unwrap();
    let before = std::fs::read_to_string(&path).unwrap();
    let other =
        || sweep(&models, "ball", &["vary e=0.1:0.9:41", JOURNEY[1], JOURNEY[2]]).unwrap().journal(&path);
    let error = other().run().err().unwrap().to_string();
    assert!(error.contains("another sweep: its `vary`") && !error.contains('\n'), "{error}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), before);
    assert_eq!(other().fresh().run().unwrap().computed, 41);
    std::fs::write(&path, "my notes\n").unwrap();
    let error = other().fresh().run().err().unwrap().to_string();
    assert!(error.ends_with("is not a journal of a sweep and was not changed"), "{error}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "my notes\n");
    std::fs::remove_file(path).unwrap();
}

/// What a point's number says does not depend on how many there are.
#[test]
fn a_larger_sample_computes_what_is_new() {
    let (models, path) = (models(), journal("larger"));
    let words = ["vary e=0:0.9", "observe first impact y'"];
    let of = |count| {
        let sweep = sweep(&models, "ball", &words).unwrap().journal(&path);
        sweep.sample(Sample::Sobol { count, seed: None }).run().unwrap()
    };
    let (few, many) = (of(8), of(20));
    assert_eq!((few.computed, many.computed), (8, 12));
    assert_eq!(numbers(&few, 0), numbers(&many, 0)[..8]);
    assert_eq!(of(8).rows.len(), 8);
    std::fs::remove_file(path).unwrap();
}
