//! Declarations with some tokens changed.

use std::ops::Range;

use liftoff_tests::random::Source;

use super::pool::Pool;
use super::words::{term, word};

/// Most copies in a row, most levels of brackets.
const MANY: usize = 4000;

/// A declaration with one change or several.
pub(super) fn mutated(pool: &Pool, source: &mut Source) -> Vec<String> {
    let mut tokens = pool.pick(source).to_vec();
    let changes = if source.chance(0.5) { 1 } else { 1 + source.below(6) };
    for _ in 0..changes {
        if tokens.is_empty() {
            break;
        }
        change(&mut tokens, pool, source);
    }
    tokens
}

fn change(tokens: &mut Vec<String>, pool: &Pool, source: &mut Source) {
    let at = source.below(tokens.len());
    let part = range(tokens, source, 12);
    match source.below(100) {
        0..12 => _ = tokens.remove(at),
        12..20 => tokens.insert(at, tokens[at].clone()),
        20..28 => tokens.swap(at, part.start),
        28..50 => tokens[at] = word(source),
        50..60 => tokens[at] = tokens[source.below(tokens.len())].clone(),
        60..68 => tokens.insert(at, word(source)),
        68..74 => tokens.insert(at, term(source)),
        74..80 => _ = tokens.splice(part, []),
        80..86 => _ = tokens.splice(at..at, tokens[part].to_vec()),
        86..92 => {
            let other = pool.pick(source);
            let taken = range(other, source, 60);
            tokens.splice(part, other[taken].iter().cloned());
        }
        92..96 => expression(tokens, at, source),
        96..98 => wrapped(tokens, part, source),
        98 => repeated(tokens, part, source),
        _ => _ = tokens.splice(at..at, (0..source.below(30)).map(|_| word(source)).collect::<Vec<_>>()),
    }
}

fn range(tokens: &[String], source: &mut Source, most: usize) -> Range<usize> {
    let start = source.below(tokens.len());
    start..tokens.len().min(start + 1 + source.below(most))
}

/// A bracketed function or power of what stands here.
fn expression(tokens: &mut Vec<String>, at: usize, source: &mut Source) {
    let inner = tokens[at].clone();
    let forms: [&[&str]; 8] = [
        &["sqrt", "(", "?", "*", "?", "+", "1", ")"],
        &["(", "?", "+", "l", "+", "m", "+", "1", ")", ".", "powi", "(", "32", ")"],
        &["(", "?", "-", "?", ")"],
        &["1", "/", "(", "1", "+", "?", ")"],
        &["sin", "(", "pi", "/", "7", "+", "?", ")"],
        &["(", "1e38", "*", "?", "*", "1e38", ")"],
        &["-", "-", "-", "?"],
        &["?", ".", "sqrt", "(", ")", ".", "sin", "(", ")"],
    ];
    let form = source.choose(&forms);
    let written = form.iter().map(|token| if *token == "?" { inner.clone() } else { (*token).to_owned() });
    tokens.splice(at..=at, written.collect::<Vec<_>>());
}

/// Brackets, perhaps of a function, often many.
fn wrapped(tokens: &mut Vec<String>, part: Range<usize>, source: &mut Source) {
    let levels = if source.chance(0.2) { source.below(MANY) } else { 1 + source.below(5) };
    let [open, close] =
        source.choose(&[["(", ")"], ["[", "]"], ["{", "}"], ["sqrt (", ")"], ["sin (", ")"], ["- (", ")"]]);
    let end = part.end;
    tokens.splice(end..end, std::iter::repeat_n(close.to_owned(), levels));
    let opening = open.split(' ').map(str::to_owned);
    let opening: Vec<String> = std::iter::repeat_n(opening, levels).flatten().collect();
    tokens.splice(part.start..part.start, opening);
}

/// The same tokens again and again, perhaps in a sum.
fn repeated(tokens: &mut Vec<String>, part: Range<usize>, source: &mut Source) {
    let copies = if source.chance(0.3) { source.below(MANY) } else { source.below(40) };
    let between = source.choose(&["+", ",", "", "*", "-"]);
    let mut one = tokens[part.clone()].to_vec();
    if !between.is_empty() {
        one.push(between.to_owned());
    }
    let many: Vec<String> = std::iter::repeat_n(one, copies).flatten().collect();
    tokens.splice(part.start..part.start, many);
}
