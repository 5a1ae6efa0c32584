//! Sweeps that processes share, here threads that send each other messages.

use super::{models, sweep};
use crate::registry::Models;
use crate::sweep::{Leader, Sample, Shard, Sweep, SweepError, merge, refuse};
use liftoff_processes::Processes;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Duration;

struct Channels {
    rank: usize,
    senders: Vec<Sender<(usize, String)>>,
    receiver: Mutex<Receiver<(usize, String)>>,
    /// How many members the others were given.
    given: AtomicUsize,
    /// How many messages this one has sent.
    sent: AtomicUsize,
}

impl Processes for Channels {
    fn rank(&self) -> usize {
        self.rank
    }

    fn count(&self) -> usize {
        self.senders.len()
    }

    fn threads(&self) -> usize {
        1
    }

    fn send(&self, rank: usize, message: &str) {
        if message.starts_with("run\n") {
            self.given.fetch_add(message.lines().count() - 1, Ordering::Relaxed);
        }
        self.senders[rank].send((self.rank, message.to_owned())).expect("a process that listens");
        self.sent.fetch_add(1, Ordering::Relaxed);
    }

    fn receive(&self, wait: Duration) -> Option<(usize, String)> {
        self.receiver.lock().expect("a receiver").recv_timeout(wait).ok()
    }
}

fn channels(count: usize) -> Vec<Channels> {
    let (senders, receivers): (Vec<_>, Vec<_>) = (0..count).map(|_| channel()).unzip();
    let of = |(rank, receiver)| Channels {
        rank,
        senders: senders.clone(),
        receiver: Mutex::new(receiver),
        given: AtomicUsize::new(0),
        sent: AtomicUsize::new(0),
    };
    receivers.into_iter().enumerate().map(of).collect()
}

/// What `lead` makes of so many processes, of which the others do `work`; and how many members
/// these were given.
fn shared<T>(
    count: usize,
    work: impl Fn(&Channels) + Sync,
    lead: impl FnOnce(&Leader<'_>) -> T,
) -> (T, usize) {
    let processes = channels(count);
    thread::scope(|scope| {
        for worker in &processes[1..] {
            scope.spawn(|| work(worker));
        }
        // Not before the others have come: a quick leader would do all by itself.
        while processes[1..].iter().any(|worker| worker.sent.load(Ordering::Relaxed) == 0) {
            thread::sleep(Duration::from_millis(1));
        }
        let leader = Leader::new(&processes[0]);
        let made = lead(&leader);
        (made, processes[0].given.load(Ordering::Relaxed))
    })
}

const WORDS: [&str; 5] =
    ["vary e=0:1.1", "vary h=0.5:2", "observe count impact", "observe max y'", "observe last impact"];

/// On one thread, members that fail among them.
fn balls(models: &Models) -> Sweep<'_> {
    let sweep = sweep(models, "ball", &WORDS).expect("a sweep");
    sweep.sample(Sample::Random { count: 300, seed: 5 }).threads(1)
}

#[test]
fn any_number_of_processes_gives_the_same() {
    let models = models();
    let alone = balls(&models).run().unwrap();
    assert!(alone.failed().count() > 10);
    let work = |processes: &Channels| balls(&models).work(processes).expect("a worker");
    for count in 1..=4 {
        let (table, given) = shared(count, work, |leader| balls(&models).team(leader).run().unwrap());
        assert_eq!(table.csv(), alone.csv(), "{count}");
        assert!((given > 0) == (count > 1) && given < 300, "{given} of {count}");
    }
}

/// Two rounds of one team: the coarse grid, then the intervals of the changes.
#[test]
fn thresholds_are_shared() {
    let models = models();
    let change = || sweep(&models, "ball", &["vary h=1:100:log", "observe first impact"]).unwrap();
    let alone = change().thresholds(1e-10).unwrap();
    let work = |processes: &Channels| change().work(processes).expect("a worker");
    let (found, given) = shared(3, work, |leader| change().team(leader).thresholds(1e-10).unwrap());
    assert_eq!(format!("{found:?}"), format!("{alone:?}"));
    assert!(given > 0);
}

