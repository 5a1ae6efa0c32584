//! Which rows have a closed form, and on which branch.

use core::f64::consts::PI;
use std::collections::BTreeMap;

use super::super::reduction::solve;
use super::super::rules::solved;
use super::super::{CoordinateValue, Phase, SLIDING, rows};
use super::laws::MORE;
use super::phase;
use crate::Analysis;
use crate::algebra::{Angle, Quotient, Series, Symbol};
use crate::kinematics::nominal_values;
use crate::tests::scenes::{OTHERS, SCENES};
use crate::tests::{PAIR, analysis};

/// A crank's end on the floor: sin φ + sin ψ = 0.
fn crank(figure: &str) -> Analysis {
    crank_read("angle(AB)", figure)
}

fn crank_read(psi: &str, figure: &str) -> Analysis {
    let height = if figure.contains('h') { "h: f64," } else { "" };
    analysis(&format!(
        "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[bar(AB, mass = m, length = l)] #[pin(O = (0, 0))] #[support(B = floor)]
         #[coordinate(phi = angle(OA))] #[coordinate(psi = {psi})] #[figure({figure})] struct Crank {{ m: f64, l: f64, {height} g: f64 }}"
    ))
}

/// Coordinates, and parameters, in the figure.
fn figure(analysis: &Analysis) -> BTreeMap<Symbol, f64> {
    let Analysis { system, kinematics, .. } = analysis;
    nominal_values(system, &system.samples[0], &kinematics.nominal(system, &system.samples[0]))
}

/// What the figure shows closed has the same coordinates in its closed form.
fn keeps_its_figure(analysis: &Analysis, phase: &Phase) -> bool {
    let values = figure(analysis);
    let of = |symbol: Symbol| values.get(&symbol).copied().unwrap_or(f64::NAN);
    let gaps = rows(&analysis.motion, phase.set).into_iter();
    if gaps
        .map(|row| analysis.motion.rows[row].gap.evaluate(&of).abs())
        .any(|gap| gap.is_nan() || gap >= 1e-9)
    {
        return false;
    }
    for (i, coordinate) in phase.coordinates.iter().enumerate() {
        let shown = of(Symbol::coordinate(i));
        let apart = match coordinate {
            CoordinateValue::Length(length) | CoordinateValue::Rate(length) => length.evaluate(&of) - shown,
            CoordinateValue::Angle(angle) => (angle.evaluate(&of) - shown + PI).rem_euclid(2.0 * PI) - PI,
        };
        assert!(apart.abs() < 1e-9, "{}, {:?}: {i} is {apart} away", analysis.system.ident, phase.set);
    }
    true
}

#[test]
fn closed_forms_are_on_the_branch_of_the_figure() {
    let cranks = ["A = (3 * l / 5, 4 * l / 5), B = (6 * l / 5, 0)", "A = (3 * l / 5, 4 * l / 5), B = (0, 0)"];
    let walls = ["B = (0, 8 * l / 5)", "B = (0, 0)"].map(|b| {
        "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[bar(BA, mass = m, length = l)] #[pin(O = (0, 0))]
         #[support(B = wall(0), facing = right)] #[coordinate(psi = angle(BA))] #[figure(A = (3 * l / 5, 4 * l / 5), FIGURE)]
         struct Wall { m: f64, l: f64, g: f64 }".replace("FIGURE", b)
    });
    let upright = ["l", "-l"].map(|height| {
        "#[gravity(g)] #[bar(OA, mass = m, length = l)] #[pin(O = (0, 0))] #[support(A = wall(0), facing = right)]
         #[coordinate(phi = angle(OA))] #[figure(A = (0, HEIGHT))] struct Upright { m: f64, l: f64, g: f64 }".replace("HEIGHT", height)
    });
    let walls = walls.iter().chain(&upright).map(|wall| analysis(wall));
    let others = SCENES.iter().chain(&OTHERS).chain(&MORE).map(|declaration| analysis(declaration));
    let all = cranks.into_iter().map(crank).chain(walls).chain(others);
    let shown =
        all.map(|analysis| analysis.phases.iter().filter(|phase| keeps_its_figure(&analysis, phase)).count());
    let shown: Vec<_> = shown.collect();
    assert!(shown[..6] == [2; 6] && shown[6..].iter().sum::<usize>() > 30, "{shown:?}");
}

