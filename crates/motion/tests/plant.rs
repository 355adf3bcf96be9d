//! The simulated arm keeps its books, and its error estimate is one.

mod support;

use nalgebra::Vector3;
use proptest::prelude::*;
use slideway_motion::MotionError;
use slideway_motion::motor::Encoder;
use slideway_motion::plant::{Actuation, Noise, Plant, PlantSettings, PlantState, Sensors, Wall};
use slideway_robot::{DhRow, Drive, DriveEffects, Dynamics, Friction, JointVector, LinkInertia, SerialArm, Twist};
use support::{arm, vector};

const PERIOD: f64 = 1e-3;
const SAMPLES: u32 = 100;

fn plant(dynamics: Dynamics<3>) -> Plant<3> {
    Plant::new(dynamics, PlantSettings::default()).expect("sound settings")
}

/// Damping of the wall, N s/m.
const DAMPING: f64 = 20.0;

/// Energy per unit of error in every speed and position: momentum for the speeds; for the positions the forces, once in the potential
/// energy and once each in the work and the loss, which are integrals of forces over the same positions.
fn energy_per_error(plant: &Plant<3>, wall: &Wall, state: &PlantState<3>, driven: &Actuation<3>) -> f64 {
    let (dynamics, q, qd) = (plant.dynamics(), &state.q, &state.qd);
    let jacobian = dynamics.arm().jacobian(q);
    let linear = jacobian.fixed_rows::<3>(0);
    let pressed = wall.force(&dynamics.arm().forward(q).translation.vector, &(linear * qd));
    let size = |v: JointVector<3>| v.abs().sum();
    let forces = size(driven.torque) + size(jacobian.transpose() * driven.push) + size(dynamics.gravity_torque(q));
    size(dynamics.mass_matrix(q) * qd)
        + 3.0 * (forces + size(linear.transpose() * pressed) + size(dynamics.friction(qd)))
}

/// Energy that the damper takes in one sample at the tool's speed, J: where a step begins before a touch and ends after it, its halves
/// may by chance agree with it and both have missed the touch by as much as the sample is long, in the momentum and in the loss.
fn missed_touch(plant: &Plant<3>, state: &PlantState<3>) -> f64 {
    let velocity = plant.dynamics().arm().jacobian(&state.q).fixed_rows::<3>(0) * state.qd;
    2.0 * DAMPING * velocity.norm_squared() * PERIOD
}

fn with_friction(dynamics: Dynamics<3>) -> Dynamics<3> {
    let friction = Friction { viscous: 0.3, forward: 0.5, backward: 0.4 };
    let drives = [Drive { reflected_inertia: 0.2, friction }; 3];
    dynamics
        .with_drives(drives)
        .expect("not negative")
        .with_effects(DriveEffects { rotor_inertia: true, friction: true })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn energy_is_what_was_there_plus_work_less_loss(
        dynamics in arm(), q in vector::<3>(2.0), qd in vector::<3>(1.0), torque in vector::<3>(5.0),
        push in prop::array::uniform3(-10.0..10.0_f64), rubs in any::<bool>(),
    ) {
        let dynamics = if rubs { with_friction(dynamics) } else { dynamics };
        let tip = dynamics.arm().forward(&q).translation.vector;
        let wall = Wall::new(tip - Vector3::new(0.0, 0.0, 0.01), Vector3::z(), 2e3, DAMPING).expect("a wall");
        let plant = plant(dynamics).with_wall(wall);
        let start = PlantState { qd, ..PlantState::at_rest(q) };
        let mut state = start;
        let push = Twist::new(push[0], push[1], push[2], 0.1, 0.0, -0.1);
        let actuation = |x: &PlantState<3>| Actuation { torque: torque * (20.0 * x.time).sin(), push };
        let weight = |x: &PlantState<3>| energy_per_error(&plant, &wall, x, &actuation(x));
        let mut slack = 0.0;
        for _ in 0..SAMPLES {
            let before = state;
            let mut seen = [false; 2];
            let resolution = plant.advance(&mut state, PERIOD, &mut |x| {
                let height = plant.dynamics().arm().forward(&x.q).translation.z - (tip.z - 0.01);
                seen[usize::from(height < 0.0)] = true;
                actuation(x)
            }).expect("resolved");
            prop_assert!(state.lost >= before.lost);
            // The estimate is the 15th part of what halving a step changes: right for a smooth motion. Where the force only bends, at
            // the wall's spring, the error may be all that changes.
            slack += 15.0 * resolution.error * weight(&before).max(weight(&state));
            if seen == [true; 2] {
                slack += missed_touch(&plant, &before).max(missed_touch(&plant, &state));
            }
        }
        // Some hundred roundings of energies and works of less than 1 kJ.
        let imbalance = plant.imbalance(&start, &state);
        prop_assert!(imbalance.abs() <= slack + 1e-11, "{imbalance:e} of {slack:e}");
    }

    #[test]
    fn the_wall_never_pulls_and_its_damper_never_gives(
        depth in -0.01..0.01_f64, speed in -2.0..2.0_f64, stiffness in 1.0..1e5_f64, damping in 0.0..1e3_f64
    ) {
        let wall = Wall::new(Vector3::zeros(), Vector3::y(), stiffness, damping).expect("a wall");
        let (point, velocity) = (Vector3::new(0.3, -depth, 0.0), Vector3::new(1.0, speed, 0.0));
        prop_assert!(wall.force(&point, &velocity).y >= 0.0);
        // k d - k d, rounded.
        prop_assert!(wall.loss(&point, &velocity) >= -1e-15 * stiffness * depth.abs() * speed.abs());
    }
}

