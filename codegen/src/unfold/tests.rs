use super::Unfolded;
use crate::Analysis;
use crate::algebra::Symbol;
use crate::kinematics::nominal_values;
use crate::system::ParameterValues;
use crate::tests::{PAIR, analysis};

/// Mirrored models of parameters m, l, g and a.
const MIRRORED: [&str; 13] = [
    // Two bars on corners.
    PAIR,
    // Four bars, an end of each on the floor, C on the mirror.
    "#[gravity(g)] #[bar(AB, mass = a, length = l)] #[bar(BC, mass = m, length = l)] #[bar(CD, mass = m, length = l)]
     #[bar(DE, mass = a, length = l)] #[support(A = floor)] #[support(C = floor)] #[support(E = floor)] #[thread(BD, length = l)]
     #[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))] #[coordinate(phi = angle(CD), from = horizontal)]
     #[coordinate(psi = angle(DE), from = horizontal)] #[coordinate(y = y(C))] #[mirror(x = 0)]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // The same with opposite bars parallel; the coordinate of the other half is declared.
    "#[gravity(g)] #[bar(AB, mass = a, length = l)] #[bar(BC, mass = m, length = l)] #[bar(CD, mass = m, length = l)]
     #[bar(DE, mass = a, length = l)] #[figure(C = (0, 0), D = (3 * l / 5, 4 * l / 5), E = (6 * l / 5, 0))]
     #[coordinate(phi = angle(BC), from = horizontal)] #[coordinate(psi = angle(CD), from = horizontal)] #[mirror(x = 0)]
     #[equal(angle(AB), angle(CD))]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // Gears in both halves.
    "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[bar(QB, mass = m, length = l)] #[bar(PC, mass = a, length = l)]
     #[bar(RD, mass = a, length = l)] #[pin(O = (-l, 0))] #[pin(Q = (l, 0))] #[pin(P = (-3 * l, 0))] #[pin(R = (3 * l, 0))]
     #[figure(A = (-l, l), C = (-3 * l, l))] #[coordinate(phi = -angle(OA), from = up)] #[coordinate(psi = angle(PC), from = up)]
     #[equal(psi, -2 * phi)] #[mirror(x = 0, swap(A, B), swap(C, D))]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // Across a level mirror that is not at zero; the lower bar named from its other end.
    "#[liftoff(dimensionless)] #[bar(DA, mass = m, length = l)] #[bar(BD, mass = m, length = l)] #[spring(AB, stiffness = g, length = l)]
     #[figure(D = (0, a), A = (3 * l / 5, a + 4 * l / 5))] #[coordinate(alpha = -angle(DA), from = up)] #[coordinate(x = -x(D))]
     #[mirror(y = a)]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // Two bars apart, their positions measured across the mirror, which is not at zero.
    "#[gravity(g)] #[bar(AD, mass = m, length = l)] #[bar(BE, mass = m, length = l)] #[support(A = floor)] #[support(B = floor)]
     #[figure(A = (a - l, 0), D = (a - l / 5, 3 * l / 5), B = (a + l, 0), E = (a + l / 5, 3 * l / 5))] #[coordinate(x = x(A))]
     #[coordinate(h = -y(A))] #[coordinate(phi = angle(AD))] #[mirror(x = a)]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // No coordinate declared; a load on the hinge.
    "#[gravity(g)] #[bar(AC, mass = m, length = l)] #[bar(CB, mass = m, length = l)] #[mass(C, a)] #[thread(AB, length = l)]
     #[support(A = floor)] #[support(B = floor)] #[figure(A = (-l / 2, 0), C = (0, sqrt(3) * l / 2))] #[mirror(x = 0)]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // The height of a foot, which is not on the mirror.
    "#[gravity(g)] #[bar(AC, mass = m, length = l)] #[bar(CB, mass = m, length = l)] #[support(A = floor)] #[support(B = floor)]
     #[figure(A = (-l / 2, 0), C = (0, sqrt(3) * l / 2))] #[coordinate(phi = angle(AC))] #[coordinate(h = y(A))] #[mirror(x = 0)]
     struct S { m: f64, l: f64, g: f64 }",
    // A bar on the mirror, another across it, and bars measured from one another.
    "#[liftoff(dimensionless)] #[gravity(g)] #[bar(OC, mass = m, length = l)] #[bar(AB, mass = a, length = 2 * l)] #[point(G = AB, at = l)] #[bar(GH, mass = m, length = l)]
     #[bar(AP, mass = m, length = l)] #[bar(BQ, mass = m, length = l)] #[spring(CH, stiffness = g, length = l / 2)]
     #[torsion(AP, stiffness = g, angle = -pi / 2)] #[torsion(BQ, stiffness = g, angle = -pi / 2)]
     #[torsion(AB, AP, stiffness = a, angle = -pi / 3)] #[torsion(AB, BQ, stiffness = a, angle = -2 * pi / 3)]
     #[figure(O = (0, -l), C = (0, 0), A = (-l, l), B = (l, l), H = (0, 2 * l), P = (-l, 0), Q = (l, 0))]
     #[coordinate(phi = angle(AP), from = down)] #[coordinate(h = y(G))] #[mirror(x = 0)]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // Bars measured from one another, in one half named in a row.
    "#[liftoff(dimensionless)] #[gravity(g)] #[bar(CA, mass = m, length = l)] #[bar(AP, mass = m, length = l)] #[bar(CB, mass = m, length = l)]
     #[bar(BQ, mass = m, length = l)] #[torsion(CA, AP, stiffness = a)] #[torsion(CB, BQ, stiffness = a)] #[pin(C = (0, 0))]
     #[figure(A = (-3 * l / 5, -4 * l / 5), P = (-3 * l / 5, -9 * l / 5))] #[coordinate(phi = angle(CA))] #[coordinate(psi = angle(AP), from = CA)]
     #[mirror(x = 0, swap(A, B), swap(P, Q))]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // The same, one bar named from its other end in one half alone.
    "#[gravity(g)] #[bar(CA, mass = m, length = l)] #[bar(AP, mass = m, length = l)] #[bar(CB, mass = m, length = l)]
     #[bar(QB, mass = m, length = l)] #[pin(C = (0, 0))] #[figure(A = (-3 * l / 5, -4 * l / 5), P = (-3 * l / 5, -9 * l / 5))]
     #[coordinate(phi = angle(CA))] #[coordinate(psi = angle(AP), from = CA)] #[mirror(x = 0, swap(A, B), swap(P, Q))]
     struct S { m: f64, l: f64, g: f64 }",
    // A loop that is closed by joints.
    "#[gravity(g)] #[bar(AB, mass = a, length = l)] #[bar(BC, mass = m, length = l)] #[bar(CD, mass = m, length = l)]
     #[bar(DE, mass = a, length = l)] #[pin(A = (-6 * l / 5, 0))] #[pin(E = (6 * l / 5, 0))] #[support(B = floor)] #[support(D = floor)]
     #[figure(B = (-3 * l / 5, 4 * l / 5), C = (0, 0))] #[mirror(x = 0)]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
    // Bodies that reflect with their frames.
    "#[liftoff(dimensionless)] #[gravity(g, 0)] #[body(left, points(C = (0, 0), A = (l, 0), B = (0, m)), mass = m)]
     #[body(right, points(C = (0, 0), D = (0, m), E = (-l, 0)), mass = m)] #[force(A = (a, g))] #[force(E = (a, -g))]
     #[figure(C = (0, 0), A = (l, 0))] #[mirror(y = 0, swap(A, E), swap(B, D))]
     struct S { m: f64, l: f64, g: f64, a: f64 }",
];

