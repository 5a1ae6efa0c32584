//! A model that can be run by the names of things.

use super::dimension::{Dimension, of_parameters};
use super::energy_rate::energy_rate;
use super::origin::{Derived, Origin};
use super::run_spec::TIME;
use super::{Configuration, MethodId, MotionError, PrecisionSpec, RunOptions};
use super::{chain, input, stopped};
use crate::run_spec::{PointImpulse, RunSpec, Values};
use core::ops::ControlFlow;
use liftoff::NameError;
use liftoff::Observer;
use liftoff::Scales;
use liftoff::{Modes, Output, OutputError, Pose, Simulation, Trajectory};
use liftoff_core::model::{ContactSet, Form, Layout};
use liftoff_core::scalar::{DoubleDouble, Dual4};
use liftoff_core::system::{Model, ModelOn, System};
use liftoff_interpreter::Interpreted;
use liftoff_verification::judgement::witness;
use liftoff_verification::precision::check_tolerance;
use liftoff_verification::{Measurement, Precision};
use std::sync::Arc;

/// Distance of neighbouring numbers that are still angles to three digits, rad.
const COARSEST: f64 = 1e-3;

/// A model with its default run.
#[derive(Clone)]
pub struct Entry {
    name: String,
    default_run: RunSpec,
    origin: Arc<dyn Origin>,
    source: Option<&'static str>,
}

impl Entry {
    pub(super) fn new(origin: Arc<dyn Origin>, default_run: RunSpec) -> Self {
        Self { name: kebab(origin.layout().name), default_run, origin, source: None }
    }

    /// A model that no compiler has seen, with the run that it declares.
    pub fn interpreted(model: Arc<Interpreted>) -> Self {
        let layout = model.layout();
        Self::deferred(kebab(layout.name), RunSpec::declared(layout), || model)
    }

    /// A model that is derived when its equations are first needed.
    pub fn deferred(
        name: String,
        default_run: RunSpec,
        derive: impl FnOnce() -> Arc<Interpreted> + Send + 'static,
    ) -> Self {
        Self { name, default_run, origin: Arc::new(Derived::new(Box::new(derive))), source: None }
    }

    /// The same model with another default run.
    #[must_use]
    pub fn with_default_run(self, default_run: RunSpec) -> Self {
        Self { default_run, ..self }
    }

    /// The same model with the text that declares it.
    #[must_use]
    pub fn with_source(self, source: &'static str) -> Self {
        Self { source: Some(source), ..self }
    }

