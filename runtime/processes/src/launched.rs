//! Whether a launcher has started this process, by the environment.

/// Variables with the number of processes: of Open MPI; of MPICH, Intel MPI and Slurm; of MVAPICH.
const COUNTS: [&str; 3] = ["OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"];
/// Variables that only a process of several has: of PMIx, by which Slurm starts those of Open MPI.
const RANK: &str = "PMIX_RANK";

/// Variables with the number of this process among them.
const RANKS: [&str; 4] = ["OMPI_COMM_WORLD_RANK", "PMI_RANK", "MV2_COMM_WORLD_RANK", RANK];

/// Whether this process has another number than 0 among those of a launcher.
pub(crate) fn follows(environment: &dyn Fn(&str) -> Option<String>) -> bool {
    RANKS.into_iter().find_map(environment).is_some_and(|rank| rank.trim() != "0")
}

/// What says that a launcher has started this process.
#[derive(Debug, PartialEq)]
pub(crate) struct Launched {
    pub(crate) variable: &'static str,
    /// How many processes it has started, where that is said.
    pub(crate) count: Option<usize>,
}

/// What the variables of the environment say.
pub(crate) fn by(environment: &dyn Fn(&str) -> Option<String>) -> Option<Launched> {
    let count = |variable| {
        let count = environment(variable)?.trim().parse().ok();
        Some(Launched { variable, count })
    };
    let rank = || environment(RANK).map(|_| Launched { variable: RANK, count: None });
    COUNTS.into_iter().find_map(count).or_else(rank)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn find_launcher(variables: &[(&str, &str)]) -> Option<(&'static str, Option<usize>)> {
        let value =
            |name: &str| variables.iter().find(|(known, _)| *known == name).map(|(_, v)| (*v).to_owned());
        by(&value).map(|launched| (launched.variable, launched.count))
    }

    #[test]
    fn launchers_are_known_by_their_variables() {
        assert_eq!(find_launcher(&[("SLURM_NTASKS", "4")]), None);
        assert_eq!(
            find_launcher(&[("PMIX_RANK", "0"), ("OMPI_COMM_WORLD_SIZE", "3")]),
            Some((COUNTS[0], Some(3)))
        );
        assert_eq!(find_launcher(&[("PMI_SIZE", "2")]), Some((COUNTS[1], Some(2))));
        assert_eq!(find_launcher(&[("PMIX_RANK", "1")]), Some((RANK, None)));
        assert_eq!(find_launcher(&[("PMI_SIZE", "two")]), Some((COUNTS[1], None)));
        let follows = |rank: Option<&str>| follows(&|name| (name == "PMI_RANK").then_some(rank?.to_owned()));
        assert_eq!([None, Some("0"), Some("2")].map(follows), [false, false, true]);
    }
}
