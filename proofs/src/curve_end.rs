//! Claim `curve-end`: a curve whose rate is decided sample by sample is never run backwards, never passed, and ends at rest.
//!
//! Hypotheses: place `u` and rate `w >= 0` at a sample with `u + Ts w / 2 <= 1`; the next rate `w2` in
//!
//! ```text
//! 0 <= w2 <= (1 - u - Ts w / 2) / Ts
//! ```
//!
//! and the rate linear in time between the two, so that `u2 = u + Ts (w + w2) / 2`. Then the same holds at the next sample, every place
//! between lies in `[u, u2]`, and `u2 <= 1`. Where `w2` is the largest that is allowed, a rate of 0 after it leads to 1 itself: from
//! every state two samples of `w2` and 0 end there, if the joints can take them. To that the look-ahead sees (claim `look-ahead-tail`), whose
//! plan ends by `α Ts² / 8` before the curve's end: by so much a stop in whole samples is longer than one at constant deceleration `α`.
//!
//! Source: this project.
//!
//! Derivation. Seen from `x = u + Ts w / 2` the next is `x + Ts w2`. The place between two samples is monotone, for its rate is a mean of
//! two rates that are not negative.
//!
//! Rounding. `u` is cut at 1; a remainder below 1e-12 counts as none.
//!
//! Dropped hypothesis: the half. With `w2` up to `2 (1 - u - Ts w / 2) / Ts` the next sample is still on the curve, and the one after
//! it is not.

use nalgebra::Vector3;
use slideway_motion::tool::{Regulation, SpeedLaw, ToolCurve, ToolKinematics, ToolLine};
use slideway_motion::{AxisLimits, MotionLimits, MotionQueue, Progress};
use slideway_robot::{DhRow, Pose, RobotError, SerialArm, Task};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "curve-end",
    statement: "A curve whose rate is decided sample by sample is never run backwards and never passed, at samples and between them, and a stand leads to its end.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "curve-end.smt2", text: include_str!("../smt/curve-end.smt2") }],
    twins: &[Twin {
        without: "half",
        script: Script {
            file: "curve-end-without-half.smt2",
            text: include_str!("../smt/curve-end-without-half.smt2"),
        },
    }],
    engines: &[Engine {
        name: "a_curve_is_never_run_backwards_never_passed_and_ends_at_rest",
        unit: "m",
        about: About::Other,
        cost: Cost::Motion,
        trial: ends_at_rest,
    }],
};

/// Set-points of a curve after which it is taken for one that never ends: more than ten times what these take.
const MOST: u32 = 20_000;

/// Changes of pace.
const PACES: usize = 4;

/// Two links of a metre.
///
/// # Errors
///
/// None.
pub fn arm() -> Result<SerialArm<2>, RobotError> {
    SerialArm::from_dh([DhRow { a: 1.0, ..DhRow::default() }; 2])
}

/// A line of the tool, and how far along it the tool of a set-point is.
struct Line {
    arm: SerialArm<2>,
    start: Vector3<f64>,
    along: Vector3<f64>,
    /// m.
    length: f64,
}

impl Line {
    /// m.
    fn place(&self, queue: &MotionQueue<2, 4>) -> f64 {
        (self.arm.forward(&queue.set_point().q).translation.vector - self.start).dot(&self.along)
    }
}

/// Runs the line to its end and gives the smallest margin, m: the slack less the length by which the tool went back, passed the end or
/// stopped beside it.
///
/// Slack. Inverse kinematics ends within 1e-10 m of a place, twice for a difference; the queue counts a remainder of 1e-12 of the line,
/// whose length is at most 0.6 m, as none.
fn run(line: &Line, queue: &mut MotionQueue<2, 4>, choices: &mut Choices) -> Result<f64, Stop> {
    const SLACK: f64 = 2e-10 + 1e-12;
    let period = choices.decade(-2.2, -1.4);
    let mut paces = choices.below(1 + PACES);
    let (mut left, mut before, mut margin) = (0.0, 0.0, f64::INFINITY);
    for _ in 0..MOST {
        if queue.is_empty() {
            let ended = exactly(queue.set_point().is_at_rest() && queue.progress() == Progress::Resting);
            return Ok(worse(worse(margin, ended), SLACK - (before - line.length).abs()));
        }
        if left <= 0.0 {
            let (seconds, pace) = (choices.between(0.0, 0.1), choices.share());
            (left, paces) = if paces > 0 { (seconds, paces - 1) } else { (f64::INFINITY, 0) };
            queue.set_rate(if left.is_finite() { pace } else { 1.0 })?;
        }
        queue.advance(period)?;
        let after = line.place(queue);
        margin = worse(margin, SLACK + (after - before).min(line.length - after));
        before = after;
        left -= period;
    }
    Err(Stop::Refused(format!("not at its end after {MOST} set-points")))
}

/// A line of the tool, 0.6 m at most, under either law that decides sample by sample, its pace changed at random times.
///
/// The law decides every 4 to 10 ms and the queue is asked for set-points every 6 to 40 ms: at a millisecond a case costs several times as
/// much, and at longer periods half of the lines are refused as too rough for them.
fn ends_at_rest(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let from = [choices.between(0.2, 1.2), choices.between(1.0, 2.0)];
    let (x, y) = (choices.between(-0.4, 0.4), choices.between(-0.4, 0.4));
    let scale = choices.pick([1.0, 0.1, 0.03, 0.01]);
    let [x, y] = [x * scale, y * scale];
    let regulation = Regulation { sampling_period: choices.between(4e-3, 1e-2), ..Regulation::DEFAULT };
    // Natural motion is planned by a rehearsal, at twice the cost: one case in four.
    let sliding = SpeedLaw::SlidingMode(regulation);
    let law = choices.pick([sliding, sliding, sliding, SpeedLaw::Natural(regulation)]);
    let arm = arm()?;
    let limits = MotionLimits::without_stops([AxisLimits::new(1.5, 8.0, 100.0)?; 2]);
    let kinematics = ToolKinematics::new(arm.clone(), Task::PlanarPosition, 0.02)?;
    let mut queue = MotionQueue::<2, 4>::new(limits, from.into())?.with_tool(kinematics);
    let start = queue.tool_pose()?;
    let curve = ToolLine::new(&start, &(Pose::translation(x, y, 0.0) * start));
    // Lines out of reach or through a singular place are refused, which is not what this is about.
    queue.move_tool_along(&ToolCurve::Line(curve), &law).map_err(|_| Stop::Skipped)?;
    let length = x.hypot(y);
    let along = Vector3::new(x, y, 0.0) / length.max(f64::MIN_POSITIVE);
    run(&Line { arm, start: start.translation.vector, along, length }, &mut queue, choices)
}
