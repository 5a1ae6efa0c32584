//! Whole runs: the same events at the same times.

use super::each;
use liftoff_studio::registry::Entry;
use std::sync::Arc;

#[test]
fn default_runs_have_the_same_events() {
    each(|entry, interpreted| {
        let spec = entry.default_run();
        let own = Entry::interpreted(Arc::clone(interpreted));
        let (compiled, own) = (entry.run(&spec).unwrap(), own.run(&spec).unwrap());
        let names =
            |run: &liftoff::Trajectory| run.events().iter().map(|e| e.to_string()).collect::<Vec<_>>();
        assert_eq!(
            compiled.events().len(),
            own.events().len(),
            "{}: {:?} {:?}",
            entry.name(),
            names(&compiled),
            names(&own)
        );
        let unit = compiled.scales().time;
        for (a, b) in compiled.events().iter().zip(own.events()) {
            let what = || format!("{}: {a} compiled, {b} interpreted", entry.name());
            assert_eq!(format!("{:?}", a.kind), format!("{:?}", b.kind), "{}", what());
            assert!((a.t - b.t).abs() <= 1e-9 * (unit + a.t.abs()), "{} {:e}", what(), a.t - b.t);
        }
    });
}
