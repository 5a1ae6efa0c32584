//! What is said of conditions, and of first integrals.

use liftoff_codegen::algebra::printed;
use liftoff_codegen::math::Math;

use super::{Section, Statement};
use crate::FirstIntegrals;
use crate::conditions::{Coincidence, Condition, Conditions};
use crate::integrals::Kind;
use crate::numeric::zeros::{First, Numbers};

impl Conditions {
    /// All that is said of it.
    pub fn section(&self) -> Section {
        let mut statements: Vec<Statement> = self.motion.iter().map(Statement::equation).collect();
        for condition in &self.reactions {
            statements.extend(of_condition(condition));
        }
        for pair in &self.pairs {
            statements.extend(of_pair(self, pair));
        }
        statements.extend(self.numbers.iter().flat_map(|numbers| self.of_numbers(numbers)));
        Section { title: self.phase.clone(), statements }
    }

    fn reaction(&self, label: &str) -> Math {
        let found = self.reactions.iter().find(|condition| condition.label == label);
        found.map_or_else(|| Math::named("N", label), |condition| condition.reaction.left.clone())
    }

    fn of_numbers(&self, numbers: &Numbers) -> Vec<Statement> {
        let name = &self.coordinate;
        let zeros = numbers.zeros.iter().map(|(label, zeros)| {
            let statement = Statement::default().formula(&self.reaction(label));
            let listed = zeros.iter().map(|zero| match zero.multiplicity {
                1 => format!("{}", zero.at),
                2 => format!("{} (double)", zero.at),
                k => format!("{} ({k}-fold)", zero.at),
            });
            match zeros.is_empty() {
                true => statement.and("has no zero"),
                false => {
                    let listed = listed.collect::<Vec<_>>().join(", ");
                    statement.and("vanishes at").formula(name).and(&format!("= {listed}"))
                }
            }
        });
        let stationary = numbers.stationary.iter().filter(|(_, places)| !places.is_empty());
        let stationary = stationary.map(|(label, places)| {
            let listed: Vec<String> =
                places.iter().map(|place| format!("{} ({})", place.at, place.reaction)).collect();
            let about =
                Statement::default().formula(&self.reaction(label)).and("is stationary, with this value, at");
            about.formula(name).and(&format!("= {}", listed.join(", ")))
        });
        let directions = ["falling", "rising"].into_iter().zip(&numbers.first);
        let first = directions.filter_map(|(direction, first)| {
            let begin =
                Statement::default().formula(name).and(&format!("{direction} from {}:", numbers.start));
            let at = |begin: Statement, at: f64| begin.formula(name).and(&format!("= {at}"));
            Some(match first.as_ref()? {
                First::Opens { at: place, contacts } => {
                    let one = contacts.len() == 1 && !contacts[0].contains(',');
                    let verb = if one { "opens" } else { "open" };
                    at(begin.and(&format!("{} {verb} first, at", contacts.join(", "))), *place)
                }
                First::Rests { at: place } => at(begin.and("nothing opens before it rests at"), *place),
                First::Never => begin.and("nothing opens"),
            })
        });
        zeros.chain(stationary).chain(first).collect()
    }
}

fn of_condition(condition: &Condition) -> Vec<Statement> {
    let equations = condition.total.iter().chain([&condition.reaction]);
    let mut statements: Vec<Statement> = equations.map(Statement::equation).collect();
    let reaction = &condition.reaction.left;
    let about = || Statement::default().formula(reaction);
    match &condition.vanishes {
        None => statements.push(about().and("vanishes for no positive parameters")),
        Some(zero) => statements.push(about().and("vanishes where").then(zero)),
    }
    match &condition.double {
        Some(_) if condition.vanishes.is_none() => {}
        Some(factors) if factors.is_empty() => {
            statements.push(about().and("touches zero for no positive parameters"));
        }
        Some(factors) => statements.push(about().and("touches zero only where").one_of(factors)),
        None => {}
    }
    statements
}

fn of_pair(conditions: &Conditions, pair: &Coincidence) -> Vec<Statement> {
    let [one, other] = pair.labels.each_ref().map(|label| conditions.reaction(label));
    let both = || Statement::default().formula(&one).and("and").formula(&other);
    if let Some(multiple) = &pair.always {
        return vec![Statement::equation(multiple)];
    }
    let mut statements: Vec<Statement> = pair
        .proportional
        .iter()
        .map(|(place, multiple)| match multiple {
            Some(multiple) => Statement::equation(multiple).and("where").then(place),
            None => both().and("are multiples of each other where").then(place),
        })
        .collect();
    match &pair.together {
        Some(factors) if factors.is_empty() && !pair.proportional.is_empty() => {
            statements.push(both().and("vanish at one position for no other positive parameters"));
        }
        Some(factors) if factors.is_empty() => {
            statements.push(both().and("vanish at one position for no positive parameters"));
        }
        Some(factors) => statements.push(both().and("vanish at one position only where").one_of(factors)),
        None => {}
    }
    statements
}

impl FirstIntegrals {
    /// All of them, line by line.
    pub fn section(&self) -> Section {
        let statements = self.integrals.iter().map(|integral| {
            let what = match &integral.kind {
                Kind::Energy => "energy".to_owned(),
                Kind::Momentum(parts) => match parts.as_slice() {
                    [(_, name)] => format!("momentum of the cyclic coordinate {}", printed(name, 0)),
                    parts => {
                        let part = |(k, name): &(i64, String)| {
                            let sign = match k {
                                1 => String::new(),
                                -1 => "−".to_owned(),
                                k => k.to_string().replace('-', "−"),
                            };
                            format!("{sign}{}", printed(name, 0))
                        };
                        format!("momentum along ({})", parts.iter().map(part).collect::<Vec<_>>().join(", "))
                    }
                },
                Kind::InternalEnergy => "energy about the mass centre".to_owned(),
            };
            Statement::equation(&integral.equation).and(&format!("({what})"))
        });
        Section { title: self.phase.clone(), statements: statements.collect() }
    }
}