/// A mirrored model and both of its halves, at a position.
struct Case {
    declaration: &'static str,
    half: Analysis,
    unfolded: Unfolded,
    parameters: Vec<f64>,
    /// Coordinates of the mirrored model, different from one another.
    q: Vec<f64>,
}

fn cases() -> impl Iterator<Item = Case> {
    MIRRORED.into_iter().flat_map(|declaration| [1.0, 2.0].map(|k| Case::new(declaration, k)))
}

impl Case {
    fn new(declaration: &'static str, k: f64) -> Self {
        let half = analysis(declaration);
        let unfolded = Unfolded::from_tokens(declaration.parse().unwrap());
        let unfolded = unfolded.unwrap_or_else(|error| panic!("{declaration}: {error}"));
        let value = |name: &syn::Ident| match name.to_string().as_str() {
            "m" => 0.7,
            "l" => 1.3,
            "g" => 9.81,
            _ => 0.4,
        };
        let parameters: Vec<f64> = half.system.parameters.iter().map(value).collect();
        let closed = || {
            half.kinematics.nominal(&half.system, &ParameterValues::new(&parameters, &half.system.constants))
        };
        let free = || (1..=half.motion.n).map(|i| 0.3 + (1.7 * i as f64 * k).sin()).collect();
        let q = if half.kinematics.joints.is_empty() { free() } else { closed() };
        Self { declaration, half, unfolded, parameters, q }
    }

