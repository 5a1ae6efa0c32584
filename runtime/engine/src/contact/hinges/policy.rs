//! Which hinges stick and which slide, and in what sense: 0, 1, −1.

/// From hinges that all stick to those that have to slide, and back, until all obey; none where
/// that goes in a circle. `answer` gives what follows for some senses, and the senses that the
/// hinges have to have instead.
pub(super) fn improve<T>(count: usize, answer: impl Fn(&[f64]) -> Option<(T, Vec<f64>)>) -> Option<T> {
    let mut tried: Vec<Vec<f64>> = Vec::new();
    let mut senses = vec![0.0; count];
    while !tried.contains(&senses) {
        let (found, next) = answer(&senses)?;
        if next == senses {
            return Some(found);
        }
        tried.push(core::mem::replace(&mut senses, next));
    }
    None
}

/// All senses of so many hinges.
pub(super) fn all(count: usize) -> impl Iterator<Item = Vec<f64>> {
    let sense = |mode: usize, k: usize| [0.0, 1.0, -1.0][mode / 3_usize.pow(k as u32) % 3];
    (0..3_usize.pow(count as u32)).map(move |mode| (0..count).map(|k| sense(mode, k)).collect())
}
