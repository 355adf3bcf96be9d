//! The controller under any sequence of inputs.

#[path = "support/inputs.rs"]
mod inputs;

use inputs::inputs;
use proptest::prelude::*;
use slideway_motion::supervisor::{Fault, Inputs, Mode};
use slideway_motion::{
    ArmController, AxisLimits, ControllerSettings, Interpolation, JointState, MotionLimits, MotionQueue,
};
use slideway_robot::JointVector;

const V: f64 = 1.5;
const A: f64 = 4.0;
const J: f64 = 60.0;
const PERIOD: f64 = 2e-3;

fn controller() -> ArmController<2, 8> {
    let limits = MotionLimits::without_stops([AxisLimits::new(V, A, J).expect("positive"); 2]);
    let queue = MotionQueue::new(limits, JointVector::zeros()).expect("finite");
    let settings = ControllerSettings { sampling_period: PERIOD, brake_deadline: 0.5, recovery_rate: 0.2 };
    ArmController::new(queue, settings).expect("in range")
}

#[derive(Clone, Debug)]
enum Act {
    Queue([f64; 2]),
    Raise(usize),
}

fn act() -> impl Strategy<Value = (Act, u32)> {
    let act = prop_oneof![
        3 => prop::array::uniform2(-1.0..1.0_f64).prop_map(Act::Queue),
        4 => prop_oneof![Just(768_usize - 128 + 16), 0..768_usize].prop_map(Act::Raise),
    ];
    (act, 1..120_u32)
}

fn assert_step(before: &JointState<2>, after: &JointState<2>) {
    // 2e-8 is the accuracy of motions planned from a moving state.
    let small = 2e-8 + 1e-10;
    assert!((after.qd - before.qd).amax() <= A * PERIOD + small, "{before:?} {after:?}");
    assert!((after.qdd - before.qdd).amax() <= J * PERIOD + small, "{before:?} {after:?}");
    let drift = after.q - before.q - before.qd * PERIOD;
    assert!(drift.amax() <= 0.5 * A * PERIOD * PERIOD + small, "{before:?} {after:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn the_controller_never_jumps_and_a_fault_always_brings_it_to_rest(acts in prop::collection::vec(act(), 1..24)) {
        let inputs = inputs();
        let mut controller = controller();
        let mut before = controller.queue().set_point();
        for (act, steps) in acts {
            let mut raised = Inputs::default();
            match act {
                Act::Queue(q) => {
                    // Refused in the modes that take no commands, and when the queue is full.
                    let _ = controller.queue_mut().and_then(|queue| queue.go_to(&q.into(), Interpolation::BoundedJerk));
                }
                Act::Raise(k) => raised = inputs[k],
            }
            for _ in 0..steps {
                let output = controller.step(&raised);
                raised = Inputs::default();
                assert_step(&before, &output.set_point);
                prop_assert!(output.error.is_none());
                prop_assert!(!output.mode.is_at_rest() || output.set_point.is_at_rest(), "{:?}", output.mode);
                before = output.set_point;
            }
        }
        let fault = Inputs { fault: Some(Fault::Drive), ..Inputs::default() };
        // From full speed: V/A, and the acceleration turned round and taken back at the jerk limit.
        let samples = ((V / A + 4.0 * A / J) / PERIOD) as usize + 3;
        for _ in 0..samples {
            before = controller.step(&fault).set_point;
        }
        prop_assert!(matches!(controller.mode(), Mode::Fault(_)) && before.is_at_rest());
    }
}

#[test]
fn a_paused_path_is_resumed_and_a_fault_is_recovered_from_slowly() {
    let mut controller = controller();
    let raise = |f: fn(&mut Inputs)| {
        let mut inputs = Inputs::default();
        f(&mut inputs);
        inputs
    };
    let settle = |controller: &mut ArmController<2, 8>, wanted: fn(Mode) -> bool| {
        for _ in 0..20_000 {
            if wanted(controller.step(&Inputs::default()).mode) {
                return;
            }
        }
        panic!("stuck in {:?}", controller.mode());
    };
    let queue = controller.queue_mut().expect("idle");
    queue.go_to(&[1.0, -1.0].into(), Interpolation::BoundedJerk).expect("free");
    controller.step(&raise(|i| i.start = true));
    (0..200).for_each(|_| drop(controller.step(&Inputs::default())));
    controller.step(&raise(|i| i.brake_on_path = true));
    settle(&mut controller, |mode| mode == Mode::Paused);
    assert!(controller.queue_mut().is_err() && !controller.queue().is_empty());
    controller.step(&raise(|i| i.resume = true));
    (0..100).for_each(|_| drop(controller.step(&Inputs::default())));
    controller.step(&raise(|i| i.fault = Some(Fault::Tracking)));
    settle(&mut controller, |mode| mode == Mode::Fault(Fault::Tracking));
    let queue = controller.queue_mut().expect("in a fault a recovery may be queued");
    queue.go_to(&[0.0, 0.0].into(), Interpolation::BoundedJerk).expect("free");
    controller.step(&raise(|i| i.recover = true));
    assert_eq!(controller.mode(), Mode::Recovery(Fault::Tracking));
    let mut fastest = 0.0_f64;
    while controller.mode() != Mode::Idle {
        fastest = fastest.max(controller.step(&Inputs::default()).set_point.qd.amax());
    }
    // The pace of a recovery is 0.2; a joint profile ends at its target to rounding.
    let rest = controller.queue().set_point();
    assert!(fastest <= 0.2 * V + 1e-12 && rest.is_at_rest() && rest.q.amax() < 1e-12, "{fastest}");
}
