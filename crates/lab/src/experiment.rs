use crate::disturbances::Disturbances;
use crate::joints::JointUnits;
use crate::method::Method;
use crate::natural::{ModelErrorRun, NaturalLaws, WrongModel};
use crate::problem::{ControlSettings, LookAheadOptions, Problem};
use crate::run::acceleration::online_limits;
use crate::run::course::{Course, ProfilePoint};
use crate::run::limit_use::{JointMotion, LimitUse, MotionInstant};
use crate::run::motion::{course_along, course_of};
use crate::run::simulate::simulate;
use crate::run::trace::Trace;
use slideway_conditioner::SpeedLimits;
use slideway_path::{
    Fault, JointPath, JointPathPoint, NotWhole, PieceKind, PositionExcess, ProblemError, Reference, SampledPath,
    WholePath,
};
use slideway_robot::JointVector;

/// A problem made ready to run, for an arm of any supported number of joints.
#[derive(Clone, Debug)]
pub struct Experiment {
    arm: Arm,
    shortest_time: f64,
}

/// A problem with its joint path.
#[derive(Clone, Debug)]
struct Traced<const N: usize> {
    problem: Problem<N>,
    path: JointPath<N>,
    /// Constant speed and natural motion, where the problem asks for them.
    natural: Option<NaturalLaws<N>>,
}

/// The only place that turns a number of joints into a type: an arm by its number of joints, an experiment from a problem of each,
/// and `each_arm!`, which evaluates one expression for whichever it is.
macro_rules! arms {
    ($($variant:ident = $joints:literal),*) => {
        #[derive(Clone, Debug)]
        enum Arm {
            $($variant(Box<Traced<$joints>>)),*
        }

        $(impl TryFrom<Problem<$joints>> for Experiment {
            type Error = ProblemError;

            /// Checks the problem and traces its joint path.
            ///
            /// # Errors
            ///
            /// The first value that cannot be used, or a path that the robot cannot follow.
            fn try_from(problem: Problem<$joints>) -> Result<Self, ProblemError> {
                Self::traced(Arm::$variant(Box::new(Traced::new(problem)?)))
            }
        })*
    };
}

arms!(One = 1, Two = 2, Three = 3, Four = 4, Five = 5, Six = 6, Seven = 7);

macro_rules! each_arm {
    ($arm:expr, $traced:ident => $value:expr) => {
        match $arm {
            Arm::One($traced) => $value,
            Arm::Two($traced) => $value,
            Arm::Three($traced) => $value,
            Arm::Four($traced) => $value,
            Arm::Five($traced) => $value,
            Arm::Six($traced) => $value,
            Arm::Seven($traced) => $value,
        }
    };
}

impl<const N: usize> Traced<N> {
    fn new(problem: Problem<N>) -> Result<Self, ProblemError> {
        problem.check()?;
        let path = JointPath::trace(&problem.path)?;
        let natural = NaturalLaws::new(&problem)?;
        Ok(Self { problem, path, natural })
    }

    fn run(&self, method: Method, shortest_time: f64) -> Result<Trace, ProblemError> {
        if let Some(laws) = self.natural.as_ref().filter(|_| method.surveys_the_path()) {
            return laws.run(&self.problem, method);
        }
        let length = self.problem.path.length();
        let rate = self.problem.fixed_speed.rate.unwrap_or(length / shortest_time);
        let horizon = self.problem.control.max_duration.unwrap_or(10.0 * shortest_time.max(length / rate) + 30.0);
        simulate(&self.problem, method, rate, horizon)
    }

    fn scale_speed_limits(&mut self, by: f64) -> Result<(), ProblemError> {
        let path = &mut self.problem.path;
        if path.speed_along.is_some() {
            let fault = Fault::Conflict("limits that vary along the path are not scaled");
            return Err(ProblemError::value("limits.speed", fault));
        }
        let (lower, upper) = (path.speed_limits.lower(), path.speed_limits.upper());
        let scaled = SpeedLimits::new(lower.map(|l| by * l), upper.map(|u| by * u));
        path.speed_limits = scaled.map_err(|error| ProblemError::value("limits.speed", error))?;
        self.problem.control.target_rate *= by;
        Ok(())
    }

