//! Python's notation.

/// Words that no identifier of the module may be: Python's, and what the module itself calls so.
pub(super) const RESERVED: [&str; 74] = [
    "False",
    "None",
    "True",
    "and",
    "as",
    "assert",
    "async",
    "await",
    "break",
    "class",
    "continue",
    "def",
    "del",
    "elif",
    "else",
    "except",
    "finally",
    "for",
    "from",
    "global",
    "if",
    "import",
    "in",
    "is",
    "lambda",
    "nonlocal",
    "not",
    "or",
    "pass",
    "raise",
    "return",
    "try",
    "while",
    "with",
    "yield",
    "bool",
    "float",
    "int",
    "len",
    "list",
    "range",
    "set",
    "sum",
    "tuple",
    "zip",
    "Expr",
    "Matrix",
    "NamedTuple",
    "Rational",
    "Symbol",
    "cos",
    "pi",
    "sin",
    "sqrt",
    "tan",
    "zeros",
    "ContactSet",
    "Row",
    "accelerations",
    "augmented",
    "contact_set",
    "contact_sets",
    "coordinates",
    "forces",
    "kinetic",
    "mass_matrix",
    "motion",
    "parameters",
    "points",
    "potential",
    "rates",
    "rows",
    "solve",
    "velocity_terms",
];

/// In brackets where there is a line end.
pub(super) fn bracketed(formula: &str) -> String {
    if formula.contains('\n') { format!("({formula})") } else { formula.to_owned() }
}

/// A string.
pub(super) fn string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', " "))
}

/// A tuple.
pub(super) fn tuple(items: impl IntoIterator<Item = String>) -> String {
    let items: Vec<String> = items.into_iter().collect();
    match &items[..] {
        [one] => format!("({one},)"),
        items => format!("({})", items.join(", ")),
    }
}

/// A matrix of one column; of no entries it is that, too.
pub(super) fn column(entries: impl IntoIterator<Item = String>) -> String {
    let entries: Vec<String> = entries.into_iter().collect();
    let count = entries.len();
    format!("Matrix({count}, 1, [{}])", entries.join(", "))
}

/// A matrix.
pub(super) fn matrix(rows: &[Vec<String>], columns: usize) -> String {
    let entries: Vec<&str> = rows.iter().flatten().map(String::as_str).collect();
    format!("Matrix({}, {columns}, [{}])", rows.len(), entries.join(", "))
}

/// A dictionary, a line for each entry.
pub(super) fn dictionary(entries: impl IntoIterator<Item = (String, String)>, indent: &str) -> String {
    let entry = |(key, value)| format!("{indent}    {key}: {value},\n");
    let entries: String = entries.into_iter().map(entry).collect();
    if entries.is_empty() { "{}".to_owned() } else { format!("{{\n{entries}{indent}}}") }
}
