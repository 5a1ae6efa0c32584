//! A parameter expression with its text and its values, worked out side by side.

/// How tightly the text binds: what has to stand in parentheses in a product or before a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

/// An expression of a declaration.
#[derive(Clone, Debug)]
pub struct Quantity {
    text: String,
    binding: Binding,
    /// Its value with the drawn parameters.
    pub value: f64,
    /// Its value with all parameters 1, as the nominal figure takes it.
    pub nominal: f64,
}

impl Quantity {
    fn new(text: String, binding: Binding, value: f64, nominal: f64) -> Self {
        Self { text, binding, value, nominal }
    }

    /// A decimal with two places, or a whole number where it is one.
    pub fn literal(hundredths: i32) -> Self {
        let value = f64::from(hundredths) / 100.0;
        let digits = match hundredths % 100 {
            0 => format!("{}", hundredths.abs() / 100),
            _ => format!("{:.2}", value.abs()),
        };
        let positive = Self::new(digits, Binding::Atom, value.abs(), value.abs());
        if hundredths < 0 { positive.negated() } else { positive }
    }

    /// A parameter or a named constant.
    pub fn named(name: &str, value: f64, nominal: f64) -> Self {
        Self::new(name.into(), Binding::Atom, value, nominal)
    }

    /// Its text.
    pub fn text(&self) -> &str {
        &self.text
    }

    fn within(&self, binding: Binding) -> String {
        if self.binding >= binding { self.text.clone() } else { format!("({})", self.text) }
    }

    /// −a.
    pub fn negated(&self) -> Self {
        let text = format!("-{}", self.within(Binding::Atom));
        Self::new(text, Binding::Sum, -self.value, -self.nominal)
    }

    /// a + b.
    pub fn plus(&self, other: &Self) -> Self {
        let text = format!("{} + {}", self.text, other.within(Binding::Product));
        let (value, nominal) = (self.value + other.value, self.nominal + other.nominal);
        Self::new(text, Binding::Sum, value, nominal)
    }

    /// a − b.
    pub fn minus(&self, other: &Self) -> Self {
        let text = format!("{} - {}", self.text, other.within(Binding::Product));
        let (value, nominal) = (self.value - other.value, self.nominal - other.nominal);
        Self::new(text, Binding::Sum, value, nominal)
    }

    /// a · b.
    pub fn times(&self, other: &Self) -> Self {
        let text = format!("{} * {}", self.within(Binding::Product), other.within(Binding::Atom));
        let (value, nominal) = (self.value * other.value, self.nominal * other.nominal);
        Self::new(text, Binding::Product, value, nominal)
    }

    /// a / b.
    pub fn over(&self, other: &Self) -> Self {
        let text = format!("{} / {}", self.within(Binding::Product), other.within(Binding::Atom));
        let (value, nominal) = (self.value / other.value, self.nominal / other.nominal);
        Self::new(text, Binding::Product, value, nominal)
    }

    /// a p/q for positive p and q, as simply as it can be written.
    pub fn scaled(&self, p: i32, q: i32) -> Self {
        match (p, q) {
            _ if self.is_zero() => self.clone(),
            (1, 1) => self.clone(),
            (1, _) => self.over(&Self::literal(100 * q)),
            (_, 1) => Self::literal(100 * p).times(self),
            _ => Self::literal(100 * p).times(self).over(&Self::literal(100 * q)),
        }
    }

    /// a², as `a.powi(2)`.
    pub fn squared(&self) -> Self {
        let text = format!("{}.powi(2)", self.within(Binding::Atom));
        Self::new(text, Binding::Atom, self.value.powi(2), self.nominal.powi(2))
    }

    /// A function of one argument.
    pub fn under(&self, name: &str, function: fn(f64) -> f64) -> Self {
        let text = format!("{name}({})", self.text);
        Self::new(text, Binding::Atom, function(self.value), function(self.nominal))
    }

    /// Whether it is written as 0.
    pub fn is_zero(&self) -> bool {
        self.text == "0"
    }
}
