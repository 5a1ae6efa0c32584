//! `#[weld(AB, CD)]`, `#[weld(AB, CD, angle = a)]`, `#[weld(AB, angle = a)]`; with `while("…")` and
//! `breaks("…")`.

use syn::parse::ParseStream;
use syn::{Expr, Ident};

use super::Description;
use super::drive::{DriveDeclaration, Target};
use super::options::{self, Options};

/// Directions that keep their difference.
#[derive(Clone, Debug)]
pub struct WeldDeclaration {
    /// The bar that the other is held by, or that keeps its direction.
    pub first: Ident,
    /// The bar that is held.
    pub second: Option<Ident>,
    /// From the first to the second; the figure's if absent.
    pub angle: Option<Expr>,
}

/// Reads a weld; one on a condition is a drive.
pub(super) fn parse(input: ParseStream, description: &mut Description) -> syn::Result<()> {
    let (first, second) = options::one_or_two_names(input)?;
    let mut options = Options::parse(input, &["angle", "while", "breaks"])?;
    let angle = options.take("angle");
    let (armed, breaks) = (options.take_switch(), options.take_break());
    if second.is_none() && angle.is_none() {
        let text = format!(
            "what is `{first}` welded to? Name another bar, or the direction it keeps: `{first}, angle = a`"
        );
        return Err(syn::Error::new(first.span(), text));
    }
    if armed.is_none() && breaks.is_none() {
        description.welds.push(WeldDeclaration { first, second, angle });
        return Ok(());
    }
    let Some(value) = angle else {
        let text = format!(
            "a weld of `{first}` that lets go needs its angle, from the first to the second: `angle = a`"
        );
        return Err(syn::Error::new(first.span(), text));
    };
    let target = match second {
        Some(second) => Target::Turn([first, second]),
        None => Target::Angle(first),
    };
    description.drives.push(DriveDeclaration { target, value, armed, breaks });
    Ok(())
}
