//! Texts: whole ones, mutated ones, and words in any order.

use liftoff_tests::random::Source;

/// Most copies in a row, most levels of brackets.
const MANY: usize = 3000;

/// Any characters, those among them that end a line, a string or a number.
const CHARACTERS: [char; 24] = [
    '\0', '\n', '\r', '\t', ' ', '\'', '"', '\\', '(', ')', '[', ']', '{', '}', ',', '.', ':', '=', '-', '9',
    'e', 'é', '变', '\u{feff}',
];

/// A text made of one that makes sense, or of words alone.
pub(crate) fn hostile(source: &mut Source, whole: &[String], words: &[&str]) -> String {
    if whole.is_empty() || source.chance(0.2) {
        return (0..source.below(12)).map(|_| source.choose(words)).collect();
    }
    let mut text: Vec<char> = source.choose(whole).chars().collect();
    let changes = source.choose(&[0, 1, 1, 2, 2, 3, 6]);
    for _ in 0..changes {
        let at = source.below(text.len() + 1);
        let to = (at + source.below(8)).min(text.len());
        change(&mut text, at..to, source, words);
    }
    text.into_iter().collect()
}

fn change(text: &mut Vec<char>, part: std::ops::Range<usize>, source: &mut Source, words: &[&str]) {
    match source.below(20) {
        0..8 => _ = text.splice(part, source.choose(words).chars()),
        8..12 => _ = text.splice(part.start..part.start, source.choose(words).chars()),
        12..15 => _ = text.splice(part, []),
        15..17 => text.insert(part.start, source.choose(&CHARACTERS)),
        17 => {
            let copied: Vec<char> = text[part.clone()].to_vec();
            _ = text.splice(part.start..part.start, copied);
        }
        18 => {
            let copies = if source.chance(0.2) { source.below(MANY) } else { source.below(20) };
            let word: Vec<char> = source.choose(words).chars().collect();
            _ = text.splice(part, std::iter::repeat_n(word, copies).flatten());
        }
        _ => {
            let levels = if source.chance(0.2) { source.below(MANY) } else { source.below(9) };
            let [open, close] =
                source.choose(&[["(", ")"], ["sin(", ")"], ["-", ""], ["abs(", ""], ["[", "]"], ["(", ""]]);
            let close: Vec<char> = close.repeat(levels).chars().collect();
            text.splice(part.end..part.end, close);
            let open: Vec<char> = open.repeat(levels).chars().collect();
            text.splice(part.start..part.start, open);
        }
    }
}
