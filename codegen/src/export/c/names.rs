//! Identifiers of a model in C.

use std::collections::BTreeMap;

use crate::Analysis;
use crate::algebra::Symbol;
use crate::export::identifiers::Identifiers;
use crate::syntax::plain;

/// Words of C and C++, and macros of the headers: no names of a model.
const WORDS: &str = "alignas alignof and asm auto bitand bitor bool break case catch char class compl complex concept const \
     consteval constexpr constinit continue co_await co_return co_yield decltype default delete do double else enum \
     explicit export extern false float for friend goto if imaginary inline int long mutable namespace new noexcept \
     not nullptr operator or private protected public register reinterpret_cast requires restrict return short \
     signed sizeof static static_assert static_cast struct switch template this thread_local throw true try typedef \
     typeid typename typeof union unsigned using virtual void volatile wchar_t while xor errno NULL EOF NAN \
     INFINITY I M_PI linux unix main";
/// What functions take, call and declare: no names in them.
const LOCAL: &str = "sqrt sin cos fabs fmax k p e state senses out rates acceleration multiplier reach moment own solve holds \
     slip_of contact_of";

/// Identifiers of a model.
pub(super) struct CNames {
    /// What every name of the library begins with.
    pub prefix: String,
    /// The same of numbers.
    pub capital: String,
    /// Fields of the parameters.
    pub parameters: Vec<String>,
    /// What inputs of functions of a state are called there.
    pub inputs: BTreeMap<Symbol, String>,
}

impl CNames {
    pub fn from_analysis(analysis: &Analysis) -> Self {
        let system = &analysis.system;
        let prefix = Identifiers::new(WORDS.split(' ')).make_unique(&snake(&plain(&system.ident)));
        let mut fields = Self::fields();
        let parameters = system.parameters.iter().map(|name| fields.make_unique(&plain(name))).collect();
        let mut given = Identifiers::new(WORDS.split(' ').chain(LOCAL.split(' ')));
        let mut inputs = BTreeMap::new();
        for (order, suffix) in [(0, ""), (1, "_d"), (2, "_dd")] {
            for (i, coordinate) in analysis.kinematics.coordinates.iter().enumerate() {
                let name = given.make_unique(&format!("{}{suffix}", coordinate.name));
                inputs.insert(Symbol::Coordinate { index: i as u16, order }, name);
            }
        }
        for row in 0..analysis.motion.rows.len() {
            inputs.insert(Symbol::reaction(row), format!("multiplier[{row}]"));
        }
        for symbol in analysis.motion.carried() {
            let name = match symbol {
                Symbol::Switch(i) => format!("switch_{}", i + 1),
                _ => "t".to_owned(),
            };
            inputs.insert(symbol, given.make_unique(&name));
        }
        Self { capital: prefix.to_uppercase(), prefix, parameters, inputs }
    }

    /// Identifiers of fields.
    pub fn fields() -> Identifiers {
        Identifiers::new(WORDS.split(' '))
    }

    /// Identifiers of a function that reads a state.
    pub fn identifiers(&self) -> Identifiers {
        let inputs = self.inputs.values().map(String::as_str);
        Identifiers::new(WORDS.split(' ').chain(LOCAL.split(' ')).chain(inputs))
    }
}

/// `falling_pair` of `FallingPair`.
fn snake(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !snake.is_empty() && !snake.ends_with('_') {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}
