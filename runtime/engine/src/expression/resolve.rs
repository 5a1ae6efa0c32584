//! Names of a model in expressions; coordinates and parameters go before the words of the language.

use super::tree::{Expression, Function, Operator};
use crate::error::{NameError, OutputError};
use crate::model::{Contact, ContactKind, ContactSet, DependentAngle, Layout, Quantity, Term};
use core::f64::consts::FRAC_PI_2;
use std::borrow::Cow;

const POINTS: [(&str, usize, usize); 6] =
    [("x", 0, 0), ("y", 1, 0), ("vx", 0, 1), ("vy", 1, 1), ("ax", 0, 2), ("ay", 1, 2)];
/// The magnitude of a point's velocity.
const SPEED: &str = "speed";
const PI: &str = "pi";
const CONSTANTS: [&str; 6] = [PI, "t", "T", "V", "E", "D"];
/// The slip velocity of a contact.
const SLIP: &str = "v";
/// The coefficient of friction of a contact.
const COEFFICIENT: &str = "mu";
/// What the names of drives on conditions begin with.
pub(super) const DRIVE: &str = "drive";
const OF_CONTACTS: [&str; 6] = ["N", "R", "ratio", SLIP, COEFFICIENT, "gap"];

/// A rate as a function: `rate(phi)` is `phi'`.
pub(super) const RATE: &str = "rate";

/// `phi'` for `rate(phi)`; other names as they are.
pub fn normalize_rate(name: &str) -> Cow<'_, str> {
    let inner =
        name.strip_prefix(RATE).and_then(|rest| rest.trim_start().strip_prefix('(')?.strip_suffix(')'));
    inner.map_or(Cow::Borrowed(name), |inner| Cow::Owned(format!("{}'", inner.trim())))
}

/// What names stand for.
#[derive(Clone, Copy)]
pub(super) enum Vocabulary<'a> {
    /// What a model has.
    Model(Names),
    /// Variables by their indices.
    Variables(&'a [&'a str]),
}

impl Vocabulary<'_> {
    pub(super) const fn new(layout: &'static Layout) -> Self {
        Self::Model(Names { layout })
    }

    /// A name that stands for itself.
    pub(super) fn value(self, name: &str, primes: usize) -> Result<Expression, OutputError> {
        let variables = match self {
            Self::Model(names) => return names.value(name, primes),
            Self::Variables(variables) => variables,
        };
        let name = format!("{name}{}", "'".repeat(primes));
        match variables.iter().position(|variable| *variable == name) {
            Some(i) => Ok(Expression::Parameter(i)),
            None if name == PI => Ok(Expression::Number(core::f64::consts::PI)),
            None => Err(NameError::new("name", &name, variables.iter().copied().chain([PI])).into()),
        }
    }

    /// The model's names, for a function of them.
    pub(super) fn of_model(self, function: &str) -> Result<Names, OutputError> {
        match self {
            Self::Model(names) => Ok(names),
            Self::Variables(_) => Err(NameError::new("function", function, Function::names()).into()),
        }
    }
}

#[derive(Clone, Copy)]
pub(super) struct Names {
    layout: &'static Layout,
}

impl Names {
    /// A name that stands for itself.
    pub(super) fn value(&self, name: &str, primes: usize) -> Result<Expression, OutputError> {
        if let Some(index) = self.layout.coordinates.iter().position(|c| c.name == name)
            && primes <= 2
        {
            return Ok(Expression::Coordinate { index, order: primes });
        }
        if let Some(angle) = self.layout.dependent.iter().find(|angle| angle.name == name)
            && primes <= 2
        {
            return Ok(follow(angle, primes));
        }
        if primes == 0 {
            if let Some(index) = self.layout.parameters.iter().position(|p| *p == name) {
                return Ok(Expression::Parameter(index));
            }
            match name {
                PI => return Ok(Expression::Number(core::f64::consts::PI)),
                "t" => return Ok(Expression::Time),
                "T" => return Ok(Expression::Kinetic),
                "V" => return Ok(Expression::Potential),
                "E" => return Ok(Expression::Energy),
                "D" => return Ok(Expression::Dissipated),
                _ => {}
            }
            if let Some(entry) = self.layout.quantities.iter().position(|q| q.name == name) {
                return Ok(Expression::Quantity(entry));
            }
        }
        if POINTS.iter().any(|(word, ..)| name.strip_prefix(word).is_some_and(|of| of.starts_with('_'))) {
            return Err(OutputError::Centre { name: name.to_owned() });
        }
        let coordinates = self.layout.names_of_positions();
        let bare = self.layout.quantities.iter().filter(|q| q.function().is_none()).map(|q| q.name);
        let known = coordinates.chain(self.layout.parameters.iter().copied()).chain(bare).chain(CONSTANTS);
        let name = format!("{name}{}", "'".repeat(primes));
        Err(NameError::new("name", &name, known).into())
    }

