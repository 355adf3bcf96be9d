//! Recordings of the path conditioner: a plane of the caller's own and a ball that swings.

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, HoldReason, Margin, Motion, PathForm, PathOutcome, PathSettings, PathStep, Reserve,
    SwitchingLaw, TrapPhase, TrapSettings, Walk,
};
use slideway_conditioner::shapes::{Ball, Moving, Oscillation, Side};

use super::{Numbers, Recording};

const PERIOD: f64 = 1e-3;
const SEED: u32 = 7;
const TRAP: TrapSettings = TrapSettings {
    walk_cutoff: 20.0,
    pace_cutoff: 10.0,
    walk: Walk::Safe { push_share: 0.5 },
    walk_speed: 0.5,
    walk_growth: 0.5,
    return_gain: 5.0,
    direction_period: 0.1,
    distance_threshold: 0.02,
    clearance_threshold: 0.0,
    activity_threshold: 0.01,
    seed: SEED as u64,
};

/// `normal . p - offset`, summed from the first coordinate on as the replaying programs do.
fn plane<const N: usize>(normal: &[f64; N], offset: f64, motion: &Motion<N>) -> ConstraintSample<N> {
    let sum = (0..N).fold(0.0, |sum, i| sum + normal[i] * motion.position[i]);
    ConstraintSample {
        value: sum - offset,
        gradient: *normal,
        time_rate: 0.0,
        gradient_rate: [0.0; N],
        time_rate_rate: 0.0,
    }
}

fn form(number: u32) -> PathForm {
    let law = SwitchingLaw::Normalised { amplitude: 1.5 };
    match number {
        0 => PathForm::Implicit { recovery_rate: 0.5 },
        1 => PathForm::Sliding { law, reserve: Reserve::Off },
        2 => PathForm::Sliding { law, reserve: Reserve::On { recovery_rate: 0.5 } },
        _ => PathForm::Appendix { law },
    }
}

fn words<const N: usize, const M: usize>(step: &PathStep<N, M>) -> [u32; 4] {
    let none = u32::MAX;
    let [outcome, reason, constraint] = match step.outcome {
        PathOutcome::Free => [0, 0, none],
        PathOutcome::Acting => [1, 0, none],
        PathOutcome::Reserve => [2, 0, none],
        PathOutcome::Held(HoldReason::ReferenceNotFinite) => [3, 1, none],
        PathOutcome::Held(HoldReason::ConstraintNotFinite(i)) => [3, 2, i as u32],
        PathOutcome::Held(HoldReason::EmptyGradient(i)) => [3, 3, i as u32],
        PathOutcome::Held(HoldReason::OpposedGradients) => [3, 4, none],
        PathOutcome::Held(HoldReason::Contradiction(i)) => [3, 5, i as u32],
        PathOutcome::Held(HoldReason::CorrectionNotFound) => [3, 6, none],
    };
    let trap = match step.trap {
        TrapPhase::Following => 0,
        TrapPhase::Returning => 1,
        TrapPhase::Walking => 2,
        TrapPhase::Blocked => 3,
    };
    [outcome, reason, constraint, trap]
}

fn print<const N: usize, const M: usize>(recording: &mut Recording, step: &PathStep<N, M>) {
    recording.print(&[step.motion.time]);
    recording.print(&step.motion.position);
    recording.print(&step.motion.velocity);
    for audit in [step.sigma, step.phi, step.share] {
        recording.print(&audit);
    }
    for part in [step.push, step.reserve, step.correction, step.walk] {
        recording.print(&part);
    }
    recording.print(&[step.pace, step.advance]);
    recording.end_line(&words(step));
}

/// Coordinates that swing against plane and ball.
fn reference<const N: usize>(k: u32, numbers: &mut Numbers) -> Motion<N> {
    let time = PERIOD * f64::from(k);
    let angle = |i: usize| (2.0 + 0.3 * i as f64) * time + 0.4 * i as f64;
    let mut position: [f64; N] = std::array::from_fn(|i| 0.5 * libm::sin(angle(i)) + 1e-5 * numbers.next());
    if k % 131 == 130 {
        position[0] = f64::NAN;
    }
    let velocity = std::array::from_fn(|i| 0.5 * (2.0 + 0.3 * i as f64) * libm::cos(angle(i)));
    Motion { time, position, velocity }
}

pub(crate) fn path<const N: usize, const M: usize>(recording: &mut Recording, number: u32, walks: bool, steps: u32) {
    let normal: [f64; N] = std::array::from_fn(|i| 1.0 / (1.0 + i as f64));
    let (offset, approach) = (0.3, [0.1; M]);
    let centre: [f64; N] = std::array::from_fn(|i| if i == 0 { -0.9 } else { 0.1 });
    let (amplitude, frequency, phase) = ([0.05; N], 3.0, 0.5);
    let conditioner = PathConditioner::<N, M>::new(PathSettings {
        sampling_period: PERIOD,
        push_cutoff: 20.0,
        approach,
        margin: Margin::Band,
        form: form(number),
        trap: walks.then_some(TRAP),
    })
    .expect("settings");
    let ball = Ball::new(centre, 0.55, Side::Outside).expect("a ball");
    let ball = Moving { shape: ball, trajectory: Oscillation { amplitude, frequency, phase } };
    recording.begin("path", &[N as u32, M as u32, number, 2 * u32::from(walks), steps]);
    recording.read(&[PERIOD, 20.0, 1.5, 0.5]);
    recording.read(&approach);
    recording.read(&[0.5, TRAP.walk_cutoff, TRAP.pace_cutoff, TRAP.walk_speed, TRAP.walk_growth, TRAP.return_gain]);
    recording.read(&[
        TRAP.direction_period,
        TRAP.distance_threshold,
        TRAP.clearance_threshold,
        TRAP.activity_threshold,
    ]);
    recording.begin("", &[SEED]);
    recording.read(&normal);
    recording.read(&[offset]);
    recording.read(&centre);
    recording.read(&[0.55]);
    recording.read(&amplitude);
    recording.read(&[frequency, phase]);
    let (mut state, mut numbers) = (conditioner.on_reference(), Numbers(u64::from(number)));
    for k in 0..steps {
        let at = reference::<N>(k, &mut numbers);
        recording.read(&[at.time]);
        recording.read(&at.position);
        recording.read(&at.velocity);
        let step = conditioner.step(&mut state, &at, |motion| {
            std::array::from_fn(|i| if i == 0 { plane(&normal, offset, motion) } else { ball.sample(motion) })
        });
        print(recording, &step);
    }
}
