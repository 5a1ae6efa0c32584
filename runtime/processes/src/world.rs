//! The processes of MPI (Message Passing Interface, version 3.1), by the crate `mpi`.

use crate::{JoinError, Processes};
use mpi::environment::Universe;
use mpi::traits::{Communicator, Destination, MatchedReceiveVec, Source};
use mpi::{Threading, initialize_with_threading};
use std::sync::{Mutex, PoisonError};
use std::thread::{self, available_parallelism};
use std::time::{Duration, Instant};

/// Between two looks for a message, so that a process that waits leaves its core to others.
const PAUSE: Duration = Duration::from_micros(200);

/// All processes that the launcher has started.
pub(crate) struct World {
    /// Calls are made by one thread at a time, as is asked of MPI.
    universe: Mutex<Universe>,
    rank: usize,
    count: usize,
    threads: usize,
}

impl World {
    pub(crate) fn join() -> Result<Self, JoinError> {
        let (universe, threading) =
            initialize_with_threading(Threading::Serialized).ok_or(JoinError::Threads)?;
        if threading < Threading::Serialized {
            return Err(JoinError::Threads);
        }
        let world = universe.world();
        let here = world.split_shared(0).size().max(1) as usize;
        let cores = available_parallelism().map_or(1, usize::from);
        let (rank, count) = (world.rank() as usize, world.size() as usize);
        Ok(Self { universe: Mutex::new(universe), rank, count, threads: (cores / here).max(1) })
    }
}

impl Processes for World {
    fn rank(&self) -> usize {
        self.rank
    }

    fn count(&self) -> usize {
        self.count
    }

    fn threads(&self) -> usize {
        self.threads
    }

    fn send(&self, rank: usize, message: &str) {
        let universe = self.universe.lock().unwrap_or_else(PoisonError::into_inner);
        universe.world().process_at_rank(rank as i32).send(message.as_bytes());
    }

    fn receive(&self, wait: Duration) -> Option<(usize, String)> {
        let since = Instant::now();
        loop {
            let universe = self.universe.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(found) = universe.world().any_process().immediate_matched_probe() {
                let (bytes, status) = found.matched_receive_vec::<u8>();
                return Some((status.source_rank() as usize, String::from_utf8_lossy(&bytes).into_owned()));
            }
            drop(universe);
            if since.elapsed() > wait {
                return None;
            }
            thread::sleep(PAUSE);
        }
    }
}