    /// Refuses unknown functions before their arguments are read.
    pub(super) fn check_function(&self, name: &str) -> Result<(), OutputError> {
        let of_points = || POINTS.iter().map(|(name, ..)| *name).chain([SPEED]);
        let of_names = || of_points().chain(OF_CONTACTS).chain([RATE]);
        if of_names().any(|known| known == name) {
            return Ok(());
        }
        let known = of_names().chain(Function::names());
        let quantities = self.layout.quantities.iter().filter_map(Quantity::function);
        Err(NameError::new("function", name, known.chain(quantities)).into())
    }

    /// Whether quantities of the model have this name before their arguments, `fx` of `fx(D, AD)`.
    pub(super) fn is_quantity(&self, name: &str) -> bool {
        self.layout.quantities.iter().any(|q| q.function() == Some(name))
    }

    /// A quantity of the model: `fx` of `D,AD`, without spaces.
    pub(super) fn quantity(&self, function: &str, arguments: &str) -> Result<Expression, OutputError> {
        let (quantities, text) = (self.layout.quantities, format!("{function}({arguments})"));
        let found = quantities.iter().position(|q| q.name.split_whitespace().collect::<String>() == text);
        found.map(Expression::Quantity).ok_or_else(|| {
            let alike = quantities.iter().filter(|q| q.function() == Some(function));
            NameError::new("quantity", &text, alike.map(|q| q.name)).into()
        })
    }

    /// Whether drives on conditions are contacts.
    pub(super) fn has_drives(&self) -> bool {
        self.layout.contacts.iter().any(|contact| contact.kind.is_drive())
    }

    /// The name as a contact of a drive on a condition, `drive distance(A, B)`, of which the rest
    /// is given without spaces; without any that of a support.
    pub(super) fn drive(&self, of: &str) -> String {
        let written = format!("{DRIVE}{of}");
        let labels = self.layout.contacts.iter().map(|contact| contact.label);
        let found = labels.into_iter().find(|label| label.split_whitespace().collect::<String>() == written);
        found.map_or(format!("{DRIVE} {of}").trim_end().to_owned(), str::to_owned)
    }

    /// A function of points or supports.
    pub(super) fn call(&self, name: &str, arguments: &[String]) -> Result<Expression, OutputError> {
        match name {
            "N" => return self.reaction(arguments),
            "R" => return self.friction(arguments),
            "ratio" => {
                let (friction, normal) = (self.friction(arguments)?, self.normal(arguments)?);
                let two_sided = self.layout.contacts[normal.contact].kind == ContactKind::Guide;
                let normal = normal.expression();
                let normal = if two_sided { Expression::apply(Function::Abs, normal) } else { normal };
                return Ok(Expression::join(Operator::Divide, friction, normal));
            }
            _ => {}
        }
        let entry = POINTS.iter().find(|(known, ..)| *known == name);
        let [argument] = arguments else {
            return Err(OutputError::Several {
                function: name.to_owned(),
                argument: if entry.is_some() || name == SPEED { "point" } else { "support" },
                first: arguments.first().cloned().unwrap_or_default(),
            });
        };
        match entry {
            Some((_, axis, order)) => {
                Ok(Expression::Point { index: self.point(argument)?, axis: *axis, order: *order })
            }
            None if name == SPEED => self.point(argument).map(Expression::speed),
            None if name == SLIP => self.of_friction(argument).map(Expression::Slip),
            None if name == COEFFICIENT => self.of_friction(argument).map(Expression::Coefficient),
            None => Ok(Expression::Gap(self.contact(argument)?.0)),
        }
    }

    fn point(&self, name: &str) -> Result<usize, OutputError> {
        let points = self.layout.points;
        let found = points.iter().position(|p| *p == name);
        if found.is_none() && ["G", "S", "CG", "CM", "COM"].contains(&name) {
            return Err(OutputError::Centre { name: name.to_owned() });
        }
        found.ok_or_else(|| NameError::new("point", name, points.iter().copied()).into())
    }

