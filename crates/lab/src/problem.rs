use crate::disturbances::Disturbances;
use slideway_conditioner::{ParameterError, bounds};
use slideway_path::{EndRate, Fault, ListOf, PathProblem, ProblemError, Reference, SampledPath};
use slideway_robot::augmented::SpeedFactor;
use slideway_robot::{Dynamics, EulerAngles, JointVector, euler};

/// A path to follow with its limits, a controller and a start: everything that the loop needs.
#[derive(Clone, Debug)]
pub struct Problem<const N: usize> {
    /// The arm, the path and the limits.
    pub path: PathProblem<N>,
    /// Names of the joints, from base to tip.
    pub joint_names: Vec<String>,
    /// The rigid bodies, where the robot's masses are known.
    pub dynamics: Option<Dynamics<N>>,
    /// Controller and regulator.
    pub control: ControlSettings,
    /// The fixed-speed methods.
    pub fixed_speed: FixedSpeed,
    /// Constant speed and natural motion beside the other methods.
    pub natural: Option<NaturalSettings>,
    /// Configuration of the robot at `t = 0`, rad (m).
    pub start: JointVector<N>,
    /// Euler triple of the tool there, nearest to the path's.
    pub start_euler: EulerAngles,
    /// Disturbances that the controller does not know of.
    pub disturbances: Disturbances,
}

/// Parameters of the controller and of the speed regulator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlSettings {
    /// Position-error gain `Kp`, 1/s.
    pub gain: f64,
    /// Sampling period `Ts`, s.
    pub sampling_period: f64,
    /// Filter bandwidth `af`, rad/s.
    pub bandwidth: f64,
    /// Target rate of the path parameter `λ̇d`, 1/s.
    pub target_rate: f64,
    /// When to give up, s; by default ten times the shortest possible time plus 30 s.
    pub max_duration: Option<f64>,
    /// Window of the look-ahead, used where there are acceleration limits.
    pub look_ahead: LookAheadOptions,
}

/// The look-ahead's window on the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LookAheadOptions {
    /// Length of the window in the path parameter; by default a quarter of the path.
    pub distance: Option<f64>,
    /// Intervals that distance is divided into.
    pub nodes: u32,
    /// Share of the acceleration limits its plan leaves to the position loop and the discretisation.
    pub margin: f64,
}

/// Parameters of the fixed-speed methods (cases 1 to 3 of `[G11]`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedSpeed {
    /// Rate of the path parameter, 1/s; by default the one that takes as long as the optimum.
    pub rate: Option<f64>,
    /// Sampling period, s.
    pub sampling_period: f64,
    /// Integration of the joint positions.
    pub integration: Integration,
}

/// Integration of the joint positions over a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integration {
    /// The joint speed is held over the sample, as a digital controller does.
    Euler,
    /// Fourth-order Runge-Kutta: the continuous-time ideal.
    Rk4,
}

/// Parameters of constant speed and natural motion (`[N]`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalSettings {
    /// Factor that natural motion's speed is proportional to.
    pub factor: SpeedFactor,
    /// Share of the speed limits that both methods use, above 0, at most 1.
    pub share: f64,
    /// Length of the start and of the stop, s.
    pub rise: f64,
}

impl ControlSettings {
    /// The filter step `a = af Ts`.
    #[must_use]
    pub fn filter_step(&self) -> f64 {
        self.bandwidth * self.sampling_period
    }

    /// Refuses what cannot be run.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key: numbers that are not positive, a filter step above 1, a gain at which
    /// the sampled position loop is not stable.
    pub fn check(&self) -> Result<(), ProblemError> {
        positive("control.gain", self.gain)?;
        positive("control.sampling_period", self.sampling_period)?;
        positive("control.bandwidth", self.bandwidth)?;
        positive("control.target_rate", self.target_rate)?;
        self.max_duration.map_or(Ok(()), |d| positive("control.max_duration", d))?;
        self.look_ahead.check()?;
        let step = self.filter_step();
        if step > 1.0 {
            return Err(ProblemError::value("control.bandwidth", ParameterError::FilterStep { step }));
        }
        check_gain("control.gain", self.gain, self.sampling_period)
    }

    /// Bound on the largest use of a speed limit by the explicit sliding mode, without tracking error (claim
    /// `drifting-band`); `None` where the reaching condition fails or the path has a corner or a self-motion.
    ///
    /// With `g = λ̇d · slowness`: `L = sup |d ln g / dλ|` and `λ̇*max = max 1 / slowness`, both from the samples, hence as good
    /// as the grid is fine.
    #[must_use]
    pub fn limit_ratio_bound(&self, path: &SampledPath) -> Option<f64> {
        let [piece] = path.pieces.as_slice() else { return None };
        let samples: Vec<(f64, f64)> = piece.in_order().iter().map(|p| (p.s, path.slowness(p))).collect();
        let slope = |w: &[(f64, f64)]| ((w[1].1 / w[0].1).ln() / (w[1].0 - w[0].0)).abs();
        let steepest = samples.windows(2).map(slope).fold(0.0, f64::max);
        let slowest = samples.iter().map(|s| s.1).fold(f64::INFINITY, f64::min);
        let slowness = samples.iter().map(|s| s.1).fold(0.0, f64::max);
        let drift = steepest * self.sampling_period / slowest;
        bounds::drifting_band(self.filter_step(), self.target_rate * slowness, drift)
    }
}

