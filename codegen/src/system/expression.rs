//! Parameter expressions: numbers, parameters and named constants under + − · /, `sqrt`, `sin`,
//! `cos`, whole powers. Every mistake in an expression is told.

use quote::ToTokens;
use syn::{BinOp, Expr, ExprCall, ExprMethodCall, Lit, UnOp};

use super::literal;
use super::scope::Scope;
use crate::algebra::{Angle, Series, work};
use crate::limits;
use crate::syntax::{self, nearest};

const FORMS: &str =
    "expected a number, a parameter, `pi`, + − * /, `sqrt(…)`, `sin(…)`, `cos(…)`, `abs(…)` or `.powi(n)`";

const FUNCTIONS: [&str; 4] = ["sqrt", "sin", "cos", "abs"];

pub(super) const POWER: &str = "a power is written `l.powi(2)`";

impl Scope<'_> {
    /// The value of an expression.
    pub fn value(&mut self, expr: &Expr) -> syn::Result<Series> {
        let value = self.computed(expr);
        if work::is_spent() {
            return Err(syn::Error::new_spanned(expr, limits::TOO_MUCH));
        }
        let value = value?;
        let text = "the exact value overflows 128-bit fractions; write long decimals as parameters";
        match value.is_overflow() {
            true => Err(syn::Error::new_spanned(expr, text)),
            false => Ok(value),
        }
    }

    fn computed(&mut self, expr: &Expr) -> syn::Result<Series> {
        match expr {
            Expr::Lit(number) => literal::exact(&number.lit).map(|value| self.constants.number(value)),
            Expr::Paren(inner) => self.value(&inner.expr),
            Expr::Group(inner) => self.value(&inner.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => self.value(&unary.expr).map(|v| -v),
            // `l ** 2` is l times what 2 points to.
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => {
                Err(syn::Error::new_spanned(unary, POWER))
            }
            Expr::Binary(binary) => self.binary(&binary.left, &binary.op, &binary.right),
            Expr::Path(path) => match path.path.get_ident() {
                Some(name) => self.named(name),
                None => Err(self.refuse(path, path, FORMS)),
            },
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            other => Err(self.refuse(other, other, FORMS)),
        }
    }

    /// The value of an expression as an angle.
    pub fn angle(&mut self, expr: &Expr) -> syn::Result<Angle> {
        self.value(expr).map(|value| self.constants.angle(&value))
    }

    /// The values of a position.
    pub fn position(&mut self, [x, y]: &syntax::Pair) -> syn::Result<[Series; 2]> {
        both(self.value(x), self.value(y)).map(|(x, y)| [x, y])
    }

    fn binary(&mut self, left: &Expr, op: &BinOp, right: &Expr) -> syn::Result<Series> {
        let (a, b) = both(self.value(left), self.value(right))?;
        match op {
            BinOp::Add(_) => Ok(&a + &b),
            BinOp::Sub(_) => Ok(&a - &b),
            BinOp::Mul(_) => Ok(self.constants.multiply(&a, &b)),
            BinOp::Div(_) => {
                let zero = || syn::Error::new_spanned(right, "division by zero");
                self.constants.divide(&a, &b).ok_or_else(zero)
            }
            BinOp::BitXor(_) => Err(syn::Error::new_spanned(op, POWER)),
            other => Err(syn::Error::new_spanned(other, FORMS)),
        }
    }

    fn call(&mut self, call: &ExprCall) -> syn::Result<Series> {
        let name = match &*call.func {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string).unwrap_or_default(),
            _ => String::new(),
        };
        match (&call.args.first(), call.args.len()) {
            (Some(argument), 1) => self.apply(&name, argument, &call.func),
            _ => Err(self.refuse(call, call, FORMS)),
        }
    }

    fn method(&mut self, call: &ExprMethodCall) -> syn::Result<Series> {
        match (call.method == "powi", call.args.first(), call.args.len()) {
            (true, Some(exponent), 1) => {
                let (base, exponent) = both(self.value(&call.receiver), whole(exponent))?;
                let zero = || syn::Error::new_spanned(call, "division by zero");
                self.power(&base, exponent).ok_or_else(zero)
            }
            (false, None, 0) => self.apply(&call.method.to_string(), &call.receiver, &call.method),
            _ => Err(self.refuse(call, &call.method, FORMS)),
        }
    }

    fn apply(&mut self, function: &str, argument: &Expr, at: &impl ToTokens) -> syn::Result<Series> {
        match function {
            "sin" => self.angle(argument).map(|angle| Series::sin(&angle)),
            "cos" => self.angle(argument).map(|angle| Series::cos(&angle)),
            "sqrt" => {
                let value = self.value(argument)?;
                let negative = || syn::Error::new_spanned(argument, "the root of a negative number");
                self.constants.sqrt(&value).ok_or_else(negative)
            }
            "abs" => {
                let value = self.value(argument)?;
                let square = self.constants.multiply(&value, &value);
                let negative = || syn::Error::new_spanned(argument, "the root of a negative number");
                self.constants.sqrt(&square).ok_or_else(negative)
            }
            _ => Err(self.refuse(argument, at, &describe_function(function, &FUNCTIONS, FORMS))),
        }
    }

    fn refuse(&mut self, tokens: &impl ToTokens, at: &impl ToTokens, text: &str) -> syn::Error {
        self.mention(tokens);
        syn::Error::new_spanned(at, text)
    }

    /// A whole power; `None` for a division by zero.
    pub fn power(&mut self, base: &Series, exponent: i32) -> Option<Series> {
        let product =
            (0..exponent.unsigned_abs()).fold(Series::one(), |p, _| self.constants.multiply(&p, base));
        match exponent < 0 {
            true => self.constants.divide(&Series::one(), &product),
            false => Some(product),
        }
    }
}

/// What is said of a function that is none: the one that was probably meant, or all that there is.
pub(super) fn describe_function(name: &str, known: &[&str], forms: &str) -> String {
    match nearest(name, known).filter(|near| *near != name) {
        Some(near) => format!("there is no function `{name}`; did you mean `{near}`?"),
        None => forms.to_owned(),
    }
}

/// The exponent of `.powi(n)`.
pub(crate) fn whole(exponent: &Expr) -> syn::Result<i32> {
    let (negative, digits) = match exponent {
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => (true, &*unary.expr),
        other => (false, other),
    };
    let value = match digits {
        Expr::Lit(number) => match &number.lit {
            Lit::Int(int) => int.base10_parse::<i32>().ok().filter(|n| *n <= 64),
            _ => None,
        },
        _ => None,
    };
    let wrong = || syn::Error::new_spanned(exponent, "expected a whole number between −64 and 64");
    value.map(|n| if negative { -n } else { n }).ok_or_else(wrong)
}

/// Both values, or all that is wrong.
fn both<A, B>(a: syn::Result<A>, b: syn::Result<B>) -> syn::Result<(A, B)> {
    match (a, b) {
        (Ok(a), Ok(b)) => Ok((a, b)),
        (Err(mut a), Err(b)) => {
            a.combine(b);
            Err(a)
        }
        (Err(error), _) | (_, Err(error)) => Err(error),
    }
}
