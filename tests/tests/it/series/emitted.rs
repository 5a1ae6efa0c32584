//! Emitted Rust evaluated as it stands, in jets: every order of a series at once.

use std::collections::BTreeMap;

use liftoff_core::scalar::{Jet, Real};
use proc_macro2::TokenStream;
use syn::{BinOp, Block, Expr, ExprCall, ExprMethodCall, Item, Lit, Member, Pat, Stmt, UnOp};

/// Coefficients that are compared.
pub const K: usize = 6;

pub type Series = Jet<f64, K>;

/// Variables by name.
pub type Variables = BTreeMap<String, Value>;

/// What an expression gives.
#[derive(Clone, Debug)]
pub enum Value {
    One(Series),
    Many(Vec<Value>),
    Fields(Variables),
}

impl Value {
    /// Several numbers.
    pub fn array(series: impl IntoIterator<Item = Series>) -> Self {
        Self::Many(series.into_iter().map(Self::One).collect())
    }

    pub fn one(&self) -> Series {
        let Self::One(series) = self else { panic!("one value, not {self:?}") };
        *series
    }

    pub fn many(&self) -> &[Self] {
        let Self::Many(values) = self else { panic!("several values, not {self:?}") };
        values
    }

    pub fn field(&self, name: &str) -> &Self {
        let Self::Fields(fields) = self else { panic!("fields, not {self:?}") };
        fields.get(name).unwrap_or_else(|| panic!("no field {name}"))
    }
}

/// The items within the inner block of `const _: () = { …; { … } };`.
pub fn items(code: TokenStream) -> Vec<Item> {
    let file: syn::File = syn::parse2(code).expect("emitted code is Rust");
    let Some(Item::Const(all)) = file.items.into_iter().next() else { panic!("one constant") };
    let Expr::Block(body) = *all.expr else { panic!("a block") };
    let Some(Stmt::Expr(Expr::Block(inner), None)) = body.block.stmts.into_iter().next_back() else {
        panic!("an inner block")
    };
    let item = |statement| match statement {
        Stmt::Item(item) => Some(item),
        _ => None,
    };
    inner.block.stmts.into_iter().filter_map(item).collect()
}

/// The result of a block; what it binds stays within.
pub fn block(block: &Block, outer: &Variables) -> Value {
    let mut variables = outer.clone();
    for statement in &block.stmts {
        match statement {
            Stmt::Local(local) => {
                let bound = value(&local.init.as_ref().expect("a value").expr, &variables);
                bind(&local.pat, &bound, &mut variables);
            }
            Stmt::Expr(result, None) => return value(result, &variables),
            other => panic!("never emitted: {other:?}"),
        }
    }
    panic!("a block has a result")
}

/// Binds names to values of the same shape.
fn bind(pattern: &Pat, value: &Value, variables: &mut Variables) {
    let patterns = match pattern {
        Pat::Ident(name) => {
            variables.insert(name.ident.to_string(), value.clone());
            return;
        }
        Pat::Wild(_) => return,
        Pat::Tuple(tuple) => &tuple.elems,
        Pat::Slice(slice) => &slice.elems,
        other => panic!("never emitted: {other:?}"),
    };
    assert_eq!(patterns.len(), value.many().len());
    patterns.iter().zip(value.many()).for_each(|(pattern, value)| bind(pattern, value, variables));
}

fn value(expression: &Expr, variables: &Variables) -> Value {
    let of = |inner: &Expr| value(inner, variables);
    match expression {
        Expr::Paren(inner) => of(&inner.expr),
        Expr::Group(inner) => of(&inner.expr),
        Expr::Closure(inner) => of(&inner.body),
        Expr::Block(inner) => block(&inner.block, variables),
        Expr::Tuple(list) => Value::Many(list.elems.iter().map(of).collect()),
        Expr::Array(list) => Value::Many(list.elems.iter().map(of).collect()),
        Expr::Path(path) => {
            let name = path.path.require_ident().expect("a name").to_string();
            variables.get(&name).unwrap_or_else(|| panic!("no {name}")).clone()
        }
        Expr::Field(field) => of(&field.base).field(&member(&field.member)).clone(),
        Expr::Index(at) => of(&at.expr).many()[parse_index(&at.index)].clone(),
        Expr::Struct(fields) => {
            let named = fields
                .fields
                .iter()
                .filter(|field| !matches!(field.expr, Expr::Path(ref p) if p.path.segments.len() > 1));
            Value::Fields(named.map(|field| (member(&field.member), of(&field.expr))).collect())
        }
        Expr::Unary(unary) => match unary.op {
            UnOp::Deref(_) => of(&unary.expr),
            _ => Value::One(-of(&unary.expr).one()),
        },
        Expr::Binary(binary) => {
            let (a, b) = (of(&binary.left).one(), of(&binary.right).one());
            Value::One(match binary.op {
                BinOp::Add(_) => a + b,
                BinOp::Sub(_) => a - b,
                BinOp::Mul(_) => a * b,
                _ => a / b,
            })
        }
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(digits) => Value::One(Jet::constant(digits.base10_parse().expect("a number"))),
            other => panic!("never emitted: {other:?}"),
        },
        Expr::Call(call) => function(call, variables),
        Expr::MethodCall(call) => method(call, variables),
        other => panic!("never emitted: {other:?}"),
    }
}

