//! What is written is stable; that it is true is tested where there is a SymPy.

const LADDER: &str = "#[gravity(g)] #[bar(AB, mass = m, length = l)] #[support(A = floor, friction = mu)] #[support(B = wall(0))]
     #[figure(A = (3 * l / 5, 0), B = (0, 4 * l / 5))] #[coordinate(lambda = angle(AB), from = vertical)]
     struct Ladder { /// Its mass.
     m: f64, l: f64, g: f64, mu: f64 }";

#[test]
fn words_of_python_are_no_names() {
    let analysis = crate::analyse(LADDER.parse().unwrap()).unwrap();
    let module = super::sympy(&analysis).unwrap();
    assert!(module.contains("lambda_ = Symbol(\"lambda_\", real=True)  # angle of AB from"), "{module}");
    assert!(module.contains("m = Symbol(\"m\", real=True)  # Its mass."), "{module}");
    insta::assert_snapshot!(module);
}

#[test]
fn words_of_c_are_no_names_and_comments_end_where_they_end() {
    let declaration = "/// A rod. */ int x; /*
         #[derive(BarSystem)] #[gravity(g)] #[bar(AB, mass = double, length = k)] #[support(A = floor)]
         #[figure(A = (3 * k / 5, 0), B = (0, 4 * k / 5))] #[coordinate(state = angle(AB), from = vertical)]
         struct Register { double: f64, k: f64, g: f64 }";
    let analysis = crate::analyse(declaration.parse().unwrap()).unwrap();
    let files = super::c(&analysis);
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["register_.h", "register_.c", "Makefile"]);
    let [header, source] = [&files[0].text, &files[1].text];
    assert!(header.contains("   A rod. * / int x; / * */\n"), "{header}");
    assert!(
        header.contains("    double double_; /* kg */\n    double k; /* m */\n    double g; /* m/s^2 */\n"),
        "{header}"
    );
    assert!(header.contains("register__on_A_derivative(const register__constants *k, "), "{header}");
    assert!(source.contains("    const double state_ = state[0];\n"), "{source}");
}

const ARM: &str =
    "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[bar(AB, mass = m, length = l)] #[pin(O = (0, 0))]
     #[hinge(A, friction = mu, radius = r)] #[force(B = (f * tan(w * t), -f / sqrt(2 - cos(w * t))))]
     #[figure(A = (l, 0), B = (2 * l, 0))] #[coordinate(alpha = angle(OA))] #[coordinate(beta = angle(AB))]
     struct Arm { m: f64, l: f64, g: f64, mu: f64, r: f64, f: f64, w: f64 }";

#[test]
fn a_hinge_with_friction_is_among_the_contacts_of_the_source() {
    let analysis = crate::analyse(ARM.parse().unwrap()).unwrap();
    let source = &super::c(&analysis)[1].text;
    assert!(source.contains("enum { HINGES = 1 };"), "{source}");
    assert!(source.contains("static const int hinges[] = {0};"), "{source}");
    assert!(source.contains("static void hinge_forces("), "{source}");
}

#[test]
fn functions_of_time_are_those_of_sympy() {
    let module = super::sympy(&crate::analyse(ARM.parse().unwrap()).unwrap()).unwrap();
    for line in ["B_x = (f) * (tan((w) * (t)))\n", "B_y = (-f) / (sqrt((2) - (cos((w) * (t)))))\n"] {
        assert!(module.contains(line), "{module}");
    }
}
