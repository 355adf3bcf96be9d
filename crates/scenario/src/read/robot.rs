use crate::error::ScenarioError;
use crate::tables::{DhTable, ModelName, RobotTable};
use crate::text::from_toml;
use serde::Deserialize;
use slideway_lab::MAX_JOINTS;
use slideway_path::Fault;
use slideway_robot::models::Model;
use slideway_robot::{ChainEnds, DhRow, RobotDescription};
use std::path::{Path, PathBuf};

/// A text with a robot in it: a scenario, or its `[robot]` table alone.
#[derive(Deserialize)]
struct RobotText {
    robot: RobotTable,
}

/// The robot in the text of a scenario, or in a text with a `[robot]` table alone; files that it names lie in `folder`.
///
/// # Errors
///
/// No robot or several, a file that gives none, or a number of joints that is not supported.
pub fn robot_in(text: &str, folder: &Path) -> Result<RobotDescription, ScenarioError> {
    let file: RobotText = from_toml(text, |_| None)?;
    describe(&file.robot, folder)
}

/// The robot of a scenario: built in, a DH table, or a URDF file; with 1 to [`MAX_JOINTS`] joints after locking some.
pub(crate) fn describe(table: &RobotTable, folder: &Path) -> Result<RobotDescription, ScenarioError> {
    check_one_source(table)?;
    let mut robot = match (table.model, &table.dh, &table.urdf) {
        (Some(name), _, _) => model(name).describe().map_err(|error| ScenarioError::value("robot.model", error))?,
        (None, Some(rows), _) => RobotDescription::from_dh("robot", &rows.iter().map(dh_row).collect::<Vec<_>>()),
        (None, None, Some(file)) => from_urdf(table, folder.join(file))?,
        (None, None, None) => {
            let missing = Fault::Missing("say which robot: `model`, a `dh` table or a `urdf` file");
            return Err(ScenarioError::value("robot", missing));
        }
    };
    for (joint, position) in &table.locked {
        let locked = robot.locked(joint, position.0);
        robot = locked.map_err(|error| ScenarioError::value(format!("robot.locked.{joint}"), error))?;
    }
    if (1..=MAX_JOINTS).contains(&robot.joint_count()) {
        Ok(robot)
    } else {
        Err(ScenarioError::value(robot_key(table), Fault::JointCount(robot.joint_count())))
    }
}

/// The key that says which robot it is, for errors about it.
pub(crate) fn robot_key(table: &RobotTable) -> &'static str {
    match (table.model, &table.dh, &table.urdf) {
        (Some(_), _, _) => "robot.model",
        (None, Some(_), _) => "robot.dh",
        (None, None, Some(_)) => "robot.urdf",
        (None, None, None) => "robot",
    }
}

fn check_one_source(table: &RobotTable) -> Result<(), ScenarioError> {
    let conflict = |key: &str, message| Err(ScenarioError::value(key, Fault::Conflict(message)));
    if table.dh.is_some() && table.model.is_some() {
        return conflict("robot.dh", "`robot.model` and `robot.dh` exclude each other");
    }
    if table.urdf.is_some() && (table.model.is_some() || table.dh.is_some()) {
        return conflict("robot.urdf", "`robot.urdf` excludes `robot.model` and `robot.dh`");
    }
    for (key, link) in [("robot.base", &table.base), ("robot.tip", &table.tip)] {
        if link.is_some() && table.urdf.is_none() {
            return conflict(key, "`base` and `tip` name links of a `robot.urdf` file, and there is none");
        }
    }
    Ok(())
}

fn from_urdf(table: &RobotTable, path: PathBuf) -> Result<RobotDescription, ScenarioError> {
    let ends = ChainEnds { base: table.base.clone(), tip: table.tip.clone() };
    RobotDescription::read_urdf(&path, &ends).map_err(|error| ScenarioError::Urdf {
        key: "robot.urdf".into(),
        path,
        error: Box::new(error),
    })
}

fn dh_row(row: &DhTable) -> DhRow {
    DhRow { a: row.a.0, alpha: row.alpha.0, d: row.d.0, offset: row.offset.0 }
}

fn model(name: ModelName) -> Model {
    match name {
        ModelName::Puma560 => Model::Puma560,
        ModelName::Planar2R => Model::Planar2R,
        ModelName::Pa10 => Model::Pa10,
        ModelName::Ur5e => Model::Ur5e,
        ModelName::Ur20 => Model::Ur20,
        ModelName::Panda => Model::Panda,
    }
}