    fn contact(&self, support: &str) -> Result<(usize, &'static Contact), OutputError> {
        contact_of(self.layout, support).ok_or_else(|| unknown_support(self.layout, support).into())
    }

    /// The entry of the layout's frictions that a support belongs to.
    fn of_friction(&self, support: &str) -> Result<usize, OutputError> {
        let (_, contact) = self.contact(support)?;
        let label = || contact.label.to_owned();
        match contact.friction {
            Some(entry) => Ok(entry),
            None if contact.rough => Err(OutputError::Rough { contact: label() }),
            None => Err(OutputError::Smooth { contact: label() }),
        }
    }

    /// The friction force of a support that has friction or is rough, or of all supports of one
    /// contact.
    fn friction(&self, supports: &[String]) -> Result<Expression, OutputError> {
        let Share { contact, share } = self.normal(supports)?;
        let layout = &self.layout.contacts[contact];
        if layout.has_friction_force() {
            Ok(Expression::Friction { contact, share })
        } else {
            Err(OutputError::Smooth { contact: layout.label.to_owned() })
        }
    }

    /// The reaction of a support, or the magnitude of the force of a joint.
    fn reaction(&self, arguments: &[String]) -> Result<Expression, OutputError> {
        let [x, y] = ["fx", "fy"].map(|axis| self.quantity(axis, &arguments.join(",")));
        match (self.normal(arguments), x, y) {
            (Err(_), Ok(x), Ok(y)) => Ok(Expression::magnitude([x, y])),
            (normal, ..) => normal.map(Share::expression),
        }
    }

    /// One support's share, or all supports of one contact.
    fn normal(&self, supports: &[String]) -> Result<Share, OutputError> {
        let Some(first) = supports.first() else {
            return Err(OutputError::NoContact { supports: String::new() });
        };
        let (index, contact) = self.contact(first)?;
        if let [_] = supports {
            if !contact.shared && contact.supports.len() > 1 {
                return Err(OutputError::NotShared { contact: contact.label.to_owned() });
            }
            return Ok(Share { contact: index, share: contact.supports.len() as f64 });
        }
        for support in supports {
            self.contact(support)?;
        }
        let whole = contact.supports.len() == supports.len()
            && contact.supports.iter().all(|member| supports.iter().any(|s| s == member));
        if whole {
            Ok(Share { contact: index, share: 1.0 })
        } else {
            Err(OutputError::NoContact { supports: supports.join(", ") })
        }
    }
}

/// A derivative of an angle by those of what it follows.
fn follow(angle: &DependentAngle, order: usize) -> Expression {
    let product = |term: &Term, value| {
        Expression::join(Operator::Multiply, Expression::Number(term.factor.into()), value)
    };
    let coordinates = angle
        .coordinates
        .iter()
        .map(|term| product(term, Expression::Coordinate { index: term.index, order }));
    let parameters = angle.parameters.iter().map(|term| product(term, Expression::Parameter(term.index)));
    let fixed = parameters.filter(|_| order == 0);
    let turned = Expression::Number(if order == 0 { f64::from(angle.quarters) * FRAC_PI_2 } else { 0.0 });
    coordinates.chain(fixed).fold(turned, |sum, term| Expression::join(Operator::Add, sum, term))
}

/// A contact, and among how many its reaction is shared.
struct Share {
    contact: usize,
    share: f64,
}

impl Share {
    fn expression(self) -> Expression {
        Expression::Reaction { contact: self.contact, share: self.share }
    }
}

/// The contact that a support belongs to.
pub fn contact_of(layout: &'static Layout, support: &str) -> Option<(usize, &'static Contact)> {
    layout.contacts.iter().enumerate().find(|(_, contact)| contact.supports.contains(&support))
}

/// The contacts that these supports belong to.
///
/// # Errors
/// A support has another name.
pub fn contact_set(layout: &'static Layout, supports: &[&str]) -> Result<ContactSet, NameError> {
    supports.iter().try_fold(ContactSet::EMPTY, |set, support| {
        let (contact, _) = contact_of(layout, support).ok_or_else(|| unknown_support(layout, support))?;
        Ok(set.with(contact))
    })
}

/// The error for a support that is not there.
pub fn unknown_support(layout: &'static Layout, support: &str) -> NameError {
    NameError::new("support", support, layout.contacts.iter().flat_map(|c| c.supports.iter().copied()))
}
