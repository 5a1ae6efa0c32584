use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use super::{Ensemble, Member, MemberError};
use crate::Budget;
use crate::prelude::*;
use crate::system::lanes;

/// A bar hangs from another.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[bar(AB, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l), B = (0, -2 * l))]
#[coordinate(phi_1 = angle(OA), from = down)]
#[coordinate(phi_2 = angle(AB), from = down)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
}

/// A bar that swings.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(OA, mass = m, length = l)]
#[pin(O = (0, 0))]
#[figure(A = (0, -l))]
#[coordinate(phi = angle(OA), from = down)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

/// A particle over a floor.
#[derive(BarSystem)]
#[gravity(g)]
#[particle(P, mass = m)]
#[support(P = floor, restitution = e)]
#[figure(P = (0, h))]
#[coordinate(x = x(P))]
#[coordinate(y = y(P))]
struct Ball {
    m: f64,
    h: f64,
    e: f64,
    g: f64,
}

const MODEL: DoublePendulum = DoublePendulum { m: 1.0, l: 1.0, g: 9.81 };

/// Lengths, starts and ends that differ, so that lanes are refilled at different times.
fn member(i: usize) -> Result<Simulation, MemberError> {
    let x = i as f64;
    let model = DoublePendulum { l: 1.0 + 0.1 * (x * 0.7).sin(), ..MODEL };
    let start = Pose::new("phi_1", 0.5 + 0.05 * x).with("phi_2", 2.0 - 0.03 * x);
    Ok(Simulation::new(&model)?.start(start)?.limit(1.0 + (x * 1.3).sin().abs()).tolerance(1e-10))
}

fn side_by_side<'a, F>(count: usize, member: F) -> Ensemble<'a, F>
where
    F: Fn(usize) -> Result<Simulation, MemberError> + Sync,
{
    Ensemble::new(count, member).side_by_side(lanes::<DoublePendulum>)
}

fn states(ends: &[Result<Member, MemberError>]) -> Vec<Vec<f64>> {
    ends.iter().map(|end| end.as_ref().expect("a smooth motion").state.clone()).collect()
}

fn on_threads<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads").install(run)
}

/// Against runs by themselves, which use another order and other steps; a tenth of the tolerance
/// per step is what both allow, some ten steps stretch it a hundredfold.
#[test]
fn members_end_where_they_end_alone() {
    let ends = side_by_side(40, member).run();
    for (i, end) in ends.into_iter().enumerate() {
        let end = end.unwrap();
        let alone = member(i).unwrap().tolerance(1e-13).run().unwrap();
        assert_eq!(end.t, alone.end_time());
        for (x, y) in end.state.iter().zip(alone.final_state()) {
            assert!((x - y).abs() < 1e-8, "{i}: {x} for {y}");
        }
    }
}

#[test]
fn bits_depend_neither_on_threads_nor_on_neighbours() {
    let all = states(&on_threads(1, || side_by_side(50, member).run()));
    assert_eq!(all, states(&on_threads(3, || side_by_side(50, member).run())));
    for i in [0, 7, 8, 33] {
        let alone = states(&side_by_side(1, |_| member(i)).run());
        assert_eq!(alone[0], all[i], "{i} beside nothing");
        let other = states(&side_by_side(11, |k| member(if k == 5 { i } else { k + 20 })).run());
        assert_eq!(other[5], all[i], "{i} beside others");
    }
}

/// Of tolerances side by side each has its own order.
#[test]
fn tolerances_may_differ() {
    let tolerances = [1e-6, 1e-12];
    let ends = side_by_side(20, |i| Ok(member(3)?.tolerance(tolerances[i % 2]))).run();
    let ends = states(&ends);
    assert!(ends.iter().skip(2).enumerate().all(|(i, end)| *end == ends[i % 2]));
    assert_ne!(ends[0], ends[1]);
}

/// What one member has wrong stays its own, in its place: a start, a tolerance, an equilibrium.
#[test]
fn errors_are_kept_in_their_places() {
    let ends = side_by_side(12, |i| {
        let simulation = member(i)?;
        match i {
            3 => Ok(simulation.start(Pose::new("psi", 1.0))?),
            5 => Ok(simulation.tolerance(2.0)),
            7 => Ok(Simulation::new(&MODEL)?),
            9 => Ok(simulation.start(Pose::nominal())?),
            10 => Ok(simulation.start_at(0.5, Pose::new("phi_1", 1.0).with("phi_2", 1.0))?),
            _ => Ok(simulation),
        }
    })
    .run();
    for (i, end) in ends.iter().enumerate() {
        match (i, end) {
            (3 | 7, Err(MemberError::Start(_) | MemberError::Run(_))) | (5, Err(MemberError::Run(_))) => {}
            (3 | 5 | 7, _) => panic!("{i}: {end:?}"),
            // Hangs until its limit; begins later.
            (9, Ok(end)) => assert_eq!(end.state, [0.0; 4]),
            (10, Ok(end)) => {
                let later = Pose::new("phi_1", 1.0).with("phi_2", 1.0);
                let alone = member(10).unwrap().start_at(0.5, later).unwrap().run().unwrap();
                assert_eq!((end.t, &end.state), (alone.end_time(), &alone.final_state()));
            }
            _ => assert!(end.is_ok(), "{i}: {end:?}"),
        }
    }
}

