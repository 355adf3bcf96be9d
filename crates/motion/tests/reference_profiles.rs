//! Durations and samples against an independent implementation: every row of `data/profiles.json`.

use serde::Deserialize;
use slideway_motion::profile::{
    Bounds, Cosine, Cubics, Hermite, Ramp, TrapezoidEnds, bounded_jerk, shortest_common, trapezoid,
};
use slideway_motion::{AxisLimits, AxisState, JointMotion, JointState, MotionPlanner};

/// Asked for of every number.
const TOLERANCE: f64 = 1e-9;

#[derive(Deserialize)]
struct Reference {
    trapezoid_rest: Vec<Trapezoid>,
    hermite_cosine_rest: Vec<Smooth>,
    scurve_rest: Vec<Jerk>,
    trapezoid_nonzero_velocity: Vec<Moving>,
    scurve_nonzero_v0_a0_vf: Vec<Moving>,
}

#[derive(Deserialize)]
struct Trapezoid {
    theta_s: f64,
    theta_g: f64,
    vmax: f64,
    amax: f64,
    duration: f64,
    segments: usize,
    t_acc: f64,
    t_cruise: f64,
    t_dec: f64,
    peak_v: f64,
    ruckig_duration: f64,
}

#[derive(Deserialize)]
struct Smooth {
    theta_s: f64,
    theta_g: f64,
    vmax: f64,
    amax: f64,
    duration: f64,
    peak_v: f64,
    peak_a: f64,
    cosine_duration: f64,
}

#[derive(Deserialize)]
struct Jerk {
    theta_s: f64,
    theta_g: f64,
    vmax: f64,
    amax: f64,
    jmax: f64,
    duration: f64,
    nonzero_segments: usize,
    peak_v: f64,
    ruckig_duration: f64,
    samples: Vec<Sample>,
}

#[derive(Deserialize)]
struct Moving {
    p0: f64,
    v0: f64,
    #[serde(default)]
    a0: f64,
    pf: f64,
    vf: f64,
    vmax: f64,
    amax: f64,
    jmax: Option<f64>,
    ruckig_duration: f64,
    samples: Vec<Sample>,
}

#[derive(Deserialize)]
struct Sample {
    t: f64,
    pva: [f64; 3],
}

fn reference() -> Reference {
    let text = include_str!("data/profiles.json");
    let reference: Reference = serde_json::from_str(text).expect("the data file");
    for rows in [
        reference.trapezoid_rest.len(),
        reference.hermite_cosine_rest.len(),
        reference.scurve_rest.len(),
        reference.trapezoid_nonzero_velocity.len(),
        reference.scurve_nonzero_v0_a0_vf.len(),
    ] {
        assert_eq!(rows, 20);
    }
    reference
}

fn limits(v: f64, a: f64) -> AxisLimits {
    AxisLimits::new(v, a, 1.0).expect("limits")
}

#[track_caller]
fn near(ours: f64, theirs: f64) {
    assert!((ours - theirs).abs() <= TOLERANCE, "{ours} is not {theirs}");
}

fn whole(motion: &Cubics) -> Bounds {
    motion.bounds(0.0, motion.duration())
}

/// Positions and velocities everywhere; accelerations where they do not jump within the tolerance of the sample's time.
fn assert_samples(at: impl Fn(f64) -> AxisState, switches: &[f64], samples: &[Sample]) {
    for Sample { t, pva: [p, v, a] } in samples {
        let state = at(*t);
        near(state.position, *p);
        near(state.velocity, *v);
        if switches.iter().all(|switch| (switch - t).abs() > TOLERANCE) {
            near(state.acceleration, *a);
        }
    }
}

fn switches(motion: &Cubics) -> Vec<f64> {
    let ends = motion.phases().iter().scan(0.0, |t, phase| {
        *t += phase.duration;
        Some(*t)
    });
    [0.0].into_iter().chain(ends).collect()
}

