//! A safety filter (a quadratic program at every sample) beside the conditioner, which solves none:
//! `cargo run --release -p slideway-baselines --example safety_filter`.

use slideway_baselines::safety_filter::dense::DualActiveSet;
use slideway_baselines::safety_filter::{FilterSettings, QpFilter};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{Constraint, ConstraintSample, Margin, Motion, PathForm, PathSettings};
use slideway_conditioner::shapes::{Ball, HalfSpace, Side};
use std::time::{Duration, Instant};

const PERIOD: f64 = 1e-3; // s
const SAMPLES: u32 = 5000;
const CUTOFF: f64 = 20.0; // rad/s
const APPROACH: [f64; 2] = [0.1; 2]; // s

/// The reference: a line that swings, through a ball and a wall.
fn reference(sample: u32) -> Motion<2> {
    let time = f64::from(sample) * PERIOD;
    Motion { time, position: [0.2 * time, 0.3 * time.sin()], velocity: [0.2, 0.3 * time.cos()] }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (ball, wall) = (Ball::new([0.3, 0.25], 0.1, Side::Outside)?, HalfSpace::new(&[0.0, -1.0], 0.2)?);
    let constraints = |motion: &Motion<2>| -> [ConstraintSample<2>; 2] { [ball.sample(motion), wall.sample(motion)] };
    let conditioner = PathConditioner::<2, 2>::new(PathSettings {
        sampling_period: PERIOD,
        push_cutoff: CUTOFF,
        approach: APPROACH,
        margin: Margin::Fixed([0.0; 2]),
        form: PathForm::Implicit { recovery_rate: 0.5 },
        trap: None,
    })?;
    let settings = FilterSettings { period: PERIOD, cutoff: CUTOFF, approach: APPROACH, rounds: 1 };
    let mut filter = QpFilter::<2, 2, _>::new(settings, DualActiveSet);
    let mut state = conditioner.on_reference();
    let mut took = [Duration::ZERO; 2];
    let (mut apart, mut worst, mut bent) = (0.0_f64, [f64::NEG_INFINITY; 2], 0.0_f64);
    for sample in 0..SAMPLES {
        let reference = reference(sample);
        let begin = Instant::now();
        let step = conditioner.step(&mut state, &reference, constraints);
        took[0] += begin.elapsed();
        let begin = Instant::now();
        let filtered = filter.step(&reference, constraints)?;
        took[1] += begin.elapsed();
        let distance = |p: &[f64; 2], q: &[f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
        apart = apart.max(distance(&step.motion.position, &filtered.position));
        bent = bent.max(distance(&step.motion.position, &reference.position));
        for (most, motion) in worst.iter_mut().zip([&step.motion, &filtered]) {
            *most = constraints(motion).iter().fold(*most, |most, sample| most.max(sample.value));
        }
    }
    let per_sample = took.map(|took| 1e9 * took.as_secs_f64() / f64::from(SAMPLES));
    println!("                greatest σ, m   time per sample, ns");
    println!("conditioner     {:+.3e}      {:8.0}", worst[0], per_sample[0]);
    println!("safety filter   {:+.3e}      {:8.0}", worst[1], per_sample[1]);
    println!("they bend the reference by up to {:.1} mm and differ by at most {:.2e} m", 1e3 * bent, apart);
    Ok(())
}
