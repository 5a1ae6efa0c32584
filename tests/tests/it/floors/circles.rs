//! Modules that import each other, and whether they are known to.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use super::imports::Arrows;

/// Modules each of which reaches all the others by imports.
pub type Circle<'a> = Vec<&'a str>;

/// The circles of some imports, by Tarjan's search.
pub fn circles(arrows: &Arrows) -> Vec<Circle<'_>> {
    let mut search = Search { arrows, order: BTreeMap::new(), open: Vec::new(), found: Vec::new() };
    for (from, _) in arrows.keys() {
        if !search.order.contains_key(from.as_str()) {
            search.visit(from);
        }
    }
    search.found
}

struct Search<'a> {
    arrows: &'a Arrows,
    order: BTreeMap<&'a str, usize>,
    open: Vec<&'a str>,
    found: Vec<Circle<'a>>,
}

impl<'a> Search<'a> {
    /// The first module among those still open that a module reaches.
    fn visit(&mut self, module: &'a str) -> usize {
        let place = self.order.len();
        self.order.insert(module, place);
        let start = self.open.len();
        self.open.push(module);
        let mut lowest = place;
        for to in imported(self.arrows, module) {
            match self.order.get(to) {
                None => lowest = lowest.min(self.visit(to)),
                Some(place) if self.open.contains(&to) => lowest = lowest.min(*place),
                Some(_) => {}
            }
        }
        if lowest == place {
            let mut circle = self.open.split_off(start);
            circle.sort_unstable();
            self.found.extend(Some(circle).filter(|circle| circle.len() > 1));
        }
        lowest
    }
}

/// The modules that a module imports.
fn imported<'a>(arrows: &'a Arrows, module: &str) -> impl Iterator<Item = &'a str> {
    arrows.keys().filter(move |(from, _)| from == module).map(|(_, to)| to.as_str())
}

/// The modules of a shortest way along imports.
fn way<'a>(arrows: &'a Arrows, from: &'a str, to: &str) -> Option<Vec<&'a str>> {
    let mut seen = BTreeSet::from([from]);
    let mut ways = VecDeque::from([vec![from]]);
    while let Some(way) = ways.pop_front() {
        let last = *way.last()?;
        if last == to {
            return Some(way);
        }
        let new = imported(arrows, last).filter(|next| seen.insert(next));
        ways.extend(new.map(|next| [&way[..], &[next]].concat()));
    }
    None
}

/// What is wrong with a list of circles: those that it lacks, and those that are no more.
pub fn complaints(arrows: &Arrows, listed: &[&[&str]]) -> Vec<String> {
    let found = circles(arrows);
    let is_known = |modules: &[&str]| listed.iter().any(|circle| is_within(modules, circle));
    let new = found.iter().filter(|circle| !is_known(circle)).map(|circle| {
        let shortest = shortest(arrows, circle, &is_known);
        format!("imports in a new circle:\n{}", describe_cycle(arrows, &shortest))
    });
    let is_gone = |circle: &&&[&str]| !found.iter().any(|other| is_within(circle, other));
    let gone = listed.iter().filter(is_gone).map(|circle| {
        let left: Vec<&Circle> = found.iter().filter(|other| is_within(other, circle)).collect();
        format!("shorten the list: of the circle {circle:?} is left {left:?}")
    });
    new.chain(gone).collect()
}

fn is_within(modules: &[&str], circle: &[&str]) -> bool {
    modules.iter().all(|module| circle.contains(module))
}

/// The modules along a shortest way round, by an arrow that is not known if there is one.
fn shortest<'a>(arrows: &'a Arrows, circle: &[&str], is_known: &dyn Fn(&[&str]) -> bool) -> Vec<&'a str> {
    let within = arrows.keys().filter(|(from, to)| is_within(&[from, to], circle));
    let round = within.filter_map(|(from, to)| {
        let back = way(arrows, to, from)?;
        Some((is_known(&[from, to]), [&[from.as_str()], &back[..]].concat()))
    });
    let first = round.min_by_key(|(is_known, round)| (*is_known, round.len()));
    first.map_or_else(Vec::new, |(_, round)| round)
}

/// Each arrow of a way with its place.
fn describe_cycle(arrows: &Arrows, way: &[&str]) -> String {
    let steps = way.windows(2).map(|pair| {
        let place = &arrows[&(pair[0].to_owned(), pair[1].to_owned())];
        format!("  {} imports {} at {place}", pair[0], pair[1])
    });
    steps.collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::floors::imports::Place;

    /// Arrows from each letter to the next, of which each has a line.
    fn arrows(pairs: &[&str]) -> Arrows {
        let name = |pair: &str, i: usize| pair[i..=i].to_owned();
        let arrow = |(line, pair): (usize, &&str)| ((name(pair, 0), name(pair, 1)), Place::new("f.rs", line));
        pairs.iter().enumerate().map(arrow).collect()
    }

    #[test]
    fn imports_along_a_line_are_no_circle() {
        assert_eq!(circles(&arrows(&["ab", "bc", "ac"])), [[""; 0]; 0]);
        assert_eq!(complaints(&arrows(&["ab", "bc", "ac"]), &[]), [""; 0]);
    }

    #[test]
    fn circles_are_found_apart() {
        let pairs = arrows(&["ab", "bc", "ca", "cd", "de", "ed", "ef", "xa"]);
        assert_eq!(circles(&pairs), [vec!["d", "e"], vec!["a", "b", "c"]]);
        assert_eq!(complaints(&pairs, &[&["a", "b", "c"], &["d", "e"]]), [""; 0]);
    }

    #[test]
    fn a_new_circle_is_reported_by_its_shortest_way_round() {
        let told = complaints(&arrows(&["ab", "bc", "ca", "cd", "da"]), &[]);
        let way = "  a imports b at f.rs:0\n  b imports c at f.rs:1\n  c imports a at f.rs:2";
        assert_eq!(told, [format!("imports in a new circle:\n{way}")]);
    }

    #[test]
    fn a_circle_that_grows_is_reported_by_what_is_new() {
        let told = complaints(&arrows(&["ab", "ba", "bc", "ca"]), &[&["a", "b"]]);
        let way = "  b imports c at f.rs:2\n  c imports a at f.rs:3\n  a imports b at f.rs:0";
        assert_eq!(told, [format!("imports in a new circle:\n{way}")]);
    }

    #[test]
    fn a_circle_that_shrank_or_went_leaves_the_list() {
        let pairs = arrows(&["ab", "ba", "bc"]);
        let left = |left: &str| [format!("shorten the list: of the circle {left}")];
        assert_eq!(complaints(&pairs, &[&["a", "b", "c"]]), left(r#"["a", "b", "c"] is left [["a", "b"]]"#));
        assert_eq!(complaints(&pairs, &[&["a", "b"], &["c", "d"]]), left(r#"["c", "d"] is left []"#));
    }
}