    fn tool(&self, q: &[f64]) -> [f64; 3] {
        self.problem.path.arm.forward(&JointVector::from_fn(|i, _| q[i])).translation.vector.into()
    }

    fn path_point(&self, piece: usize, s: f64) -> Result<JointPathPoint, ProblemError> {
        let piece = &self.path.pieces()[piece];
        let point = piece.at(&self.problem.path, s)?;
        let stands = matches!(piece.kind(), PieceKind::SelfMotion { .. });
        let list = |v: &JointVector<N>| v.iter().copied().collect();
        Ok(JointPathPoint {
            lambda: point.lambda,
            lambda_rate: if stands { 0.0 } else { 1.0 },
            q: list(&point.q),
            first: list(&point.first),
            second: list(&point.second),
        })
    }

    fn spare_joints(&self) -> usize {
        match &self.problem.path.reference {
            Reference::Tool(tool) => N.saturating_sub(tool.task.rows().len()),
            Reference::Joint(_) => 0,
        }
    }
}

impl Experiment {
    fn traced(arm: Arm) -> Result<Self, ProblemError> {
        let mut experiment = Self { arm, shortest_time: 0.0 };
        // A coarse value serves the default rate and the time after which to give up.
        experiment.shortest_time = experiment.sample(200, 3)?.speed_limited_time();
        Ok(experiment)
    }

    /// The methods that can be run: those under acceleration limits only where the problem has them, neither they nor the
    /// speed limits vary along the path, and the path begins and ends at rest; constant speed and natural motion only where it
    /// has settings for them.
    #[must_use]
    pub fn methods(&self) -> Vec<Method> {
        let (accelerations, natural) =
            each_arm!(&self.arm, a => (online_limits(&a.problem).is_some(), a.natural.is_some()));
        let runs = |m: &Method| (accelerations || !m.limits_acceleration()) && (natural || !m.surveys_the_path());
        Method::ALL.into_iter().filter(runs).collect()
    }

    /// Methods that this problem's limits call for and that cannot be run on it, with what they need.
    #[must_use]
    pub fn left_out(&self) -> Option<(Vec<Method>, &'static str)> {
        let limited = each_arm!(&self.arm, a => a.problem.path.acceleration_limits.is_some());
        let runs = self.methods();
        let left: Vec<Method> =
            Method::ALL.into_iter().filter(|m| m.limits_acceleration() && !runs.contains(m)).collect();
        (limited && !left.is_empty()).then_some((left, ONLINE_LIMITS_NEED))
    }

    /// The same experiment with every joint-speed limit and the target rate multiplied by a number: what the regulator sees of the path
    /// stays in proportion.
    ///
    /// # Errors
    ///
    /// Limits that vary along the path; a factor that leaves no usable limits.
    pub fn with_speed_limits_scaled(&self, by: f64) -> Result<Self, ProblemError> {
        let mut other = self.clone();
        each_arm!(&mut other.arm, a => a.scale_speed_limits(by))?;
        Self::traced(other.arm)
    }

