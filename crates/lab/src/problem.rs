use crate::error::{Fault, LabError};
use crate::joint_path::placement::Placement;
use crate::limits::EndRate;
use crate::limits::dynamic_limits::{ToolLimits, TorqueLimits};
use crate::limits::joint_bounds::JointBounds;
use crate::limits::limit_reader::LimitReader;
use crate::limits::position_limits::PositionLimits;
use crate::path::CartesianPath;
use crate::path::joint_curve::JointCurve;
use crate::path::reference::{Reference, ToolReference};
use crate::robot::robot_key;
use crate::run::disturbances::Disturbances;
use crate::scenario::Scenario;
use crate::scenario::number::positive;
use crate::scenario::schema::{ControlTable, IntegrationName, InverseTable, LookAheadTable, TaskName};
use slideway_conditioner::{ParameterError, SpeedLimits};
use slideway_robot::{EulerAngles, InverseMethod, JointVector, RobotDescription, RobotError, SerialArm, Task};

/// A robot, a path and limits: everything the loop and the optimum need, validated.
#[derive(Clone, Debug)]
pub struct Problem<const N: usize> {
    /// The arm.
    pub arm: SerialArm<N>,
    /// What the robot is to follow.
    pub path: Reference<N>,
    /// Joint-speed limits, rad/s (m/s for joints that slide); where they vary along the path, the widest they get.
    pub speed_limits: SpeedLimits<N>,
    /// Joint-speed limits along the path, where they vary.
    pub speed_along: Option<JointBounds<N>>,
    /// Joint-acceleration limits, rad/s² (m/s²).
    pub acceleration_limits: Option<JointBounds<N>>,
    /// Torque limits of the drives, with the robot's dynamics.
    pub torque_limits: Option<TorqueLimits<N>>,
    /// Limits of the tool.
    pub tool_limits: ToolLimits,
    /// How far the joints may go: reported, not enforced.
    pub position_limits: PositionLimits<N>,
    /// Path rate at the path's first point.
    pub start_rate: EndRate,
    /// Path rate at its last point.
    pub end_rate: EndRate,
    /// Controller and regulator.
    pub control: ControlSettings,
    /// The fixed-speed methods.
    pub fixed_speed: FixedSpeed,
    /// Where the robot stands at `t = 0`.
    pub start: JointVector<N>,
    /// Euler triple of the tool there, nearest to the path's.
    pub start_euler: EulerAngles,
    /// The configuration on the path's first point, on the same branch.
    pub path_start: JointVector<N>,
    /// What the controller does not know of.
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
    /// What the look-ahead sees, where there are acceleration limits.
    pub look_ahead: LookAheadOptions,
}

/// What the look-ahead sees of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LookAheadOptions {
    /// How far it sees in the path parameter; by default a quarter of the path.
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

impl ControlSettings {
    /// The filter step `a = af Ts`.
    #[must_use]
    pub fn filter_step(&self) -> f64 {
        self.bandwidth * self.sampling_period
    }
}

impl<const N: usize> Problem<N> {
    /// Makes a problem from a scenario and its robot, an arm of `N` joints.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key.
    pub(crate) fn new(scenario: &Scenario, robot: &RobotDescription) -> Result<Self, LabError> {
        scenario.check_options()?;
        let file = &scenario.file;
        let arm = robot.arm().map_err(|error| LabError::value(robot_key(&file.robot), error))?;
        let path: Reference<N> = reference(scenario)?;
        let limits = LimitReader { table: &file.limits, robot, path: path.start()..path.end() };
        let speed = limits.speed::<N>()?;
        let mut problem = Self {
            arm,
            path,
            speed_limits: limits.widest_speed(&speed)?,
            speed_along: speed.vary().then_some(speed),
            acceleration_limits: limits.acceleration()?,
            torque_limits: limits.torque()?,
            tool_limits: limits.tool()?,
            position_limits: PositionLimits::new(file.limits.position.as_ref(), robot)?,
            start_rate: limits.end_rate("limits.start_rate", file.limits.start_rate)?,
            end_rate: limits.end_rate("limits.end_rate", file.limits.end_rate)?,
            control: control(&file.control)?,
            fixed_speed: fixed_speed(scenario)?,
            start: JointVector::zeros(),
            start_euler: EulerAngles::zeros(),
            path_start: JointVector::zeros(),
            disturbances: Disturbances::read(&file.disturbances, N)?,
        };
        Placement { problem: &mut problem, scenario }.place()?;
        Ok(problem)
    }
}

