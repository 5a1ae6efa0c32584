//! The processes that work for the leader of a [team](super::team).

use super::plan::Plan;
use super::team::TICK;
use super::team::answer::Answer;
use super::team::order::Order;
use super::{Sweep, SweepError};
use liftoff_processes::Processes;
use serde_json::Value;

impl Sweep<'_> {
    /// Computes what the leader sends, until it sends no more; files and progress are the leader's.
    ///
    /// # Errors
    /// The sweep cannot be made in this process. The leader has been told, and has sent no more.
    pub fn work(&self, processes: &dyn Processes) -> Result<(), SweepError> {
        let plan = Plan::new(self).inspect_err(|error| refuse(processes, &error.to_string()))?;
        let pool = plan.pool().inspect_err(|error| refuse(processes, &error.to_string()))?;
        let tell = |answer: &Answer| processes.send(0, &answer.text(self.observations.len()));
        tell(&Answer::Ready(Value::Object(self.identity()).to_string()));
        loop {
            let Some((_, message)) = processes.receive(TICK) else { continue };
            match Order::parse(&message) {
                Some(Order::Run(members)) => {
                    let found = plan.batch(pool.as_ref(), &members);
                    match plan.is_cancelled() {
                        false => tell(&Answer::Rows(found)),
                        true => tell(&Answer::Left(found)),
                    }
                }
                Some(Order::End) => break,
                None => tell(&Answer::Refused("was sent what is no order".to_owned())),
            }
        }
        tell(&Answer::End);
        Ok(())
    }
}

/// Tells the leader why this process cannot take part, and waits until it sends no more.
pub fn refuse(processes: &dyn Processes, reason: &str) {
    let tell = |answer: &Answer| processes.send(0, &answer.text(0));
    tell(&Answer::Refused(reason.to_owned()));
    let is_end = |message: String| Order::parse(&message) == Some(Order::End);
    while !processes.receive(TICK).is_some_and(|(_, message)| is_end(message)) {}
    tell(&Answer::End);
}
