use crate::{DhRow, JointLimits, LinkInertia, PositionRange, RobotDescription, RobotError, models};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A built-in arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// PUMA-560, six joints, with dynamics: [`models::puma560_dynamics`].
    Puma560,
    /// Planar arm of two thin rods of 1 m and 1 kg, axes along z, so that gravity does no work on it.
    Planar2R,
    /// Mitsubishi PA-10, seven joints, geometry only: 0.317, 0.45, 0.5 and 0.08 m along the stretched arm.
    Pa10,
    /// Universal Robots UR5e, six joints, geometry and limits, from the manufacturer's table of DH parameters and published
    /// robot description.
    Ur5e,
    /// Universal Robots UR20, six joints, with dynamics, from the manufacturer's table of DH parameters and
    /// dynamics and published robot description.
    Ur20,
    /// Franka Emika Panda, seven joints, geometry and limits from the manufacturer's interface specification; the tool is
    /// the flange.
    Panda,
}

impl Model {
    /// All built-in arms.
    pub const ALL: [Self; 6] = [Self::Puma560, Self::Planar2R, Self::Pa10, Self::Ur5e, Self::Ur20, Self::Panda];

    /// The name used on the command line and in scenario files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Puma560 => "puma560",
            Self::Planar2R => "planar-2r",
            Self::Pa10 => "pa10",
            Self::Ur5e => "ur5e",
            Self::Ur20 => "ur20",
            Self::Panda => "panda",
        }
    }

    /// One line on what it is.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Puma560 => "PUMA-560, 6 joints, dynamics; base at the shoulder, tool at the wrist centre",
            Self::Planar2R => "two thin rods of 1 m and 1 kg in the horizontal plane, dynamics",
            Self::Pa10 => "Mitsubishi PA-10, 7 joints, geometry",
            Self::Ur5e => "Universal Robots UR5e, 6 joints, geometry and limits",
            Self::Ur20 => "Universal Robots UR20, 6 joints, limits and dynamics",
            Self::Panda => "Franka Emika Panda, 7 joints, geometry and limits, tool at the flange",
        }
    }

    /// The built-in arm of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|model| model.name() == name)
    }

    /// Everything known about the arm.
    ///
    /// # Errors
    ///
    /// None with the numbers built in; the checks every description passes are not bypassed.
    pub fn describe(self) -> Result<RobotDescription, RobotError> {
        match self {
            Self::Puma560 => puma560(),
            Self::Planar2R => Ok(planar_2r()),
            Self::Pa10 => Ok(pa10()),
            Self::Ur5e => Ok(ur5e()),
            Self::Ur20 => Ok(ur20()),
            Self::Panda => Ok(panda()),
        }
    }
}

fn row(a: f64, alpha: f64, d: f64) -> DhRow {
    DhRow { a, alpha, d, offset: 0.0 }
}

fn degrees(lower: f64, upper: f64) -> PositionRange {
    PositionRange { lower: lower.to_radians(), upper: upper.to_radians() }
}

/// Position limits as in Corke's Robotics Toolbox.
fn puma560() -> Result<RobotDescription, RobotError> {
    let dynamics = models::puma560_dynamics()?;
    let rows = dynamics.arm().dh().copied().unwrap_or_default();
    let mut robot = RobotDescription::from_dh("puma560", &rows);
    let ranges = [
        degrees(-160.0, 160.0),
        degrees(-45.0, 225.0),
        degrees(-225.0, 45.0),
        degrees(-110.0, 170.0),
        degrees(-100.0, 100.0),
        degrees(-266.0, 266.0),
    ];
    for (i, joint) in robot.joints.iter_mut().enumerate() {
        joint.limits.position = Some(ranges[i]);
        joint.link = dynamics.links()[i];
        joint.drive = dynamics.drives()[i];
    }
    Ok(robot)
}

fn planar_2r() -> RobotDescription {
    let mut robot = RobotDescription::from_dh("planar-2r", &[row(1.0, 0.0, 0.0), row(1.0, 0.0, 0.0)]);
    // A thin rod along x: m l² / 12 about its middle.
    let moment = 1.0 / 12.0;
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.0, moment, moment));
    for joint in &mut robot.joints {
        joint.link = LinkInertia { mass: 1.0, com: Vector3::new(0.5, 0.0, 0.0), inertia };
    }
    robot
}

/// `Rz [0.317] Ry Rz [0.45] Ry Rz [0.5] Ry Rz [0.08]`, written as a standard DH table.
fn pa10() -> RobotDescription {
    let rows = [
        row(0.0, -FRAC_PI_2, 0.317),
        row(0.0, FRAC_PI_2, 0.0),
        row(0.0, -FRAC_PI_2, 0.45),
        row(0.0, FRAC_PI_2, 0.0),
        row(0.0, -FRAC_PI_2, 0.5),
        row(0.0, FRAC_PI_2, 0.0),
        row(0.0, 0.0, 0.08),
    ];
    RobotDescription::from_dh("pa10", &rows)
}

