use nalgebra::Vector3;
use slideway_robot::{BodyFault, JointVector, LinkInertia, Pose, SerialArm, Twist};

/// Motion of a force sensor: pose, twist and acceleration of its frame in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorMotion {
    /// Pose of the sensor.
    pub pose: Pose,
    /// Velocity of its origin, m/s, and angular velocity, rad/s.
    pub twist: Twist,
    /// Their time derivatives.
    pub acceleration: Twist,
}

impl SensorMotion {
    /// Of an arm whose tool frame is the sensor's.
    #[must_use]
    pub fn of<const N: usize>(
        arm: &SerialArm<N>,
        q: &JointVector<N>,
        qd: &JointVector<N>,
        qdd: &JointVector<N>,
    ) -> Self {
        let frames = arm.frames(q);
        let jacobian = arm.jacobian_at(&frames);
        Self { pose: frames.tool, twist: jacobian * qd, acceleration: jacobian * qdd + arm.bias_acceleration(q, qd) }
    }
}

/// A force sensor in the wrist that carries a tool: it feels the tool's weight and inertia as well as what touches the tool.
///
/// ```text
/// sensed = external + m (g - a_c)                                    force
/// sensed = external + c × m (g - a_c) - (I α + ω × I ω)              moment about the sensor's origin
/// ```
///
/// with the centre of mass `c` from the sensor's origin and its acceleration `a_c = a + α × c + ω × (ω × c)`. Source: `[R16]`,
/// the sensor's equation, whose gravity and inertial terms it leaves to the reader. Wrenches are forces in N through the sensor's
/// origin and moments in N·m, exerted on the sensor by what it carries; sensed ones in the sensor's axes, external ones in the
/// base's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WristSensor {
    load: LinkInertia,
    gravity: Vector3<f64>,
}

impl WristSensor {
    /// A sensor that carries `load`, given in its own frame, under a gravitational acceleration in the base frame, m/s².
    ///
    /// # Errors
    ///
    /// A load that is no rigid body.
    pub fn new(load: LinkInertia, gravity: Vector3<f64>) -> Result<Self, BodyFault> {
        load.validate()?;
        Ok(Self { load, gravity })
    }

    /// External wrench on the tool, from the sensed one.
    #[must_use]
    pub fn external(&self, sensed: &Twist, motion: &SensorMotion) -> Twist {
        turned(sensed, &motion.pose) - self.own(motion)
    }

    /// Sensed wrench, from the external one; for a simulation.
    #[must_use]
    pub fn sensed(&self, external: &Twist, motion: &SensorMotion) -> Twist {
        // [R16] eq 3
        turned(&(external + self.own(motion)), &motion.pose.inverse())
    }

    /// Weight and inertial force of the load, base frame.
    fn own(&self, motion: &SensorMotion) -> Twist {
        let turn = Pose::from_parts(Vector3::zeros().into(), motion.pose.rotation);
        let LinkInertia { mass, com, inertia } = self.load.seen_from(&turn);
        let angular = |twist: &Twist| twist.fixed_rows::<3>(3).into_owned();
        let (omega, alpha) = (angular(&motion.twist), angular(&motion.acceleration));
        let linear = motion.acceleration.fixed_rows::<3>(0).into_owned();
        let force = (self.gravity - linear - alpha.cross(&com) - omega.cross(&omega.cross(&com))) * mass;
        let moment = com.cross(&force) - inertia * alpha - omega.cross(&(inertia * omega));
        stacked(&force, &moment)
    }
}

/// Force and moment expressed in axes turned by the rotation of a pose.
fn turned(wrench: &Twist, pose: &Pose) -> Twist {
    let part = |row: usize| pose.rotation * Vector3::new(wrench[row], wrench[row + 1], wrench[row + 2]);
    stacked(&part(0), &part(3))
}

fn stacked(force: &Vector3<f64>, moment: &Vector3<f64>) -> Twist {
    Twist::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
}
