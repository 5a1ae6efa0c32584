//! Expressions of time and motion: those of parameters, and `t`, declared coordinates and their
//! rates, positions of points and their rates, `tan`. What parameters determine is folded into one
//! series.

use quote::ToTokens;
use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprMethodCall, Ident, UnOp};

use super::bodies::Structure;
use super::expression::{POWER, describe_function, whole};
use super::scope::Scope;
use super::signals;
use super::{Declared, Formula, Function, Operator, Reading, Signal};
use crate::algebra::{Rational, Series, work};
use crate::elementary::Elementary;
use crate::limits;
use crate::spline::Table;
use crate::syntax::{plain, unknown};

const FORMS: &str = "expected a number, a parameter, `t`, a coordinate, `rate(phi)`, `x(P)`, `y(P)`, `vx(P)`, `vy(P)`, \
                     + − * /, `sqrt(…)`, `sin(…)`, `cos(…)`, `tan(…)`, `exp(…)`, `log(…)`, `tanh(…)`, \
                     `atan(…)`, `atan2(y, x)`, `abs(…)`, `sign(…)`, `min(a, b)`, `max(a, b)`, `clamp(x, low, high)`, \
                     `if(a > b, x, y)`, \
                     `table(x, [x0, x1], [y0, y1])` or `.powi(n)`";

/// Functions by the names that may be misspelt.
const FUNCTIONS: [&str; 20] = [
    "sqrt", "sin", "cos", "tan", "exp", "log", "tanh", "atan", "atan2", "abs", "sign", "min", "max", "clamp",
    "if", "table", "rate", "vx", "vy", "powi",
];

/// A table has no more places: each is a kink that steps are looked through for.
const MOST_PLACES: usize = 512;