    fn position(&self, q: &[f64]) -> Vec<f64> {
        self.unfolded.position(&self.parameters, q)
    }

    fn reflection(&self) -> Vec<Vec<f64>> {
        self.unfolded.reflection(&self.parameters, &self.position(&self.q))
    }

    /// The places of all points of both halves.
    fn places(&self, q: &[f64]) -> Vec<[f64; 2]> {
        places(&self.unfolded.analysis, &self.parameters, q)
    }

    /// The mirror image of all points.
    fn image(&self, places: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mirror = self.half.system.mirror.as_ref().unwrap();
        let at = self.half.system.parameter_value(&mirror.at, &self.parameters);
        let image = |image: &usize| {
            let mut place = places[*image];
            place[mirror.axis] = 2.0 * at - place[mirror.axis];
            place
        };
        mirror.points.iter().map(image).collect()
    }

    /// Slopes of a function at a position by central differences: exact to 1e-10 of values near 1.
    fn slopes(at: &[f64], f: impl Fn(&[f64]) -> Vec<f64>) -> Vec<Vec<f64>> {
        let h = 1e-5;
        let column = |i: usize| {
            let moved = |by: f64| {
                f(&at.iter().enumerate().map(|(j, x)| if i == j { x + by } else { *x }).collect::<Vec<_>>())
            };
            moved(h).iter().zip(moved(-h)).map(|(a, b)| (a - b) / (2.0 * h)).collect::<Vec<f64>>()
        };
        transposed(&(0..at.len()).map(column).collect::<Vec<_>>())
    }

    fn assert_near(&self, what: &str, a: &[Vec<f64>], b: &[Vec<f64>], within: f64) {
        let pairs = a.iter().flatten().zip(b.iter().flatten());
        let error = pairs
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, |most: f64, x| if x > most || x.is_nan() { x } else { most });
        assert!(
            (a.len(), a.first().map(Vec::len)) == (b.len(), b.first().map(Vec::len)),
            "{what} of {}",
            self.declaration
        );
        assert!(
            error <= within,
            "{what}: {error:e} of {}\n{}\n{a:?}\n{b:?}",
            self.declaration,
            self.unfolded.analysis.system.declaration
        );
    }
}

/// The places of all points.
fn places(analysis: &Analysis, parameters: &[f64], q: &[f64]) -> Vec<[f64; 2]> {
    let numbers = ParameterValues::new(parameters, &analysis.system.constants);
    let values = nominal_values(&analysis.system, &numbers, q);
    let value = |symbol: Symbol| values[&symbol];
    analysis.kinematics.points.iter().map(|place| place.each_ref().map(|c| c.evaluate(&value))).collect()
}

