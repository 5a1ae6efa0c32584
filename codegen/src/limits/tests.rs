//! What is read within the stack of a thread, and what is refused; each limit at its edge and far
//! beyond.

use super::{LENGTH, LEVELS};

/// An expression of so many parts.
type Form<'a> = &'a dyn Fn(usize) -> String;

/// The messages about a length, from a thread with 2 MiB of stack: the least that anything of the
/// compiler has.
fn find_mistakes(length: String) -> Vec<String> {
    let derived = move || {
        let item = format!(
            "#[bar(AB, mass = m, length = l)] #[pin(A = (0, 0))] #[figure(A = (0, 0), B = (l, 0))]
             #[gravity({length})] #[couple(AB = {length})] struct S {{ m: f64, l: f64 }}"
        );
        let errors = crate::analyse(item.parse().unwrap()).err().into_iter().flatten();
        errors.map(|error| error.to_string()).collect()
    };
    std::thread::Builder::new().stack_size(2 << 20).spawn(derived).unwrap().join().unwrap()
}

#[test]
fn deep_nesting_is_parsed_or_refused() {
    for (open, close) in [("(", ")"), ("sqrt(2+", ")"), ("-(", ")"), ("sin(l+", ")"), ("(1/(1+", "))")] {
        for levels in [LEVELS / 2 - 3, LEVELS, 200, 10_000] {
            let told = find_mistakes(format!("{}l{}", open.repeat(levels), close.repeat(levels)));
            let refused = told.iter().any(|text| text.starts_with("more than 48 nested brackets"));
            assert_eq!(refused, levels >= LEVELS, "{open} {levels}: {told:?}");
        }
    }
}

#[test]
fn long_expressions_are_parsed_or_refused() {
    let sum = |terms: usize| (1..terms).map(|k| format!("m*{k} + ")).collect::<String>() + "l";
    let root = |count: usize| "l".to_owned() + &".sqrt()".repeat(count);
    let minus = |count: usize| "- ".repeat(count) + "l";
    let forms: [(&str, Form, usize); 3] = [("+", &sum, 4), ("√", &root, 3), ("−", &minus, 1)];
    for (name, form, tokens) in forms {
        // Some tokens stand around it.
        let least = (LENGTH - 20) / tokens;
        for count in [20, least, 3 * LENGTH, 100_000] {
            let told = find_mistakes(form(count));
            let mut limits = ["this is too long", "a declaration has at most"].into_iter();
            let refused = limits.any(|limit| told.iter().any(|text| text.starts_with(limit)));
            assert_eq!(refused, count > LENGTH, "{name} {count}: {told:?}");
        }
    }
}

#[test]
fn a_long_declaration_is_no_long_expression() {
    let attributes = "#[constant(h = l + m)] ".repeat(4000);
    let many: String = (0..2000).map(|k| format!("p{k}: f64, ")).collect();
    for item in [format!("{attributes} struct S {{ m: f64 }}"), format!("struct S {{ {many} }}")] {
        assert_eq!(super::check_declaration(&item.parse().unwrap()).err().map(|e| e.to_string()), None);
    }
    let text = "#[figure(A = (0, 0))]".repeat(20_000) + "struct S;";
    let error = super::check_declaration(&text.parse().unwrap()).unwrap_err();
    assert_eq!(error.to_string(), "a declaration has at most 100000 tokens");
}

/// A file has more than its declarations.
#[test]
fn files_are_long() {
    let functions = "fn f() { let x = vec![1 2 3]; if a {} else {} }".repeat(3000);
    let table = format!("const T: [u8; 9999] = [{}];", "1, ".repeat(9999));
    let page = format!("page! {{ {} }}", "a ".repeat(5000));
    for file in [functions, table, page] {
        assert_eq!(super::check(&file.parse().unwrap()).err().map(|e| e.to_string()), None);
    }
}

/// Expressions of thousands of terms, of which products are told before they are millions.
#[test]
fn costly_declarations_are_refused() {
    let roots = (1..12).map(|i| format!("(sqrt(l+{i})+1)")).collect::<Vec<_>>().join("*");
    for length in ["(l+m+1).powi(64)".to_owned(), roots] {
        let item = format!(
            "#[liftoff(dimensionless)] #[bar(AB, mass = m, length = {length})] #[pin(A = (0, 0))]
             #[figure(A = (0, 0), B = (0, -({length})))] struct S {{ m: f64, l: f64 }}"
        );
        let errors = crate::analyse(item.parse().unwrap()).err().into_iter().flatten();
        let told: Vec<String> = errors.map(|error| error.to_string()).collect();
        assert_eq!(told, [super::TOO_MUCH]);
    }
}

#[test]
fn beyond_fifty_mistakes_only_their_number_is_reported() {
    let told = |n: usize| {
        let unknown: String = (0..n).map(|k| format!("#[pin(P{k} = (0, 0))]")).collect();
        let item = format!(
            "{unknown} #[bar(AB, mass = m, length = l)] #[figure(A = (0, 0), B = (l, 0))] struct S {{ m: f64, l: f64 }}"
        );
        let errors = crate::analyse(item.parse().unwrap()).unwrap_err();
        errors.into_iter().map(|error| error.to_string()).collect::<Vec<_>>()
    };
    let (fifty, many) = (told(50), told(120));
    assert_eq!((fifty.len(), many.len()), (50, 51));
    assert!(!fifty[49].contains("more mistakes"), "{}", fifty[49]);
    assert_eq!((&many[..50], &many[50][..]), (&fifty[..], "and 70 more mistakes"));
}

/// As many contacts, attributes, points and links as anyone may think of.
#[test]
fn large_systems_are_derived_or_refused() {
    let bar = "#[bar(AB, mass = m, length = l)] #[figure(A = (0, 0), B = (l, 0))]";
    let walls: String =
        (0..70).map(|k| format!("#[support(w{k} = wall(-{k} - 1), under = A, facing = right)]")).collect();
    let feet: String =
        (1..70).map(|k| format!("#[point(P{k} = AB, at = l / {k} / 2)] #[support(P{k} = floor)]")).collect();
    let bars: String = (0..300).map(|k| format!("#[bar(b{k} = p{k} -> q{k}, mass = m, length = l)] #[pin(p{k} = (0, 0))] #[figure(q{k} = (l, 0))]")).collect();
    let chain =
        |n: usize| format!("#[chain(c, links = {n}, from = O, mass = m, length = l)] #[pin(O = (0, 0))]");
    let named = "#[bar(AB, mass = m, length = l)] ".repeat(2000);
    for attributes in [
        format!("{bar} {walls}"),
        format!("{bar} {feet}"),
        format!("{bar} {bars}"),
        chain(513),
        chain(256),
        named,
    ] {
        let began = std::time::Instant::now();
        let code = crate::expand(format!("{attributes} struct S {{ m: f64, l: f64 }}").parse().unwrap());
        let rust = syn::parse2::<syn::File>(code.clone()).is_ok();
        // Seconds on a loaded machine, without optimisation; nothing of it takes one otherwise.
        assert!(rust && began.elapsed().as_secs() < 60, "{:.60}: {:?}", attributes, began.elapsed());
    }
}
