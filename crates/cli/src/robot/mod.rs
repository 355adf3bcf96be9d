mod state;

use crate::args::RobotArguments;
use crate::robot::state::{Inputs, RobotState, evaluate};
use crate::say::diagnostic::{CliError, Named};
use crate::say::loaded::{scenario_error, source};
use crate::say::output::{Outcome, print, print_json};
use crate::say::words::nearest;
use comfy_table::{Table, presets};
use slideway_lab::MAX_JOINTS;
use slideway_path::formula::constant;
use slideway_robot::models::Model;
use slideway_robot::{ChainEnds, DriveEffects, RobotDescription, RobotSummary};
use slideway_scenario::robot_in;
use std::fmt::Write as _;
use std::path::Path;

pub(crate) fn run(arguments: &RobotArguments) -> Result<Outcome, CliError> {
    let robot = load(arguments)?;
    let inputs = inputs(&robot, arguments)?;
    let state = evaluate(&robot, &inputs)?;
    if arguments.json {
        print_json(&state)?;
    } else {
        print(&render(&inputs, &state))?;
    }
    Ok(Outcome::Holds)
}

/// A built-in robot by name, else the robot of a scenario file, else a URDF file.
fn load(arguments: &RobotArguments) -> Result<RobotDescription, CliError> {
    let name = arguments.robot.as_str();
    let robot = match Model::named(name) {
        Some(model) => built_in(model, arguments)?,
        None if Path::new(name).extension().is_some_and(|extension| extension == "toml") => {
            of_scenario(name, arguments)?
        }
        None => read_urdf(name, arguments)?,
    };
    if robot.joint_count() > MAX_JOINTS {
        return Err(CliError::TooManyJoints {
            name: name.to_owned(),
            base: robot.base,
            tip: robot.tip,
            joints: robot.joints.into_iter().map(|j| j.name).collect(),
            most: MAX_JOINTS,
        });
    }
    Ok(robot)
}

/// The robot of a scenario: for DH tables above all.
fn of_scenario(name: &str, arguments: &RobotArguments) -> Result<RobotDescription, CliError> {
    no_links(name, arguments)?;
    let (_, text) = source(name)?;
    let folder = Path::new(name).parent().unwrap_or(Path::new(""));
    robot_in(&text, folder).map_err(|error| scenario_error(error, name, Some(text)))
}

/// Base and tip can be chosen in URDF files only.
fn no_links(name: &str, arguments: &RobotArguments) -> Result<(), CliError> {
    for (option, link) in [("base", &arguments.base), ("tip", &arguments.tip)] {
        if link.is_some() {
            return Err(CliError::NoData { option, name: name.into(), what: "links to choose from" });
        }
    }
    Ok(())
}

fn built_in(model: Model, arguments: &RobotArguments) -> Result<RobotDescription, CliError> {
    no_links(model.name(), arguments)?;
    model.describe().map_err(|error| CliError::Robot { error: Box::new(error), name: model.name().into() })
}

fn read_urdf(name: &str, arguments: &RobotArguments) -> Result<RobotDescription, CliError> {
    let path = Path::new(name);
    if !path.exists() {
        let nearest = nearest(name, Model::ALL.iter().map(|m| m.name()));
        return Err(CliError::Unknown { what: Named::Robot, name: name.to_owned(), nearest });
    }
    let fault = |error, text| CliError::Urdf { error: Box::new(error), file: name.to_owned(), text };
    let text = RobotDescription::read_urdf_text(path).map_err(|error| fault(error, None))?;
    let ends = ChainEnds { base: arguments.base.clone(), tip: arguments.tip.clone() };
    RobotDescription::parse_urdf(&text, &ends).map_err(|error| fault(error, Some(text)))
}

/// The numbers given, zeros where none are, checked against what the robot has.
fn inputs(robot: &RobotDescription, arguments: &RobotArguments) -> Result<Inputs, CliError> {
    let no_data = |option, what| Err(CliError::NoData { option, name: robot.name.clone(), what });
    let joints = robot.joint_count();
    let zeros = || vec![0.0; joints];
    if !robot.has_masses() {
        for (option, given) in [("qdd", arguments.qdd.is_some()), ("tau", arguments.tau.is_some())] {
            if given {
                return no_data(option, "masses, hence no dynamics");
            }
        }
    }
    if arguments.rotor_inertia && robot.joints.iter().all(|j| j.drive.reflected_inertia == 0.0) {
        return no_data("rotor-inertia", "rotor inertia");
    }
    if arguments.friction && robot.joints.iter().all(|j| j.drive.friction == Default::default()) {
        return no_data("friction", "friction");
    }
    Ok(Inputs {
        q: numbers("q", arguments.q.as_deref(), joints)?.unwrap_or_else(zeros),
        qd: numbers("qd", arguments.qd.as_deref(), joints)?.unwrap_or_else(zeros),
        qdd: numbers("qdd", arguments.qdd.as_deref(), joints)?.unwrap_or_else(zeros),
        tau: numbers("tau", arguments.tau.as_deref(), joints)?,
        effects: DriveEffects { rotor_inertia: arguments.rotor_inertia, friction: arguments.friction },
    })
}