/// The projection onto the displacements that the joints allow: 1 − Σ u uᵀ, u an orthonormal basis
/// of their rows.
fn allowed(analysis: &Analysis, parameters: &[f64], q: &[f64]) -> Vec<Vec<f64>> {
    let mut projection: Vec<Vec<f64>> =
        (0..q.len()).map(|i| (0..q.len()).map(|j| f64::from(i == j)).collect()).collect();
    for row in &analysis.functions.kernel.jacobian[analysis.motion.contacts.len()..] {
        let row = times(&[analysis.evaluate(row, parameters, q)], &projection);
        let square = times(&row, &transposed(&row))[0][0];
        for (i, line) in projection.iter_mut().enumerate() {
            line.iter_mut().zip(&row[0]).for_each(|(x, u)| *x -= row[0][i] * u / square);
        }
    }
    projection
}

fn rows(places: &[[f64; 2]]) -> Vec<Vec<f64>> {
    places.iter().map(|place| place.to_vec()).collect()
}

fn transposed(a: &[Vec<f64>]) -> Vec<Vec<f64>> {
    (0..a.first().map_or(0, Vec::len)).map(|j| a.iter().map(|row| row[j]).collect()).collect()
}

fn times(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let b = transposed(b);
    a.iter()
        .map(|row| b.iter().map(|column| row.iter().zip(column).map(|(x, y)| x * y).sum()).collect())
        .collect()
}

/// Sᵀ M S, and as another row fᵀ S at rest.
fn equations(analysis: &Analysis, parameters: &[f64], q: &[f64], s: &[Vec<f64>]) -> [Vec<Vec<f64>>; 2] {
    let state = [q, &vec![0.0; q.len()]].concat();
    let force = analysis.evaluate(&analysis.functions.kernel.force, parameters, &state);
    [times(&transposed(s), &times(&analysis.mass(parameters, &state), s)), times(&[force], s)]
}

#[test]
fn both_halves_are_where_the_mirrored_model_is() {
    for case in cases() {
        let half = places(&case.half, &case.parameters, &case.q);
        let whole = case.places(&case.position(&case.q));
        case.assert_near("places", &rows(&whole), &rows(&half), 1e-14);
    }
}

/// Of every small displacement, whether symmetric or not.
#[test]
fn the_reflection_takes_displacements_to_their_mirror_images() {
    for case in cases() {
        let at = case.position(&case.q);
        let allowed = allowed(&case.unfolded.analysis, &case.parameters, &at);
        let moved = |q: &[f64]| case.places(q).concat();
        let images = |q: &[f64]| case.image(&case.places(q)).concat();
        let [slopes, of_images] = [Case::slopes(&at, moved), Case::slopes(&at, images)];
        let reflected = times(&case.reflection(), &allowed);
        case.assert_near("images", &times(&slopes, &reflected), &times(&of_images, &allowed), 1e-9);
        case.assert_near("images of images", &times(&case.reflection(), &reflected), &allowed, 1e-13);
    }
}

/// Both halves have M' = Sᵀ M S and f' = Sᵀ f of the mirrored model, S the slopes of their
/// position; a mirror image has the same M and f.
#[test]
fn symmetric_motions_are_those_of_the_mirrored_model() {
    for case in cases() {
        let Case { half, unfolded: Unfolded { analysis: whole, .. }, parameters, q, .. } = &case;
        let at = case.position(q);
        let [mass, force] = equations(half, parameters, q, &allowed(half, parameters, q));
        let slopes = times(&Case::slopes(q, |q| case.position(q)), &allowed(half, parameters, q));
        let [of_both, forces_of_both] = equations(whole, parameters, &at, &slopes);
        case.assert_near("M", &of_both, &mass, 1e-9);
        case.assert_near("f", &forces_of_both, &force, 1e-9 * 9.81);
        let allowed = allowed(whole, parameters, &at);
        let [mass, force] = equations(whole, parameters, &at, &allowed);
        let [of_images, forces_of_images] =
            equations(whole, parameters, &at, &times(&case.reflection(), &allowed));
        case.assert_near("M of images", &of_images, &mass, 1e-13);
        case.assert_near("f of images", &forces_of_images, &force, 1e-13 * 9.81);
    }
}

