use proptest::prelude::{Just, ProptestConfig, Strategy, prop_assert, prop_oneof, proptest};
use slideway_motion::tool::{Regulation, SpeedLaw, ToolCurve, ToolKinematics, ToolLine};
use slideway_motion::{AxisLimits, AxisState, MotionError, MotionLimits, MotionQueue, Progress};
use slideway_proofs::curve_end::CLAIM;
use slideway_robot::{DhRow, Pose, SerialArm, Task};

use crate::support::{Outcome, config, counterexample, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The place after two samples of constant acceleration that end with the rates `w2` and 0, the period as the unit of time.
fn after_two(u: f64, w: f64, w2: f64) -> f64 {
    let next = AxisState { position: u, velocity: w, acceleration: w2 - w }.after(1.0, 0.0);
    AxisState { acceleration: -w2, ..next }.after(1.0, 0.0).position
}

#[test]
fn with_twice_the_rate_the_end_is_passed() -> Outcome {
    let model = counterexample(&CLAIM, "half")?;
    let (u, w, w2) = (model.value("u")?, model.value("w")?, model.value("w2")?);
    // The scripts' values have twenty digits.
    assert!(after_two(u, w, w2) >= 1.01 - 1e-12);
    assert!((after_two(u, w, 1.0 - u - 0.5 * w) - 1.0).abs() <= 1e-12);
    Ok(())
}

/// Two links of a metre.
fn arm() -> Result<SerialArm<2>, MotionError> {
    let link = DhRow { a: 1.0, ..DhRow::default() };
    Ok(SerialArm::from_dh([link; 2])?)
}

fn law() -> impl Strategy<Value = SpeedLaw> {
    let regulation = Regulation { sampling_period: 4e-3, ..Regulation::DEFAULT };
    prop_oneof![Just(SpeedLaw::SlidingMode(regulation)), Just(SpeedLaw::Natural(regulation))]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..config() })]

    /// Lines of the tool under both laws, their pace changed at random times.
    #[test]
    fn a_curve_is_never_run_backwards_never_passed_and_ends_at_rest(
        from in (0.2..1.2_f64, 1.0..2.0_f64),
        by in (-0.4..0.4_f64, -0.4..0.4_f64),
        law in law(),
        paces in proptest::collection::vec((0.0..0.3_f64, prop_oneof![Just(0.0), Just(1.0), 0.0..1.0]), 0..5),
        period in 1e-3..1e-2_f64,
    ) {
        let arm = arm()?;
        let limits = MotionLimits::without_stops([AxisLimits::new(1.5, 8.0, 100.0)?; 2]);
        let kinematics = ToolKinematics::new(arm.clone(), Task::PlanarPosition, 0.02)?;
        let mut queue = MotionQueue::<2, 4>::new(limits, [from.0, from.1].into())?.with_tool(kinematics);
        let start = queue.tool_pose()?;
        let shift = Pose::translation(by.0, by.1, 0.0);
        let line = ToolLine::new(&start, &(shift * start));
        // Lines out of reach or through a singular place are refused, which is not what this is about.
        if queue.move_tool_along(&ToolCurve::Line(line), &law).is_err() {
            return Ok(());
        }
        let direction = line.direction().fixed_rows::<3>(0).into_owned();
        let share = |queue: &MotionQueue<2, 4>| {
            let tool = arm.forward(&queue.set_point().q).translation.vector;
            (tool - start.translation.vector).dot(&direction) / direction.norm_squared()
        };
        let mut paces = paces.into_iter();
        let mut left = 0.0;
        let mut before = 0.0;
        let mut samples = 0;
        while !queue.is_empty() {
            if left <= 0.0 {
                let (seconds, pace) = paces.next().unwrap_or((f64::INFINITY, 1.0));
                queue.set_rate(pace)?;
                left = seconds;
            }
            queue.advance(period)?;
            let after = share(&queue);
            // Inverse kinematics within 1e-10 m of lines of a micrometre and more.
            let slack = 2e-10 / direction.norm();
            prop_assert!(after >= before - slack && after <= 1.0 + slack, "{before} {after}");
            before = after;
            left -= period;
            samples += 1;
            prop_assert!(samples < 20_000);
        }
        prop_assert!((before - 1.0).abs() <= 2e-10 / direction.norm() + 1e-11);
        prop_assert!(queue.set_point().is_at_rest() && queue.progress() == Progress::Resting);
    }
}
