//! A derived model without values of its parameters.

use std::sync::Arc;

use liftoff_codegen::{Analysis, numbers};
use liftoff_core::model::{ContactSet, Layout};
use liftoff_core::scalar::{DoubleDouble, Dual4};
use liftoff_core::system::{Model, ModelOn, System, TimeSeries};

use crate::code::Code;
use crate::constants::{Constants, of_parameters};
use crate::layout;
use crate::numbers::ParameterNumbers;
use crate::pool::Number;
use crate::system::{Evaluator, FullCode, PhaseCode};

/// A derived model that is run by interpretation.
#[derive(Debug)]
pub struct Interpreted {
    pub(crate) layout: &'static Layout,
    pub(crate) constants: Constants,
    pub(crate) full: FullCode,
    pub(crate) phases: Vec<PhaseCode>,
    numbers: ParameterNumbers,
    restitution: Option<Code>,
}

/// Values as numbers `S`.
fn on<S: Number>(values: &[f64]) -> Vec<S> {
    values.iter().map(|&value| S::from_f64(value)).collect()
}

impl Interpreted {
    /// What was derived of a declaration. Its names are kept as long as the program runs, once for
    /// each declaration.
    pub fn from_analysis(analysis: &Analysis) -> Arc<Self> {
        let functions = &analysis.functions;
        let (parameters, contacts) = (analysis.system.parameters.len(), analysis.motion.contacts.len());
        let mut outputs = functions.outputs();
        outputs.extend(functions.kinks.iter().map(|kink| kink.value()));
        let constants = Constants::collect(&functions.program, &outputs, parameters, contacts);
        let full = FullCode::lower(analysis, &constants.ids);
        let phases = functions.phases.iter().map(|phase| PhaseCode::lower(analysis, &constants.ids, phase));
        Arc::new(Self {
            layout: layout::build_layout(analysis),
            phases: phases.collect(),
            numbers: ParameterNumbers::from_analysis(analysis),
            restitution: numbers::restitution(analysis).map(|numbers| of_parameters(&numbers, parameters)),
            full,
            constants,
        })
    }

    /// Names of everything.
    pub fn layout(&self) -> &'static Layout {
        self.layout
    }

    /// The model with these values of its parameters, in the order of the layout; what is missing
    /// is not a number.
    pub fn model(self: &Arc<Self>, parameters: &[f64]) -> Model {
        let nominal = self.numbers.nominal(parameters);
        Model {
            system: Arc::new(Evaluator::<f64>::new(self, parameters, ContactSet::EMPTY)),
            series: Arc::new(Evaluator::<TimeSeries>::new(self, &on(parameters), ContactSet::EMPTY)),
            parameters: parameters.to_vec(),
            restitution: self.restitution(parameters),
            measures: self.numbers.measures(parameters, &nominal),
            numbers: self.numbers.drawn(parameters),
            nominal,
        }
    }

    /// Its equations in double-double, with these values of its parameters.
    pub fn precise(self: &Arc<Self>, parameters: &[f64]) -> Arc<dyn System<DoubleDouble>> {
        Arc::new(Evaluator::<DoubleDouble>::new(self, &on(parameters), ContactSet::EMPTY))
    }

    /// The model on values with their derivatives, given those of its parameters.
    pub fn varied(self: &Arc<Self>, parameters: &[Dual4]) -> ModelOn<Dual4> {
        ModelOn {
            system: Arc::new(Evaluator::<Dual4>::new(self, parameters, ContactSet::EMPTY)),
            parameters: parameters.to_vec(),
            restitution: self.restitution(parameters),
        }
    }

    /// Restitution of each contact, then the tangential one of each with friction.
    fn restitution<S: Number>(&self, parameters: &[S]) -> Vec<S> {
        let mut restitution = vec![S::ZERO; self.layout.reactions()];
        if let Some(code) = &self.restitution {
            code.evaluate(&[], &[parameters], &mut restitution);
        }
        restitution
    }
}