/// Lengths in m, speeds in degrees per second, torques in Nm; the elbow turns half a turn either way, the others a whole one.
fn universal(name: &str, a: [f64; 2], d: [f64; 4], speeds: [f64; 6], efforts: [f64; 6]) -> RobotDescription {
    let rows = [
        row(0.0, FRAC_PI_2, d[0]),
        row(a[0], 0.0, 0.0),
        row(a[1], 0.0, 0.0),
        row(0.0, FRAC_PI_2, d[1]),
        row(0.0, -FRAC_PI_2, d[2]),
        row(0.0, 0.0, d[3]),
    ];
    let mut robot = RobotDescription::from_dh(name, &rows);
    for (i, joint) in robot.joints.iter_mut().enumerate() {
        let reach = if i == 2 { PI } else { 2.0 * PI };
        let position = Some(PositionRange { lower: -reach, upper: reach });
        joint.limits = JointLimits {
            position,
            velocity: Some(speeds[i].to_radians()),
            effort: Some(efforts[i]),
            ..JointLimits::default()
        };
    }
    robot
}

fn ur5e() -> RobotDescription {
    let efforts = [150.0, 150.0, 150.0, 28.0, 28.0, 28.0];
    universal("ur5e", [-0.425, -0.3922], [0.1625, 0.1333, 0.0997, 0.0996], [180.0; 6], efforts)
}

fn ur20() -> RobotDescription {
    let speeds = [120.0, 120.0, 150.0, 210.0, 210.0, 210.0];
    let efforts = [738.0, 738.0, 433.0, 107.0, 107.0, 107.0];
    let mut robot = universal("ur20", [-0.8620, -0.7287], [0.2363, 0.2010, 0.1593, 0.1543], speeds, efforts);
    // Mass, centre of mass, and the matrix by its entries xx, yy, zz, xy, xz, yz, all in the frame of the DH convention.
    let links = [
        (16.343, [0.0, -0.0610, 0.0062], [0.08866, 0.07632, 0.08418, -0.00011, -0.00011, 0.00720]),
        (29.632, [0.5226, 0.0, 0.2098], [0.14670, 4.66590, 4.63480, 0.00019, -0.05163, 0.00004]),
        (7.879, [0.3234, 0.0, 0.0604], [0.02612, 0.75763, 0.75327, -0.00005, -0.02898, -0.00001]),
        (3.054, [0.0, -0.0026, 0.0393], [0.00555, 0.00537, 0.00402, -0.00001, -0.00002, 0.00036]),
        (3.126, [0.0, 0.0024, 0.0379], [0.00586, 0.00578, 0.00427, -0.00001, -0.00002, -0.00037]),
        (0.926, [0.0, 0.0, -0.0293], [0.00092, 0.00091, 0.00117, 0.0, 0.0, 0.0]),
    ];
    let rows = robot.dh.clone().unwrap_or_default();
    for (i, (mass, com, [xx, yy, zz, xy, xz, yz])) in links.into_iter().enumerate() {
        let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let link = LinkInertia { mass, com: com.into(), inertia };
        robot.joints[i].link = link.seen_from(&rows[i].after_joint());
    }
    robot
}

/// The manufacturer gives Craig's convention, `Rx(α) Tx(a) Rz(q) Tz(d)`; as a standard table the `a` and `α` of a row move
/// to the row before, and the first row's must be zero, which they are.
fn panda() -> RobotDescription {
    let rows = [
        row(0.0, -FRAC_PI_2, 0.333),
        row(0.0, FRAC_PI_2, 0.0),
        row(0.0825, FRAC_PI_2, 0.316),
        row(-0.0825, -FRAC_PI_2, 0.0),
        row(0.0, FRAC_PI_2, 0.384),
        row(0.088, FRAC_PI_2, 0.0),
        row(0.0, 0.0, 0.107),
    ];
    let ranges = [
        (-2.8973, 2.8973),
        (-1.7628, 1.7628),
        (-2.8973, 2.8973),
        (-3.0718, -0.0698),
        (-2.8973, 2.8973),
        (-0.0175, 3.7525),
        (-2.8973, 2.8973),
    ];
    let mut robot = RobotDescription::from_dh("panda", &rows);
    for (i, joint) in robot.joints.iter_mut().enumerate() {
        let (lower, upper) = ranges[i];
        let (velocity, effort) = if i < 4 { (2.175, 87.0) } else { (2.61, 12.0) };
        let position = Some(PositionRange { lower, upper });
        joint.limits =
            JointLimits { position, velocity: Some(velocity), effort: Some(effort), ..JointLimits::default() };
    }
    robot
}