/// A contact of the mirrored model is one of each of its supports.
#[test]
fn contacts_are_as_far_open_as_those_of_the_mirrored_model() {
    for case in cases() {
        let gaps = |analysis: &Analysis, q: &[f64]| -> Vec<(String, f64)> {
            let values = analysis.evaluate(&analysis.functions.kernel.gap, &case.parameters, q);
            let named = analysis.motion.contacts.iter().zip(values);
            let each = named.flat_map(|(contact, gap)| {
                contact.supports.iter().map(move |&i| (analysis.system.supports[i].name.clone(), gap))
            });
            let mut each: Vec<_> = each.collect();
            each.sort_by(|a, b| a.0.cmp(&b.0));
            each
        };
        let [half, whole] =
            [gaps(&case.half, &case.q), gaps(&case.unfolded.analysis, &case.position(&case.q))];
        assert_eq!(half.len(), whole.len(), "{}", case.declaration);
        for ((name, a), (other, b)) in half.iter().zip(&whole) {
            assert!(name == other && (a - b).abs() < 1e-14, "{name} {a} {other} {b}: {}", case.declaration);
        }
    }
}

fn named(unfolded: &Unfolded) -> Vec<String> {
    unfolded.analysis.kinematics.coordinates.iter().map(|coordinate| coordinate.name.clone()).collect()
}

#[test]
fn coordinates_keep_their_names_and_are_equal_to_their_images() {
    let four = Case::new(MIRRORED[1], 1.0);
    assert_eq!(named(&four.unfolded), ["phi", "psi", "phi_image", "psi_image", "x_C", "y"]);
    let [phi, psi, y] = four.q[..] else { panic!("{:?}", four.q) };
    assert_eq!(four.position(&four.q), [phi, psi, phi, psi, 0.0, y]);
    // Images of equal angles are equal.
    assert_eq!(named(&Case::new(MIRRORED[2], 1.0).unfolded), ["phi", "psi", "x_C", "y_C"]);
    assert_eq!(named(&Case::new(MIRRORED[3], 1.0).unfolded), ["phi", "phi_image"]);
    // Names that the model has already are not taken twice.
    let taken = MIRRORED[1].replace("a: f64", "phi_image: f64").replace("= a,", "= phi_image,");
    let unfolded = Unfolded::from_tokens(taken.parse().unwrap()).unwrap();
    assert!(named(&unfolded).contains(&"phi_image_".to_owned()));
}

#[test]
fn what_is_not_unfolded_is_reported() {
    let told =
        |declaration: &str| Unfolded::from_tokens(declaration.parse().unwrap()).unwrap_err().to_string();
    let whole = Unfolded::from_tokens(PAIR.parse().unwrap()).unwrap().analysis.system.declaration;
    assert!(told(&whole).starts_with("`Pair` has no mirror"), "{}", told(&whole));
    // Without gravity a bar of which one point is known lies to the right, its image to the left.
    let hanging = "#[bar(CA, mass = m, length = l)] #[bar(CB, mass = m, length = l)] #[pin(C = (0, 0))] \
                   #[mirror(x = 0, swap(A, B))] struct Hanging { m: f64, l: f64 }";
    assert!(told(hanging).starts_with("only the mirror says where point `B` is"), "{}", told(hanging));
    let geared = MIRRORED[10].replace("#[mirror", "#[equal(psi, 2 * phi)] #[mirror");
    assert!(told(&geared).starts_with("`psi` is an angle between bars of which"), "{}", told(&geared));
}
