use crate::{DhRow, Drive, Dynamics, DynamicsError, Joint, JointKind, LinkInertia, Pose, RobotError, SerialArm};

/// An arm as a file or a table describes it, its number of joints known at run time only.
///
/// [`RobotDescription::arm`] and [`RobotDescription::dynamics`] turn it into types that compute.
#[derive(Clone, Debug, PartialEq)]
pub struct RobotDescription {
    /// Name of the robot.
    pub name: String,
    /// Name of the frame that poses are expressed in.
    pub base: String,
    /// Name of the frame that counts as the tool.
    pub tip: String,
    /// The joints that move, from base to tip.
    pub joints: Vec<JointDescription>,
    /// Pose of the tip in the frame of the last joint after its motion.
    pub tool: Pose,
    /// What was read and left aside, in words.
    pub notes: Vec<String>,
    /// The DH table the description was made from, if it was.
    pub(crate) dh: Option<Vec<DhRow>>,
}

/// A joint with everything known about it and about the link it moves.
#[derive(Clone, Debug, PartialEq)]
pub struct JointDescription {
    /// Its name.
    pub name: String,
    /// Where it sits and how it moves.
    pub joint: Joint,
    /// How far, how fast and how strong.
    pub limits: JointLimits,
    /// The link behind it, in the frame of the joint after its motion; massless if nothing is known.
    pub link: LinkInertia,
    /// Its motor.
    pub drive: Drive,
}

/// Limits of a joint; `None` where there is none, or none is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointLimits {
    /// Positions, rad or m.
    pub position: Option<PositionRange>,
    /// Largest speed, rad/s or m/s.
    pub velocity: Option<f64>,
    /// Largest torque or force, N·m or N.
    pub effort: Option<f64>,
}

/// A closed range of joint positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionRange {
    /// Smallest position, rad or m.
    pub lower: f64,
    /// Largest position, rad or m.
    pub upper: f64,
}

impl PositionRange {
    /// Whether a position lies in the range; NaN does not.
    #[must_use]
    pub fn contains(&self, q: f64) -> bool {
        q >= self.lower && q <= self.upper
    }
}

impl RobotDescription {
    /// A description of an arm of revolute joints by a standard DH table, joints named `joint1` and on.
    #[must_use]
    pub fn from_dh(name: &str, rows: &[DhRow]) -> Self {
        let mut before = Pose::identity();
        let joints = rows.iter().enumerate().map(|(i, row)| {
            let origin = std::mem::replace(&mut before, row.after_joint());
            let axis = nalgebra::Vector3::z_axis();
            JointDescription {
                name: format!("joint{}", i + 1),
                joint: Joint { origin, axis, kind: JointKind::Revolute, offset: row.offset },
                limits: JointLimits::default(),
                link: LinkInertia::default(),
                drive: Drive::default(),
            }
        });
        Self {
            name: name.to_owned(),
            base: "base".into(),
            joints: joints.collect(),
            tool: before,
            tip: "tool".into(),
            notes: Vec::new(),
            dh: Some(rows.to_vec()),
        }
    }

    /// Number of joints that move.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.joints.len()
    }

    /// The arm's kinematics.
    ///
    /// # Errors
    ///
    /// The description has another number of joints, or a number in its DH table is not finite.
    pub fn arm<const N: usize>(&self) -> Result<SerialArm<N>, RobotError> {
        let wrong = |found| RobotError::JointCount { found, expected: N };
        if let Some(rows) = &self.dh {
            let rows: [DhRow; N] = rows.as_slice().try_into().map_err(|_| wrong(rows.len()))?;
            return SerialArm::from_dh(rows);
        }
        let joints: Vec<Joint> = self.joints.iter().map(|j| j.joint).collect();
        let joints = <[Joint; N]>::try_from(joints).map_err(|j| wrong(j.len()))?;
        Ok(SerialArm::new(joints, self.tool))
    }

    /// Whether any link has a mass: without one there are no torques to compute.
    #[must_use]
    pub fn has_masses(&self) -> bool {
        self.joints.iter().any(|j| !j.link.is_massless())
    }

    /// The arm's dynamics, rotor inertia and friction off.
    ///
    /// # Errors
    ///
    /// As [`RobotDescription::arm`]; a link that is no rigid body.
    pub fn dynamics<const N: usize>(&self) -> Result<Dynamics<N>, RobotError> {
        let arm = self.arm::<N>()?;
        let links: [LinkInertia; N] = std::array::from_fn(|i| self.joints[i].link);
        let drives: [Drive; N] = std::array::from_fn(|i| self.joints[i].drive);
        let with_drives = |d: Dynamics<N>| d.with_drives(drives);
        let made: Result<Dynamics<N>, DynamicsError> = Dynamics::new(arm, links).and_then(with_drives);
        Ok(made?)
    }

    /// Largest speeds of the joints, if every joint has one, rad/s or m/s.
    #[must_use]
    pub fn velocity_limits(&self) -> Option<Vec<f64>> {
        self.joints.iter().map(|j| j.limits.velocity).collect()
    }

    /// The torque limits of all joints, N·m (N), if every joint has one.
    #[must_use]
    pub fn effort_limits(&self) -> Option<Vec<f64>> {
        self.joints.iter().map(|j| j.limits.effort).collect()
    }

    /// Replaces the limits of a joint by name.
    ///
    /// # Errors
    ///
    /// There is no joint of that name, or the limits are inverted or not positive.
    pub fn override_limits(&mut self, joint: &str, limits: JointLimits) -> Result<(), RobotError> {
        let unknown = || RobotError::UnknownJoint {
            name: joint.to_owned(),
            known: self.joints.iter().map(|j| j.name.clone()).collect(),
        };
        let index = self.joints.iter().position(|j| j.name == joint).ok_or_else(unknown)?;
        limits.validate(joint)?;
        self.joints[index].limits = limits;
        Ok(())
    }
}

impl JointLimits {
    /// Checks that the range is not inverted and that the others are positive.
    ///
    /// # Errors
    ///
    /// The first one that is wrong, with the joint's name.
    pub fn validate(&self, joint: &str) -> Result<(), RobotError> {
        if let Some(PositionRange { lower, upper }) = self.position.filter(|range| !(range.lower <= range.upper)) {
            return Err(RobotError::InvertedLimits { joint: joint.to_owned(), lower, upper });
        }
        for (what, limit) in [("velocity", self.velocity), ("effort", self.effort)] {
            if let Some(value) = limit.filter(|limit| !(*limit > 0.0)) {
                return Err(RobotError::LimitNotPositive { joint: joint.to_owned(), what, value });
            }
        }
        Ok(())
    }
}