    /// Number of joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joint_names().len()
    }

    /// Names of the joints, from base to tip.
    #[must_use]
    pub fn joint_names(&self) -> &[String] {
        each_arm!(&self.arm, a => &a.problem.joint_names)
    }

    /// Disturbances in this experiment's runs, which the controller does not know of.
    #[must_use]
    pub fn disturbances(&self) -> &Disturbances {
        each_arm!(&self.arm, a => &a.problem.disturbances)
    }

    /// The same experiment under other disturbances: the very runs of a problem that has them from the first.
    ///
    /// # Errors
    ///
    /// Disturbances that no problem may have, NaN among them.
    pub fn with_disturbances(&self, disturbances: &Disturbances) -> Result<Self, ProblemError> {
        disturbances.check(self.joints())?;
        let mut other = self.clone();
        each_arm!(&mut other.arm, a => a.problem.disturbances = disturbances.clone());
        Ok(other)
    }

    /// Motion of the joints in a run, from the first motion of its reference to the reference's end.
    #[must_use]
    pub fn course(&self, trace: &Trace) -> Course {
        each_arm!(&self.arm, a => course_of(&a.problem, trace))
    }

    /// Motion of the joints along an optimum's profile.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn course_along(&self, profile: &[ProfilePoint]) -> Result<Course, ProblemError> {
        each_arm!(&self.arm, a => course_along(&a.problem, &a.path, profile))
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
    /// A share of 1 or more, which leaves links without a mass; [`ProblemError::NoFiniteSpeed`] if the loop diverges.
    pub fn follow_with_wrong_masses(&self, course: &Course, share: f64) -> Result<Option<ModelErrorRun>, ProblemError> {
        each_arm!(&self.arm, a => match &a.problem.dynamics {
            Some(arm) => WrongModel::new(arm, share)?.follow(course),
            None => Ok(None),
        })
    }

    /// The method that the verdict is about: the one chosen, else the look-ahead where it can be run, which keeps acceleration
    /// limits as the optimum does, else the synchronised sliding mode, whose robot arrives with its reference.
    ///
    /// # Errors
    ///
    /// A choice that cannot be run here.
    pub fn judged_method(&self, chosen: Option<Method>) -> Result<Method, ProblemError> {
        let look_ahead = self.methods().contains(&Method::AccelerationLookAhead);
        let default = if look_ahead { Method::AccelerationLookAhead } else { Method::SlidingModeSynchronised };
        let method = chosen.unwrap_or(default);
        if self.methods().contains(&method) {
            return Ok(method);
        }
        Err(ProblemError::value("compare.method", cannot_run(method)))
    }

    /// Runs one method.
    ///
    /// # Errors
    ///
    /// Parameters that the conditioner refuses.
    pub fn run(&self, method: Method) -> Result<Trace, ProblemError> {
        each_arm!(&self.arm, a => a.run(method, self.shortest_time))
    }

    /// Runs the look-ahead with a window of its own.
    ///
    /// # Errors
    ///
    /// A problem without acceleration limits, or parameters that the conditioner refuses.
    pub fn run_seeing(&self, options: LookAheadOptions) -> Result<Trace, ProblemError> {
        let mut other = self.clone();
        each_arm!(&mut other.arm, a => a.problem.control.look_ahead = options);
        other.run(Method::AccelerationLookAhead)
    }

    /// Path parameter from the path's start to its end.
    #[must_use]
    pub fn path_length(&self) -> f64 {
        each_arm!(&self.arm, a => a.problem.path.length())
    }

    /// Samples the joint path with about `intervals` intervals and `between` samples inside each.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn sample(&self, intervals: usize, between: usize) -> Result<SampledPath, ProblemError> {
        each_arm!(&self.arm, a => SampledPath::new(&a.problem.path, &a.path, intervals, between))
    }

    /// The joint path and its limits for an optimum of the whole path: see [`JointPath::whole`].
    ///
    /// # Errors
    ///
    /// Limits or ends that such an optimum does not take.
    pub fn whole_path(&self, tolerance: f64) -> Result<WholePath, NotWhole> {
        each_arm!(&self.arm, a => a.path.whole(&a.problem.path, tolerance))
    }

    /// The same with a spline in place of a path of the joints: see [`JointPath::spline`].
    ///
    /// # Errors
    ///
    /// Limits or ends that such an optimum does not take.
    pub fn spline_path(&self, tolerance: f64) -> Result<WholePath, NotWhole> {
        each_arm!(&self.arm, a => a.path.spline(&a.problem.path, tolerance))
    }

    /// The joint path at a place of one of its pieces.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn path_point(&self, piece: usize, s: f64) -> Result<JointPathPoint, ProblemError> {
        each_arm!(&self.arm, a => a.path_point(piece, s))
    }

    /// Torques of a motion, Nm (N for joints that slide), and the limit that it uses most.
    #[must_use]
    pub fn instant(&self, motion: &JointMotion) -> MotionInstant {
        each_arm!(&self.arm, a => a.problem.motion_instant(motion))
    }

    /// Units of the joints.
    #[must_use]
    pub fn joint_units(&self) -> Vec<JointUnits> {
        each_arm!(&self.arm, a => JointUnits::of(&a.problem.path.arm).into_iter().take(self.joints()).collect())
    }

    /// Parameters of the controller and the speed regulator.
    #[must_use]
    pub fn control(&self) -> ControlSettings {
        each_arm!(&self.arm, a => a.problem.control)
    }

    /// True where the path is one of the joints.
    #[must_use]
    pub fn follows_joints(&self) -> bool {
        each_arm!(&self.arm, a => matches!(a.problem.path.reference, Reference::Joint(_)))
    }

    /// Points of the tool path, m.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn tool_path(&self, points: usize) -> Vec<[f64; 3]> {
        let last = points.max(2) - 1;
        each_arm!(&self.arm, a => {
            let path = &a.problem.path;
            let at = |i: usize| path.begin() + (path.end() - path.begin()) * i as f64 / last as f64;
            (0..=last).map(|i| path.reference_pose(at(i)).translation.vector.into()).collect()
        })
    }

    /// Position of the tool at each sample of a trace, m.
    #[must_use]
    pub fn tool_trace(&self, trace: &Trace) -> Vec<[f64; 3]> {
        each_arm!(&self.arm, a => trace.samples.iter().map(|s| a.tool(&s.q)).collect())
    }

    /// The largest share of a joint-speed limit that any command of a run used, the robot's catching up included: at most 1, to the
    /// last bit, for every method that has limits (claim `command-within-limits`). Infinite if a command is not a number.
    ///
    /// # Errors
    ///
    /// A limit that varies along the path and has the wrong sign where the run went.
    pub fn command_use(&self, trace: &Trace) -> Result<f64, ProblemError> {
        each_arm!(&self.arm, a => a.problem.command_use(trace))
    }

    /// Use that a run made of each kind of limit that the problem has besides constant joint-speed limits.
    #[must_use]
    pub fn limit_use(&self, trace: &Trace) -> Vec<LimitUse> {
        each_arm!(&self.arm, a => a.problem.limit_use(trace))
    }

    /// Joints beyond the coordinates that a path of the tool prescribes. Where there are any, the methods and the joint path of the
    /// optimum take, of all joint motions, the smallest (pseudo-inverse): nothing else is asked of the spare ones.
    #[must_use]
    pub fn spare_joints(&self) -> usize {
        each_arm!(&self.arm, a => a.spare_joints())
    }

    /// The joints that leave their ranges along the path.
    #[must_use]
    pub fn position_excesses(&self) -> Vec<PositionExcess> {
        each_arm!(&self.arm, a => a.path.position_excesses(&a.problem.path.position_limits))
    }
}

/// Requirement of the methods under acceleration limits, as a sentence.
const ONLINE_LIMITS_NEED: &str = "this method needs joint-acceleration limits, the same along the whole path as the speed limits are, and rest at both ends";

/// Why a method cannot be run in an experiment that does not list it.
fn cannot_run(method: Method) -> Fault {
    if method.surveys_the_path() {
        Fault::Unmet {
            need: "this method needs a `[natural]` table",
            remedy: "add a table `[natural]`, which may be empty, or judge another method",
        }
    } else {
        Fault::Unmet {
            need: ONLINE_LIMITS_NEED,
            remedy: "give `limits.acceleration` in numbers without formulas and leave out `limits.start_rate` and `limits.end_rate`, or \
                     judge another method",
        }
    }
}
