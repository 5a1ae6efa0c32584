//! How a one-sided constraint acts: `rough`, `friction = mu`, `static = mu_s`, `tangential = e_t`,
//! `jams`, `restitution = e`, `law = newton`, `moreau`, `poisson` or `stronge`, `stop`,
//! `while("…")`, `breaks("…")`.

use syn::Expr;

use super::options::Options;
use super::switch::SwitchDeclaration;

/// How a support or a thread acts.
#[derive(Clone, Debug)]
pub struct ContactLaw {
    /// No slip while closed.
    pub rough: bool,
    /// Coulomb friction.
    pub friction: Option<FrictionLaw>,
    /// Restitution.
    pub restitution: Option<Expr>,
    /// What restitution relates.
    pub law: ImpactLaw,
    /// Whether reaching it ends a run.
    pub stop: bool,
    /// The condition that it is there on.
    pub armed: Option<SwitchDeclaration>,
    /// The condition that ends it.
    pub breaks: Option<SwitchDeclaration>,
}

/// Coulomb friction.
#[derive(Clone, Debug)]
pub struct FrictionLaw {
    /// The coefficient of sliding friction, which may depend on the slip velocity `v`.
    pub kinetic: Expr,
    /// That of static friction, where it differs.
    pub limit: Option<Expr>,
    /// The part of the slip velocity that an impact gives back where it would end the slip.
    pub tangential: Option<Expr>,
    /// Whether a run ends where no reaction obeys the law; else an impact without collision ends
    /// the slip.
    pub jams: bool,
}

/// What restitution relates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ImpactLaw {
    /// Velocities.
    #[default]
    Newton,
    /// Velocities, with Coulomb's law between the whole impulse and the velocity after it.
    Moreau,
    /// Impulses.
    Poisson,
    /// Energies.
    Stronge,
}

/// The options that [`ContactLaw::take`] takes of any contact.
pub(super) const CONTACT_LAW: [&str; 4] = ["restitution", "law", "while", "breaks"];
/// The options that it takes of a support.
pub(super) const FRICTION: [&str; 3] = ["friction", "static", "tangential"];

impl ContactLaw {
    /// Takes the contact law from the options of a support or thread.
    pub(super) fn take(options: &mut Options) -> syn::Result<Self> {
        let law = options.take_name("law")?;
        let law = match law.as_ref().map(ToString::to_string).as_deref() {
            None | Some("newton") => Ok(ImpactLaw::Newton),
            Some("moreau") => Ok(ImpactLaw::Moreau),
            Some("poisson") => Ok(ImpactLaw::Poisson),
            Some("stronge") => Ok(ImpactLaw::Stronge),
            Some(_) => {
                let text = "the law of impact is `newton` (velocities), `moreau` (velocities, with friction at the end alone), \
                            `poisson` (impulses) or `stronge` (energies)";
                Err(syn::Error::new_spanned(law, text))
            }
        }?;
        let rough = options.flag("rough");
        Ok(Self {
            friction: friction(options, rough)?,
            rough,
            restitution: options.take("restitution"),
            law,
            stop: options.flag("stop"),
            armed: options.take_switch(),
            breaks: options.take_break(),
        })
    }
}

pub(super) fn friction(options: &mut Options, rough: bool) -> syn::Result<Option<FrictionLaw>> {
    let (kinetic, limit) = (options.take("friction"), options.take("static"));
    let (tangential, jams) = (options.take("tangential"), options.written("jams").cloned());
    if let (None, Some(tangential)) = (&kinetic, &tangential) {
        let text = "`tangential` restitution needs friction; add `friction = mu`";
        return Err(syn::Error::new_spanned(tangential, text));
    }
    if let (None, Some(jams)) = (&kinetic, &jams) {
        return Err(syn::Error::new(jams.span(), "`jams` applies to friction only; add `friction = mu`"));
    }
    let jams = jams.is_some();
    match (kinetic, limit) {
        (Some(kinetic), _) if rough => {
            let text = "a rough contact never slips, whatever its friction; remove `rough` or `friction`";
            Err(syn::Error::new_spanned(kinetic, text))
        }
        (Some(kinetic), limit) => Ok(Some(FrictionLaw { kinetic, limit, tangential, jams })),
        (None, Some(limit)) => {
            let text = "`static` is the coefficient at rest; add the sliding coefficient: `friction = mu`";
            Err(syn::Error::new_spanned(limit, text))
        }
        (None, None) => Ok(None),
    }
}
