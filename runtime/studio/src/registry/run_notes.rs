//! What a run decided that its reader should know.

use liftoff::{LogEntry, LoggedDecision, Trajectory};

/// The decisions that bear on what is printed, each once, with the time it was first taken.
pub fn run_notes(record: &Trajectory) -> Vec<String> {
    let mut found: Vec<(String, f64, usize)> = Vec::new();
    for LogEntry { t, decision } in record.log().iter().filter(|entry| matters(&entry.decision)) {
        let text = decision.to_string();
        match found.iter_mut().find(|(known, ..)| *known == text) {
            Some((.., count)) => *count += 1,
            None => found.push((text, *t, 1)),
        }
    }
    found.into_iter().map(|(text, t, count)| describe_note(&text, t, count)).collect()
}

fn describe_note(text: &str, t: f64, count: usize) -> String {
    match count - 1 {
        0 => format!("at t = {t:.4}: {text}"),
        1 => format!("at t = {t:.4}, and once more: {text}"),
        more => format!("at t = {t:.4}, and {more} times more: {text}"),
    }
}

/// Whether it bears on the numbers or on the end of a run. What is left out changes only how they are computed; a kind of
/// decision that is not named here is told.
fn matters(decision: &LoggedDecision) -> bool {
    use LoggedDecision::{BearingChanged, FrictionAhead, OtherBranch, SingularPosition, SmallPivot};
    !matches!(decision, BearingChanged | FrictionAhead(_) | OtherBranch | SingularPosition | SmallPivot)
}

#[cfg(test)]
mod tests {
    use super::*;
    use liftoff::prelude::*;

    /// A level rod on three supports, which share its weight in any of many ways.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[point(C = AB, at = l / 2)]
    #[support(A = floor)]
    #[support(C = floor)]
    #[support(B = floor)]
    #[figure(A = (-l / 2, 0), B = (l / 2, 0))]
    #[coordinate(phi = angle(AB))]
    #[coordinate(x = x(C))]
    #[coordinate(y = y(C))]
    struct Rod {
        m: f64,
        l: f64,
        g: f64,
    }

    /// A level rod rests with one end on a support; its other end strikes.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[bar(AB, mass = m, length = l)]
    #[support(A = floor, restitution = e)]
    #[support(B = floor, restitution = e)]
    #[figure(A = (-l / 2, 0), B = (l / 2, 0.1))]
    #[coordinate(phi = angle(AB), from = right)]
    #[coordinate(x = x(A))]
    #[coordinate(y = y(A))]
    struct Struck {
        m: f64,
        l: f64,
        e: f64,
        g: f64,
    }

    /// A bracket on a pole, held by the friction of two edges.
    #[derive(BarSystem)]
    #[gravity(g)]
    #[body(arm, points(A = (0, h), B = (d, 0), W = (s, 0)), mass = m, inertia = m * d * d, centre = (s, 0))]
    #[support(upper = wall(0), under = A, facing = left, friction = mu)]
    #[support(lower = wall(d), under = B, facing = right, friction = mu)]
    #[figure(A = (0, h), B = (d, 0), W = (s, 0))]
    #[coordinate(phi = angle(arm), from = right)]
    #[coordinate(y = y(B))]
    #[coordinate(x = x(B))]
    struct Bracket {
        m: f64,
        d: f64,
        h: f64,
        s: f64,
        mu: f64,
        g: f64,
    }

    /// One of them sticks, in the other impacts come one after the other: what was chosen is told, though the run needs no more.
    #[test]
    fn what_was_chosen_is_reported() {
        let struck = Simulation::new(&Struck { m: 1.0, l: 1.0, e: 0.5, g: 9.81 }).unwrap();
        let struck = struck.start(Pose::new("phi", 0.1).with("x", 0.0).with("y", 0.0)).unwrap();
        let told = run_notes(&struck.limit(1.0).run().unwrap());
        assert!(matches!(&told[..], [one] if one.contains("the order of the impacts matters")), "{told:?}");

        let bracket = Bracket { m: 2.0, d: 0.05, h: 0.1, s: 0.3, mu: 0.25, g: 9.81 };
        let bracket = Simulation::new(&bracket).unwrap().start(Pose::new("phi", 0.0).with("y", 0.0)).unwrap();
        let run = bracket.limit(1.0).run().unwrap();
        assert!(run.final_state()[3..].iter().all(|rate| rate.abs() < 1e-12), "{:?}", run.final_state());
        let told = run_notes(&run);
        assert!(told[0].contains("2 motions satisfy the law of friction"), "{told:?}");
    }

    #[test]
    fn reactions_that_are_not_unique_are_reported_once() {
        let rod = Simulation::new(&Rod { m: 1.0, l: 1.0, g: 1.0 }).unwrap().release("C", 0.5).unwrap();
        let told = run_notes(&rod.limit(1.0).run().unwrap());
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].contains("the reactions are not unique; the least-norm ones are given"), "{told:?}");
        assert_eq!(super::describe_note("a", 0.5, 1), "at t = 0.5000: a");
        assert_eq!(super::describe_note("a", 0.5, 3), "at t = 0.5000, and 2 times more: a");
    }
}