    /// The text that declares it, where the program has it.
    pub fn source(&self) -> Option<&'static str> {
        self.source
    }

    /// Name on the command line, in kebab case.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The first line of its doc comment.
    pub fn summary(&self) -> &'static str {
        self.layout().summary
    }

    /// The names of its coordinates, supports and points.
    pub fn layout(&self) -> &'static Layout {
        self.origin.layout()
    }

    /// The run without options; without values if the model declares none.
    pub fn default_run(&self) -> RunSpec {
        self.default_run.clone()
    }

    /// Whether a compiler has seen its equations; else they are interpreted.
    pub fn is_compiled(&self) -> bool {
        self.origin.lanes().is_some()
    }

    /// The model with these parameters.
    ///
    /// # Errors
    /// Parameters that it does not have, or that are not given.
    pub fn model(&self, parameters: &Values) -> Result<Model, MotionError> {
        model(&*self.origin, parameters)
    }

    /// Its equations in double-double, with these parameters.
    ///
    /// # Errors
    /// Parameters that it does not have, or that are not given; the declaration cannot be derived
    /// again.
    pub fn precise(&self, parameters: &Values) -> Result<Arc<dyn System<DoubleDouble>>, MotionError> {
        Ok(self.for_interpreter()?.precise(&self.model(parameters)?.parameters))
    }

    /// The model on values with their derivatives, given those of all parameters in the order of
    /// the layout.
    ///
    /// # Errors
    /// The declaration cannot be derived again.
    pub fn varied(&self, parameters: &[Dual4]) -> Result<ModelOn<Dual4>, MotionError> {
        Ok(self.for_interpreter()?.varied(parameters))
    }

    /// The simulation that a run asks for.
    ///
    /// # Errors
    /// It asks for what the model does not have, or what makes no sense.
    pub fn simulation(&self, spec: &RunSpec) -> Result<Simulation, MotionError> {
        simulation(self.model(&spec.parameters)?, spec)
    }

    /// The same with these options.
    ///
    /// # Errors
    /// As for [`Self::simulation`].
    pub fn simulation_by(&self, options: RunOptions, spec: &RunSpec) -> Result<Simulation, MotionError> {
        Ok(options.apply(self.simulation(spec)?))
    }

    /// Positions of all points at the start of a run.
    pub fn configuration(&self, spec: &RunSpec) -> Result<Configuration, MotionError> {
        let simulation = self.simulation(spec)?;
        let start = simulation.start_state().map_err(input)?;
        Ok(Configuration::new(simulation.model(), &start))
    }

    /// Its contact sets, with the parameters of a run.
    pub fn modes(&self, spec: &RunSpec) -> Result<Modes, MotionError> {
        liftoff::modes(self.model(&spec.parameters)?).map_err(input)
    }

    /// Whether this is an output of the model; why not, if it is none.
    pub fn check(&self, output: &str) -> Result<(), MotionError> {
        Ok(Output::parse(self.layout(), output).map(drop)?)
    }

    /// Runs it by the method that the product chooses.
    pub fn run(&self, spec: &RunSpec) -> Result<Trajectory, MotionError> {
        self.run_by(RunOptions::default(), spec)
    }

    /// Runs it with these options.
    pub fn run_by(&self, options: RunOptions, spec: &RunSpec) -> Result<Trajectory, MotionError> {
        self.simulation_by(options, spec)?.run().map_err(stopped)
    }

    /// Runs it by a method, for a case that the judge follows.
    pub fn run_witnessed(&self, by: MethodId, spec: &RunSpec) -> Result<Trajectory, MotionError> {
        let simulation = self.simulation(spec)?.method(by);
        let run = simulation.run().map_err(stopped)?;
        witness(&run, &simulation.held());
        Ok(run)
    }

    /// Runs it with these options and keeps the events and the last state alone: however long the
    /// run, it takes no more memory than its events do. The observer sees each step; `&mut ()`
    /// looks at none.
    pub fn observe_by(
        &self,
        options: RunOptions,
        spec: &RunSpec,
        observer: &mut impl Observer,
    ) -> Result<Trajectory, MotionError> {
        self.simulation_by(options, spec)?.observe(observer).map_err(stopped)
    }

    /// Measures all of its error against its run time.
    pub fn precision(
        &self,
        spec: &RunSpec,
        request: &PrecisionSpec,
    ) -> Result<Vec<Measurement>, MotionError> {
        self.measure(spec, request, &mut || ControlFlow::Continue(()))
    }

    /// Measures its error against its run time, method by method and tolerance by tolerance, until
    /// `go_on` breaks; that is asked before each in each of the
    /// [rounds](liftoff_verification::precision::ROUNDS).
    pub fn measure(
        &self,
        spec: &RunSpec,
        request: &PrecisionSpec,
        go_on: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Vec<Measurement>, MotionError> {
        request.check().map_err(input)?;
        let interpreted = self.for_interpreter()?;
        let precision =
            Precision::new(self.simulation(spec)?, |parameters: &[f64]| interpreted.precise(parameters));
        Ok(precision.measuring(request.measuring).measure_all(request, go_on))
    }

    /// The same against a closed form of the state, coordinates then rates.
    pub fn precision_against(
        &self,
        spec: &RunSpec,
        request: &PrecisionSpec,
        state: impl Fn(f64) -> Vec<DoubleDouble>,
    ) -> Result<Vec<Measurement>, MotionError> {
        request.check().map_err(input)?;
        let precision = Precision::against(self.simulation(spec)?, state).map_err(input)?;
        Ok(precision.measuring(request.measuring).measure_all(request, &mut || ControlFlow::Continue(())))
    }

    /// The natural length, time and mass of a run: the units in which tolerances are absolute.
    pub fn units(&self, spec: &RunSpec) -> Result<[f64; 3], MotionError> {
        let Scales { length, time, mass, .. } = self.simulation(spec)?.scales();
        Ok([length, time, mass])
    }

    /// The dimension of each parameter; none where the model has numbers with a dimension in it.
    pub fn dimensions(&self) -> Option<Vec<Dimension>> {
        of_parameters(self.layout())
    }

    /// How fast a phase gains energy at a state, by its equations.
    pub fn energy_rate(
        &self,
        spec: &RunSpec,
        set: ContactSet,
        t: f64,
        state: &[f64],
    ) -> Result<f64, MotionError> {
        let simulation = self.simulation(spec)?;
        let phase = Arc::clone(&simulation.model().system).phase(set, Form::Multipliers);
        Ok(energy_rate(&*phase, &self.layout().state_at(state, t), simulation.scales().time))
    }

    fn for_interpreter(&self) -> Result<Arc<Interpreted>, MotionError> {
        self.origin.interpreted().map_err(MotionError::Input)
    }

    /// How its motions are integrated side by side, if they can be.
    pub(crate) fn lanes(&self) -> Option<liftoff_core::system::LaneConstructor> {
        self.origin.lanes()
    }
}

