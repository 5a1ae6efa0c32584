//! How a one-sided constraint acts: `rough`, `restitution = e`, `law = newton` or `poisson`, `stop`.

use syn::Expr;

use super::options::Options;

/// How a support or a thread acts.
#[derive(Clone, Debug)]
pub struct ContactLaw {
    /// No slip while closed.
    pub rough: bool,
    /// Restitution.
    pub restitution: Option<Expr>,
    /// Whether restitution relates impulses (Poisson), not velocities (Newton).
    pub poisson: bool,
    /// Whether reaching it ends a run.
    pub stop: bool,
}

/// The options that [`ContactLaw::take`] takes.
pub(super) const CONTACT_LAW: [&str; 2] = ["restitution", "law"];

impl ContactLaw {
    /// Takes the contact law from the options of a support or thread.
    pub(super) fn take(options: &mut Options) -> syn::Result<Self> {
        let law = options.take_name("law")?;
        let poisson = match law.as_ref().map(ToString::to_string).as_deref() {
            None | Some("newton") => Ok(false),
            Some("poisson") => Ok(true),
            Some(_) => {
                let text = "the law of impact is `newton` (velocities) or `poisson` (impulses)";
                Err(syn::Error::new_spanned(law, text))
            }
        }?;
        Ok(Self {
            rough: options.flag("rough"),
            restitution: options.take("restitution"),
            poisson,
            stop: options.flag("stop"),
        })
    }
}
