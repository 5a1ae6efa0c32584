//! A file with the chosen mutants of its sites behind a switch.

use std::ops::Range;

use crate::sites::Site;

/// A file with mutants, and where in it each stands; of one within another, both places.
#[derive(Debug, Default)]
pub struct Schema {
    /// The text.
    pub text: String,
    /// Numbers of mutants, and the bytes of the text that are theirs.
    pub places: Vec<(u32, Range<usize>)>,
}

impl Schema {
    /// Writes a file with the chosen sites, outermost first, each with its number.
    pub fn new(source: &str, chosen: &[(u32, &Site)]) -> Self {
        let mut schema = Self::default();
        schema.write(source, 0..source.len(), chosen);
        schema
    }

    /// The mutant in whose bytes this range of the text lies; the innermost.
    pub fn find_mutant(&self, range: &Range<usize>) -> Option<u32> {
        let holds = |place: &Range<usize>| place.start <= range.start && range.end <= place.end;
        let within = self.places.iter().filter(|(_, place)| holds(place));
        within.min_by_key(|(_, place)| place.len()).map(|&(id, _)| id)
    }

    fn write(&mut self, source: &str, range: Range<usize>, chosen: &[(u32, &Site)]) {
        let mut at = range.start;
        for (i, &(id, site)) in chosen.iter().enumerate() {
            if site.range.start < at || site.range.end > range.end {
                continue;
            }
            self.text.push_str(&source[at..site.range.start]);
            self.branch(source, (id, site), &chosen[i + 1..]);
            at = site.range.end;
        }
        self.text.push_str(&source[at..range.end]);
    }

    fn branch(&mut self, source: &str, (id, site): (u32, &Site), inner: &[(u32, &Site)]) {
        let start = self.text.len();
        let (open, close) = if site.statement { ("", "") } else { ("(", ")") };
        self.text.push_str(&format!("{open}if crate::mutant({id}) {{ "));
        if !site.statement {
            let (left, right) = (site.range.start..site.cut.start, site.cut.end..site.range.end);
            self.operand(source, left, inner);
            self.text.push_str(site.to);
            self.operand(source, right, inner);
        }
        self.text.push_str(" } else { ");
        self.write(source, site.range.clone(), inner);
        self.text.push_str(&format!(" }}{close}"));
        self.places.push((id, start..self.text.len()));
    }

    fn operand(&mut self, source: &str, range: Range<usize>, inner: &[(u32, &Site)]) {
        if !range.is_empty() {
            self.text.push('(');
            self.write(source, range, inner);
            self.text.push(')');
        }
    }
}