/// One finite number per joint, separated by commas if there are any, else by white space.
fn numbers(option: &'static str, text: Option<&str>, joints: usize) -> Result<Option<Vec<f64>>, CliError> {
    let Some(text) = text else { return Ok(None) };
    let fault = |message: String| {
        let remedy = format!("give {joints} numbers, for example --{option} \"{}\"", vec!["0"; joints].join(" "));
        CliError::Numbers { option, message, remedy }
    };
    let parts: Vec<&str> =
        if text.contains(',') { text.split(',').collect() } else { text.split_whitespace().collect() };
    let number = |part: &str| match part.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(number) => Err(fault(format!("{number} is not a finite number"))),
        Err(_) => constant(part.trim()).map_err(|error| fault(format!("`{}`: {error}", part.trim()))),
    };
    let numbers = parts.into_iter().map(number).collect::<Result<Vec<f64>, CliError>>()?;
    if numbers.len() != joints {
        return Err(fault(format!("{} numbers given, {joints} needed (one per joint)", numbers.len())));
    }
    Ok(Some(numbers))
}

fn render(inputs: &Inputs, state: &RobotState) -> String {
    let mut text = description(&state.robot, inputs);
    let mut matrix = |title: &str, rows: &[Vec<f64>]| {
        let _ = writeln!(text, "{title}\n{}", rows.iter().map(|row| line(row)).collect::<String>());
    };
    matrix("pose of the tool, m", &state.pose);
    matrix("Jacobian, linear rows first", &state.jacobian);
    matrix("manipulability", &[vec![state.manipulability]]);
    let Some(mass) = &state.mass_matrix else {
        return text + "no masses: no dynamics\n";
    };
    matrix("mass matrix", mass);
    for (title, values) in [
        ("gravity torque", &state.gravity),
        ("Coriolis torque", &state.coriolis),
        ("torque (inverse dynamics)", &state.torque),
        ("acceleration (forward dynamics)", &state.acceleration),
    ] {
        if let Some(values) = values {
            matrix(title, std::slice::from_ref(values));
        }
    }
    text
}

fn line(row: &[f64]) -> String {
    // A rounded negative zero prints as zero.
    row.iter().map(|x| format!("{:>13.6}", if x.abs() < 5e-7 { 0.0 } else { *x })).collect::<String>() + "\n"
}

/// Base, tip, joints with their limits, gravity where it counts, and notes.
fn description(robot: &RobotSummary, inputs: &Inputs) -> String {
    let mut text = format!("{}: {} joints from `{}` to `{}`\n", robot.name, robot.joints.len(), robot.base, robot.tip);
    if robot.has_masses {
        let [x, y, z] = robot.gravity;
        let _ = writeln!(text, "gravity in `{}`: {x:.4} {y:.4} {z:.4} m/s²", robot.base);
    }
    for note in &robot.notes {
        let _ = writeln!(text, "note: {note}");
    }
    text + &joint_table(robot, inputs).to_string() + "\n\n"
}

fn joint_table(robot: &RobotSummary, inputs: &Inputs) -> Table {
    let mut table = Table::new();
    let header = ["joint", "kind", "q", "lower", "upper", "speed", "acceleration", "torque"];
    table.load_style(presets::NOTHING).set_header(header);
    let cell = |value: Option<f64>| value.map_or("-".to_owned(), |v| format!("{v:.4}"));
    for (joint, &q) in robot.joints.iter().zip(&inputs.q) {
        let [lower, upper] = joint.position;
        let outside = lower.is_some_and(|lower| q < lower) || upper.is_some_and(|upper| q > upper);
        table.add_row([
            joint.name.clone(),
            format!("{:?}", joint.kind).to_lowercase(),
            format!("{q:.4}{}", if outside { " (outside)" } else { "" }),
            cell(lower),
            cell(upper),
            cell(joint.speed),
            cell(joint.acceleration),
            cell(joint.torque),
        ]);
    }
    table
}
