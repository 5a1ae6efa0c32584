//! How much of a long result is printed.

use clap::Args;

/// Lines of a screen.
const SCREEN: usize = 24;

#[derive(Args, Clone, Copy, Debug)]
pub struct Length {
    /// Print all, also what does not fit a screen of 24 lines
    #[arg(long)]
    all: bool,
}

impl Length {
    /// Whether so many lines are printed whole.
    pub fn fits(self, lines: usize) -> bool {
        self.all || lines <= SCREEN
    }

    /// The whole text where it fits a screen or all is asked for; else the brief one, and how to
    /// have the rest.
    pub fn fit(self, whole: String, brief: impl FnOnce(usize) -> String) -> String {
        let lines = whole.lines().count();
        match self.fits(lines) {
            true => whole,
            false => format!("{}--all prints all {lines} lines\n", brief(SCREEN - 1)),
        }
    }
}

/// At most so many of some in order, the first and the last among them, evenly between; none where
/// fewer than two are asked for.
pub fn thin<T>(all: &[T], most: usize) -> impl Iterator<Item = &T> {
    let count = if most < 2 { 0 } else { all.len().min(most) };
    (0..count).map(move |k| &all[if count < 2 { k } else { k * (all.len() - 1) / (count - 1) }])
}

#[cfg(test)]
mod tests {
    use super::{Length, thin};

    #[test]
    fn what_fits_a_screen_is_whole_and_the_rest_is_asked_for() {
        let (short, long) = ("line\n".repeat(24), "line\n".repeat(25));
        let [brief, all] = [false, true].map(|all| Length { all });
        assert_eq!(brief.fit(short.clone(), |_| String::new()), short);
        assert_eq!(all.fit(long.clone(), |_| String::new()), long);
        let shown = brief.fit(long, |lines| "line\n".repeat(lines));
        assert_eq!((shown.lines().count(), shown.lines().last()), (24, Some("--all prints all 25 lines")));
    }

    #[test]
    fn first_and_last_stay() {
        let all: Vec<usize> = (0..=30).collect();
        assert_eq!(thin(&all, 4).copied().collect::<Vec<_>>(), [0, 10, 20, 30]);
        assert_eq!(thin(&all[..3], 4).copied().collect::<Vec<_>>(), [0, 1, 2]);
        assert_eq!(thin(&all, 2).copied().collect::<Vec<_>>(), [0, 30]);
        assert_eq!(thin(&all, 1).count(), 0);
        assert_eq!(thin(&all[..1], 4).copied().collect::<Vec<_>>(), [0]);
        assert_eq!(thin(&all[..0], 4).count(), 0);
    }
}
