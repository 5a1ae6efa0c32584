//! What was merged.

/// What was merged.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Merged {
    /// The name of the model.
    pub model: String,
    /// Number of members.
    pub members: usize,
    /// Number of shards.
    pub shards: usize,
    /// How many members have failed.
    pub failed: usize,
}

impl Merged {
    /// How many members of how many shards, in a line.
    pub fn summary(&self) -> String {
        let Self { model, members, shards, failed } = self;
        let plural = if *shards == 1 { "" } else { "s" };
        let failed = if *failed > 0 { format!(", {failed} failed") } else { String::new() };
        format!("{members} members of {model} from {shards} shard{plural}{failed}\n")
    }
}
