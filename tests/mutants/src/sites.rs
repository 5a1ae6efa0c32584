//! Places of a file where one change makes a mutant.

use std::ops::Range;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, Stmt, UnOp};

/// A change of one expression or statement: the bytes `cut` of `range` become `to`.
#[derive(Clone, Debug)]
pub struct Site {
    /// The expression or statement.
    pub range: Range<usize>,
    /// What of it is replaced.
    pub cut: Range<usize>,
    /// By what.
    pub to: &'static str,
    /// Its line in the file.
    pub line: usize,
    /// A statement is removed with its semicolon; an expression keeps a value.
    pub statement: bool,
}

/// All sites of a file, outermost first; none in constants, patterns, types, macros and tests.
///
/// # Errors
/// The file does not parse.
pub fn sites(text: &str) -> syn::Result<Vec<Site>> {
    let mut found = Finder(Vec::new());
    found.visit_file(&syn::parse_file(text)?);
    found.0.sort_by_key(|site| (site.range.start, std::cmp::Reverse(site.range.end)));
    Ok(found.0)
}

struct Finder(Vec<Site>);

impl Finder {
    fn push(&mut self, whole: &impl Spanned, cut: Range<usize>, to: &'static str, statement: bool) {
        let span = whole.span();
        self.0.push(Site { range: span.byte_range(), cut, to, line: span.start().line, statement });
    }
}

fn swapped(op: &BinOp) -> Option<&'static str> {
    Some(match op {
        BinOp::Add(_) => "-",
        BinOp::Sub(_) => "+",
        BinOp::Mul(_) => "/",
        BinOp::Div(_) => "*",
        BinOp::Lt(_) => "<=",
        BinOp::Le(_) => "<",
        BinOp::Gt(_) => ">=",
        BinOp::Ge(_) => ">",
        BinOp::Eq(_) => "!=",
        BinOp::Ne(_) => "==",
        BinOp::And(_) => "||",
        BinOp::Or(_) => "&&",
        _ => return None,
    })
}

fn is_assignment(op: &BinOp) -> bool {
    matches!(op, BinOp::AddAssign(_) | BinOp::SubAssign(_) | BinOp::MulAssign(_) | BinOp::DivAssign(_))
        || matches!(op, BinOp::BitAndAssign(_) | BinOp::BitOrAssign(_) | BinOp::BitXorAssign(_))
        || matches!(op, BinOp::RemAssign(_) | BinOp::ShlAssign(_) | BinOp::ShrAssign(_))
}

/// A chain of conditions that binds names.
fn binds(expr: &Expr) -> bool {
    match expr {
        Expr::Let(_) => true,
        Expr::Binary(binary) => binds(&binary.left) || binds(&binary.right),
        _ => false,
    }
}

fn of_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let path = attribute.path();
        path.is_ident("test")
            || path.is_ident("cfg")
                && attribute.parse_args::<syn::Path>().is_ok_and(|path| path.is_ident("test"))
    })
}

impl<'a> Visit<'a> for Finder {
    fn visit_expr_binary(&mut self, binary: &'a syn::ExprBinary) {
        if let Some(to) = swapped(&binary.op).filter(|_| !binds(&binary.left) && !binds(&binary.right)) {
            self.push(binary, binary.op.span().byte_range(), to, false);
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_unary(&mut self, unary: &'a syn::ExprUnary) {
        if matches!(unary.op, UnOp::Not(_) | UnOp::Neg(_)) {
            self.push(unary, unary.op.span().byte_range(), "", false);
        }
        visit::visit_expr_unary(self, unary);
    }

    fn visit_stmt(&mut self, statement: &'a Stmt) {
        let removable = match statement {
            Stmt::Expr(Expr::MethodCall(_), Some(_)) => true,
            Stmt::Expr(Expr::Binary(binary), Some(_)) => is_assignment(&binary.op),
            _ => false,
        };
        if removable {
            self.push(statement, statement.span().byte_range(), "", true);
        }
        visit::visit_stmt(self, statement);
    }

    fn visit_item_fn(&mut self, item: &'a syn::ItemFn) {
        if item.sig.constness.is_none() && !of_tests(&item.attrs) {
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'a syn::ImplItemFn) {
        if item.sig.constness.is_none() && !of_tests(&item.attrs) {
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_item_mod(&mut self, item: &'a syn::ItemMod) {
        if !of_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_impl(&mut self, item: &'a syn::ItemImpl) {
        if !of_tests(&item.attrs) {
            visit::visit_item_impl(self, item);
        }
    }

    fn visit_expr_repeat(&mut self, repeat: &'a syn::ExprRepeat) {
        self.visit_expr(&repeat.expr);
    }

    fn visit_item_const(&mut self, _: &'a syn::ItemConst) {}
    fn visit_item_static(&mut self, _: &'a syn::ItemStatic) {}
    fn visit_impl_item_const(&mut self, _: &'a syn::ImplItemConst) {}
    fn visit_trait_item_const(&mut self, _: &'a syn::TraitItemConst) {}
    fn visit_expr_const(&mut self, _: &'a syn::ExprConst) {}
    fn visit_pat(&mut self, _: &'a syn::Pat) {}
    fn visit_type(&mut self, _: &'a syn::Type) {}
    fn visit_path(&mut self, _: &'a syn::Path) {}
    fn visit_attribute(&mut self, _: &'a syn::Attribute) {}
}
