use proptest::prelude::{Just, ProptestConfig, Strategy, prop_assert, prop_oneof, proptest};
use slideway_motion::{AxisLimits, Interpolation, JointState, MotionError, MotionLimits, MotionQueue, Range};
use slideway_proofs::queue_continuity::CLAIM;

use crate::support::{Outcome, config, counterexample, joints, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The interval check as the queue does it: `r² Q''` for a pace and a planned acceleration.
fn product(pace: Range, acceleration: Range) -> Range {
    pace.times(pace).times(acceleration)
}

#[test]
fn checked_at_the_ends_alone_a_span_hides_what_the_whole_span_shows() -> Outcome {
    let model = counterexample(&CLAIM, "whole-span")?;
    let (a, limit, t) = (model.value("a")?, model.value("A")?, model.value("t")?);
    let at = |t: f64| product(Range::point(1.0 - t), Range::point(t * a)).magnitude();
    assert!(at(0.0) <= limit && at(1.0) <= limit && at(t) >= 1.05 * limit);
    let whole = product(Range { lower: 0.0, upper: 1.0 }, Range { lower: 0.0, upper: a });
    assert!(whole.magnitude() >= at(t));
    Ok(())
}

const ACCELERATION: f64 = 4.0;

/// A command, and the time that passes afterwards.
#[derive(Clone, Debug)]
enum Command {
    GoTo([f64; 2], Interpolation),
    InterruptTo([f64; 2], Interpolation),
    Pace(f64),
    StopAtWayPoint,
    BrakeFully,
}

fn command() -> impl Strategy<Value = (Command, f64)> {
    let family = || prop_oneof![Just(Interpolation::Trapezoid), Just(Interpolation::Cubic)];
    let command = prop_oneof![
        4 => (joints::<2>(-2.0..2.0), family()).prop_map(|(q, family)| Command::GoTo(q, family)),
        2 => joints::<2>(-2.0..2.0).prop_map(|q| Command::InterruptTo(q, Interpolation::Trapezoid)),
        3 => prop_oneof![Just(0.0), Just(1.0), 0.0..1.0].prop_map(Command::Pace),
        1 => Just(Command::StopAtWayPoint),
        1 => Just(Command::BrakeFully),
    ];
    (command, 0.0..0.6_f64)
}

fn give(queue: &mut MotionQueue<2, 8>, command: &Command) -> Result<(), MotionError> {
    match command {
        Command::GoTo(q, family) => queue.go_to(&(*q).into(), *family),
        Command::InterruptTo(q, family) => queue.interrupt_to(&(*q).into(), *family),
        Command::Pace(pace) => queue.set_rate(*pace),
        Command::StopAtWayPoint => {
            queue.stop_at_way_point();
            Ok(())
        }
        Command::BrakeFully => {
            queue.brake_fully();
            Ok(())
        }
    }
}

/// By how much a step exceeds what acceleration limits allow, rad/s and rad.
fn excess(before: &JointState<2>, after: &JointState<2>, h: f64) -> (f64, f64) {
    let speed = (after.qd - before.qd).amax() - ACCELERATION * h;
    let position = (after.q - before.q - before.qd * h).amax() - 0.5 * ACCELERATION * h * h;
    (speed, position)
}

proptest! {
    #![proptest_config(ProptestConfig { ..config() })]

    #[test]
    fn no_sequence_of_commands_makes_a_set_point_jump(
        commands in proptest::collection::vec(command(), 1..8),
        period in prop_oneof![Just(1e-3), 2e-3..2e-2],
    ) {
        let limits = MotionLimits::without_stops([AxisLimits::new(1.5, ACCELERATION, 60.0)?; 2]);
        let mut queue = MotionQueue::<2, 8>::new(limits, [0.0, 0.0].into())?;
        let mut before = queue.set_point();
        for (command, seconds) in &commands {
            // A command that is refused changes nothing: that is part of what is checked.
            let _ = give(&mut queue, command);
            for _ in 0..(seconds / period) as usize {
                let after = queue.advance(period)?;
                let (speed, position) = excess(&before, &after, period);
                // The planner of moving states ends within 2e-8 of its target, where the queue goes on from rest.
                prop_assert!(speed <= 2e-8 + 1e-9 && position <= 2e-8 + 1e-9, "{speed:e} {position:e} after {command:?}");
                before = after;
            }
        }
    }
}