/// The angles of the first two figures are the same whatever l is; h changes that of the third.
#[test]
fn branches_are_checked_where_parameters_may_change_them() {
    let branch = |figure: &str| {
        let crank = crank(figure);
        phase(&crank, 1).unwrap().eliminated[0].branch.clone()
    };
    assert_eq!(branch("A = (3 * l / 5, 4 * l / 5), B = (6 * l / 5, 0)"), None);
    assert_eq!(branch("A = (3 * l / 5, 4 * l / 5), B = (0, 0)"), None);
    let checked = branch("A = (sqrt(l * l - h * h), h), B = (2 * sqrt(l * l - h * h), 0)").unwrap();
    let sum = |quarters| {
        Angle::from_symbol(Symbol::coordinate(0))
            + Angle::from_symbol(Symbol::coordinate(1))
            + Angle::quarters(quarters)
    };
    assert!([sum(0), -&sum(0)].contains(&checked.zero), "{checked:?}");
    assert_ne!(checked.zero, checked.other);
}

/// With both bars upright ψ = −φ and ψ = φ + π are equally near.
#[test]
fn of_branches_equally_near_the_first_is_taken() {
    let crank = crank("A = (0, l), B = (0, 0)");
    let CoordinateValue::Angle(angle) = &phase(&crank, 1).unwrap().eliminated[0].value else { panic!() };
    assert_eq!(angle, &(Angle::from_symbol(Symbol::coordinate(0)) + Angle::quarters(2)));
}

/// a sin φ + b sin ψ = 0 and sin φ = cos ψ are left to the projected form.
#[test]
fn waves_of_other_sizes_or_kinds_are_not_equated() {
    let rods = analysis(OTHERS[5]);
    let ends = rods.motion.contacts.iter().map(|contact| contact.label(&rods.system));
    assert_eq!(ends.collect::<Vec<_>>(), ["A", "C", "B"]);
    assert!(phase(&rods, 0b011).is_none() && phase(&rods, 0b101).is_some());
    let mixed = crank_read("angle(AB), from = down", "A = (3 * l / 5, 4 * l / 5), B = (6 * l / 5, 0)");
    assert!(phase(&mixed, 1).is_none() && phase(&mixed, 0).is_some());
}

#[test]
fn of_more_contacts_that_slide_there_is_no_closed_form() {
    let body = |i: usize| {
        format!(
            "#[particle(P{i}, mass = m)] #[support(P{i} = floor, friction = mu)] #[figure(P{i} = ({i}, 0))] "
        )
    };
    let beads: String = (0..SLIDING + 1).map(body).collect();
    let beads = analysis(&format!("#[gravity(g)] {beads} struct Beads {{ m: f64, mu: f64, g: f64 }}"));
    let most = beads.phases.iter().map(|phase| phase.sliding.len()).max();
    assert_eq!(most, Some(SLIDING));
    assert!(phase(&beads, 0b111).is_some());
}

#[test]
fn sets_with_own_code_are_as_many_as_declared() {
    for most in [1, 2, 3] {
        let declaration = OTHERS[5].replace("struct", &format!("#[liftoff(sets = {most})] struct"));
        assert_eq!(analysis(&declaration).phases.len(), most);
    }
}

