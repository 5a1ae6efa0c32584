//! Whatever else is declared must have its mirror image, or be its own.

use proc_macro2::Span;

use super::Pairing;
use crate::system::parts::Parts;
use crate::system::scope::Scope;

/// The images of points and bodies, and what they are asked for.
pub(super) struct Images<'a> {
    pub pairing: &'a Pairing<'a>,
    pub bodies: &'a [(usize, bool)],
    pub parts: &'a Parts,
}

impl Images<'_> {
    /// Whether the image of a body of direction δ has the direction π − δ, not −δ.
    pub fn half_turn(&self, body: usize) -> bool {
        (self.pairing.line.axis == 0) != self.bodies[body].1
    }

    pub fn body_name(&self, body: usize) -> &str {
        &self.pairing.structure.bodies[body].name
    }
}

/// What has a mirror image.
pub(super) trait Reflect: Sized {
    /// What it is called.
    const KIND: &'static str;
    /// Its name and where it is declared.
    fn named(&self, images: &Images) -> (String, Span);
    /// What its image must be.
    fn image(&self, images: &Images) -> Self;
    /// Whether both act on the same points or bodies.
    fn meets(&self, other: &Self) -> bool;
    /// Whether two that act on the same points or bodies are equal.
    fn same(&self, other: &Self, images: &Images) -> bool;
    /// The points or bodies it acts on.
    fn describe_location(&self, images: &Images) -> String;
}

/// Reports what has no image.
pub(super) fn check<T: Reflect>(scope: &mut Scope, images: &Images, items: &[T]) {
    let expected: Vec<T> = items.iter().map(|item| item.image(images)).collect();
    let equal = |a: &T, b: &T| a.meets(b) && a.same(b, images);
    let matched = |a: usize| {
        let rank = (0..a).filter(|&b| equal(&expected[b], &expected[a])).count();
        items.iter().filter(|other| equal(&expected[a], other)).nth(rank).is_some()
    };
    let lonely: Vec<usize> = (0..items.len()).filter(|&a| !matched(a)).collect();
    for &a in &lonely {
        let (kind, (name, span)) = (T::KIND, items[a].named(images));
        let counterpart = items.iter().position(|other| expected[a].meets(other));
        let text = match counterpart {
            Some(b) if b == a => format!("{kind} `{name}` is not symmetric to the mirror"),
            Some(b) if b < a && lonely.contains(&b) => continue,
            Some(b) => {
                let other = items[b].named(images).0;
                format!("{kind}s `{name}` and `{other}` are not mirror images: their values differ")
            }
            None => {
                let place = expected[a].describe_location(images);
                format!("{kind} `{name}` has no mirror image; declare one for {place} too")
            }
        };
        scope.report.add_message(span, text);
    }
}
