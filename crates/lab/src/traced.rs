//! An experiment of one number of joints, and what can be asked of it without knowing that number.

use crate::error::{Fault, LabError};
use crate::joint_path::JointPath;
use crate::joint_path::sampled::{SampledPath, sample};
use crate::limits::limit_use::LimitUse;
use crate::limits::position_limits::PositionExcess;
use crate::natural::{ModelErrorRun, NaturalLaws, WrongModel};
use crate::path::reference::Reference;
use crate::problem::{ControlSettings, LookAheadOptions, Problem};
use crate::robot::robot_key;
use crate::run::acceleration::online_limits;
use crate::run::course::{Course, ProfilePoint};
use crate::run::disturbances::Disturbances;
use crate::run::law::Method;
use crate::run::motion::{course_along, course_of};
use crate::run::simulate::simulate;
use crate::run::trace::Trace;
use crate::scenario::Scenario;
use slideway_conditioner::SpeedLimits;
use slideway_robot::{Dynamics, RobotDescription};

/// A problem and its joint path.
#[derive(Clone, Debug)]
pub(crate) struct Traced<const N: usize> {
    problem: Problem<N>,
    path: JointPath<N>,
    /// Constant speed and natural motion, where the scenario asks for them.
    natural: Option<NaturalLaws<N>>,
    /// The rigid bodies, where the robot's masses are known.
    dynamics: Option<Dynamics<N>>,
}

/// What an experiment does without knowing the number of joints.
pub(crate) trait AnyJoints {
    fn joints(&self) -> usize;
    fn control(&self) -> ControlSettings;
    fn limits_acceleration(&self) -> bool;
    fn has_natural_laws(&self) -> bool;
    fn disturbances(&self) -> &Disturbances;
    fn disturb(&mut self, disturbances: &Disturbances) -> Result<(), LabError>;
    fn scale_speed_limits(&mut self, by: f64) -> Result<(), LabError>;
    fn course(&self, trace: &Trace) -> Course;
    fn course_along(&self, profile: &[ProfilePoint]) -> Result<Course, LabError>;
    fn follow_with_wrong_masses(&self, course: &Course, share: f64) -> Result<Option<ModelErrorRun>, LabError>;
    fn path_length(&self) -> f64;
    fn run(&self, method: Method, shortest_time: f64) -> Result<Trace, LabError>;
    fn run_seeing(&self, options: LookAheadOptions, shortest_time: f64) -> Result<Trace, LabError>;
    fn sample(&self, intervals: usize, between: usize) -> Result<SampledPath, LabError>;
    fn tool_path(&self, points: usize) -> Vec<[f64; 3]>;
    fn tool_trace(&self, trace: &Trace) -> Vec<[f64; 3]>;
    fn command_use(&self, trace: &Trace) -> Result<f64, LabError>;
    fn limit_use(&self, trace: &Trace) -> Vec<LimitUse>;
    fn position_excesses(&self) -> Vec<PositionExcess>;
    fn spare_joints(&self) -> usize;
}

impl<const N: usize> Traced<N> {
    pub(crate) fn new(scenario: &Scenario, robot: &RobotDescription) -> Result<Self, LabError> {
        let problem = Problem::new(scenario, robot)?;
        let path = JointPath::trace(&problem)?;
        let natural = NaturalLaws::new(scenario, &problem)?;
        let key = robot_key(&scenario.file.robot);
        let dynamics = robot.has_masses().then(|| robot.dynamics()).transpose();
        Ok(Self { problem, path, natural, dynamics: dynamics.map_err(|error| LabError::value(key, error))? })
    }
}

impl<const N: usize> AnyJoints for Traced<N> {
    fn joints(&self) -> usize {
        N
    }

    fn control(&self) -> ControlSettings {
        self.problem.control
    }

    fn limits_acceleration(&self) -> bool {
        online_limits(&self.problem).is_some()
    }

    fn has_natural_laws(&self) -> bool {
        self.natural.is_some()
    }

    fn disturbances(&self) -> &Disturbances {
        &self.problem.disturbances
    }

    fn disturb(&mut self, disturbances: &Disturbances) -> Result<(), LabError> {
        disturbances.check(N)?;
        self.problem.disturbances = disturbances.clone();
        Ok(())
    }

    fn scale_speed_limits(&mut self, by: f64) -> Result<(), LabError> {
        if self.problem.speed_along.is_some() {
            let fault = Fault::Conflict("limits that vary along the path are not scaled");
            return Err(LabError::value("limits.speed", fault));
        }
        let (lower, upper) = (self.problem.speed_limits.lower(), self.problem.speed_limits.upper());
        let scaled = SpeedLimits::new(lower.map(|l| by * l), upper.map(|u| by * u));
        self.problem.speed_limits = scaled.map_err(|error| LabError::value("limits.speed", error))?;
        self.problem.control.target_rate *= by;
        Ok(())
    }

    fn course(&self, trace: &Trace) -> Course {
        course_of(&self.problem, self.dynamics.as_ref(), trace)
    }

    fn course_along(&self, profile: &[ProfilePoint]) -> Result<Course, LabError> {
        course_along(&self.problem, self.dynamics.as_ref(), &self.path, profile)
    }

    fn follow_with_wrong_masses(&self, course: &Course, share: f64) -> Result<Option<ModelErrorRun>, LabError> {
        self.dynamics.as_ref().map_or(Ok(None), |arm| WrongModel::new(arm, share)?.follow(course))
    }

    fn run(&self, method: Method, shortest_time: f64) -> Result<Trace, LabError> {
        if let Some(laws) = self.natural.as_ref().filter(|_| method.surveys_the_path()) {
            return laws.run(&self.problem, method);
        }
        let length = self.problem.path.end() - self.problem.path.start();
        let rate = self.problem.fixed_speed.rate.unwrap_or(length / shortest_time);
        let horizon = self.problem.control.max_duration.unwrap_or(10.0 * shortest_time.max(length / rate) + 30.0);
        simulate(&self.problem, method, rate, horizon)
    }

    fn run_seeing(&self, options: LookAheadOptions, shortest_time: f64) -> Result<Trace, LabError> {
        let mut other = self.clone();
        other.problem.control.look_ahead = options;
        other.run(Method::AccelerationLookAhead, shortest_time)
    }

    fn path_length(&self) -> f64 {
        self.problem.path.end() - self.problem.path.start()
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

    fn command_use(&self, trace: &Trace) -> Result<f64, LabError> {
        self.problem.command_use(trace)
    }

    fn limit_use(&self, trace: &Trace) -> Vec<LimitUse> {
        self.problem.limit_use(trace)
    }

    fn position_excesses(&self) -> Vec<PositionExcess> {
        self.problem.position_limits.excesses(&self.path)
    }

    fn spare_joints(&self) -> usize {
        match &self.problem.path {
            Reference::Tool(tool) => N.saturating_sub(tool.task.rows().len()),
            Reference::Joint(_) => 0,
        }
    }
}
