//! Expressions of time and motion: those of parameters, and `t`, declared coordinates and their
//! rates, positions of points and their rates, `tan`. What parameters determine is folded into one
//! series.

use quote::ToTokens;
use syn::{BinOp, Expr, ExprCall, ExprMethodCall, Ident, UnOp};

use super::bodies::Structure;
use super::expression::whole;
use super::scope::Scope;
use super::{Declared, Formula, Function, Operator, Reading, Signal};
use crate::algebra::{Rational, Series, work};
use crate::elementary::Elementary;
use crate::limits;
use crate::syntax::{plain, unknown};

const FORMS: &str = "expected a number, a parameter, `t`, a coordinate, `rate(phi)`, `x(P)`, `y(P)`, `vx(P)`, `vy(P)`, \
                     + − * /, `sqrt(…)`, `sin(…)`, `cos(…)`, `tan(…)`, `exp(…)`, `log(…)`, `tanh(…)`, `abs(…)`, \
                     `min(a, b)`, `max(a, b)`, `clamp(x, low, high)` or `.powi(n)`";

/// What expressions may read.
pub(super) struct Readable<'a> {
    /// Points and bodies.
    pub structure: &'a Structure,
    /// Declared coordinates.
    pub coordinates: &'a [Declared],
}

/// An expression while it is read.
struct FormulaReader<'a, 's, 'd> {
    scope: &'s mut Scope<'d>,
    readable: &'a Readable<'a>,
    reads: Reads,
}

/// What an expression may contain beside parameters.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reads {
    /// Time and motion.
    Motion,
    /// Time alone, of what is named.
    Time(&'static str),
    /// The slip velocity alone.
    Slip,
}

impl Readable<'_> {
    /// The formula of an expression, or its mistakes are kept.
    pub fn formula(&self, scope: &mut Scope, expr: &Expr) -> Option<Formula> {
        let formula = FormulaReader { scope, readable: self, reads: Reads::Motion }.parse(expr)?;
        scope.note(Signal::new(&scope.description.constants, expr, &formula, false));
        Some(formula)
    }

    /// The formula of an expression of time and parameters, or its mistakes are kept; `why` it
    /// contains no motion.
    pub fn of_time(&self, scope: &mut Scope, expr: &Expr, why: &'static str) -> Option<Formula> {
        let formula = FormulaReader { scope, readable: self, reads: Reads::Time(why) }.parse(expr)?;
        scope.note(Signal::new(&scope.description.constants, expr, &formula, false));
        Some(formula)
    }

    /// The same of a prescribed motion.
    pub fn prescribed(&self, scope: &mut Scope, expr: &Expr, why: &'static str) -> Option<Formula> {
        let formula = FormulaReader { scope, readable: self, reads: Reads::Time(why) }.parse(expr)?;
        scope.note(Signal::new(&scope.description.constants, expr, &formula, true));
        Some(formula)
    }

    /// The formula of an expression of a slip velocity `v` and parameters, or its mistakes are
    /// kept.
    pub fn of_slip(&self, scope: &mut Scope, expr: &Expr) -> Option<Formula> {
        FormulaReader { scope, readable: self, reads: Reads::Slip }.parse(expr)
    }

    /// The index of a coordinate.
    pub fn coordinate(&self, name: &Ident) -> Option<usize> {
        self.coordinates.iter().position(|other| other.name == *name)
    }

    /// The index of a coordinate; that there is none is reported.
    pub fn declared(&self, scope: &mut Scope, name: &Ident) -> Option<usize> {
        let names: Vec<String> =
            scope.description.coordinates.iter().map(|other| plain(&other.name)).collect();
        scope.find("coordinate", name, names.iter().map(String::as_str))?;
        self.coordinate(name)
    }
}

