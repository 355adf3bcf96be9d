use super::seam::{ACCELERATION, Law, SPEED, beginning, home, kinematics, limits, seam};
use crate::StudyError;
use slideway_motion::supervisor::{Inputs, Mode, QueueState, SegmentKind};
use slideway_motion::tool::ToolCurve;
use slideway_motion::{ArmController, ControllerSettings, Interpolation, JointState, MotionError, MotionQueue};
use slideway_robot::{JointVector, SerialArm, models};

/// Sampling period, s.
const PERIOD: f64 = 1e-3;
/// Time for which the arm waits after the brake, s.
const PAUSE: f64 = 0.3;
/// After this long every run has to be over, s.
const PATIENCE: f64 = 30.0;

/// Interruption of the motion along the seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Interruption {
    None,
    /// A brake on the path when half of the seam is done.
    HalfWay,
}

/// Measurements of one run of the cell.
#[derive(Default)]
pub(super) struct CellRun {
    /// From the beginning of the seam to its end, pauses included, s.
    pub(super) seam_time: f64,
    /// From home to home, s.
    pub(super) cycle_time: f64,
    /// From the request to brake to rest, s.
    pub(super) brake_time: f64,
    /// Largest distance of the tool from the seam, at and between set-points, m.
    pub(super) path_error: f64,
    /// Largest joint speed, and largest change of one over a sample, as shares of their limits.
    pub(super) limit_use: f64,
    pub(super) ends_at_home: bool,
    /// True if the seam was paused exactly once.
    pub(super) pauses_once: bool,
    /// Rate of the seam over its share.
    pub(super) rates: Vec<[f64; 2]>,
    /// Speed of the tool over time.
    pub(super) speeds: Vec<[f64; 2]>,
    /// Use of a limit over time.
    pub(super) uses: Vec<[f64; 2]>,
    /// y and z of the tool.
    pub(super) places: Vec<[f64; 2]>,
}

type Controller = ArmController<6, 8>;

/// Plays the cell from home to home.
pub(super) fn play(law: Law, interruption: Interruption) -> Result<CellRun, StudyError> {
    let mut player = Player::new(law)?;
    let most = (PATIENCE / PERIOD) as u32;
    for sample in 0..most {
        player.step(f64::from(sample) * PERIOD, interruption)?;
        if player.controller.mode() == Mode::Idle {
            return Ok(player.finished());
        }
    }
    Err(StudyError::Endless { what: "the welding cell", seconds: PATIENCE })
}

struct Player {
    controller: Controller,
    arm: SerialArm<6>,
    seam: ToolCurve,
    run: CellRun,
    /// Share of the seam at the last set-point on it.
    share: f64,
    asked: Option<f64>,
    paused: Option<f64>,
    pauses: u32,
}

impl Player {
    fn new(law: Law) -> Result<Self, MotionError> {
        let seam = seam()?;
        let mut queue = MotionQueue::new(limits()?, home())?.with_tool(kinematics()?);
        queue.go_to(&beginning(), Interpolation::BoundedJerk)?;
        queue.move_tool_along(&seam, &law.speed_law())?;
        queue.go_to(&home(), Interpolation::BoundedJerk)?;
        let settings = ControllerSettings { sampling_period: PERIOD, brake_deadline: 1.0, recovery_rate: 0.2 };
        Ok(Self {
            controller: Controller::new(queue, settings)?,
            arm: models::puma560(),
            seam,
            run: CellRun::default(),
            share: 0.0,
            asked: None,
            paused: None,
            pauses: 0,
        })
    }

    fn step(&mut self, time: f64, interruption: Interruption) -> Result<(), MotionError> {
        let before = self.controller.queue().set_point();
        let inputs = self.inputs(time, interruption);
        let output = self.controller.step(&inputs);
        if let Some(error) = output.error {
            return Err(error);
        }
        self.watch_pause(time);
        self.record(time + PERIOD, &before, &output.set_point);
        Ok(())
    }

    fn inputs(&mut self, time: f64, interruption: Interruption) -> Inputs {
        let start = time == 0.0;
        let brake = interruption == Interruption::HalfWay && self.asked.is_none() && self.share >= 0.5;
        if brake {
            self.asked = Some(time);
        }
        let resume = self.paused.is_some_and(|since| time - since >= PAUSE);
        Inputs { start, brake_on_path: brake, resume, ..Inputs::default() }
    }

    fn watch_pause(&mut self, time: f64) {
        match (self.controller.mode(), self.paused) {
            (Mode::Paused, None) => {
                self.paused = Some(time);
                self.pauses += 1;
                self.run.brake_time = self.asked.map_or(f64::NAN, |asked| time - asked);
            }
            (Mode::Paused, Some(_)) => {}
            (_, _) => self.paused = None,
        }
    }

    fn record(&mut self, time: f64, before: &JointState<6>, after: &JointState<6>) {
        let tool = self.arm.forward(&after.q).translation.vector;
        let jacobian = self.arm.jacobian(&after.q);
        let speed = (jacobian * after.qd).fixed_rows::<3>(0).norm();
        let used = (after.qd.amax() / SPEED).max((after.qd - before.qd).amax() / (ACCELERATION * PERIOD));
        self.run.limit_use = self.run.limit_use.max(used);
        self.run.uses.push([time, used]);
        self.run.speeds.push([time, speed]);
        self.run.places.push([tool.y, tool.z]);
        self.run.cycle_time = time;
        let on_seam = matches!(
            self.controller.queue().state(),
            QueueState::Ready(SegmentKind::Tool) | QueueState::Paused(SegmentKind::Tool)
        );
        if on_seam {
            self.run.seam_time += PERIOD;
            self.follow_seam(before, after);
        }
    }

    /// Distance from the seam, at the set-point and half-way to it, and the rate there.
    fn follow_seam(&mut self, before: &JointState<6>, after: &JointState<6>) {
        let (_, distance) = self.nearest(&after.q);
        let (_, between) = self.nearest(&((before.q + after.q) * 0.5));
        self.run.path_error = self.run.path_error.max(distance).max(between);
        (self.share, _) = self.nearest(&after.q);
        let twist = self.seam.at(self.share).twist;
        let along = self.arm.jacobian(&after.q) * after.qd;
        self.run.rates.push([self.share, along.dot(&twist) / twist.norm_squared()]);
    }

    /// The place of the seam nearest to the tool, by Newton's method from the last one, and how far it is.
    fn nearest(&self, q: &JointVector<6>) -> (f64, f64) {
        let tool = self.arm.forward(q).translation.vector;
        let mut u = self.share;
        for _ in 0..8 {
            let place = self.seam.at(u);
            let (twist, gap) = (place.twist.fixed_rows::<3>(0), place.pose.translation.vector - tool);
            u = (u - gap.dot(&twist) / twist.norm_squared()).clamp(0.0, 1.0);
        }
        (u, (self.seam.at(u).pose.translation.vector - tool).norm())
    }

    fn finished(mut self) -> CellRun {
        let end = self.controller.queue().set_point();
        self.run.ends_at_home = end.is_at_rest() && (end.q - home()).amax() <= 1e-9;
        self.run.pauses_once = self.pauses == 1;
        self.run
    }
}
