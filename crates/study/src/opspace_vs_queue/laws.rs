use super::reference;
use crate::bench::pid;
use slideway_motion::control::task_space::{OperationalSettings, OperationalSpace, ToolFeedback, ToolGains, ToolState};
use slideway_motion::control::{TorqueController, TorqueLaw};
use slideway_motion::plant::PlantState;
use slideway_motion::{JointState, MotionError};
use slideway_robot::{Dynamics, JointVector, Task, Twist};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Law {
    Operational,
    JointPid,
    ComputedTorque,
}

impl Law {
    pub(super) const ALL: [Self; 3] = [Self::Operational, Self::JointPid, Self::ComputedTorque];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Operational => "operational space",
            Self::JointPid => "joint PID, gravity compensated",
            Self::ComputedTorque => "joint computed torque",
        }
    }

    pub(super) fn key(self) -> &'static str {
        match self {
            Self::Operational => "operational",
            Self::JointPid => "joint-pid",
            Self::ComputedTorque => "computed-torque",
        }
    }
}

pub(super) struct Controllers {
    space: OperationalSpace<6>,
    feedback: ToolFeedback,
    pid: TorqueController<6>,
    computed: TorqueController<6>,
}

impl Controllers {
    pub(super) fn new(model: &Dynamics<6>) -> Result<Self, MotionError> {
        let largest = JointVector::from_element(f64::INFINITY);
        let settings = OperationalSettings { length: 0.3, largest_inertia: 200.0, posture_damping: 0.0 };
        let both = ToolGains::uniform;
        let (strong, weak) = (pid(400.0, 0.0, 80.0, 1e3)?, pid(20.0, 0.0, 4.0, 1e3)?);
        let joints = [strong, strong, pid(200.0, 0.0, 40.0, 1e3)?, weak, weak, weak];
        let linear = [pid(100.0, 0.0, 20.0, 1e6)?; 6];
        Ok(Self {
            space: OperationalSpace::new(model.clone(), Task::Pose, settings, largest)?,
            feedback: ToolFeedback { proportional: both(100.0, 100.0)?, derivative: both(20.0, 20.0)? },
            pid: TorqueController::new(model.clone(), TorqueLaw::GravityCompensation, joints, largest)?,
            computed: TorqueController::new(model.clone(), TorqueLaw::ComputedTorque, linear, largest)?,
        })
    }

    pub(super) fn torque(&mut self, law: Law, wanted: &JointState<6>, state: &PlantState<6>) -> JointVector<6> {
        let (q, qd) = (&state.q, &state.qd);
        match law {
            Law::JointPid => self.pid.step(wanted, q, qd).torque,
            Law::ComputedTorque => self.computed.step(wanted, q, qd).torque,
            Law::Operational => {
                let model = self.space.dynamics();
                let tool = ToolState::of(model.arm(), q, qd);
                let acceleration = self.feedback.acceleration(&reference(model, wanted), &tool);
                self.space.step(q, qd, &acceleration, &Twist::zeros()).torque
            }
        }
    }
}
