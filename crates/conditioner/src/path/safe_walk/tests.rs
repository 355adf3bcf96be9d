use super::*;
use crate::path::constraint::{Constraint, sample_all};
use crate::path::settings::{Margin, PathForm, PathSettings, Reserve, TrapSettings};
use crate::shapes::{Ball, Ellipsoid, Moving, Oscillation, Side};

const PUSH_CUTOFF: f64 = 15.0;
const WALK_CUTOFF: f64 = 12.0;
const SHARE: f64 = 0.4;
const AMPLITUDE: f64 = 0.8;

fn conditioner<const N: usize, const M: usize>(approach: [f64; M]) -> PathConditioner<N, M> {
    PathConditioner::new(PathSettings {
        sampling_period: 1e-3,
        push_cutoff: PUSH_CUTOFF,
        approach,
        margin: Margin::None,
        form: PathForm::Sliding {
            law: SwitchingLaw::Normalised { amplitude: AMPLITUDE },
            reserve: Reserve::On { recovery_rate: 1.0 },
        },
        trap: Some(TrapSettings {
            walk_cutoff: WALK_CUTOFF,
            pace_cutoff: 20.0,
            walk: Walk::Safe { push_share: SHARE },
            walk_speed: 1.0,
            walk_growth: 1.0,
            return_gain: 3.0,
            direction_period: 0.1,
            distance_threshold: 0.05,
            clearance_threshold: 0.05,
            activity_threshold: 0.01,
            seed: 1,
        }),
    })
    .expect("valid settings")
}

fn safe_walk<'a, const N: usize, const M: usize>(
    conditioner: &'a PathConditioner<N, M>,
    state: &PathState<N, M>,
    now: &'a Evaluated<N, M>,
) -> SafeWalk<'a, N, M> {
    let law = conditioner.settings.form.law().expect("an explicit form");
    conditioner.safe_walk(state, now, law, SHARE, WALK_CUTOFF)
}

/// One that moves and whose gradient has no unit length, one that stands.
fn obstacles(motion: &Motion<3>) -> [ConstraintSample<3>; 2] {
    let shape = Ellipsoid::new([0.1, 0.0, 0.0], &[0.8, 0.5, 0.1], 0.4, Side::Outside).expect("semi-axes");
    let trajectory = Oscillation { amplitude: [0.1, -0.2, 0.05], frequency: 3.0, phase: 0.4 };
    let ball = Ball::new([0.3, 0.2, 0.1], 0.2, Side::Inside).expect("a radius");
    sample_all(&[&Moving { shape, trajectory }, &ball], motion)
}

const REFERENCE: [f64; 3] = [0.3, 0.15, 0.22];
const TIME: f64 = 0.7;

/// Pushed, walking, and both in motion.
fn busy(conditioner: &PathConditioner<3, 2>) -> PathState<3, 2> {
    let mut state = conditioner.on_reference();
    state.push.first = [0.03, -0.02, 0.04];
    state.push.second = [0.2, 0.3, -0.5];
    state.trap.walk = [0.05, 0.02, -0.03];
    state.trap.speed = [-0.4, 0.6, 0.3];
    state
}

/// Where the filters bring the conditioned reference by themselves, `after` a time: no input, the reference stands.
fn coasting(state: &PathState<3, 2>, after: f64) -> Motion<3> {
    let s = PUSH_CUTOFF / libm::sqrt(2.0);
    let (c, n, fading) = (libm::cos(s * after), libm::sin(s * after), libm::exp(-s * after));
    let walked = -libm::expm1(-WALK_CUTOFF * after) / WALK_CUTOFF;
    let mut motion = Motion { time: TIME + after, position: REFERENCE, velocity: [0.0; 3] };
    for i in 0..3 {
        let (f, rate, speed) = (state.push.first[i], state.push.second[i], state.trap.speed[i]);
        motion.position[i] += fading * ((c + n) * f + n / s * rate) + state.trap.walk[i] + walked * speed;
        motion.velocity[i] = fading * ((c - n) * rate - 2.0 * s * n * f) + libm::exp(-WALK_CUTOFF * after) * speed;
    }
    motion
}

/// Central difference of `φ` along a motion.
fn rate_of_phi(conditioner: &PathConditioner<3, 2>, motion: impl Fn(f64) -> Motion<3>) -> [f64; 2] {
    let h = 1e-4;
    let [after, before] = [h, -h].map(|t| {
        let there = motion(t);
        conditioner.phi(&obstacles(&there), &there.velocity)
    });
    core::array::from_fn(|i| (after[i] - before[i]) / (2.0 * h))
}

/// Largest error of the central difference: a sixth of h² times the third derivative of `φ`, which is below
/// 1e4 per s³ for the motions here. Its rounding, 1e-16 / h, is far less.
const DIFFERENCE: f64 = 2e-5;

fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance, "{found:?} is not within {tolerance} of {expected:?}");
    }
}

/// Naive twin: the difference of `φ` over the closed form of the filters.
#[test]
fn the_drift_is_the_rate_of_phi_while_the_filters_coast() {
    let conditioner = conditioner([0.06, 0.11]);
    let state = busy(&conditioner);
    let now = conditioner.evaluate(coasting(&state, 0.0), &obstacles);
    let drift = safe_walk(&conditioner, &state, &now).drift(now.motion.velocity, &obstacles);
    assert_near(&drift, &rate_of_phi(&conditioner, |t| coasting(&state, t)), DIFFERENCE);
}

