use crate::{
    DhRow, Drive, Dynamics, DynamicsError, Follower, GRAVITY, Joint, JointKind, JointLimits, LimitKind, LinkInertia,
    Note, Pose, RobotError, SerialArm,
};
use nalgebra::Vector3;

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
    /// Other links that could have been meant as the tip; none where the tip was given.
    pub tip_alternatives: Vec<String>,
    /// The joints that move on their own, from base to tip.
    pub joints: Vec<JointDescription>,
    /// The joints between base and tip that follow one of [`RobotDescription::joints`], from base to tip.
    pub followers: Vec<FollowerDescription>,
    /// Pose of the tip in the frame of the last joint after its motion.
    pub tool: Pose,
    /// Gravitational acceleration in the base frame, m/s².
    pub gravity: Vector3<f64>,
    /// Notes on what was guessed, held or left aside.
    pub notes: Vec<Note>,
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
    /// Limits of position, speed, torque, acceleration and jerk.
    pub limits: JointLimits,
    /// The link behind it, in the frame of the joint after its motion; massless if nothing is known.
    pub link: LinkInertia,
    /// Its motor.
    pub drive: Drive,
}

/// A joint that follows another, with its link. Its friction and its limits are part of its leader's.
#[derive(Clone, Debug, PartialEq)]
pub struct FollowerDescription {
    /// Its name.
    pub name: String,
    /// Where it sits and how it follows.
    pub follower: Follower,
    /// The link behind it, in the frame of the joint after its motion.
    pub link: LinkInertia,
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
            tip_alternatives: Vec::new(),
            followers: Vec::new(),
            gravity: GRAVITY,
            notes: Vec::new(),
            dh: Some(rows.to_vec()),
        }
    }

    /// Number of joints that move on their own.
    #[must_use]
    pub fn joint_count(&self) -> usize {
        self.joints.len()
    }

    /// The arm's kinematics.
    ///
    /// # Errors
    ///
    /// The description has another number of joints, a number in its DH table is not finite, or a follower has no leader.
    pub fn arm<const N: usize>(&self) -> Result<SerialArm<N>, RobotError> {
        let wrong = |found| RobotError::JointCount { found, expected: N };
        if let Some(rows) = &self.dh {
            let rows: [DhRow; N] = rows.as_slice().try_into().map_err(|_| wrong(rows.len()))?;
            return SerialArm::from_dh(rows);
        }
        let joints: Vec<Joint> = self.joints.iter().map(|j| j.joint).collect();
        let joints = <[Joint; N]>::try_from(joints).map_err(|j| wrong(j.len()))?;
        SerialArm::new(joints, self.tool).with_followers(self.followers.iter().map(|f| f.follower).collect())
    }

    /// True if any link has a mass: without one there are no torques to compute.
    #[must_use]
    pub fn has_masses(&self) -> bool {
        let links = self.joints.iter().map(|j| &j.link).chain(self.followers.iter().map(|f| &f.link));
        links.into_iter().any(|link| !link.is_massless())
    }

    /// The arm's dynamics under [`RobotDescription::gravity`], rotor inertia and friction off.
    ///
    /// # Errors
    ///
    /// As [`RobotDescription::arm`]; a link that is no rigid body.
    pub fn dynamics<const N: usize>(&self) -> Result<Dynamics<N>, RobotError> {
        let arm = self.arm::<N>()?;
        let links: [LinkInertia; N] = std::array::from_fn(|i| self.joints[i].link);
        let drives: [Drive; N] = std::array::from_fn(|i| self.joints[i].drive);
        let followers = self.followers.iter().map(|f| f.link).collect();
        let complete = |d: Dynamics<N>| d.with_drives(drives)?.with_follower_links(followers);
        let made: Result<Dynamics<N>, DynamicsError> = Dynamics::new(arm, links).and_then(complete);
        Ok(made?.with_gravity(self.gravity))
    }

    /// The same robot under another gravitational acceleration, in the base frame, m/s²; with `None` it stays as it is.
    ///
    /// # Errors
    ///
    /// A number that is not finite.
    pub fn with_gravity(self, gravity: Option<[f64; 3]>) -> Result<Self, RobotError> {
        let Some(given) = gravity else { return Ok(self) };
        match given.into_iter().find(|x| !x.is_finite()) {
            Some(value) => Err(RobotError::Gravity { value }),
            None => Ok(Self { gravity: given.into(), ..self }),
        }
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

    /// Largest accelerations of the joints, if every joint has one, rad/s² or m/s².
    #[must_use]
    pub fn acceleration_limits(&self) -> Option<Vec<f64>> {
        self.joints.iter().map(|j| j.limits.acceleration).collect()
    }

    /// Names of the joints without a limit of a kind, from base to tip.
    #[must_use]
    pub fn joints_without(&self, limit: LimitKind) -> Vec<&str> {
        let lacks = |limits: &JointLimits| match limit {
            LimitKind::Position => limits.position.is_none(),
            other => limits.bound(other).is_none(),
        };
        self.joints.iter().filter(|j| lacks(&j.limits)).map(|j| j.name.as_str()).collect()
    }

    /// Replaces the limits of a joint by name.
    ///
    /// # Errors
    ///
    /// There is no joint of that name, or the limits are inverted or not positive.
    pub fn override_limits(&mut self, joint: &str, limits: JointLimits) -> Result<(), RobotError> {
        let index = self.index_of(joint)?;
        limits.validate(joint)?;
        self.joints[index].limits = limits;
        Ok(())
    }
    pub(crate) fn index_of(&self, joint: &str) -> Result<usize, RobotError> {
        let unknown = || {
            let mut known: Vec<String> = self.joints.iter().map(|j| j.name.clone()).collect();
            known.sort_by_key(|name| strsim::levenshtein(name, joint));
            RobotError::UnknownJoint { name: joint.to_owned(), known }
        };
        self.joints.iter().position(|j| j.name == joint).ok_or_else(unknown)
    }
}
