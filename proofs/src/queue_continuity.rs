//! Claim `queue-continuity`: under any sequence of commands the set-points of a queue are continuous and keep their limits.
//!
//! Hypotheses: each motion `Q(s)` keeps speed and acceleration limits by plan, from rest to rest or from the present state. A change of
//! the pace `r = ṡ`, with slope `w`, is accepted only if over each of its spans, in which `r`, `w`, `Q'` and `Q''` cover intervals,
//!
//! ```text
//! -A <= min(r r Q'') + min(w Q'),   max(r r Q'') + max(w Q') <= A        extremes over the corners of the intervals
//! ```
//!
//! Then `|r² Q'' + w Q'| <= A` at every instant (`q̈` of the set-point `q = Q(s)`), so that over `h` seconds no joint's speed changes by
//! more than `A h` and its position by no more than `A h² / 2` beside `q̇ h`. On the way the set-point is a point of the planned path: a brake
//! on the path stays on it.
//!
//! Source: this project; `[R16]` asks for it.
//!
//! Derivation. A bilinear function over a box has its extremes in the corners, `r r Q''` by two such steps; sums of bounds bound the
//! sum; the mean value theorem gives the rest. An interruption starts from the set-point given out last.
//!
//! Rounding. Intervals are rounded to nearest and compared with a slack of 1e-9 of the limit. Motions that begin in motion end within
//! 2e-8 of their target, the accuracy of their planner.
//!
//! Dropped hypothesis: that the limit is checked over the whole span, not at its ends alone.

use slideway_motion::{AxisLimits, Interpolation, JointState, MotionError, MotionLimits, MotionQueue};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "queue-continuity",
    statement: "Under any sequence of commands, interruptions and changes of pace the set-points of a motion queue are continuous with their velocities, and no joint's acceleration exceeds its limit.",
    source: "this project; asked for by [R16]",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "queue-continuity.smt2", text: include_str!("../smt/queue-continuity.smt2") },
        Script { file: "queue-continuity-sum.smt2", text: include_str!("../smt/queue-continuity-sum.smt2") },
    ],
    twins: &[Twin {
        without: "whole-span",
        script: Script {
            file: "queue-continuity-without-whole-span.smt2",
            text: include_str!("../smt/queue-continuity-without-whole-span.smt2"),
        },
    }],
    engines: &[Engine {
        name: "no_sequence_of_commands_makes_a_set_point_jump",
        unit: "share of what a period allows",
        about: About::Other,
        cost: Cost::Run,
        trial: keeps_moving,
    }],
};

/// Acceleration limit of both joints, rad/s².
const ACCELERATION: f64 = 4.0;

/// A command that the queue may refuse.
#[derive(Clone, Copy, Debug)]
enum Command {
    GoTo([f64; 2], Interpolation),
    InterruptTo([f64; 2], Interpolation),
    Pace(f64),
    StopAtWayPoint,
    BrakeOnPath,
    BrakeFully,
}

fn command(choices: &mut Choices) -> Command {
    let kind = choices.below(12);
    let target = choices.numbers::<2>(-2.0, 2.0);
    let family = choices.pick([Interpolation::Trapezoid, Interpolation::Cubic, Interpolation::BoundedJerk]);
    match kind {
        0..4 => Command::GoTo(target, family),
        4..6 => Command::InterruptTo(target, choices.pick([Interpolation::Trapezoid, Interpolation::BoundedJerk])),
        6..9 => Command::Pace(choices.share()),
        9 => Command::StopAtWayPoint,
        10 => Command::BrakeOnPath,
        _ => Command::BrakeFully,
    }
}

fn give(queue: &mut MotionQueue<2, 8>, command: Command) -> Result<(), MotionError> {
    match command {
        Command::GoTo(q, family) => queue.go_to(&q.into(), family)?,
        Command::InterruptTo(q, family) => queue.interrupt_to(&q.into(), family)?,
        Command::Pace(pace) => queue.set_rate(pace)?,
        Command::StopAtWayPoint => queue.stop_at_way_point(),
        Command::BrakeOnPath => queue.brake_on_path(),
        Command::BrakeFully => queue.brake_fully(),
    }
    Ok(())
}

/// Room that a step of `h` seconds leaves below the acceleration limit, as a share of the change that the limit allows: the smaller
/// of the speed's and the position's.
///
/// Slack. The planner of moving states ends within 2e-8 of its target, where the queue goes on from rest; the limits are checked to
/// 1e-9 of them.
fn room(before: &JointState<2>, after: &JointState<2>, h: f64) -> f64 {
    let slack = 2e-8 + 1e-9;
    let speed = (after.qd - before.qd).amax() - slack;
    let position = (after.q - before.q - before.qd * h).amax() - slack;
    worse(1.0 - speed / (ACCELERATION * h), 1.0 - position / (0.5 * ACCELERATION * h * h))
}

/// Up to seven commands at random times, 2 to 20 ms between set-points or one. A command that is refused changes nothing: that is part
/// of what is checked.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn keeps_moving(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let limits = MotionLimits::without_stops([AxisLimits::new(1.5, ACCELERATION, 60.0)?; 2]);
    let mut queue = MotionQueue::<2, 8>::new(limits, [0.0, 0.0].into())?;
    let varied = choices.between(2e-3, 2e-2);
    let period = choices.pick([1e-3, varied, varied, varied]);
    let mut before = queue.set_point();
    let mut margin = f64::INFINITY;
    for _ in 0..1 + choices.below(7) {
        let command = command(choices);
        let samples = (choices.between(0.0, 0.6) / period) as usize;
        let _ = give(&mut queue, command);
        for _ in 0..samples {
            let after = queue.advance(period)?;
            margin = worse(margin, room(&before, &after, period));
            before = after;
        }
    }
    Ok(margin)
}
