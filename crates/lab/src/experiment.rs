use crate::error::LabError;
use crate::joint_path::JointPath;
use crate::law::Method;
use crate::limit_use::LimitUse;
use crate::problem::{ControlSettings, Problem};
use crate::robot::describe;
use crate::sampled::{SampledPath, sample};
use crate::scenario::Scenario;
use crate::simulate::simulate;
use crate::trace::Trace;
use slideway_robot::RobotDescription;

/// A scenario made ready to run, for an arm of any supported number of joints.
#[derive(Clone, Debug)]
pub struct Experiment {
    arm: Arm,
    shortest_time: f64,
}

/// The problem with its joint path, by number of joints. The only place that turns a number into a type.
#[derive(Clone, Debug)]
enum Arm {
    One(Box<Traced<1>>),
    Two(Box<Traced<2>>),
    Three(Box<Traced<3>>),
    Four(Box<Traced<4>>),
    Five(Box<Traced<5>>),
    Six(Box<Traced<6>>),
    Seven(Box<Traced<7>>),
}

/// A problem and its joint path.
#[derive(Clone, Debug)]
struct Traced<const N: usize> {
    problem: Problem<N>,
    path: JointPath<N>,
}

/// What an experiment does without knowing the number of joints.
trait AnyJoints {
    fn control(&self) -> ControlSettings;
    fn run(&self, method: Method, shortest_time: f64) -> Result<Trace, LabError>;
    fn sample(&self, intervals: usize, between: usize) -> Result<SampledPath, LabError>;
    fn tool_path(&self, points: usize) -> Vec<[f64; 3]>;
    fn tool_trace(&self, trace: &Trace) -> Vec<[f64; 3]>;
    fn limit_use(&self, trace: &Trace) -> Vec<LimitUse>;
}

impl Experiment {
    /// Validates a scenario and traces its joint path.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, or a path that the robot cannot follow.
    pub fn new(scenario: &Scenario) -> Result<Self, LabError> {
        let robot = describe(scenario)?;
        let arm = match robot.joint_count() {
            1 => Arm::One(Box::new(Traced::new(scenario, &robot)?)),
            2 => Arm::Two(Box::new(Traced::new(scenario, &robot)?)),
            3 => Arm::Three(Box::new(Traced::new(scenario, &robot)?)),
            4 => Arm::Four(Box::new(Traced::new(scenario, &robot)?)),
            5 => Arm::Five(Box::new(Traced::new(scenario, &robot)?)),
            6 => Arm::Six(Box::new(Traced::new(scenario, &robot)?)),
            _ => Arm::Seven(Box::new(Traced::new(scenario, &robot)?)),
        };
        let mut experiment = Self { arm, shortest_time: 0.0 };
        // A coarse value serves the default rate and the time after which to give up.
        experiment.shortest_time = experiment.any().sample(200, 3)?.speed_limited_time();
        Ok(experiment)
    }

    fn any(&self) -> &dyn AnyJoints {
        match &self.arm {
            Arm::One(traced) => traced.as_ref(),
            Arm::Two(traced) => traced.as_ref(),
            Arm::Three(traced) => traced.as_ref(),
            Arm::Four(traced) => traced.as_ref(),
            Arm::Five(traced) => traced.as_ref(),
            Arm::Six(traced) => traced.as_ref(),
            Arm::Seven(traced) => traced.as_ref(),
        }
    }

    /// Runs one method.
    ///
    /// # Errors
    ///
    /// Parameters that the conditioner refuses.
    pub fn run(&self, method: Method) -> Result<Trace, LabError> {
        self.any().run(method, self.shortest_time)
    }

    /// Samples the joint path with about `intervals` intervals and `between` samples inside each.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn sample(&self, intervals: usize, between: usize) -> Result<SampledPath, LabError> {
        self.any().sample(intervals, between)
    }

    /// Parameters of the controller and the speed regulator.
    #[must_use]
    pub fn control(&self) -> ControlSettings {
        self.any().control()
    }

    /// Points of the tool path, m.
    #[must_use]
    pub fn tool_path(&self, points: usize) -> Vec<[f64; 3]> {
        self.any().tool_path(points)
    }

    /// Where the tool was at each sample of a trace, m.
    #[must_use]
    pub fn tool_trace(&self, trace: &Trace) -> Vec<[f64; 3]> {
        self.any().tool_trace(trace)
    }

    /// What a run used of each kind of limit that the scenario gives besides constant joint-speed limits.
    #[must_use]
    pub fn limit_use(&self, trace: &Trace) -> Vec<LimitUse> {
        self.any().limit_use(trace)
    }
}

impl<const N: usize> Traced<N> {
    fn new(scenario: &Scenario, robot: &RobotDescription) -> Result<Self, LabError> {
        let problem = Problem::new(scenario, robot)?;
        let path = JointPath::trace(&problem)?;
        Ok(Self { problem, path })
    }
}

impl<const N: usize> AnyJoints for Traced<N> {
    fn control(&self) -> ControlSettings {
        self.problem.control
    }

    fn run(&self, method: Method, shortest_time: f64) -> Result<Trace, LabError> {
        let length = self.problem.path.end() - self.problem.path.start();
        let rate = self.problem.fixed_speed.rate.unwrap_or(length / shortest_time);
        let horizon = self.problem.control.max_duration.unwrap_or(10.0 * shortest_time.max(length / rate) + 30.0);
        simulate(&self.problem, method, rate, horizon)
    }

    fn sample(&self, intervals: usize, between: usize) -> Result<SampledPath, LabError> {
        sample(&self.problem, &self.path, intervals, between)
    }

    #[allow(clippy::cast_precision_loss)]
    fn tool_path(&self, points: usize) -> Vec<[f64; 3]> {
        let (start, end) = (self.problem.path.start(), self.problem.path.end());
        let at = |i: usize| start + (end - start) * i as f64 / (points.max(2) - 1) as f64;
        let tool = |lambda: f64| self.problem.reference_pose(lambda).translation.vector.into();
        (0..points.max(2)).map(|i| tool(at(i))).collect()
    }

    fn tool_trace(&self, trace: &Trace) -> Vec<[f64; 3]> {
        let tool = |q: &[f64]| self.problem.arm.forward(&slideway_robot::JointVector::from_fn(|i, _| q[i]));
        trace.samples.iter().map(|s| tool(&s.q).translation.vector.into()).collect()
    }

    fn limit_use(&self, trace: &Trace) -> Vec<LimitUse> {
        self.problem.limit_use(trace)
    }
}