/// Naive twin: the same along a parabola, at another velocity than the present one.
#[test]
fn the_drift_at_another_speed_is_the_rate_of_phi_along_the_bent_path() {
    let conditioner = conditioner([0.06, 0.11]);
    let state = busy(&conditioner);
    let now = conditioner.evaluate(coasting(&state, 0.0), &obstacles);
    let walk = safe_walk(&conditioner, &state, &now);
    let velocity = [1.3, -0.8, 0.6];
    let parabola = |t: f64| Motion {
        time: TIME + t,
        position: add_scaled(&add_scaled(&now.motion.position, t, &velocity), 0.5 * t * t, &walk.pull),
        velocity: add_scaled(&velocity, t, &walk.pull),
    };
    assert_near(&walk.drift(velocity, &obstacles), &rate_of_phi(&conditioner, parabola), DIFFERENCE);
}

/// Naive twin: what a share of the push, straight against the gradient, takes off the drift.
#[test]
fn the_room_is_what_the_share_of_the_push_takes_off_and_the_way_left_to_the_boundary() {
    let conditioner = conditioner([0.06, 0.11]);
    let state = busy(&conditioner);
    let mut now = conditioner.evaluate(coasting(&state, 0.0), &obstacles);
    // One boundary is 0.03 away: it may be neared at α2 times that. One is left behind: nothing to spare.
    now.excess = [-0.03, 0.02];
    let spare = [WALK_CUTOFF * 0.03, 0.0];
    let walk = safe_walk(&conditioner, &state, &now);
    let free = walk.drift(now.motion.velocity, &obstacles);
    for i in 0..2 {
        let gradient = now.samples[i].gradient;
        let against = scaled(-PUSH_CUTOFF * PUSH_CUTOFF * SHARE * AMPLITUDE / norm(&gradient), &gradient);
        let mut pushed = safe_walk(&conditioner, &state, &now);
        pushed.pull = add_scaled(&pushed.pull, 1.0, &against);
        let taken = free[i] - pushed.drift(now.motion.velocity, &obstacles)[i];
        // Numbers below 50, some ten operations.
        assert!((walk.room[i] - spare[i] - taken).abs() < 1e-13, "{} and {taken}", walk.room[i]);
    }
}

const RADIUS: f64 = 0.1;
const APPROACH: f64 = 0.06;

/// A ball around the origin that is not to be left.
fn cage(motion: &Motion<2>) -> [ConstraintSample<2>; 1] {
    [Ball::new([0.0; 2], RADIUS, Side::Inside).expect("a radius").sample(motion)]
}

/// A wanted walk after it is shortened at the rim of the cage, reached at this speed; no push, the reference rests.
fn shortened(speed: [f64; 2], wanted: [f64; 2]) -> [f64; 2] {
    let conditioner = conditioner([APPROACH]);
    let mut state = conditioner.on_reference();
    state.trap.speed = speed;
    let now = conditioner.evaluate(Motion { time: 0.0, position: [RADIUS, 0.0], velocity: speed }, &cage);
    safe_walk(&conditioner, &state, &now).shorten(&wanted, &[true], &cage)
}

#[test]
fn the_walk_round_a_cage_is_as_fast_as_the_share_of_the_push_can_bend() {
    // K v² / R = share α1² K U: 2.7 m/s.
    let fastest = PUSH_CUTOFF * libm::sqrt(SHARE * AMPLITUDE * RADIUS);
    for wanted in [5.0, -5.0] {
        assert_near(&shortened([0.0; 2], [0.0, wanted]), &[0.0, fastest.copysign(wanted)], 1e-13);
    }
    // Slower than that it walks as it wants to.
    assert_eq!(shortened([0.0; 2], [0.0, 1.0]), [0.0, 1.0]);
}

#[test]
fn the_walk_counts_on_the_brake_of_its_filter() {
    // Outwards at speed w the filter takes K α2 w off the drift; the speed v that is asked for may use it up.
    let w = 0.1;
    let room = SHARE * PUSH_CUTOFF * PUSH_CUTOFF * APPROACH * AMPLITUDE;
    assert_near(&shortened([w, 0.0], [50.0, 0.0]), &[room + APPROACH * WALK_CUTOFF * w, 0.0], 1e-12);
}

#[test]
fn a_walk_that_is_too_fast_already_brakes_along_the_rim() {
    // 4 m/s where 2.7 m/s can be bent: the whole input against the motion, whatever was wanted.
    assert_near(&shortened([0.0, 4.0], [0.0, 0.3]), &[0.0, -0.3], 1e-15);
    assert_near(&shortened([0.0, -4.0], [0.0, 0.3]), &[0.0, 0.3], 1e-15);
    // Straight outwards there is no motion along the rim to brake.
    assert_eq!(shortened([90.0, 0.0], [0.0, 0.3]), [0.0; 2]);
}

#[test]
fn a_drift_that_is_not_a_number_brakes() {
    let conditioner = conditioner([APPROACH]);
    let mut state = conditioner.on_reference();
    state.trap.speed = [0.0, 0.5];
    let motion = Motion { time: 0.0, position: [RADIUS, 0.0], velocity: [0.0, 0.5] };
    let now = conditioner.evaluate(motion, &cage);
    let broken = |motion: &Motion<2>| cage(motion).map(|s| ConstraintSample { time_rate_rate: f64::NAN, ..s });
    let walk = safe_walk(&conditioner, &state, &now).shorten(&[0.0, 0.3], &[true], &broken);
    assert_near(&walk, &[0.0, -0.3], 1e-15);
}
