//! How a one-sided constraint acts: `rough`, `friction = mu`, `static = mu_s`, `restitution = e`, `law = newton` or `poisson`,
//! `stop`.

use syn::Expr;

use super::options::Options;

/// How a support or a thread acts.
#[derive(Clone, Debug)]
pub struct ContactLaw {
    /// No slip while closed.
    pub rough: bool,
    /// Coulomb friction.
    pub friction: Option<FrictionLaw>,
    /// Restitution.
    pub restitution: Option<Expr>,
    /// Whether restitution relates impulses (Poisson), not velocities (Newton).
    pub poisson: bool,
    /// Whether reaching it ends a run.
    pub stop: bool,
}

/// Coulomb friction.
#[derive(Clone, Debug)]
pub struct FrictionLaw {
    /// The coefficient of sliding friction, which may depend on the slip velocity `v`.
    pub kinetic: Expr,
    /// That of static friction, where it differs.
    pub limit: Option<Expr>,
}

/// The options that [`ContactLaw::take`] takes of any contact.
pub(super) const CONTACT_LAW: [&str; 2] = ["restitution", "law"];
/// The options that it takes of a support.
pub(super) const FRICTION: [&str; 2] = ["friction", "static"];

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
        let rough = options.flag("rough");
        Ok(Self {
            friction: friction(options, rough)?,
            rough,
            restitution: options.take("restitution"),
            poisson,
            stop: options.flag("stop"),
        })
    }
}

fn friction(options: &mut Options, rough: bool) -> syn::Result<Option<FrictionLaw>> {
    let (kinetic, limit) = (options.take("friction"), options.take("static"));
    match (kinetic, limit) {
        (Some(kinetic), _) if rough => {
            let text = "a rough contact never slips, whatever its friction; remove `rough` or `friction`";
            Err(syn::Error::new_spanned(kinetic, text))
        }
        (Some(kinetic), limit) => Ok(Some(FrictionLaw { kinetic, limit })),
        (None, Some(limit)) => {
            let text = "`static` is the coefficient at rest; add that of sliding: `friction = mu`";
            Err(syn::Error::new_spanned(limit, text))
        }
        (None, None) => Ok(None),
    }
}