/// The path and, for one of the tool, how the controller follows it.
fn reference<const N: usize>(scenario: &Scenario) -> Result<Reference<N>, LabError> {
    let file = &scenario.file;
    if let Some(joints) = &file.path.joints {
        let shared = [
            ("path.position", file.path.position.is_some()),
            ("path.orientation", file.path.orientation.is_some()),
            ("path.poses", file.path.poses.is_some()),
        ];
        if let Some((key, _)) = shared.into_iter().find(|(_, given)| *given) {
            let fault = Fault::Conflict("a path of the joints (`path.joints`) leaves nothing for the tool to say");
            return Err(LabError::value(key, fault));
        }
        return Ok(Reference::Joint(JointCurve::new(&file.path, joints, scenario.folder())?));
    }
    let missing = Fault::Missing("a path of the tool needs an inverse, for example `[robot.inverse.adjugate]`");
    let table = file.robot.inverse.as_ref().ok_or_else(|| LabError::value("robot.inverse", missing))?;
    let tool = ToolReference {
        path: CartesianPath::new(&file.path, file.robot.task, scenario.folder())?,
        task: task(file.robot.task),
        inverse: inverse(table),
    };
    let validated = tool.inverse.validate(tool.task, N);
    validated.map_err(|error| LabError::value(inverse_key(table, &error), error))?;
    let rows = tool.task.rows().len();
    if rows > N {
        let fault = Fault::OutOfRange { value: rows as f64, least: 1.0, most: N as f64 };
        return Err(LabError::value("robot.task", fault));
    }
    Ok(Reference::Tool(tool))
}

fn task(name: TaskName) -> Task {
    match name {
        TaskName::Pose => Task::Pose,
        TaskName::Position => Task::Position,
        TaskName::PlanarPosition => Task::PlanarPosition,
        TaskName::PlanarPose => Task::PlanarPose,
    }
}

fn inverse(table: &InverseTable) -> InverseMethod {
    match table {
        InverseTable::Adjugate { epsilon } => InverseMethod::Adjugate { epsilon: epsilon.0 },
        InverseTable::DampedLeastSquares { damping } => InverseMethod::DampedLeastSquares { damping: damping.0 },
        InverseTable::TruncatedSvd { cutoff } => InverseMethod::TruncatedSvd { cutoff: cutoff.0 },
    }
}

/// The key that an inverse's error is about.
fn inverse_key(table: &InverseTable, error: &RobotError) -> &'static str {
    match (table, error) {
        (InverseTable::Adjugate { .. }, RobotError::NotPositive { .. }) => "robot.inverse.adjugate.epsilon",
        (InverseTable::DampedLeastSquares { .. }, _) => "robot.inverse.damped-least-squares.damping",
        (InverseTable::TruncatedSvd { .. }, _) => "robot.inverse.truncated-svd.cutoff",
        _ => "robot.inverse",
    }
}

fn control(table: &ControlTable) -> Result<ControlSettings, LabError> {
    let settings = ControlSettings {
        gain: positive("control.gain", table.gain)?,
        sampling_period: positive("control.sampling_period", table.sampling_period)?,
        bandwidth: positive("control.bandwidth", table.bandwidth)?,
        target_rate: positive("control.target_rate", table.target_rate)?,
        max_duration: table.max_duration.map(|d| positive("control.max_duration", d)).transpose()?,
        look_ahead: look_ahead(&table.look_ahead)?,
    };
    let step = settings.filter_step();
    if step > 1.0 {
        return Err(LabError::value("control.bandwidth", ParameterError::FilterStep { step }));
    }
    check_gain("control.gain", settings.gain, settings.sampling_period)?;
    Ok(settings)
}

/// More nodes than this in a window would take longer than a sample.
const MOST_NODES: u32 = 10_000;

fn look_ahead(table: &LookAheadTable) -> Result<LookAheadOptions, LabError> {
    let nodes = table.nodes.unwrap_or(64);
    if !(1..=MOST_NODES).contains(&nodes) {
        let fault = Fault::OutOfRange { value: nodes.into(), least: 1.0, most: MOST_NODES.into() };
        return Err(LabError::value("control.look_ahead.nodes", fault));
    }
    let margin = table.margin.map_or(0.05, |m| m.0);
    if !(0.0..1.0).contains(&margin) {
        return Err(LabError::value("control.look_ahead.margin", ParameterError::AccelerationMargin(margin)));
    }
    let distance = table.distance.map(|d| positive("control.look_ahead.distance", d)).transpose()?;
    Ok(LookAheadOptions { distance, nodes, margin })
}

/// The sampled position loop `e <- (1 - Kp Ts) e` is stable for `Kp Ts < 2` only.
fn check_gain(key: &str, gain: f64, sampling_period: f64) -> Result<(), LabError> {
    let most = 2.0 / sampling_period;
    let fault = Fault::OutOfOpenRange { value: gain, least: 0.0, most };
    if gain < most { Ok(()) } else { Err(LabError::value(key, fault)) }
}

fn fixed_speed(scenario: &Scenario) -> Result<FixedSpeed, LabError> {
    let table = &scenario.file.fixed_speed;
    let control = &scenario.file.control;
    let period = match table.sampling_period {
        Some(period) => positive("fixed_speed.sampling_period", period)?,
        None => control.sampling_period.0,
    };
    check_gain("fixed_speed.sampling_period", control.gain.0, period)?;
    Ok(FixedSpeed {
        rate: table.rate.map(|r| positive("fixed_speed.rate", r)).transpose()?,
        sampling_period: period,
        integration: match table.integration {
            IntegrationName::Euler => Integration::Euler,
            IntegrationName::Rk4 => Integration::Rk4,
        },
    })
}
