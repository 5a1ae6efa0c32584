//! Random systems: what holds for the oracle in any of them, and what the drawing promises.

use std::collections::BTreeSet;

use liftoff_codegen::geometry::{Geometry, Look, Value};
use liftoff_codegen::kinematics::Kinematics;
use liftoff_codegen::system::Support;
use liftoff_tests::oracle::{Assembly, Contact, Mark, Place, State};
use liftoff_tests::random::{Sample, Source, Vocabulary, sample, sample_of};

/// A closed set that leaves the system regular: supports are added while the rows stay independent.
fn closed(sample: &Sample, state: &State, source: &mut Source) -> Vec<usize> {
    let mut set = Vec::new();
    for support in 0..sample.assembly.supports.len() {
        let larger = [set.clone(), vec![support]].concat();
        let regular = sample.assembly.solve(state, &larger).is_ok_and(|m| m.pivots > 1e-6);
        if regular && source.chance(0.7) {
            set = larger;
        }
    }
    set
}

/// The state a time t later at constant accelerations.
fn later(state: &State, accelerations: &nalgebra::DVector<f64>, t: f64) -> State {
    State {
        positions: &state.positions + &state.rates * t + accelerations * (0.5 * t * t),
        rates: &state.rates + accelerations * t,
        time: state.time + t,
    }
}

/// g̈ by central differences of g alone.
fn second_difference(f: impl Fn(f64) -> f64, t: f64) -> f64 {
    (f(t) - 2.0 * f(0.0) + f(-t)) / (t * t)
}

fn check_rows(assembly: &Assembly, state: &State, set: &[usize]) {
    let motion = assembly.solve(state, set).expect("regular");
    let size = 1.0 + motion.accelerations.amax();
    let t = 1e-3 / size.sqrt();
    let at = |t: f64| later(state, &motion.accelerations, t);
    // truncation t² g⁗/12 with rates up to 2 and |q̈| < size, rounding 1e-15/t²
    let near = |computed: f64, expected: f64, scale: f64| {
        let error = (computed - expected).abs();
        assert!(error < 1e-4 * size * scale, "{error:e} of {size:e} times {scale:e}");
    };
    for support in 0..assembly.supports.len() {
        let gap = |t: f64| assembly.gap(&at(t), support)[0];
        near(second_difference(gap, t), motion.gap_accelerations[support], stretch(assembly, state, support));
        if set.contains(&support) {
            assert!(motion.gap_accelerations[support].abs() < 1e-10 * size);
            let slip = |t: f64| {
                let then = at(t);
                assembly.tangent_row(&then, support).map_or(0.0, |row| row.rate(&then.rates))
            };
            near((slip(t) - slip(-t)) / (2.0 * t), 0.0, stretch(assembly, state, support));
        }
    }
    for row in 0..assembly.joint_rows(state).len() {
        near(second_difference(|t| assembly.joint_rows(&at(t))[row].value, t), 0.0, 1.0);
    }
}

/// How much faster than others the derivatives of a gap may grow: those of a distance r as 1/r³.
fn stretch(assembly: &Assembly, state: &State, support: usize) -> f64 {
    let distance = |a: Place, b: Place| (assembly.position(state, a) - assembly.position(state, b)).norm();
    let shortest = match &assembly.supports[support].contact {
        Contact::Circle { point, centre, .. } => distance(*point, Place::Ground(*centre)),
        Contact::Thread { path, .. } => {
            path.windows(2).map(|ends| distance(ends[0], ends[1])).fold(1.0, f64::min)
        }
        _ => 1.0,
    };
    shortest.min(1.0).powi(-3)
}

/// Without closed supports the joints do no work but that of the drives: q̇·(M q̈ − Q) = Σ λ ḟ.
fn check_power(assembly: &Assembly, state: &State) {
    let motion = assembly.solve(state, &[]).expect("regular");
    let inertial = assembly.masses().component_mul(&motion.accelerations);
    let forces = assembly.forces(state);
    let paces = assembly.drives.iter().map(|drive| drive.value.jet(assembly, state)[1]);
    let driven: f64 = paces.zip(&motion.drives).map(|(pace, force)| pace * force).sum();
    let scale = 1.0 + inertial.amax() + forces.amax() + driven.abs();
    let power = state.rates.dot(&(inertial - forces)) - driven;
    assert!(power.abs() < 1e-9 * scale * (1.0 + state.rates.norm()), "{power:e} of {scale:e}");
}