/// (l cos φ + m) q + r = 0 where l = 2, m = 3, φ = 1: the pivot has two terms, and (l cos φ + m) /
/// (l + m) of its largest value; m q + r = 0 is better.
#[test]
fn pivots_cost_what_they_may_lose() {
    let [m, l, q, r] =
        [Symbol::parameter(0), Symbol::parameter(1), Symbol::coordinate(1), Symbol::parameter(2)];
    let values = BTreeMap::from([(m, 3.0), (l, 2.0), (Symbol::coordinate(0), 1.0)]);
    let cosine = Series::cos(&Angle::from_symbol(Symbol::coordinate(0)));
    let moving = &(&Series::symbol(l) * &cosine) + &Series::symbol(m);
    let equation = |pivot: &Series| &(pivot * &Series::symbol(q)) + &Series::symbol(r);
    let (value, pivot, (terms, lost)) = solved(&equation(&moving), q, &values).unwrap();
    assert_eq!((pivot, terms), (Some(moving), 2));
    assert!((lost - (1.0 - (2.0 * 1f64.cos() + 3.0) / 5.0)).abs() < 1e-12, "{lost}");
    let at = |symbol| if symbol == r { 7.0 } else { values[&symbol] };
    assert!((value.evaluate(&at) + 7.0 / (2.0 * 1f64.cos() + 3.0)).abs() < 1e-12);
    let (_, pivot, cost) = solved(&equation(&Series::symbol(m)), q, &values).unwrap();
    assert_eq!((pivot, cost), (None, (0, 0.0)));
}

/// x sin γ + y cos γ = 0: on a gentle slope x is no number or loses its digits, and where the slope
/// is steep y does.
#[test]
fn a_gentle_slope_determines_the_height() {
    let slope = analysis(
        "#[gravity(g)] #[particle(P, mass = m)] #[support(P = slope(-gamma), friction = mu)] #[figure(P = (0, 0))]
         struct Slope { m: f64, gamma: f64, mu: f64, g: f64 }",
    );
    let slides = phase(&slope, 1).unwrap();
    let eliminated = slides.eliminated.iter().find(|eliminated| eliminated.row == 0).unwrap();
    let names = slope.kinematics.coordinates.iter().map(|coordinate| coordinate.name.to_string());
    assert_eq!(names.collect::<Vec<_>>()[eliminated.coordinate], "y_P");
    assert_eq!(slides.pivots, [Series::cos(&Angle::from_symbol(Symbol::parameter(1)))]);
}

/// Of a chain from the joint of a pair on two corners: with five links the reaction of both corners
/// has more than 200 terms, with six that of one corner too.
#[test]
fn long_expressions_are_left_to_the_projected_form() {
    let sets = |links: usize| {
        let points = &["D", "E", "F", "G", "H", "I", "J"][..=links];
        let ends = points.windows(2).enumerate();
        let bars: String =
            ends.map(|(i, ends)| format!("#[bar({}, mass = m{i}, length = l)]", ends.concat())).collect();
        let places: String = (1..=links).map(|i| format!(", {} = (0, -{i} * l)", points[i])).collect();
        let masses: String = (0..links).map(|i| format!("m{i}: f64, ")).collect();
        let pair =
            PAIR.replace("#[mirror(x = 0)]", &bars).replace("B = (l, 0)", &format!("B = (l, 0){places}"));
        let chain = analysis(&pair.replace("{ m:", &format!("{{ {masses} m:")));
        chain.phases.iter().map(|phase| phase.set.closed).collect::<Vec<_>>()
    };
    assert_eq!(sets(5), [0b00, 0b01, 0b10]);
    assert_eq!(sets(6), [0b00]);
}

/// φ = a sin ωt: the particle on the bar keeps its place, its contact one of its coordinates.
#[test]
fn a_prescribed_angle_is_eliminated() {
    let shaken = analysis(MORE[3]);
    let kept = |closed| phase(&shaken, closed).unwrap().kept.len();
    assert_eq!((shaken.motion.n, kept(0)), (3, 2));
}

/// x₁ = r₀ and (a + b) x₀ + x₁ = r₁.
#[test]
fn reactions_follow_whatever_the_order_of_their_rows() {
    let of = |i: usize| Series::symbol(Symbol::parameter(i));
    let [zero, one] = [Series::zero(), Series::one()];
    let rows = [[zero, one.clone()], [&of(0) + &of(1), one]];
    let mut matrix = rows.map(|row| row.map(Quotient::from).to_vec());
    let mut right = [of(2), of(3)].map(Quotient::from);
    solve(&mut matrix, &mut right).unwrap();
    let values = [2.0, 3.0, 7.0, 17.0];
    let at =
        |symbol| values.into_iter().enumerate().find(|&(i, _)| Symbol::parameter(i) == symbol).unwrap().1;
    assert_eq!(right.map(|x| x.evaluate(&at)), [2.0, 7.0]);
}
