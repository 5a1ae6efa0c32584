//! Mirrored models with both of their halves: against those of which both halves are declared, and
//! against themselves.

use std::f64::consts::FRAC_PI_2;

use liftoff_analysis::{BySymmetry, Linearisation, Subject};
use liftoff_core::system::Equations;
use liftoff_models::models;
use liftoff_studio::RunSpec;
use liftoff_studio::registry::{Entry, Unfolded};
use liftoff_studio::run_spec::{Values, overridden};
use nalgebra::DMatrix;

/// Every mirrored model, with its halves.
fn mirrored() -> Vec<(&'static Entry, Unfolded)> {
    let declared = models().iter().filter(|model| model.layout().declaration.contains("mirror"));
    declared.map(|model| (model, model.unfolded().unwrap())).collect()
}

fn subject(model: &Entry, parameters: &Values, start: Values) -> Subject {
    let spec = RunSpec { parameters: parameters.clone(), start, ..RunSpec::default() };
    Subject::new(&model.simulation(&spec).unwrap(), model.precise(parameters).unwrap()).unwrap()
}

/// About the same position, with these supports closed: the mirrored model and its halves.
fn linearised(
    (model, unfolded): (&Entry, &Unfolded),
    parameters: &Values,
    start: Values,
    closed: &dyn Fn(&Subject) -> Vec<&'static str>,
) -> (Linearisation, BySymmetry) {
    let half = subject(model, parameters, start);
    let supports = closed(&half);
    let whole =
        subject(unfolded.model(), parameters, unfolded.position(parameters, &half.positions()).unwrap());
    let reflection = unfolded.reflection(parameters, &whole.positions()).unwrap();
    let [half, whole] = [half, whole]
        .map(|subject| Linearisation::compute(&subject, subject.contacts(&supports).unwrap()).unwrap());
    (half, whole.by_symmetry(&reflection).unwrap())
}

fn touching(subject: &Subject) -> Vec<&'static str> {
    let contacts = subject.layout().contacts;
    subject.touching().iter().flat_map(|i| contacts[i].supports).copied().collect()
}

/// σₐ/σₛ = √[(1/3 + 2λ)/(1/12 + λ − λ²)] of Fig. 1b upright, all supports closed, from the mirrored
/// declaration alone.
#[test]
fn the_antisymmetric_motion_of_the_zigzag_grows_by_its_closed_form() {
    let zigzag = models().find("zigzag").unwrap();
    let unfolded = zigzag.unfolded().unwrap();
    for lambda in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let ratios = [("m1".to_owned(), 1.0 - lambda), ("m2".to_owned(), lambda)];
        let parameters = overridden(zigzag.default_run().parameters, &ratios);
        let upright = ["phi_inner", "phi_outer"].map(|name| (name.to_owned(), FRAC_PI_2)).to_vec();
        let (_, parts) = linearised((zigzag, &unfolded), &parameters, upright, &touching);
        let exact = ((1.0 / 3.0 + 2.0 * lambda) / (1.0 / 12.0 + lambda - lambda * lambda)).sqrt();
        let ratio = parts.growth_ratio().unwrap();
        assert!((ratio / exact - 1.0).abs() < 1e-10, "{lambda}: {ratio} {exact}");
        // The other antisymmetric motion is the shift to the side.
        assert_eq!((parts.symmetric.degrees(), parts.antisymmetric.degrees()), (1, 2));
    }
}

/// Z Zᵀ, Z K Zᵀ and Z C Zᵀ do not depend on the choice of ξ: for the coordinates of a mirrored
/// model those of the symmetric motions of both halves are its own.
#[test]
fn symmetric_motions_are_those_of_the_mirrored_model() {
    let all = mirrored();
    assert!(all.len() >= 6, "{}", all.len());
    for (model, unfolded) in &all {
        let spec = model.default_run();
        // Flat on both corners the pair has more freedom: near that, at its default φ = 0.01,
        // roundings grow by 1/φ².
        let start = if model.name() == "falling-pair" { vec![("phi".to_owned(), 0.5)] } else { spec.start };
        let open = |_: &Subject| Vec::new();
        for closed in [&touching as &dyn Fn(&Subject) -> Vec<&'static str>, &open] {
            let (half, parts) = linearised((model, unfolded), &spec.parameters, start.clone(), closed);
            let [names, all] = [model, unfolded.model()]
                .map(|model| model.layout().coordinates.iter().map(|c| c.name).collect::<Vec<_>>());
            let rows: Vec<usize> =
                names.iter().map(|name| all.iter().position(|n| n == name).unwrap()).collect();
            let symmetric = parts.symmetric.basis().select_rows(&rows);
            let across = |z: &DMatrix<f64>, a: &DMatrix<f64>| z * a * z.transpose();
            let one = DMatrix::identity(half.degrees(), half.degrees());
            assert_eq!(parts.symmetric.degrees(), half.degrees(), "{}", model.name());
            let both = [&parts.symmetric, &parts.antisymmetric];
            assert!(
                both.iter().all(|part| part.modes().len() == part.degrees()),
                "{}: {parts:?}",
                model.name()
            );
            for (a, b) in [
                (&one, &one),
                (half.stiffness(), parts.symmetric.stiffness()),
                (half.damping(), parts.symmetric.damping()),
            ] {
                let (a, b) = (across(half.basis(), a), across(&symmetric, b));
                let error = (&a - &b).amax();
                // Roundings of a dozen operations; measured 2e-15.
                assert!(error <= 1e-14 * a.amax().max(1.0), "{}: {error:e}\n{a}{b}", model.name());
            }
        }
    }
}