#[test]
fn an_ensemble_stops_when_cancelled() {
    let failing = |i: usize| member(i)?.start(Pose::new("psi", 1.0)).map_err(MemberError::from);
    let run = AtomicUsize::new(0);
    let count = |i: usize| {
        run.fetch_add(1, Ordering::Relaxed);
        failing(i)
    };
    let ends = on_threads(1, || side_by_side(100, count).stop_after(3).run());
    assert_eq!(run.load(Ordering::Relaxed), 3);
    assert_eq!(ends.iter().filter(|end| matches!(end, Err(MemberError::NotRun))).count(), 97);

    let flag = AtomicBool::new(false);
    let told = Mutex::new(Vec::new());
    let progress = |done: usize| {
        told.lock().expect("no thread has panicked").push(done);
        flag.store(done >= 20, Ordering::Relaxed);
    };
    let ends = on_threads(2, || side_by_side(1000, member).progress(&progress).cancel(&flag).run());
    let done = ends.iter().filter(|end| end.is_ok()).count();
    // Those that are in lanes, eight on each of two threads, are not left.
    assert!((20..=36).contains(&done), "{done}");
    let mut told = told.into_inner().expect("no thread has panicked");
    told.sort_unstable();
    assert_eq!(told, (1..=done).collect::<Vec<_>>());
}

/// Members of another model than that whose lanes they are run alone.
#[test]
fn lanes_are_entered_by_their_own_model_only() {
    let other = |i| Ensemble::new(1, move |_| member(i)).side_by_side(lanes::<Pendulum>).run();
    assert_eq!(states(&other(3)), states(&Ensemble::new(1, |_| member(3)).run()));
    assert_ne!(states(&other(3)), states(&side_by_side(1, |_| member(3)).run()));
}

/// What a member has of its own that may end it holds beside others too.
#[test]
fn members_keep_their_budgets_and_are_cancelled() {
    let cancelled = Arc::new(AtomicBool::new(true));
    let ends = side_by_side(6, |i| match i {
        1 => Ok(member(i)?.budget(Budget { steps: 3, ..Budget::default() })),
        4 => Ok(member(i)?.cancel(Arc::clone(&cancelled))),
        _ => member(i),
    })
    .run();
    for (i, end) in ends.iter().enumerate() {
        assert_eq!(end.is_err(), i == 1 || i == 4, "{i}: {end:?}");
    }
}

/// Contacts are met one by one: h = 1, e = ½, the first impact at √(2h/g).
#[test]
fn members_with_contacts_have_events() {
    let ends = Ensemble::new(9, |i| {
        let ball = Ball { m: 1.0, h: 1.0 + i as f64, e: 0.5, g: 9.81 };
        Ok(Simulation::new(&ball)?.limit(1.9 * (2.0 * ball.h / ball.g).sqrt()))
    })
    .run();
    for (i, end) in ends.iter().enumerate() {
        let member = end.as_ref().unwrap();
        let [impact] = &member.events[..] else { panic!("{:?}", member.events) };
        assert_eq!(impact.kind, EventKind::Impact);
        // Rounding of the root.
        assert!((impact.t - (2.0 * (1.0 + i as f64) / 9.81).sqrt()).abs() < 1e-12);
    }
}

/// Outputs at the end, of what is integrated in lanes and of what runs alone.
#[test]
fn outputs_are_those_of_the_end() {
    let output = || Output::parse(DoublePendulum::LAYOUT, "T + V").unwrap();
    let ends = side_by_side(4, |i| if i < 2 { member(i) } else { Ok(member(i)?.until("t = 0.5")?) })
        .outputs(vec![output()])
        .run();
    for (i, end) in ends.into_iter().enumerate() {
        let end = end.unwrap();
        let alone = member(i).unwrap().run().unwrap();
        let start = alone.value(&output(), 0.0);
        // The energy is kept within the tolerance of some ten steps, and is of the order of m g l.
        assert!((end.outputs[0] - start).abs() < 1e-7, "{i}: {} for {start}", end.outputs[0]);
        assert_eq!(end.t == 0.5, i >= 2);
    }
}

/// At an angle of 1e9 the rounding of the angle changes the energy by more than ten tolerances:
/// beside others as alone.
#[test]
fn a_member_that_loses_its_energy_is_refused_side_by_side_too() {
    let given = |i: usize| {
        let turns = [0.0, 1e9][i % 2];
        let start = Pose::new("phi_1", 0.5 + turns).with("phi_2", 2.0 + turns);
        Ok(Simulation::new(&MODEL)?.start(start)?.limit(2.0).tolerance(1e-12))
    };
    let (beside, alone) = (side_by_side(4, given).run(), Ensemble::new(4, given).run());
    for (i, (beside, alone)) in beside.iter().zip(&alone).enumerate() {
        assert_eq!(beside.is_ok(), i % 2 == 0, "{i}");
        assert_eq!(
            beside.as_ref().err().map(ToString::to_string),
            alone.as_ref().err().map(ToString::to_string)
        );
    }
}
