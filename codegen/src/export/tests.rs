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
