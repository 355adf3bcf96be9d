//! The problem of a speed scenario.

use crate::error::ScenarioError;
use crate::read::limits::LimitReader;
use crate::read::placement::Placement;
use crate::read::reference::reference;
use crate::read::robot::robot_key;
use crate::tables::number::Number;
use crate::tables::{
    ControlTable, DisturbancesTable, FactorName, FixedSpeedTable, IntegrationName, NaturalTable, ScenarioFile,
};
use slideway_lab::{
    ControlSettings, Disturbances, FixedSpeed, Integration, LookAheadOptions, NaturalSettings, Problem,
};
use slideway_path::{Fault, ListOf, PathProblem, ProblemError};
use slideway_robot::RobotDescription;
use slideway_robot::augmented::SpeedFactor;
use std::path::Path;

/// The problem of a scenario and its robot, an arm of `N` joints; files that it names lie in `folder`.
///
/// # Errors
///
/// The first value that cannot be used, with its key.
pub(crate) fn read_problem<const N: usize>(
    file: &ScenarioFile,
    folder: &Path,
    robot: &RobotDescription,
) -> Result<Problem<N>, ScenarioError> {
    let of_robot = |error| ScenarioError::value(robot_key(&file.robot), error);
    let arm = robot.arm().map_err(of_robot)?;
    let reference = reference(file, folder)?;
    let limits = LimitReader { table: &file.limits, robot, path: reference.start()..reference.end() };
    let speed = limits.speed::<N>()?;
    let speed_limits = limits.widest_speed(&speed)?;
    let (acceleration_limits, torque_limits) = (limits.acceleration()?, limits.torque()?);
    let (tool_limits, position_limits) = (limits.tool()?, limits.position()?);
    let start_rate = limits.end_rate("limits.start_rate", file.limits.start_rate)?;
    let end_rate = limits.end_rate("limits.end_rate", file.limits.end_rate)?;
    let control = control(&file.control);
    control.check()?;
    let fixed_speed = fixed_speed(&file.fixed_speed, &control);
    fixed_speed.check(control.gain)?;
    let disturbances = disturbances(&file.disturbances, N)?;
    let placement = Placement { arm: &arm, reference: &reference, table: &file.start, path_key: file.path.start_key() };
    let start = placement.place()?;
    Ok(Problem {
        joint_names: robot.joints.iter().map(|joint| joint.name.clone()).collect(),
        dynamics: robot.has_masses().then(|| robot.dynamics()).transpose().map_err(of_robot)?,
        path: PathProblem {
            arm,
            reference,
            start: start.on_path,
            speed_limits,
            speed_along: speed.vary().then_some(speed),
            acceleration_limits,
            torque_limits,
            tool_limits,
            position_limits,
            start_rate,
            end_rate,
        },
        control,
        fixed_speed,
        natural: file.natural.as_ref().map(natural),
        start: start.q,
        start_euler: start.euler,
        disturbances,
    })
}

fn control(table: &ControlTable) -> ControlSettings {
    let default = LookAheadOptions::default();
    ControlSettings {
        gain: table.gain.0,
        sampling_period: table.sampling_period.0,
        bandwidth: table.bandwidth.0,
        target_rate: table.target_rate.0,
        max_duration: table.max_duration.map(|d| d.0),
        look_ahead: LookAheadOptions {
            distance: table.look_ahead.distance.map(|d| d.0),
            nodes: table.look_ahead.nodes.unwrap_or(default.nodes),
            margin: table.look_ahead.margin.map_or(default.margin, |m| m.0),
        },
    }
}

fn fixed_speed(table: &FixedSpeedTable, control: &ControlSettings) -> FixedSpeed {
    FixedSpeed {
        rate: table.rate.map(|rate| rate.0),
        sampling_period: table.sampling_period.map_or(control.sampling_period, |period| period.0),
        integration: match table.integration {
            IntegrationName::Euler => Integration::Euler,
            IntegrationName::Rk4 => Integration::Rk4,
        },
    }
}

fn natural(table: &NaturalTable) -> NaturalSettings {
    NaturalSettings {
        factor: match table.factor {
            FactorName::Determinant => SpeedFactor::Determinant,
            // The scale is a constant factor of b, which the survey chooses.
            FactorName::Arm => SpeedFactor::Arm { scale: 1.0 },
        },
        share: table.share.map_or(1.0, |share| share.0),
        rise: table.rise.map_or(0.0, |rise| rise.0),
    }
}

/// The table `[disturbances]`, for an arm of `joints` joints.
fn disturbances(table: &DisturbancesTable, joints: usize) -> Result<Disturbances, ProblemError> {
    let list = |numbers: &Option<Vec<Number>>| numbers.iter().flatten().map(|n| n.0).collect();
    let disturbances = Disturbances {
        seed: table.seed.unwrap_or(0),
        initial_error: list(&table.initial_error),
        joint_noise: table.joint_noise.map_or(0.0, |n| n.0),
        joint_offset: list(&table.joint_offset),
        speed_error: list(&table.speed_error),
        delay: table.delay.unwrap_or(0),
        jitter: table.jitter.map_or(0.0, |j| j.0),
    };
    let given = [
        ("initial_error", &table.initial_error),
        ("joint_offset", &table.joint_offset),
        ("speed_error", &table.speed_error),
    ];
    if let Some((key, _)) = given.into_iter().find(|(_, list)| list.as_ref().is_some_and(Vec::is_empty)) {
        let fault = Fault::WrongLength { found: 0, expected: joints, list: ListOf::Joints };
        return Err(ProblemError::value(format!("disturbances.{key}"), fault));
    }
    disturbances.check(joints)?;
    Ok(disturbances)
}