impl FormulaReader<'_, '_, '_> {
    fn parse(&mut self, expr: &Expr) -> Option<Formula> {
        let formula = match expr {
            Expr::Lit(_) => self.scope.number(expr).map(Formula::Constant),
            Expr::Paren(inner) => self.parse(&inner.expr),
            Expr::Group(inner) => self.parse(&inner.expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                let inner = self.parse(&unary.expr)?;
                self.apply(Function::Negate, inner, expr)
            }
            Expr::Binary(binary) => {
                let (left, right) = (self.parse(&binary.left), self.parse(&binary.right));
                let Some(operator) = operator(&binary.op) else {
                    self.scope.report.over(&binary.op, FORMS);
                    return None;
                };
                self.join(operator, left?, right?, &binary.right)
            }
            Expr::Path(path) => match path.path.get_ident() {
                Some(name) => self.name(name),
                None => self.refuse(expr, expr),
            },
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            other => self.refuse(other, other),
        }?;
        if work::is_spent() {
            self.scope.report.over(expr, limits::TOO_MUCH);
            return None;
        }
        if matches!(&formula, Formula::Constant(series) if series.is_overflow()) {
            let text = "the exact value overflows 128-bit fractions; write long decimals as parameters";
            self.scope.report.over(expr, text);
            return None;
        }
        Some(formula)
    }

    fn name(&mut self, name: &Ident) -> Option<Formula> {
        if name == "t" && self.reads != Reads::Slip {
            return Some(Formula::Time);
        }
        if name == "v" && self.reads == Reads::Slip {
            if self.scope.knows(name) {
                let text = "`v` is the slip velocity in a friction; give the parameter another name";
                self.scope.report.add_message(name.span(), text);
            }
            return Some(Formula::Slip);
        }
        let coordinates = &self.scope.description.coordinates;
        if coordinates.iter().any(|other| other.name == *name) {
            return self.coordinate(name, false);
        }
        if self.scope.knows(name) {
            let value = self.scope.named(name);
            return self.scope.report.keep(value).map(Formula::Constant);
        }
        let named: Vec<String> = coordinates.iter().map(|other| plain(&other.name)).collect();
        let known: Vec<String> = self.scope.names().into_iter().chain(named).collect();
        self.scope.mistaken(name, &known);
        if !self.scope.description.malformed.contains(&plain(name)) {
            let text = unknown("parameter or coordinate", name, known.iter().map(String::as_str));
            self.scope.report.add_message(name.span(), text);
        }
        None
    }

    fn coordinate(&mut self, name: &Ident, rate: bool) -> Option<Formula> {
        // What may not be read need not be resolved.
        let index = if self.reads == Reads::Motion { self.readable.declared(self.scope, name)? } else { 0 };
        self.motion(Reading::Coordinate(index), rate, name)
    }

    fn motion(&mut self, reading: Reading, rate: bool, at: &impl ToTokens) -> Option<Formula> {
        let text = match self.reads {
            Reads::Motion => return Some(Formula::Motion { reading, rate }),
            Reads::Time(why) => why,
            Reads::Slip => {
                "friction may depend on parameters and on the slip velocity `v`, on no other motion"
            }
        };
        self.scope.report.over(at, text);
        None
    }

    fn call(&mut self, call: &ExprCall) -> Option<Formula> {
        let name = match &*call.func {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string).unwrap_or_default(),
            _ => String::new(),
        };
        let count = match name.as_str() {
            "min" | "max" => 2,
            "clamp" => 3,
            _ => 1,
        };
        let Some(argument) = call.args.first().filter(|_| call.args.len() == count) else {
            if count > 1 {
                self.scope.mention(call);
                self.scope.report.over(call, format!("`{name}` takes {count} arguments"));
                return None;
            }
            return self.refuse(call, call);
        };
        if count > 1 {
            return self.bounded(&name, call);
        }
        let (axis, rate) = match name.as_str() {
            "rate" => {
                let name = self.plain(argument, "rate(phi)")?;
                return self.coordinate(&name, true);
            }
            "x" => (0, false),
            "y" => (1, false),
            "vx" => (0, true),
            "vy" => (1, true),
            _ => return self.function(&name, argument, call, &call.func),
        };
        let name = self.plain(argument, &format!("{name}(P)"))?;
        let point = self.readable.structure.point(self.scope, &name)?;
        self.motion(Reading::Position(point, axis), rate, call)
    }

    fn plain(&mut self, argument: &Expr, form: &str) -> Option<Ident> {
        let name = match argument {
            Expr::Path(path) => path.path.get_ident().cloned(),
            _ => None,
        };
        if name.is_none() {
            self.scope.mention(argument);
            self.scope.report.over(argument, format!("expected one name: `{form}`"));
        }
        name
    }

    fn method(&mut self, call: &ExprMethodCall) -> Option<Formula> {
        match (call.method == "powi", call.args.first(), call.args.len()) {
            (true, Some(exponent), 1) => {
                let exponent = self.scope.report.keep(whole(exponent));
                let base = self.parse(&call.receiver)?;
                self.apply(Function::Power(exponent?), base, call)
            }
            (false, None, 0) => self.function(&call.method.to_string(), &call.receiver, call, &call.method),
            _ => self.refuse(call, &call.method),
        }
    }

    fn function(
        &mut self,
        name: &str,
        argument: &Expr,
        whole: &impl ToTokens,
        at: &impl ToTokens,
    ) -> Option<Formula> {
        let function = match name {
            "sqrt" => Function::Sqrt,
            "sin" => Function::Sin,
            "cos" => Function::Cos,
            "tan" => Function::Tan,
            "abs" => {
                let argument = self.parse(argument)?;
                return self.magnitude(argument, whole);
            }
            _ => match Elementary::ALL.into_iter().find(|function| function.name() == name) {
                Some(function) => Function::Elementary(function),
                None => return self.refuse(argument, at),
            },
        };
        let argument = self.parse(argument)?;
        self.apply(function, argument, whole)
    }

    /// √(x x), whose kink is found where x changes its sign.
    fn magnitude(&mut self, x: Formula, at: &impl ToTokens) -> Option<Formula> {
        let square = self.apply(Function::Power(2), x, at)?;
        self.apply(Function::Sqrt, square, at)
    }

    /// `min(a, b)`, `max(a, b)`, and `clamp(x, low, high)`, which is `max(low, min(x, high))`.
    fn bounded(&mut self, name: &str, call: &ExprCall) -> Option<Formula> {
        let arguments: Vec<Option<Formula>> = call.args.iter().map(|argument| self.parse(argument)).collect();
        let mut arguments = arguments.into_iter().collect::<Option<Vec<_>>>()?.into_iter();
        let mut next = || arguments.next();
        match name {
            "min" => self.extreme(Operator::Subtract, next()?, next()?, call),
            "max" => self.extreme(Operator::Add, next()?, next()?, call),
            _ => {
                let (x, low, high) = (next()?, next()?, next()?);
                let below = self.extreme(Operator::Subtract, x, high, call)?;
                self.extreme(Operator::Add, low, below, call)
            }
        }
    }

    /// ½ (a + b ± |a − b|): the greatest of two with +, the least with −.
    fn extreme(&mut self, sign: Operator, a: Formula, b: Formula, at: &impl ToTokens) -> Option<Formula> {
        let sum = self.join(Operator::Add, a.clone(), b.clone(), at)?;
        let difference = self.join(Operator::Subtract, a, b, at)?;
        let distance = self.magnitude(difference, at)?;
        let twice = self.join(sign, sum, distance, at)?;
        self.join(Operator::Multiply, Formula::Constant(Series::constant(Rational::HALF)), twice, at)
    }

    fn join(&mut self, operator: Operator, a: Formula, b: Formula, at: &impl ToTokens) -> Option<Formula> {
        let joined = self.scope.joined_by(operator, a, b);
        self.kept(joined, at)
    }

    fn apply(&mut self, function: Function, argument: Formula, at: &impl ToTokens) -> Option<Formula> {
        let result = self.scope.applied(function, argument);
        self.kept(result, at)
    }

    fn kept(&mut self, result: Result<Formula, &str>, at: &impl ToTokens) -> Option<Formula> {
        result.map_err(|text| self.scope.report.over(at, text)).ok()
    }

    fn refuse(&mut self, tokens: &impl ToTokens, at: &impl ToTokens) -> Option<Formula> {
        self.scope.mention(tokens);
        self.scope.report.over(at, FORMS);
        None
    }
}

fn operator(op: &BinOp) -> Option<Operator> {
    match op {
        BinOp::Add(_) => Some(Operator::Add),
        BinOp::Sub(_) => Some(Operator::Subtract),
        BinOp::Mul(_) => Some(Operator::Multiply),
        BinOp::Div(_) => Some(Operator::Divide),
        _ => None,
    }
}
