use crate::error::{Fault, LabError};
use crate::joint_path::sampled::SampledPath;
use crate::limits::limit_use::LimitUse;
use crate::limits::position_limits::PositionExcess;
use crate::natural::ModelErrorRun;
use crate::problem::{ControlSettings, LookAheadOptions};
use crate::robot::describe;
use crate::run::course::{Course, ProfilePoint};
use crate::run::disturbances::Disturbances;
use crate::run::law::Method;
use crate::run::trace::Trace;
use crate::scenario::Scenario;
use crate::traced::{AnyJoints, Traced};

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

    fn any_mut(&mut self) -> &mut dyn AnyJoints {
        match &mut self.arm {
            Arm::One(traced) => traced.as_mut(),
            Arm::Two(traced) => traced.as_mut(),
            Arm::Three(traced) => traced.as_mut(),
            Arm::Four(traced) => traced.as_mut(),
            Arm::Five(traced) => traced.as_mut(),
            Arm::Six(traced) => traced.as_mut(),
            Arm::Seven(traced) => traced.as_mut(),
        }
    }

    /// The methods that can be run: those under acceleration limits only where the scenario gives them, neither they nor the
    /// speed limits vary along the path, and the path begins and ends at rest; constant speed and natural motion only where it
    /// has a `[natural]` table.
    #[must_use]
    pub fn methods(&self) -> Vec<Method> {
        let (accelerations, natural) = (self.any().limits_acceleration(), self.any().has_natural_laws());
        let runs = |m: &Method| (accelerations || !m.limits_acceleration()) && (natural || !m.surveys_the_path());
        Method::ALL.into_iter().filter(runs).collect()
    }

    /// The same experiment with every joint-speed limit and the target rate multiplied by a number: what the regulator sees of the path
    /// stays in proportion.
    ///
    /// # Errors
    ///
    /// Limits that vary along the path; a factor that leaves no usable limits.
    pub fn with_speed_limits_scaled(&self, by: f64) -> Result<Self, LabError> {
        let mut other = self.clone();
        other.any_mut().scale_speed_limits(by)?;
        other.shortest_time = other.any().sample(200, 3)?.speed_limited_time();
        Ok(other)
    }

    /// Number of joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.any().joints()
    }

    /// What the controller does not know of in this experiment's runs.
    #[must_use]
    pub fn disturbances(&self) -> &Disturbances {
        self.any().disturbances()
    }

    /// The same experiment under other disturbances: the very runs of a scenario whose table `[disturbances]` says so.
    ///
    /// # Errors
    ///
    /// Disturbances that no scenario may have, NaN among them.
    pub fn with_disturbances(&self, disturbances: &Disturbances) -> Result<Self, LabError> {
        let mut other = self.clone();
        other.any_mut().disturb(disturbances)?;
        Ok(other)
    }

    /// What the joints do in a run, from the first motion of its reference to the reference's end.
    #[must_use]
    pub fn course(&self, trace: &Trace) -> Course {
        self.any().course(trace)
    }

    /// What the joints do along an optimum's profile.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn course_along(&self, profile: &[ProfilePoint]) -> Result<Course, LabError> {
        self.any().course_along(profile)
    }

    /// Lets the arm follow a course by computed torque in joint space (both poles at -10 1/s) with a model in which the links'
    /// masses and moments of inertia are wrong by `share` and `-share`, by turns from the base, after `[N] Fig. 3`.
    ///
    /// With `share` 0 the tool stays where the course has it, to rounding. What is measured is the model's part alone: the
    /// course's own distance from the path is no part of it. `None` where the masses are unknown, and where the course's
    /// joint speed jumps (at a corner), which no torque does.
    ///
    /// # Errors
    ///
    /// A share of 1 or more, which leaves links without a mass; [`LabError::NoFiniteSpeed`] if the loop diverges.
    pub fn follow_with_wrong_masses(&self, course: &Course, share: f64) -> Result<Option<ModelErrorRun>, LabError> {
        self.any().follow_with_wrong_masses(course, share)
    }

    /// The method that the verdict is about: the scenario's choice, else the look-ahead where it can be run, which keeps
    /// acceleration limits as the optimum does, else the published sliding mode.
    ///
    /// # Errors
    ///
    /// A choice that cannot be run here.
    pub fn judged_method(&self, scenario: &Scenario) -> Result<Method, LabError> {
        let look_ahead = self.methods().contains(&Method::AccelerationLookAhead);
        let default = if look_ahead { Method::AccelerationLookAhead } else { Method::SlidingMode };
        let method = scenario.judged_method().unwrap_or(default);
        if self.methods().contains(&method) {
            return Ok(method);
        }
        Err(LabError::value("compare.method", cannot_run(method)))
    }

    /// Runs one method.
    ///
    /// # Errors
    ///
    /// Parameters that the conditioner refuses.
    pub fn run(&self, method: Method) -> Result<Trace, LabError> {
        self.any().run(method, self.shortest_time)
    }

    /// Runs the look-ahead with a window of its own.
    ///
    /// # Errors
    ///
    /// A scenario without acceleration limits, or parameters that the conditioner refuses.
    pub fn run_seeing(&self, options: LookAheadOptions) -> Result<Trace, LabError> {
        self.any().run_seeing(options, self.shortest_time)
    }

    /// Path parameter from the path's start to its end.
    #[must_use]
    pub fn path_length(&self) -> f64 {
        self.any().path_length()
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

    /// The largest share of a joint-speed limit that any command of a run used, the robot's catching up included: at most 1, to the
    /// last bit, for every method that has limits (claim `command-within-limits`). Infinite if a command is not a number.
    ///
    /// # Errors
    ///
    /// A limit that varies along the path and has the wrong sign where the run went.
    pub fn command_use(&self, trace: &Trace) -> Result<f64, LabError> {
        self.any().command_use(trace)
    }

    /// What a run used of each kind of limit that the scenario gives besides constant joint-speed limits.
    #[must_use]
    pub fn limit_use(&self, trace: &Trace) -> Vec<LimitUse> {
        self.any().limit_use(trace)
    }

    /// Joints beyond the coordinates that a path of the tool prescribes. Where there are any, the methods and the joint path of the
    /// optimum take, of all joint motions, the smallest (pseudo-inverse): nothing else is asked of the spare ones.
    #[must_use]
    pub fn spare_joints(&self) -> usize {
        self.any().spare_joints()
    }

    /// The joints that leave their ranges along the path.
    #[must_use]
    pub fn position_excesses(&self) -> Vec<PositionExcess> {
        self.any().position_excesses()
    }
}

/// Why a method cannot be run in an experiment that does not list it.
fn cannot_run(method: Method) -> Fault {
    if method.surveys_the_path() {
        Fault::Unmet {
            need: "this method needs a `[natural]` table",
            remedy: "add a table `[natural]`, which may be empty, or judge another method",
        }
    } else {
        Fault::Unmet {
            need: "this method needs joint-acceleration limits, the same along the whole path as the speed limits are, and rest at both ends",
            remedy: "give `limits.acceleration` in numbers without formulas and leave out `limits.start_rate` and `limits.end_rate`, or \
                     judge another method",
        }
    }
}
