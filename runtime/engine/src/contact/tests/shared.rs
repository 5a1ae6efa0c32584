//! Loads that contacts with friction share.

use crate::contact::friction::SlipVelocity;
use crate::contact::{ContactProblem, decide};
use crate::model::ContactSet;
use crate::prelude::*;
use crate::system::Model;

/// A rod on three supports, pushed along at its middle.
#[derive(BarSystem)]
#[gravity(g)]
#[bar(AB, mass = m, length = 2 * l)]
#[point(C = AB, at = l)]
#[support(A = floor, friction = mu)]
#[support(B = floor, friction = mu)]
#[support(C = floor, friction = mu)]
#[force(C = (p, 0))]
#[coordinate(x = x(C))]
#[coordinate(y = y(C))]
#[coordinate(theta = angle(AB), from = right)]
#[figure(A = (-l, 0), B = (l, 0))]
pub(in crate::contact) struct Pushed {
    pub(in crate::contact) m: f64,
    pub(in crate::contact) l: f64,
    pub(in crate::contact) g: f64,
    pub(in crate::contact) mu: f64,
    pub(in crate::contact) p: f64,
}

/// However the supports share the weight, each rubs by its own part of it: R = −σ μ N where they
/// slide, |R| ≤ μ N where they stick, with ΣN = m g, no moment, and ΣR = −p.
#[test]
fn each_support_rubs_by_its_own_share() {
    let (m, g, mu) = (2.0, 9.81, 0.3);
    let weight = m * g;
    for (known, sense) in
        [(SlipVelocity::Forward, 1.0), (SlipVelocity::Backward, -1.0), (SlipVelocity::Rest, 0.0)]
    {
        for part in [0.0, 0.9, -0.9] {
            let p = part * mu * weight;
            let model = Model::new(&Pushed { m, l: 0.7, g, mu, p });
            let x = model.layout().coordinates.iter().position(|it| it.name == "x").unwrap();
            let mut state = [0.0; 6];
            state[3 + x] = sense;
            let touching: ContactSet = (0..3).collect();
            let slips = [0, 1, 2].map(|contact| (contact, known));
            let question = ContactProblem { touching, slips: &slips, ..ContactProblem::default() };
            let found = decide(&model, &state, &question).unwrap();
            let note = format!("{known:?} {part} {:?}", found.reactions);
            assert!(found.closed.len() == 3 && !found.unique, "{note}");
            let [normals, frictions] = [&found.reactions[..3], &found.reactions[3..]];
            assert!((normals.iter().sum::<f64>() - weight).abs() < 1e-11 * weight, "{note}");
            assert!((normals[0] - normals[1]).abs() < 1e-11 * weight, "{note}");
            for (normal, friction) in normals.iter().zip(frictions) {
                let slack = 1e-11 * weight;
                assert!(*normal > -slack && friction.abs() <= mu * normal + slack, "{note}");
                assert!(sense == 0.0 || (friction + sense * mu * normal).abs() < slack, "{note}");
            }
            let across: f64 = frictions.iter().sum();
            let expected = if sense == 0.0 { -p } else { -sense * mu * weight };
            assert!((across - expected).abs() < 1e-11 * weight, "{note}");
        }
    }
}