/// Gravity and undamped springs take from V what they give: Q·q̇ = −dV/dt.
fn check_potential(assembly: &Assembly, state: &State) {
    let mut undamped = Assembly { loads: Vec::new(), couples: Vec::new(), ..assembly.clone() };
    undamped.springs.iter_mut().for_each(|spring| spring.damping = 0.0);
    undamped.torsions.iter_mut().for_each(|torsion| torsion.damping = 0.0);
    let still = nalgebra::DVector::zeros(state.rates.len());
    let energy = |t: f64| undamped.potential_energy(&later(state, &still, t));
    let power = undamped.forces(state).dot(&state.rates);
    let error = (energy(1e-5) - energy(-1e-5)) / 2e-5 + power;
    // rounding 1e-16 V/t, truncation t² V⃛/6
    assert!(error.abs() < 1e-8 * (1.0 + power.abs() + energy(0.0).abs()), "{error:e} of {power:e}");
}

/// Each body and particle: m C̈ = m g + what is said to act on it, and I θ̈ = its moment where
/// there are no couples.
fn check_actions(assembly: &Assembly, state: &State, set: &[usize]) {
    let motion = assembly.solve(state, set).expect("regular");
    let at = |place: &Place| match *place {
        Place::Body(mark) => Some(3 * mark.body),
        Place::Particle(index) => Some(3 * assembly.bodies.len() + 2 * index),
        Place::Ground(_) => None,
    };
    let mut acting = nalgebra::DVector::<f64>::zeros(assembly.dimension());
    for (index, force) in motion.actions.iter().filter_map(|(place, force)| Some((at(place)?, force))) {
        acting[index] += force.x;
        acting[index + 1] += force.y;
    }
    let inertial = assembly.masses().component_mul(&motion.accelerations);
    let mut weightless = assembly.clone();
    weightless.gravity = nalgebra::Vector2::zeros();
    let weights = assembly.forces(state) - weightless.forces(state);
    let scale = 1.0 + inertial.amax() + acting.amax();
    for (place, force) in &motion.actions {
        if let Place::Body(mark) = *place {
            let centre = Mark { body: mark.body, local: assembly.bodies[mark.body].centre };
            let arm = assembly.position(state, *place) - assembly.position(state, centre);
            acting[3 * mark.body + 2] += arm.perp(force);
        }
    }
    let (ties, drives) = (assembly.ties.iter(), assembly.drives.iter());
    let twisted =
        !assembly.torsions.is_empty() || !assembly.couples.is_empty() || drives.len() + ties.len() > 0;
    let turns = |index: usize| twisted && index < 3 * assembly.bodies.len() && index % 3 == 2;
    for index in (0..inertial.len()).filter(|&index| !turns(index)) {
        let error: f64 = inertial[index] - weights[index] - acting[index];
        assert!(error.abs() < 1e-9 * scale, "{error:e} of {scale:e}");
    }
}

/// An impact that gives closed supports random rates: the joints keep theirs, every work is
/// accounted for.
fn check_impact(assembly: &Assembly, state: &State, set: &[usize], source: &mut Source) {
    let acting: Vec<_> = set.iter().map(|&support| (support, source.range(-1.0, 1.0))).collect();
    let impact = assembly.impact(state, &acting, &[]).expect("regular");
    let after = State { rates: impact.rates.clone(), ..state.clone() };
    let size = 1.0 + after.rates.amax();
    assert!(assembly.residual(&after) < 1e-9 * size);
    let mut work = 0.0;
    for &(support, rate) in &acting {
        let gaps = [state, &after].map(|at| assembly.gap(at, support)[1]);
        assert!((gaps[1] - rate).abs() < 1e-9 * size);
        work += impact.normal[support] * (gaps[0] + gaps[1]) / 2.0;
        let slips = [state, &after]
            .map(|at| assembly.tangent_row(at, support).map_or(0.0, |row| row.rate(&at.rates)));
        assert!(slips[1].abs() < 1e-9 * size);
        work += impact.tangential[support] * slips[0] / 2.0;
    }
    if assembly.drives.is_empty() {
        let gained = assembly.kinetic_energy(&after) - assembly.kinetic_energy(state);
        let scale = 1.0 + gained.abs() + impact.normal.iter().fold(0.0, |a: f64, p| a.max(p.abs())) * size;
        assert!((gained - work).abs() < 1e-9 * scale, "{gained:e} by {work:e}");
    }
}

fn check_laws(seed: u64, vocabulary: Vocabulary) {
    let sample = sample_of(seed, vocabulary);
    let mut source = Source::new(seed ^ 1);
    let Some(state) = sample.state(&mut source) else {
        return;
    };
    let residual = sample.assembly.residual(&state);
    assert!(residual < 1e-11, "seed {seed}: {residual:e}");
    let set = closed(&sample, &state, &mut source);
    check_rows(&sample.assembly, &state, &set);
    check_power(&sample.assembly, &state);
    check_potential(&sample.assembly, &state);
    check_actions(&sample.assembly, &state, &set);
    check_impact(&sample.assembly, &state, &set, &mut source);
}