fn simulation(model: Model, spec: &RunSpec) -> Result<Simulation, MotionError> {
    check_tolerance(spec.tolerance).map_err(input)?;
    for values in [&spec.start, &spec.energy_of] {
        check_angles(model.layout(), values)?;
    }
    let mut run = Simulation::new(model)
        .map_err(input)?
        .tolerance(spec.tolerance)
        .start_at(spec.begin(), pose(&spec.start))
        .map_err(input)?;
    if !spec.energy_of.is_empty() {
        run = run.on_energy_of(pose(&spec.energy_of)).map_err(input)?;
    }
    for support in &spec.hold {
        run = run.hold(support).map_err(input)?;
    }
    for (support, at) in &spec.release {
        run = run.release(support, *at).map_err(input)?;
    }
    for (thread, condition) in &spec.cut {
        run = run.cut(thread, condition).map_err(input)?;
    }
    for PointImpulse { point, impulse, at } in &spec.impulses {
        run = run.impulse(point, *impulse, *at).map_err(input)?;
    }
    if let Some(limit) = spec.limit {
        run = run.limit(limit);
    }
    if spec.stop_at_impacts {
        run = run.stop_at_impacts();
    }
    for condition in &spec.until {
        run = run.until(condition).map_err(|error| of_condition(condition, error))?;
    }
    Ok(run)
}

/// Says which of the conditions is wrong: a declaration, an option or a caller has given it.
fn of_condition(condition: &str, error: OutputError) -> MotionError {
    match error {
        OutputError::Constant { .. } => input(error),
        _ => MotionError::Input(format!("until `{condition}`: {}", chain(&error))),
    }
}

fn model(origin: &dyn Origin, parameters: &Values) -> Result<Model, MotionError> {
    let names = origin.layout().parameters;
    let stranger = parameters.iter().find(|(name, _)| !names.contains(&name.as_str()));
    if let Some((name, _)) = stranger {
        return Err(input(NameError::new("parameter", name, names.iter().copied())));
    }
    let value =
        |name: &&str| parameters.iter().rev().find(|(given, _)| given == name).map(|(_, value)| *value);
    let missing = |name: &&str| MotionError::Input(missing_parameter(name));
    let values: Result<Vec<f64>, _> =
        names.iter().map(|name| value(name).ok_or_else(|| missing(name))).collect();
    Ok(origin.build(&values?))
}

/// What is said of a parameter without a value.
pub(crate) fn missing_parameter(name: &str) -> String {
    format!("parameter `{name}` is not given: set it, `{name} = 1`, or declare it with `#[value = 1]`")
}

/// Refuses angles so large that neighbouring numbers are different angles.
fn check_angles(layout: &Layout, values: &Values) -> Result<(), MotionError> {
    let apart = |value: f64| f64::EPSILON * value.abs();
    let lost = values
        .iter()
        .find(|(name, value)| value.is_finite() && apart(*value) > COARSEST && layout.is_angle(name));
    match lost {
        Some((name, value)) => Err(MotionError::Input(format!(
            "{name} = {value:e}: numbers there are {:.1e} rad apart, so an angle has no digits left",
            apart(*value)
        ))),
        None => Ok(()),
    }
}

fn pose(values: &Values) -> Pose {
    let given = values.iter().filter(|(name, _)| name != TIME);
    given.fold(Pose::nominal(), |pose, (name, value)| pose.with(name, *value))
}

/// `StepLadder` as `step-ladder`.
pub fn kebab(name: &str) -> String {
    let mut kebab = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !kebab.is_empty() {
            kebab.push('-');
        }
        kebab.extend(letter.to_lowercase());
    }
    kebab
}