fn parse_index(index: &Expr) -> usize {
    let Expr::Lit(syn::ExprLit { lit: Lit::Int(digits), .. }) = index else {
        panic!("never emitted: {index:?}")
    };
    digits.base10_parse().expect("a place")
}

fn member(member: &Member) -> String {
    let Member::Named(name) = member else { panic!("fields have names") };
    name.to_string()
}

/// `S::ratio(p, q)` and the like.
fn function(call: &ExprCall, variables: &Variables) -> Value {
    let Expr::Path(path) = &*call.func else { panic!("never emitted: {call:?}") };
    let name = path.path.segments.last().expect("a name").ident.to_string();
    let arguments: Vec<Value> = call.args.iter().map(|argument| value(argument, variables)).collect();
    match (name.as_str(), &arguments[..]) {
        ("ratio", [p, q]) => Value::One(p.one() / q.one()),
        ("from_f64", [x]) => x.clone(),
        ("pi", []) => Value::One(Jet::pi()),
        ("sin_cos_each", [angles]) => {
            let pairs = angles.many().iter().map(|angle| angle.one().sin_cos());
            let (sines, cosines): (Vec<_>, Vec<_>) = pairs.unzip();
            Value::Many(vec![Value::array(sines), Value::array(cosines)])
        }
        other => panic!("never emitted: {other:?}"),
    }
}

fn method(call: &ExprMethodCall, variables: &Variables) -> Value {
    let arguments: Vec<Value> = call.args.iter().map(|argument| value(argument, variables)).collect();
    let name = call.method.to_string();
    if matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("order")) {
        return order(&name, &arguments);
    }
    let receiver = value(&call.receiver, variables).one();
    match (name.as_str(), &arguments[..]) {
        ("mul_add", [a, b]) => Value::One(receiver.mul_add(a.one(), b.one())),
        ("sqrt", []) => Value::One(receiver.sqrt()),
        ("exp", []) => Value::One(receiver.exp()),
        ("ln", []) => Value::One(receiver.ln()),
        ("tanh", []) => Value::One(receiver.tanh()),
        ("atan", []) => Value::One(receiver.atan()),
        ("sin_cos", []) => {
            let (sin, cos) = receiver.sin_cos();
            Value::array([sin, cos])
        }
        other => panic!("never emitted: {other:?}"),
    }
}

/// What `liftoff_core::series::SeriesOps` promises, of all orders together.
fn order(name: &str, arguments: &[Value]) -> Value {
    Value::One(match (name, arguments) {
        ("constant", [value]) => at_zero(value.one()),
        ("offset", [a, constant]) => a.one() + at_zero(constant.one()),
        ("product", [_, a, b]) => a.one() * b.one(),
        ("square", [_, a]) => a.one() * a.one(),
        ("quotient", [_, a, b]) => a.one() / b.one(),
        ("inverse", [_, constant, b]) => at_zero(constant.one()) / b.one(),
        ("sqrt", [_, a]) => a.one().sqrt(),
        ("exp", [_, a]) => a.one().exp(),
        ("ln", [_, a]) => a.one().ln(),
        ("tanh", [_, a]) => a.one().tanh(),
        ("atan", [_, a]) => a.one().atan(),
        ("magnitude", [_, a]) if a.one().coefficient(0) < 0.0 => -a.one(),
        ("magnitude", [_, a]) => a.one(),
        ("versed", [value, cos]) => at_zero(value.one() + cos.one()) - cos.one(),
        ("sin_cos", [_, angle, values]) => {
            let [sin, cos] = values.many() else { panic!("a sine and a cosine") };
            let (sin, cos) = (at_zero(sin.one()), at_zero(cos.one()));
            let (s, c) = (angle.one() - at_zero(angle.one())).sin_cos();
            return Value::array([sin * c + cos * s, cos * c - sin * s]);
        }
        other => panic!("never emitted: {other:?}"),
    })
}

/// The value alone.
fn at_zero(series: Series) -> Series {
    Jet::constant(series.coefficient(0))
}