#[test]
fn oracle_keeps_the_laws_in_random_bars() {
    (0..200).for_each(|seed| check_laws(seed, Vocabulary::BARS));
}

#[test]
fn oracle_keeps_the_laws_in_random_systems() {
    (0..400).for_each(|seed| check_laws(seed, Vocabulary::ALL));
}

#[test]
fn the_same_seed_draws_the_same_system() {
    let [first, second] = [5, 5].map(|seed| sample(seed).declaration);
    assert_eq!(first, second);
}

#[test]
fn declarations_are_rust_and_use_every_parameter() {
    for seed in 0..200 {
        let sample = sample_of(seed, if seed < 100 { Vocabulary::BARS } else { Vocabulary::ALL });
        assert!(sample.tokens().is_ok(), "{}", sample.declaration);
        let body = sample.declaration.split("pub struct").next().unwrap_or_default();
        let words: BTreeSet<_> = body.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
        for (name, _) in &sample.parameters {
            assert!(words.contains(name.as_str()), "{name} is unused:\n{}", sample.declaration);
        }
    }
}

/// Of whatever kind a part is, it has a form, and numbers of forms are parameters' alone.
#[test]
fn every_part_has_its_form() {
    for seed in 0..200 {
        let sample = sample_of(seed, Vocabulary::ALL);
        let system = liftoff_codegen::resolve(sample.tokens().unwrap()).unwrap();
        let coordinates = Kinematics::derive(&system).unwrap().coordinates;
        let forms = Geometry::from_system(&system, &coordinates);
        let marks = |look| forms.marks.iter().filter(|(_, mark)| *mark == look).count();
        assert_eq!((marks(Look::Foot), marks(Look::Mass)), (system.pins.len(), system.particles.len()));
        assert_eq!((forms.bodies.len(), forms.readings.len()), (system.bodies.len(), coordinates.len()));
        assert_eq!((forms.springs.len(), forms.spirals.len()), (system.springs.len(), system.torsions.len()));
        assert_eq!((forms.blocks.len(), forms.sections.len()), (system.sliders.len(), system.sections.len()));
        for Support { name, contact, .. } in &system.supports {
            let pushes = forms.pushes.iter().filter(|push| push.support == *name).count();
            let thread = forms.threads.iter().any(|thread| thread.name == *name);
            let stands = thread || forms.fixtures.iter().any(|fixture| fixture.name == *name);
            assert!(
                stands && pushes == 1 + usize::from(contact.is_thread()),
                "{name}:\n{}",
                sample.declaration
            );
        }
        let values: Vec<f64> = sample.parameters.iter().map(|(_, value)| *value).collect();
        for number in &forms.numbers.0 {
            if let Value::Length(length) = number {
                let value = system.parameter_value(length, &values);
                assert!(value.is_finite(), "{length:?}:\n{}", sample.declaration);
            }
        }
    }
}

#[test]
fn drawing_reaches_every_kind_of_thing() {
    let wanted = [
        "#[chain(",
        "#[point(",
        "#[mass(",
        "#[pin(",
        "#[equal(angle(",
        "#[constant(",
        "#[gravity(",
        "= floor",
        "= wall(",
        "= slope(",
        "corner(",
        "over = ",
        "facing = ",
        "inertia = ",
        "centre = (",
        "from = horizontal",
        "from = vertical",
        "from = left",
        " -> ",
        "sqrt(",
        "mass = 0,",
        "= -y(",
        "#[mirror(x",
        "#[mirror(y",
        "swap(",
    ];
    reaches(&wanted, Vocabulary::BARS);
}

fn reaches(wanted: &[&str], vocabulary: Vocabulary) {
    let all: String = (0..400).map(|seed| sample_of(seed, vocabulary).declaration).collect();
    let missing: Vec<_> = wanted.iter().filter(|what| !all.contains(**what)).collect();
    assert!(missing.is_empty(), "never drawn in 400 systems: {missing:?}");
}

#[test]
fn drawing_reaches_the_whole_vocabulary() {
    let wanted = [
        "#[body(",
        "#[particle(",
        "#[ground(",
        "#[weld(",
        "#[slider(",
        "= horizontal(",
        "= vertical(",
        "= line(",
        "= bar(",
        "= circle(",
        "= bowl(",
        "= slot(",
        ", rough",
        "restitution = ",
        "law = poisson",
        "#[thread(",
        "#[spring(",
        "damping = ",
        "stiffness = ",
        "#[torsion(",
        "#[force(",
        "frame = ",
        "rate(",
        "vx(",
        "#[couple(",
        "on = ",
        "#[drive(",
        "#[drive(angle(",
        "#[drive(x(",
        "#[section(",
    ];
    reaches(&wanted, Vocabulary::ALL);
}
