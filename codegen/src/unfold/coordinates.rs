//! Coordinates of both halves. An angle q of a bar b, δ = r + s q, has the image q' = q of the
//! image b', δ' = r' − s q', r' the image of r.

use proc_macro2::{Literal, Span, TokenStream};
use quote::quote;
use syn::{Attribute, Ident, parse_quote};

use crate::algebra::Angle;
use crate::kinematics::Kinematics;
use crate::syntax::{DIRECTIONS, ident, plain};
use crate::system::{ConstrainedAngle, CoordinateKind, Equal, Mirror, Reference, System, measures_the_same};

/// Coordinates that are declared, and attributes that declare more.
pub(super) struct Coordinates<'a> {
    pub system: &'a System,
    pub mirror: &'a Mirror,
    pub declared: Vec<(Ident, CoordinateKind)>,
    /// Names that stand for something.
    pub taken: Vec<String>,
    pub attributes: Vec<Attribute>,
}

impl Coordinates<'_> {
    /// The coordinate that reads this, by a name like `stem` if it is not declared yet.
    pub fn named(&mut self, stem: &str, kind: &CoordinateKind) -> Ident {
        if let Some((name, _)) = self.declared.iter().find(|(_, known)| known == kind) {
            return name.clone();
        }
        let mut name = stem.to_owned();
        while self.taken.contains(&name) {
            name.push('_');
        }
        let (ident, measured) = (ident(&name), self.measured(kind));
        self.attributes.push(parse_quote!(#[coordinate(#ident = #measured)]));
        self.taken.push(name);
        self.declared.push((ident.clone(), kind.clone()));
        ident
    }

    /// What reads the same of the mirror image; none of an angle between bars of which one is named
    /// from the other end.
    pub fn image(&self, kind: &CoordinateKind) -> Option<CoordinateKind> {
        let turned = |body: usize| self.mirror.bodies[body].1;
        let image = |body: usize| self.mirror.bodies[body].0;
        match kind {
            CoordinateKind::Angle { body, reference, sign } => {
                let reference = match reference {
                    Reference::Ground(angle) => {
                        Reference::Ground(&self.mirror.sum_of_directions(*body) - angle)
                    }
                    Reference::Body(other) if turned(*other) == turned(*body) => {
                        Reference::Body(image(*other))
                    }
                    Reference::Body(_) => return None,
                };
                Some(CoordinateKind::Angle { body: image(*body), reference, sign: -sign })
            }
            CoordinateKind::Position { point, axis, sign } => {
                let sign = if *axis == self.mirror.axis { -sign } else { *sign };
                Some(CoordinateKind::Position { point: self.mirror.points[*point], axis: *axis, sign })
            }
        }
    }

    /// Whether nothing that is declared determines it: what hangs together has one position along
    /// each axis.
    pub fn is_free(&self, kind: &CoordinateKind, kinematics: &Kinematics) -> bool {
        use CoordinateKind::Position;
        let root = |point: usize| kinematics.tree.root[point];
        !self.declared.iter().any(|(_, known)| match (known, kind) {
            (Position { point: a, axis: i, .. }, Position { point: b, axis: j, .. }) => {
                root(*a) == root(*b) && i == j
            }
            _ => known == kind || measures_the_same(known, kind),
        })
    }

    /// Keeps the images of equal angles equal.
    pub fn equal(&mut self, Equal { factors: [a, b], left, right, span }: &Equal) -> syn::Result<()> {
        let (left, right) = (self.image_of_angle(left, *span)?, self.image_of_angle(right, *span)?);
        let (left, right) = (times(*a, &left), times(*b, &right));
        self.attributes.push(parse_quote!(#[equal(#left, #right)]));
        Ok(())
    }

    fn image_of_angle(&mut self, direction: &ConstrainedAngle, span: Span) -> syn::Result<Ident> {
        let (name, kind) = match direction {
            ConstrainedAngle::Body(body) => {
                let reference = Reference::Ground(Angle::zero());
                let name = format!("theta_{}", self.system.bodies[*body].name);
                (name, CoordinateKind::Angle { body: *body, reference, sign: 1 })
            }
            ConstrainedAngle::Coordinate(i) => {
                let declared = &self.system.coordinates[*i];
                (plain(&declared.name), declared.kind.clone())
            }
        };
        let image = self.image(&kind).ok_or_else(|| {
            let text = format!(
                "`{name}` is an angle between bars of which the mirror turns one only: to unfold what is equal to it, name \
                 both from the same end"
            );
            syn::Error::new(span, text)
        })?;
        Ok(self.named(&format!("{name}_image"), &image))
    }

    /// `-angle(DE), from = left`, `y(C)`.
    fn measured(&self, kind: &CoordinateKind) -> TokenStream {
        let (measured, sign) = match kind {
            CoordinateKind::Angle { body, reference, sign } => {
                let bar = ident(&self.system.bodies[*body].name);
                let from = match reference {
                    Reference::Ground(angle) => {
                        let end = DIRECTIONS[usize::from(angle.quarter_turns())];
                        ident(end)
                    }
                    Reference::Body(other) => ident(&self.system.bodies[*other].name),
                };
                (quote!(angle(#bar), from = #from), sign)
            }
            CoordinateKind::Position { point, axis, sign } => {
                let (axis, point) = (ident(["x", "y"][*axis]), ident(&self.system.points[*point].name));
                (quote!(#axis(#point)), sign)
            }
        };
        if *sign < 0 { quote!(-#measured) } else { measured }
    }
}

fn times(factor: i32, name: &Ident) -> TokenStream {
    let size = Literal::u32_unsuffixed(factor.unsigned_abs());
    let sign = (factor < 0).then(|| quote!(-));
    quote!(#sign #size * #name)
}
