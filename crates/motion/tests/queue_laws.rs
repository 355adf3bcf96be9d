//! Laws that the set-points of a queue obey under any sequence of commands and interruptions.

use proptest::prelude::*;
use slideway_motion::profile::Ramp;
use slideway_motion::{
    AxisLimits, Interpolation, JointState, MotionError, MotionLimits, MotionQueue, Progress, Repeat, WayPointRule,
    path_through,
};
use slideway_robot::{JointVector, PositionRange};

const N: usize = 3;
type Queue = MotionQueue<N, 8>;

/// A motion that begins in motion ends within 2e-8 of its target in position, speed and acceleration.
const PLANNER: f64 = 2e-8;

/// Rounding of sums of numbers below 1000, the largest jerk.
const ROUNDING: f64 = 1e-10;

const STOP: f64 = 2.5;

#[derive(Clone, Debug)]
enum Command {
    GoTo([f64; N]),
    Path([[f64; N]; 2], WayPointRule),
    InterruptTo([f64; N]),
    Rate(f64),
    BrakeOnPath,
    BrakeFully,
    StopAtWayPoint,
    Replace(usize, [f64; N]),
    GoRound([f64; N]),
}

fn point() -> impl Strategy<Value = [f64; N]> {
    prop::array::uniform3(-2.4..2.4_f64)
}

fn command() -> impl Strategy<Value = Command> {
    let rule = prop_oneof![Just(WayPointRule::MeanSlope), Just(WayPointRule::Spline)];
    prop_oneof![
        4 => point().prop_map(Command::GoTo),
        1 => (prop::array::uniform2(point()), rule).prop_map(|(p, r)| Command::Path(p, r)),
        4 => point().prop_map(Command::InterruptTo),
        3 => prop_oneof![Just(1.0), 0.0..1.0_f64].prop_map(Command::Rate),
        2 => Just(Command::BrakeOnPath),
        1 => Just(Command::BrakeFully),
        1 => Just(Command::StopAtWayPoint),
        1 => (0..4_usize, point()).prop_map(|(i, p)| Command::Replace(i, p)),
        1 => point().prop_map(Command::GoRound),
    ]
}

fn limits() -> impl Strategy<Value = MotionLimits<N>> {
    prop::array::uniform3((0.3..3.0_f64, 1.0..20.0_f64, 5.0..500.0_f64)).prop_map(|axes| {
        let axes = axes.map(|(v, a, j)| AxisLimits::new(v, a, j).expect("positive"));
        let stops = Some(PositionRange { lower: -STOP - 0.1, upper: STOP + 0.1 });
        MotionLimits::new(axes, [stops; N], 0.1).expect("room")
    })
}

fn obey(queue: &mut Queue, command: &Command, interpolation: Interpolation) -> Result<(), MotionError> {
    match command {
        Command::GoTo(q) => queue.go_to(&JointVector::from(*q), interpolation),
        Command::Path(points, rule) => {
            // Only cubics have velocities at way-points.
            let points = [queue.end(), points[0].into(), points[1].into()];
            let path = path_through(&points, *rule, queue.limits())?;
            match interpolation.ramp() {
                Some(Ramp::JerkLimited) => Ok(()),
                ramp => queue.move_along(&path, ramp),
            }
        }
        Command::InterruptTo(q) => queue.interrupt_to(&JointVector::from(*q), interpolation),
        Command::Rate(rate) => queue.set_rate(*rate),
        Command::BrakeOnPath => {
            queue.brake_on_path();
            Ok(())
        }
        Command::BrakeFully => {
            queue.brake_fully();
            Ok(())
        }
        Command::StopAtWayPoint => {
            queue.stop_at_way_point();
            Ok(())
        }
        Command::Replace(i, q) => queue.replace_target(*i, &JointVector::from(*q)),
        Command::GoRound(q) => {
            if queue.progress() == Progress::Resting {
                let home = queue.end();
                queue.go_to(&JointVector::from(*q), interpolation)?;
                queue.go_to(&home, interpolation)?;
                queue.set_repeat(Repeat::Forever)?;
            }
            Ok(())
        }
    }
}