#[test]
fn trapezoids_from_rest_to_rest_agree() {
    for row in reference().trapezoid_rest {
        let ends = TrapezoidEnds { start: row.theta_s, start_velocity: 0.0, goal: row.theta_g, goal_velocity: 0.0 };
        let ours = trapezoid(&ends, &limits(row.vmax, row.amax));
        let durations: Vec<f64> = ours.phases().iter().map(|p| p.duration).collect();
        assert_eq!(durations.len(), row.segments);
        near(ours.duration(), row.duration);
        near(ours.duration(), row.ruckig_duration);
        near(durations[0], row.t_acc);
        near(*durations.last().expect("phases"), row.t_dec);
        near(if durations.len() == 3 { durations[1] } else { 0.0 }, row.t_cruise);
        near(whole(&ours).velocity.magnitude(), row.peak_v);
        near(ours.end().position, row.theta_g);
    }
}

#[test]
fn cubics_and_cosines_from_rest_to_rest_agree() {
    for row in reference().hermite_cosine_rest {
        let limits = limits(row.vmax, row.amax);
        let cubic = Hermite { start: row.theta_s, goal: row.theta_g, ..Hermite::default() };
        let duration = shortest_common(&[cubic], &[limits]).expect("from rest to rest there is always one");
        near(duration, row.duration);
        let peaks = whole(&cubic.over(duration));
        near(peaks.velocity.magnitude(), row.peak_v);
        near(peaks.acceleration.magnitude(), row.peak_a);
        near(Cosine::shortest(row.theta_s, row.theta_g, &limits), row.cosine_duration);
    }
}

#[test]
fn jerk_limited_motions_from_rest_to_rest_agree() {
    for row in reference().scurve_rest {
        let limits = AxisLimits::new(row.vmax, row.amax, row.jmax).expect("limits");
        let ours = bounded_jerk(row.theta_s, row.theta_g, &limits);
        assert_eq!(ours.phases().len(), row.nonzero_segments);
        near(ours.duration(), row.duration);
        near(ours.duration(), row.ruckig_duration);
        near(whole(&ours).velocity.magnitude(), row.peak_v);
        assert_samples(|t| ours.at(t), &[], &row.samples);
    }
}

#[test]
fn trapezoids_between_speeds_agree() {
    for row in reference().trapezoid_nonzero_velocity {
        let ends = TrapezoidEnds { start: row.p0, start_velocity: row.v0, goal: row.pf, goal_velocity: row.vf };
        let ours = trapezoid(&ends, &limits(row.vmax, row.amax));
        near(ours.duration(), row.ruckig_duration);
        assert_samples(|t| ours.at(t), &switches(&ours), &row.samples);
    }
}

/// The planner of motions between moving states, on one axis.
fn planned(row: &Moving, ramp: Ramp) -> JointMotion<1> {
    let state =
        |position, velocity, acceleration| JointState::from_axes(&[AxisState { position, velocity, acceleration }]);
    let limits = AxisLimits::new(row.vmax, row.amax, row.jmax.unwrap_or(1.0)).expect("limits");
    let (start, goal) = (state(row.p0, row.v0, row.a0), state(row.pf, row.vf, 0.0));
    JointMotion::new(MotionPlanner::default().plan(&start, &goal, &[limits], ramp).expect("a motion"))
}

#[test]
fn jerk_limited_motions_between_moving_states_agree() {
    for row in reference().scurve_nonzero_v0_a0_vf {
        let ours = planned(&row, Ramp::JerkLimited);
        near(ours.duration(), row.ruckig_duration);
        assert_samples(|t| ours.at(t).axis(0), &[], &row.samples);
    }
}

#[test]
fn planned_trapezoids_are_as_fast_as_the_closed_form() {
    for row in reference().trapezoid_nonzero_velocity {
        let ours = planned(&row, Ramp::AccelerationLimited);
        near(ours.duration(), row.ruckig_duration);
    }
}