#[test]
fn a_shard_is_shared_and_merged() {
    let models = models();
    let folder = std::env::temp_dir().join(format!("liftoff-{}-team", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    let work = |processes: &Channels| balls(&models).work(processes).expect("a worker");
    for i in 0..2 {
        let shard = Shard::new(i, 2).unwrap();
        let lead = |leader: &Leader<'_>| balls(&models).team(leader).run_shard(shard, &folder).unwrap();
        let (share, _) = shared(2, work, lead);
        assert!(share.is_whole());
    }
    let file = folder.join("table.csv");
    merge(std::slice::from_ref(&folder)).unwrap().write_csv(&file).unwrap();
    assert_eq!(std::fs::read_to_string(&file).unwrap(), balls(&models).run().unwrap().csv());
    std::fs::remove_dir_all(folder).unwrap();
}

fn refused(work: impl Fn(&Channels) + Sync) -> SweepError {
    let models = models();
    let (result, _) = shared(3, work, |leader| balls(&models).team(leader).run());
    result.err().expect("a process that takes no part")
}

#[test]
fn a_process_that_takes_no_part_is_reported() {
    let models = models();
    let fine = |processes: &Channels| balls(&models).work(processes).expect("a worker");
    let told = |error: SweepError| error.to_string();
    let other = refused(|processes| match processes.rank {
        2 => balls(&models).set("g=3").unwrap().work(processes).expect("a worker"),
        _ => fine(processes),
    });
    assert_eq!(told(other), r#"process 2 computes another sweep: its `set` is ["g=3"], not []"#);
    let mistaken = refused(|processes| match processes.rank {
        1 => assert!(balls(&models).set("e=1").unwrap().set("e=2").unwrap().work(processes).is_err()),
        _ => fine(processes),
    });
    assert_eq!(told(mistaken), "process 1 cannot take part: --set: `e` is given twice");
    let missing = refused(|processes| refuse(processes, "no model `ball`"));
    assert!(told(missing).ends_with(" cannot take part: no model `ball`"));
    let senseless = refused(|processes| {
        if processes.rank == 2 {
            processes.send(0, "rows\n1,2\n");
        }
        fine(processes);
    });
    assert_eq!(told(senseless), "process 2 sends what is no answer");
}

/// What was done before is kept by the leader's journal, and one process goes on with it.
#[test]
fn a_process_that_is_interrupted_ends_the_sweep() {
    let models = models();
    let path = std::env::temp_dir().join(format!("liftoff-{}-team.journal", std::process::id()));
    let _ = std::fs::remove_file(&path);
    let long = || balls(&models).sample(Sample::Random { count: 3000, seed: 5 });
    let (result, _) = shared(
        2,
        |processes| {
            let flag = AtomicBool::new(false);
            thread::scope(|scope| {
                scope.spawn(|| {
                    thread::sleep(Duration::from_millis(100));
                    flag.store(true, Ordering::Relaxed);
                });
                long().cancel(&flag).work(processes).expect("a worker");
            });
        },
        |leader| long().journal(&path).team(leader).run(),
    );
    assert!(matches!(result, Err(SweepError::Interrupted)));
    let rest = long().journal(&path).run().unwrap();
    assert!(rest.is_whole() && rest.computed < 3000, "{}", rest.computed);
    std::fs::remove_file(path).unwrap();
}

/// No more is given out once the leader is interrupted; it has what was brought.
#[test]
fn a_leader_that_is_interrupted_keeps_what_is_done() {
    let models = models();
    let work = |processes: &Channels| balls(&models).work(processes).expect("a worker");
    let flag = AtomicBool::new(false);
    let progress = |done: usize, _: usize| flag.store(done >= 20, Ordering::Relaxed);
    let lead =
        |leader: &Leader<'_>| balls(&models).cancel(&flag).progress(&progress).team(leader).run().unwrap();
    let (table, _) = shared(3, work, lead);
    assert!(!table.is_whole() && table.rows.len() >= 20);
}

/// The error is the leader's own, and the workers are let go.
#[test]
fn a_journal_that_cannot_be_written_ends_the_sweep() {
    let models = models();
    let work = |processes: &Channels| balls(&models).work(processes).expect("a worker");
    let path = std::env::temp_dir();
    let (result, _) = shared(3, work, |leader| balls(&models).journal(&path).team(leader).run());
    assert!(matches!(result, Err(SweepError::Journal { .. })));
}