/// From one sample to the next, `T` apart: what limits of speed, acceleration and jerk allow, for every joint.
fn assert_step(limits: &MotionLimits<N>, before: &JointState<N>, after: &JointState<N>, dt: f64, ramp: Option<Ramp>) {
    for (i, axis) in limits.axes().iter().enumerate() {
        let (a, b) = (before.axis(i), after.axis(i));
        let (v_max, a_max, j_max) = (axis.velocity(), axis.acceleration(), axis.jerk());
        let small = PLANNER + ROUNDING;
        let says = |what: &str| format!("joint {i}: {what}\nfrom {a:?}\nto   {b:?}\nlimits {axis:?}, dt {dt}");
        assert!((b.position - a.position).abs() <= v_max * dt + small, "{}", says("position jumps"));
        assert!(b.velocity.abs() <= v_max * (1.0 + 1e-9) + small, "{}", says("too fast"));
        if ramp.is_none() {
            continue;
        }
        assert!((b.velocity - a.velocity).abs() <= a_max * dt + small, "{}", says("velocity jumps"));
        assert!(b.acceleration.abs() <= a_max * (1.0 + 1e-9) + small, "{}", says("too much acceleration"));
        let straight = a.position + a.velocity * dt;
        assert!(
            (b.position - straight).abs() <= 0.5 * a_max * dt * dt + small,
            "{}",
            says("position leaves its speed")
        );
        if ramp == Some(Ramp::JerkLimited) {
            assert!((b.acceleration - a.acceleration).abs() <= j_max * dt + small, "{}", says("acceleration jumps"));
            let straight = a.velocity + a.acceleration * dt;
            assert!((b.velocity - straight).abs() <= 0.5 * j_max * dt * dt + small, "{}", says("speed leaves"));
        }
    }
}

fn run(limits: &MotionLimits<N>, interpolation: Interpolation, script: &[(Command, u32)], dt: f64) {
    let mut queue = Queue::new(limits.clone(), JointVector::zeros()).expect("zero is inside");
    let mut before = queue.set_point();
    for (command, steps) in script {
        // A refused command must change nothing: the steps that follow are checked all the same. That no motion was
        // found is not among the reasons.
        if let Err(error) = obey(&mut queue, command, interpolation) {
            let fair = matches!(
                error,
                MotionError::JointStop { .. }
                    | MotionError::NeedsRest { .. }
                    | MotionError::NotEditable { .. }
                    | MotionError::Cyclic
                    | MotionError::QueueFull { .. }
                    | MotionError::WayPoints { .. }
                    | MotionError::RateChanging
            );
            assert!(fair, "{command:?}: {error}");
        }
        for _ in 0..*steps {
            let after = queue.advance(dt).expect("a positive period");
            assert_step(limits, &before, &after, dt, interpolation.ramp());
            let slack = if interpolation == Interpolation::BoundedJerk { 0.1 } else { PLANNER };
            assert!(after.q.iter().all(|q| q.abs() <= STOP + slack), "beyond a stop: {}", after.q);
            before = after;
        }
    }
}

fn script() -> impl Strategy<Value = Vec<(Command, u32)>> {
    prop::collection::vec((command(), 0..80_u32), 1..16)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn lines_never_jump(limits in limits(), script in script(), dt in 1e-3..2e-2_f64) {
        run(&limits, Interpolation::Linear, &script, dt);
    }

    #[test]
    fn trapezoids_never_jump_in_speed(limits in limits(), script in script(), dt in 1e-3..2e-2_f64) {
        run(&limits, Interpolation::Trapezoid, &script, dt);
    }

    #[test]
    fn cubics_never_jump_in_speed(limits in limits(), script in script(), dt in 1e-3..2e-2_f64) {
        run(&limits, Interpolation::Cubic, &script, dt);
    }

    #[test]
    fn cosines_never_jump_in_speed(limits in limits(), script in script(), dt in 1e-3..2e-2_f64) {
        run(&limits, Interpolation::Cosine, &script, dt);
    }

    #[test]
    fn bounded_jerk_never_jumps_in_acceleration(limits in limits(), script in script(), dt in 1e-3..2e-2_f64) {
        run(&limits, Interpolation::BoundedJerk, &script, dt);
    }
}