/// More nodes than this in a window would take longer than a sample.
const MOST_NODES: u32 = 10_000;

impl Default for LookAheadOptions {
    fn default() -> Self {
        Self { distance: None, nodes: 64, margin: 0.05 }
    }
}

impl LookAheadOptions {
    fn check(&self) -> Result<(), ProblemError> {
        if !(1..=MOST_NODES).contains(&self.nodes) {
            let fault = Fault::OutOfRange { value: self.nodes.into(), least: 1.0, most: MOST_NODES.into() };
            return Err(ProblemError::value("control.look_ahead.nodes", fault));
        }
        if !(0.0..1.0).contains(&self.margin) {
            let error = ParameterError::AccelerationMargin(self.margin);
            return Err(ProblemError::value("control.look_ahead.margin", error));
        }
        self.distance.map_or(Ok(()), |d| positive("control.look_ahead.distance", d))
    }
}

impl FixedSpeed {
    /// Refuses what cannot be run with a position-error gain in 1/s.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key.
    pub fn check(&self, gain: f64) -> Result<(), ProblemError> {
        positive("fixed_speed.sampling_period", self.sampling_period)?;
        check_gain("fixed_speed.sampling_period", gain, self.sampling_period)?;
        self.rate.map_or(Ok(()), |rate| positive("fixed_speed.rate", rate))
    }
}

impl NaturalSettings {
    /// Refuses what cannot be run.
    ///
    /// # Errors
    ///
    /// A rise that is negative or not finite; a share outside (0, 1].
    pub fn check(&self) -> Result<(), ProblemError> {
        let Self { rise, share, .. } = *self;
        if !(rise >= 0.0 && rise.is_finite()) {
            let fault = Fault::OutOfRange { value: rise, least: 0.0, most: f64::MAX };
            return Err(ProblemError::value("natural.rise", fault));
        }
        positive("natural.share", share)?;
        let fault = Fault::OutOfRange { value: share, least: 0.0, most: 1.0 };
        if share <= 1.0 { Ok(()) } else { Err(ProblemError::value("natural.share", fault)) }
    }
}

impl<const N: usize> Problem<N> {
    /// The robot on the path's first point, joints named `joint1` and on, nothing disturbed; fixed speeds with the controller's
    /// sampling period. Other starts, fixed speeds, natural motion, masses and disturbances are fields to be set.
    #[must_use]
    pub fn new(path: PathProblem<N>, control: ControlSettings) -> Self {
        let wanted = match &path.reference {
            Reference::Tool(tool) => tool.path.at(tool.path.start()).euler.map(|e| e.angles),
            Reference::Joint(_) => None,
        };
        let start = path.start;
        Self {
            start_euler: euler::nearest(&path.arm.forward(&start).rotation, &wanted.unwrap_or_default()),
            joint_names: (1..=N).map(|i| format!("joint{i}")).collect(),
            dynamics: None,
            fixed_speed: FixedSpeed {
                rate: None,
                sampling_period: control.sampling_period,
                integration: Integration::Euler,
            },
            natural: None,
            start,
            disturbances: Disturbances::default(),
            path,
            control,
        }
    }

    /// Refuses what cannot be run.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key.
    pub fn check(&self) -> Result<(), ProblemError> {
        let found = self.joint_names.len();
        if found != N {
            let fault = Fault::WrongLength { found, expected: N, list: ListOf::Joints };
            return Err(ProblemError::value("joint_names", fault));
        }
        self.control.check()?;
        let target = self.control.target_rate;
        if let EndRate::Given(rate) = self.path.start_rate
            && !(rate <= target)
        {
            return Err(ProblemError::value("limits.start_rate", Fault::AboveTarget { rate, target }));
        }
        self.fixed_speed.check(self.control.gain)?;
        self.disturbances.check(N)
    }
}

fn positive(key: &str, value: f64) -> Result<(), ProblemError> {
    if value > 0.0 { Ok(()) } else { Err(ProblemError::value(key, Fault::NotPositive(value))) }
}

/// The sampled position loop `e <- (1 - Kp Ts) e` is stable for `Kp Ts < 2` only.
fn check_gain(key: &str, gain: f64, sampling_period: f64) -> Result<(), ProblemError> {
    let most = 2.0 / sampling_period;
    let fault = Fault::OutOfOpenRange { value: gain, least: 0.0, most };
    if gain < most { Ok(()) } else { Err(ProblemError::value(key, fault)) }
}
