use crate::supervisor::{AfterBrake, Event, Fault, Inputs, Mode, Signals, Supervisor};
use crate::{JointState, MotionError, MotionQueue};

/// Settings of an [`ArmController`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControllerSettings {
    /// Sampling period, s.
    pub sampling_period: f64,
    /// Longest brake on the path before it becomes a full brake, s.
    pub brake_deadline: f64,
    /// Pace of a recovery, in (0, 1].
    pub recovery_rate: f64,
}

/// One sample's output.
#[derive(Clone, Debug, PartialEq)]
pub struct Output<const N: usize> {
    /// Where the joints are to be.
    pub set_point: JointState<N>,
    /// The mode in which it was computed.
    pub mode: Mode,
    /// Why the motion was broken off in this sample, if it was.
    pub error: Option<MotionError>,
}

/// A queue under a supervisor: what runs once a sample on an arm's controller.
///
/// Guaranteed: the set-points are as continuous as the queue's; in a mode at rest they stand still; what cannot be computed
/// brakes the arm in the same sample.
pub struct ArmController<const N: usize, const CAPACITY: usize> {
    queue: MotionQueue<N, CAPACITY>,
    supervisor: Supervisor,
    settings: ControllerSettings,
    /// Samples since a brake on the path began, as time, s.
    braking_for: f64,
}

impl<const N: usize, const CAPACITY: usize> ArmController<N, CAPACITY> {
    /// A controller at rest.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] with the first setting out of its range.
    pub fn new(queue: MotionQueue<N, CAPACITY>, settings: ControllerSettings) -> Result<Self, MotionError> {
        let ControllerSettings { sampling_period, brake_deadline, recovery_rate } = settings;
        for (name, value, most) in [
            ("sampling_period", sampling_period, f64::MAX),
            ("brake_deadline", brake_deadline, f64::MAX),
            ("recovery_rate", recovery_rate, 1.0),
        ] {
            if !(value > 0.0 && value <= most) {
                return Err(MotionError::Setting { name, value });
            }
        }
        Ok(Self { queue, supervisor: Supervisor::default(), settings, braking_for: 0.0 })
    }

    /// The queue.
    #[must_use]
    pub fn queue(&self) -> &MotionQueue<N, CAPACITY> {
        &self.queue
    }

    /// The queue, to give it commands. After a fault only a joint motion that is meant for the recovery makes sense.
    ///
    /// # Errors
    ///
    /// [`MotionError::WrongMode`] while braking, recovering or paused.
    pub fn queue_mut(&mut self) -> Result<&mut MotionQueue<N, CAPACITY>, MotionError> {
        match self.mode() {
            Mode::Idle | Mode::JointMotion | Mode::ToolMotion | Mode::Fault(_) => Ok(&mut self.queue),
            mode @ (Mode::BrakingOnPath | Mode::Paused | Mode::BrakingFully(_) | Mode::Recovery(_)) => {
                Err(MotionError::WrongMode { mode })
            }
        }
    }

    /// The supervisor, with its log.
    #[must_use]
    pub fn supervisor(&self) -> &Supervisor {
        &self.supervisor
    }

    /// The mode.
    #[must_use]
    pub fn mode(&self) -> Mode {
        self.supervisor.mode()
    }

    /// One sample.
    pub fn step(&mut self, inputs: &Inputs) -> Output<N> {
        self.decide(inputs);
        let error =
            if self.mode().is_at_rest() { None } else { self.queue.advance(self.settings.sampling_period).err() };
        if let Some(error) = &error {
            let fault = if matches!(error, MotionError::Tool { .. }) { Fault::Tool } else { Fault::Computation };
            self.decide(&Inputs { fault: Some(fault), ..*inputs });
            // A brake is made of joint profiles; they cannot fail. If they did, the last set-point would be held.
            let _ = self.queue.advance(self.settings.sampling_period);
        }
        self.braking_for =
            if self.mode() == Mode::BrakingOnPath { self.braking_for + self.settings.sampling_period } else { 0.0 };
        Output { set_point: self.queue.set_point(), mode: self.mode(), error }
    }

    fn decide(&mut self, inputs: &Inputs) {
        let overdue = self.braking_for > self.settings.brake_deadline;
        let signals = Signals { inputs: *inputs, overdue, queue: self.queue.state() };
        if let Some(event) = self.supervisor.step(&signals) {
            self.enter(&event);
        }
    }

    /// Sets the queue's pace, or its brake, as the mode that is entered needs it.
    fn enter(&mut self, event: &Event) {
        // Paces of 0, 1 and a validated setting are never refused.
        let pace = match (event.from, event.to) {
            (_, Mode::BrakingOnPath) => Some(0.0),
            (_, Mode::Recovery(_)) => Some(self.settings.recovery_rate),
            (Mode::Paused, Mode::JointMotion | Mode::ToolMotion) => Some(1.0),
            // Another fault on the way to rest does not begin the brake anew.
            (Mode::BrakingFully(_), Mode::BrakingFully(AfterBrake::Fault(_))) => None,
            // At rest in the middle of a path a full brake only forgets the path.
            (_, Mode::BrakingFully(_)) | (Mode::Paused, _) | (Mode::Idle, Mode::Fault(_)) => {
                self.queue.brake_fully();
                None
            }
            (Mode::BrakingOnPath | Mode::Recovery(_), Mode::Idle) => Some(1.0),
            _ => None,
        };
        if let Some(pace) = pace {
            let _ = self.queue.set_rate(pace);
        }
    }
}