/// A rod on a hinge without weight under a torque that grows with time: `q = t³ / (6 I)`, which the scheme integrates exactly.
#[test]
fn a_rod_under_a_growing_torque_goes_as_the_cube_of_time() {
    let arm = SerialArm::from_dh([DhRow { a: 1.0, alpha: 0.0, d: 0.0, offset: 0.0 }]).expect("finite");
    let link = LinkInertia { mass: 2.0, com: Vector3::x() * 0.5, inertia: nalgebra::Matrix3::identity() * 0.5 };
    let dynamics = Dynamics::new(arm, [link]).expect("a rod").with_gravity(Vector3::zeros());
    let plant = Plant::new(dynamics, PlantSettings::default()).expect("sound settings");
    let mut state = PlantState::at_rest(JointVector::<1>::zeros());
    for _ in 0..100 {
        plant.advance(&mut state, 0.01, &mut |x| Actuation::torque([x.time].into())).expect("resolved");
    }
    // Inertia about the hinge: 0.5 + 2 / 4 = 1. A hundred samples of roundings.
    assert!((state.q[0] - 1.0 / 6.0).abs() < 1e-14 && (state.time - 1.0).abs() < 1e-14, "{state:?}");
}

#[test]
fn what_is_not_resolved_is_refused_and_changes_nothing() {
    let dynamics = slideway_robot::models::puma560_dynamics().expect("the built-in arm");
    let settings = PlantSettings { most_steps: 2, ..PlantSettings::default() };
    let plant = Plant::new(dynamics, settings).expect("sound settings");
    let start = PlantState::at_rest(JointVector::from_element(0.3));
    let mut state = start;
    let shaking = &mut |x: &PlantState<6>| Actuation::torque(JointVector::from_element(1e3 * (1e4 * x.time).sin()));
    let refused = plant.advance(&mut state, 0.1, shaking);
    assert!(matches!(refused, Err(MotionError::NotResolved { .. })) && state == start, "{refused:?}");
    let nan = &mut |_: &PlantState<6>| Actuation::torque(JointVector::from_element(f64::NAN));
    assert!(matches!(plant.advance(&mut state, PERIOD, nan), Err(MotionError::Dynamics(_))) && state == start);
    let bad = PlantSettings { steps: 0, ..PlantSettings::default() };
    let dynamics = slideway_robot::models::puma560_dynamics().expect("the built-in arm");
    assert!(Plant::new(dynamics, bad).is_err());
}

#[test]
fn the_same_seed_reads_the_same_and_noise_has_its_deviation() {
    let noise = Noise { position: 1e-3, speed: 1e-2, force: 0.5, moment: 0.1 };
    let mut sensors = [7, 7, 8].map(|seed| Sensors::new(noise, seed).expect("not negative"));
    let zero = JointVector::<3>::zeros();
    let [a, b, c] = sensors.each_mut().map(|s| s.joints(&zero, &zero));
    assert!(a == b && a != c);
    let count = 20_000;
    let squares = (0..count).map(|_| sensors[0].wrench(&Twist::zeros())[0].powi(2)).sum::<f64>();
    // Relative deviation of a variance from n samples: sqrt(2 / n) = 0.01; five of them.
    assert!((squares / f64::from(count) / 0.25 - 1.0).abs() < 0.05);
    let encoder = Encoder::new(1e-2).expect("positive");
    let mut coarse = Sensors::new(Noise::default(), 1).expect("not negative").with_encoder(encoder);
    let read = coarse.joints(&JointVector::<1>::from([0.1234]), &JointVector::zeros()).q[0];
    assert!((read - 0.12).abs() < 1e-15, "{read}");
}