type Pair = (&'static str, &'static str);

/// Models of which both halves are declared, with the names of their coordinates that those of the
/// mirrored model and their images have there.
const DECLARED: [(&str, &str, &[Pair]); 2] = [
    (
        "zigzag",
        "zigzag-full",
        &[
            ("phi_inner", "phi_cd"),
            ("phi_outer", "phi_de"),
            ("phi_inner_image", "phi_bc"),
            ("phi_outer_image", "phi_ab"),
            ("x_C", "x"),
            ("y", "y"),
        ],
    ),
    (
        "falling-pair",
        "falling-pair-full",
        &[("phi", "phi_right"), ("phi_image", "phi_left"), ("x_D", "x"), ("y", "y")],
    ),
];

fn equations(model: &Entry, parameters: &Values, state: &[f64]) -> Equations<f64> {
    model.model(parameters).unwrap().system.equations(state)
}

/// M, f, and of each support g, J and b, at positions and rates without any symmetry.
#[test]
fn unfolded_models_are_those_of_which_both_halves_are_declared() {
    for (mirrored, declared, names) in DECLARED {
        let mirrored = models().find(mirrored).unwrap();
        let unfolded = mirrored.unfolded().unwrap();
        let (unfolded, declared) = (unfolded.model(), models().find(declared).unwrap());
        let parameters = mirrored.default_run().parameters;
        let n = names.len();
        let places = |model: &Entry, of: fn(&Pair) -> &'static str| -> Vec<usize> {
            let known = model.layout().coordinates;
            assert_eq!(known.len(), n);
            names.iter().map(|pair| known.iter().position(|c| c.name == of(pair)).unwrap()).collect()
        };
        let [ours, theirs] = [places(unfolded, |pair| pair.0), places(declared, |pair| pair.1)];
        for k in 1..=5 {
            let value = |i: usize| (1.7 * ((i + 1) * (2 * k + 1)) as f64).sin();
            let state = |places: &[usize]| {
                let mut state = vec![0.0; 2 * n];
                for (i, &place) in places.iter().enumerate() {
                    state[place] = value(i);
                    state[n + place] = value(n + i);
                }
                state
            };
            let a = equations(unfolded, &parameters, &state(&ours));
            let b = equations(declared, &parameters, &state(&theirs));
            let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-13 * b.abs().max(1.0), "{a} {b} {k}");
            for (&i, &p) in ours.iter().zip(&theirs) {
                near(a.force()[i], b.force()[p]);
                ours.iter().zip(&theirs).for_each(|(&j, &q)| near(a.mass(i)[j], b.mass(p)[q]));
            }
            for (row, contact) in unfolded.layout().contacts.iter().enumerate() {
                let other = declared.layout().contacts.iter().position(|c| c.label == contact.label).unwrap();
                near(a.gap()[row], b.gap()[other]);
                near(a.bias()[row], b.bias()[other]);
                ours.iter().zip(&theirs).for_each(|(&j, &q)| near(a.jacobian(row)[j], b.jacobian(other)[q]));
            }
        }
    }
}

/// A start from a mirrored run is one of both halves, which move alike as long as nothing disturbs
/// them.
#[test]
fn a_symmetric_start_has_the_motion_of_the_mirrored_model() {
    let zigzag = models().find("zigzag").unwrap();
    let unfolded = zigzag.unfolded().unwrap();
    let angles = ["phi_inner", "phi_outer"].map(|name| (name.to_owned(), 1.5)).to_vec();
    let spec = RunSpec { parameters: zigzag.default_run().parameters, start: angles, ..RunSpec::default() };
    let start = zigzag.configuration(&spec).unwrap().state;
    let start = unfolded.position(&spec.parameters, &start[..zigzag.layout().coordinates.len()]).unwrap();
    let first = |model: &Entry, start: &Values| {
        let run = model.run(&RunSpec { start: start.clone(), ..spec.clone() }).unwrap();
        let open = run.events().iter().find(|event| event.kind == liftoff::EventKind::Open).unwrap();
        (open.t, open.supports.clone())
    };
    let (half, whole) = (first(zigzag, &spec.start), first(unfolded.model(), &start));
    assert!((half.0 - whole.0).abs() < 1e-9 * half.0, "{half:?} {whole:?}");
    assert!(whole.1.iter().all(|support| half.1.contains(support)), "{half:?} {whole:?}");
}