/// What is said of a function that jumps where none may.
const JUMPS: &str = "`if`, `sign` and `atan2` jump, which";

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
    /// The same without jumps.
    Smooth(&'static str),
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
        let formula = FormulaReader { scope, readable: self, reads: Reads::Smooth(why) }.parse(expr)?;
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
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => {
                self.scope.report.over(unary, POWER);
                return None;
            }
            Expr::Binary(binary) => {
                let (left, right) = (self.parse(&binary.left), self.parse(&binary.right));
                let Some(operator) = operator(&binary.op) else {
                    let is_power = matches!(binary.op, BinOp::BitXor(_));
                    self.scope.report.over(&binary.op, if is_power { POWER } else { FORMS });
                    return None;
                };
                self.join(operator, left?, right?, &binary.right)
            }
            Expr::Path(path) => match path.path.get_ident() {
                Some(name) => self.name(name),
                None => self.refuse(expr, expr, FORMS),
            },
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            other => self.refuse(other, other, FORMS),
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
            Reads::Time(why) | Reads::Smooth(why) => why,
            Reads::Slip => {
                "friction may depend on parameters and on the slip velocity `v`, on no other motion"
            }
        };
        self.scope.report.over(at, text);
        None
    }

    fn call(&mut self, call: &ExprCall) -> Option<Formula> {
        let name = match &*call.func {
            Expr::Path(path) => path.path.get_ident().map(plain).unwrap_or_default(),
            _ => String::new(),
        };
        let count = match name.as_str() {
            "min" | "max" | "atan2" => 2,
            "clamp" | "if" | "table" => 3,
            _ => 1,
        };
        let Some(argument) = call.args.first().filter(|_| call.args.len() == count) else {
            if count > 1 {
                self.scope.mention(call);
                self.scope.report.over(call, format!("`{name}` takes {count} arguments"));
                return None;
            }
            return self.refuse(call, call, &describe_function(&name, &FUNCTIONS, FORMS));
        };
        match name.as_str() {
            "if" => return self.choice(call),
            "atan2" => return self.direction(call),
            "table" => return self.table(call),
            "sign" => return self.sign(argument, call),
            _ if count > 1 => return self.bounded(&name, call),
            _ => {}
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
            _ => self.refuse(call, &call.method, FORMS),
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
                None => {
                    let text = describe_function(name, &FUNCTIONS, FORMS);
                    return self.refuse(argument, at, &text);
                }
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

    /// `if(a > b, x, y)`: s x + (1 − s) y, s the switch of the condition.
    fn choice(&mut self, call: &ExprCall) -> Option<Formula> {
        self.may_jump(call)?;
        let condition = self.condition(&call.args[0]);
        let [x, y] = [1, 2].map(|i| self.parse(&call.args[i]));
        let (condition, x, y) = (condition?, x?, y?);
        let switch = self.switch("if", &condition);
        let one = Formula::Constant(Series::one());
        let other = self.join(Operator::Subtract, one, switch.clone(), call)?;
        let parts = [(switch, x), (other, y)].map(|(factor, value)| match value.is_zero() {
            true => Some(value),
            false => self.join(Operator::Multiply, factor, value, call),
        });
        let [x, y] = parts;
        match (x?, y?) {
            (x, y) if y.is_zero() => Some(x),
            (x, y) if x.is_zero() => Some(y),
            (x, y) => self.join(Operator::Add, x, y, call),
        }
    }

    /// `sign(x)`: s − r, s the switch of x > 0, r that of x < 0.
    fn sign(&mut self, argument: &Expr, call: &ExprCall) -> Option<Formula> {
        self.may_jump(call)?;
        let [above, below] = [self.comparison(argument, '>', None)?, self.comparison(argument, '<', None)?];
        let [above, below] = [above, below].map(|condition| self.switch("sign", &condition));
        self.join(Operator::Subtract, above, below, call)
    }

    /// `atan2(y, x)`, of (x, y) turned by α back to a half plane around the first axis:
    /// α − (1 − s) π + 2 atan (v/(u + |(u, v)|)), u = ± (x cos α + y sin α),
    /// v = ± (y cos α − x sin α), with + and s = 1 but in the eighth below the cut, y < 0 and x < y.
    /// That eighth ends at a ray where little can rest; tan α/2 = ⅕.
    fn direction(&mut self, call: &ExprCall) -> Option<Formula> {
        self.may_jump(call)?;
        let (y, x) = (self.parse(&call.args[0]), self.parse(&call.args[1]));
        let (y, x) = (y?, x?);
        let [v, u] = [&call.args[0], &call.args[1]].map(|expr| self.text(expr));
        let Some((v, u)) = v.zip(u) else {
            self.scope.report.over(call, "`atan2` is of no table");
            return None;
        };
        if let (Formula::Constant(_), Formula::Constant(_)) = (&y, &x) {
            let text = "`atan2` of what does not vary; write `atan(y / x)`";
            self.scope.report.over(call, text);
            return None;
        }
        let s = self.switch("atan2", &format!("max({v}, {u} - {v}) > 0"));
        let number = |n: i64| Formula::Constant(Series::integer(n));
        let pi = Formula::Constant(Series::symbol(self.scope.constants.pi()));
        let mut join = |operator, a: &Formula, b: &Formula| self.join(operator, a.clone(), b.clone(), call);
        let twice = join(Operator::Multiply, &number(2), &s)?;
        let side = join(Operator::Subtract, &twice, &number(1))?;
        let mut turned = |[a, b]: [i64; 2]| {
            let (along, across) =
                (join(Operator::Multiply, &number(a), &x)?, join(Operator::Multiply, &number(b), &y)?);
            let sum = join(Operator::Add, &along, &across)?;
            join(Operator::Multiply, &side, &sum)
        };
        let (u, v) = (turned([12, 5])?, turned([-5, 12])?);
        let [x, y] = [x, y].map(|part| self.apply(Function::Power(2), part, call));
        let square = self.join(Operator::Add, x?, y?, call)?;
        let length = self.apply(Function::Sqrt, square, call)?;
        let length = self.join(Operator::Multiply, number(13), length, call)?;
        let below = self.join(Operator::Add, u, length, call)?;
        let half = self.join(Operator::Divide, v, below, call)?;
        let fifth = Formula::Constant(Series::constant(Rational::new(1, 5)));
        let angles = [half, fifth].map(|tangent| {
            let angle = self.apply(Function::Elementary(Elementary::Atan), tangent, call)?;
            self.join(Operator::Multiply, number(2), angle, call)
        });
        let [angle, turn] = angles;
        let whole = self.join(Operator::Add, angle?, turn?, call)?;
        let off = self.join(Operator::Subtract, s, number(1), call)?;
        let off = self.join(Operator::Multiply, pi, off, call)?;
        self.join(Operator::Add, whole, off, call)
    }

    /// `table(x, [x0, x1], [y0, y1])`.
    fn table(&mut self, call: &ExprCall) -> Option<Formula> {
        let x = self.parse(&call.args[0]);
        if let Reads::Smooth(_) | Reads::Slip = self.reads {
            let text =
                "a table is for loads: beyond its ends it is constant, where a drive would have a kink";
            self.scope.report.over(call, text);
            return None;
        }
        let places = self.numbers(&call.args[1])?;
        let values = self.numbers(&call.args[2])?;
        let text = if places.len() != values.len() {
            format!("a table has as many values as places; {} and {}", values.len(), places.len())
        } else if !(2..=MOST_PLACES).contains(&values.len()) {
            format!("a table has from 2 to {MOST_PLACES} values")
        } else if let Some(pair) = places.windows(2).find(|pair| pair[1] <= pair[0]) {
            format!("the places of a table rise; {} follows {}", pair[1].to_f64(), pair[0].to_f64())
        } else {
            let values: Vec<f64> = values.into_iter().map(Rational::to_f64).collect();
            let table = Elementary::Table(Table::new(places, &values));
            return self.apply(Function::Elementary(table), x?, call);
        };
        self.scope.report.over(&call.args[1], text);
        None
    }

    /// `[0, 1.5, 2]`.
    fn numbers(&mut self, list: &Expr) -> Option<Vec<Rational>> {
        let Expr::Array(list) = list else {
            self.scope.mention(list);
            let text = "a list of numbers: `table(x, [0, 1, 2], [3, 5, 4])`";
            self.scope.report.over(list, text);
            return None;
        };
        let numbers = list.elems.iter().map(|element| {
            let value = self.scope.number(element)?.as_constant();
            if value.is_none() {
                let text = "a table has numbers; write a parameter as a factor beside it";
                self.scope.report.over(element, text);
            }
            value
        });
        numbers.collect::<Vec<_>>().into_iter().collect()
    }

    /// Refuses what jumps where nothing may.
    fn may_jump(&mut self, call: &ExprCall) -> Option<()> {
        let why = match self.reads {
            Reads::Motion | Reads::Time(_) => return Some(()),
            Reads::Smooth(_) => "what is prescribed must not; give a drive a condition, `while(\"…\")`",
            Reads::Slip => "a coefficient of friction must not; `tanh(v / w)` is steep and smooth",
        };
        self.scope.mention(call);
        self.scope.report.over(call, format!("{JUMPS} {why}"));
        None
    }

    /// 1 while a condition holds, else 0.
    fn switch(&mut self, name: &str, condition: &str) -> Formula {
        let label = format!("{name}({condition})").replace(", ", ",");
        Formula::Switch(self.scope.switch_on(&label, condition))
    }

    /// A condition as those of runs are written: `a > b`, with `&&` and `||` between comparisons.
    fn condition(&mut self, expr: &Expr) -> Option<String> {
        match expr {
            Expr::Paren(inner) => self.condition(&inner.expr).map(|inside| format!("({inside})")),
            Expr::Group(inner) => self.condition(&inner.expr),
            Expr::Binary(ExprBinary { left, op, right, .. }) => {
                let word = match op {
                    BinOp::And(_) => "and",
                    BinOp::Or(_) => "or",
                    BinOp::Gt(_) | BinOp::Ge(_) => return self.comparison(left, '>', Some(right)),
                    BinOp::Lt(_) | BinOp::Le(_) => return self.comparison(left, '<', Some(right)),
                    _ => return self.no_condition(expr),
                };
                let (left, right) = (self.condition(left), self.condition(right));
                Some(format!("{} {word} {}", left?, right?))
            }
            _ => self.no_condition(expr),
        }
    }

    fn no_condition(&mut self, expr: &Expr) -> Option<String> {
        self.scope.mention(expr);
        self.scope.report.over(expr, "`if` begins with a condition: `if(phi > 0, a, b)`");
        None
    }

    /// `a > b`; b is 0 where there is none.
    fn comparison(&mut self, left: &Expr, sign: char, right: Option<&Expr>) -> Option<String> {
        let reads = std::mem::replace(&mut self.reads, Reads::Motion);
        let (a, b) = (self.parse(left), right.map(|right| self.parse(right)));
        self.reads = reads;
        let (a, b) = (a?, b.unwrap_or(Some(Formula::Constant(Series::zero())))?);
        let text = match (&a, &b) {
            (Formula::Constant(_), Formula::Constant(_)) => "a condition depends on time or motion",
            _ if a.jumps() || b.jumps() => "what a condition compares must not jump",
            _ => {
                let below = right.map_or(Some("0".to_owned()), |right| self.text(right));
                match self.text(left).zip(below) {
                    Some((above, below)) => return Some(format!("{above} {sign} {below}")),
                    None => "a condition compares no table",
                }
            }
        };
        self.scope.report.over(left, text);
        None
    }

    /// An expression as conditions of runs are written.
    fn text(&mut self, expr: &Expr) -> Option<String> {
        signals::text(&self.scope.description.constants, expr)
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

    fn refuse(&mut self, tokens: &impl ToTokens, at: &impl ToTokens, text: &str) -> Option<Formula> {
        self.scope.mention(tokens);
        self.scope.report.over(at, text);
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
