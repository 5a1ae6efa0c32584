//! The two lines at the head of a shard: of which sweep it is which part, and the names of its
//! columns.

use super::Shard;
use crate::sweep::journal::{FORM, Identity, MARK, SEED, checksum, identity_of};
use crate::sweep::{MOST_MEMBERS, SweepError, columnar};
use liftoff_columnar::{Column, Heading};
use serde_json::Value;

/// The words of a shard beside those of its sweep.
const SHARD: &str = "shard";
const SHARDS: &str = "shards";
const MEMBERS: &str = "members";
const COLUMNS: &str = "columns";
/// The word of how rows are written.
const JOURNAL: &str = "journal";

const NONE: &str = "is not a shard of a sweep, or its first lines are damaged";

/// The head of a shard.
#[derive(Clone, Debug)]
pub(super) struct Head {
    /// That of the sweep, with the shard and the number of members.
    pub(super) identity: Identity,
    pub(super) shard: Shard,
    /// Of the whole sweep.
    pub(super) members: usize,
    /// The names of the columns of the table, with the end of the line.
    pub(super) names: String,
    pub(super) columns: Vec<Column>,
    /// What its lines' checksums begin with.
    pub(super) seed: u64,
}

impl Head {
    pub(super) fn new(
        mut identity: Identity,
        (names, columns): (String, Vec<Column>),
        shard: Shard,
        members: usize,
    ) -> Self {
        for (word, number) in [(SHARD, shard.index), (SHARDS, shard.count), (MEMBERS, members)] {
            identity.insert(word.to_owned(), number.into());
        }
        identity.insert(COLUMNS.to_owned(), columnar::word(&columns));
        let seed = checksum(SEED, lines(&identity, &names).as_bytes());
        Self { identity, shard, members, names, columns, seed }
    }

    /// The head that a file begins with.
    pub(super) fn parse(first: &[u8], second: &[u8]) -> Result<Self, String> {
        let identity = identity_of(first.trim_ascii_end()).ok_or(NONE)?;
        let number = |word| identity.get(word).and_then(Value::as_u64)?.try_into().ok();
        let names = String::from_utf8(second.to_vec()).ok().filter(|names| names.ends_with('\n'));
        let columns = identity.get(COLUMNS).and_then(columnar::of_word);
        let read = (number(SHARD), number(SHARDS), number(MEMBERS), names.zip(columns));
        if identity.get(JOURNAL) != Some(&FORM.into()) {
            return Err("was written by another version".to_owned());
        }
        let (Some(index), Some(count), Some(members), Some(columns)) = read else {
            return Err(NONE.to_owned());
        };
        if members > MOST_MEMBERS {
            return Err(format!("has {members} members, and {MOST_MEMBERS} are the most"));
        }
        Ok(Self::new(
            identity,
            columns,
            Shard::new(index, count).map_err(|reason| format!("has {reason}"))?,
            members,
        ))
    }

    /// What every shard of one sweep has.
    pub(super) fn of_all(&self) -> Identity {
        let mut identity = self.identity.clone();
        identity.remove(SHARD);
        identity
    }

    /// What a columnar file says of the whole table: what the table of one process says.
    pub(super) fn heading(&self) -> Result<Heading, SweepError> {
        let mut identity = self.identity.clone();
        for word in [SHARD, SHARDS, MEMBERS, COLUMNS] {
            identity.remove(word);
        }
        columnar::heading(&identity, self.columns.clone())
    }

    /// The name of the model.
    pub(super) fn model(&self) -> &str {
        self.identity.get("model").and_then(Value::as_str).unwrap_or_default()
    }

    pub(super) fn share(&self) -> usize {
        self.shard.share(self.members)
    }

    /// Both lines.
    pub(super) fn text(&self) -> String {
        lines(&self.identity, &self.names)
    }

    /// The last line of a shard that is whole, before its checksum.
    pub(super) fn last(&self) -> String {
        format!("# whole,{}", self.share())
    }
}

fn lines(identity: &Identity, names: &str) -> String {
    format!("{MARK}{}\n{names}", Value::Object(identity.clone()))
}
