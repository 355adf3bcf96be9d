//! Controllers and the simulated arm together.

mod support;

use nalgebra::Vector3;
use proptest::prelude::*;
use slideway_motion::control::task_space::{
    ForceControl, ForceState, Impedance, OperationalSettings, OperationalSpace, ToolFeedback, ToolGains, ToolReference,
    ToolState, VirtualMass,
};
use slideway_motion::control::{Derivative, Pid, PidSettings, TorqueController, TorqueLaw};
use slideway_motion::plant::{Actuation, Plant, PlantSettings, PlantState, Wall};
use slideway_motion::{JointState, MotionError};
use slideway_robot::{DriveEffects, Dynamics, JointVector, Task, Twist, models};
use support::{arm, vector};

const PERIOD: f64 = 1e-3;

fn unlimited<const N: usize>() -> JointVector<N> {
    JointVector::from_element(f64::INFINITY)
}

fn gains(linear: f64, angular: f64) -> ToolGains {
    ToolGains::uniform(linear, angular).expect("not negative")
}

fn plant<const N: usize>(dynamics: &Dynamics<N>) -> Plant<N> {
    Plant::new(dynamics.clone(), PlantSettings::default()).expect("sound settings")
}

/// With rotor inertia: without it the wrist's links weigh so little (1e-4 kg m²) that no damping held for a millisecond is stable.
fn puma() -> Dynamics<6> {
    let effects = DriveEffects { rotor_inertia: true, friction: false };
    models::puma560_dynamics().expect("the built-in arm").with_effects(effects)
}

/// Elbow bent, wrist away from its singularity.
fn ready() -> JointVector<6> {
    JointVector::from([0.2, 0.6, -3.0, 0.3, -1.0, 0.4])
}

fn pid(proportional: f64, derivative: f64) -> Pid {
    Pid::new(PidSettings {
        proportional,
        integral: 0.0,
        derivative,
        derivative_from: Derivative::Measured,
        largest: 1e9,
        sampling_period: PERIOD,
    })
    .expect("sound settings")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// `ë + 20 ė + 100 e = 0`: `e = (e0 + (ė0 + 10 e0) t) exp(-10 t)`, for every joint, whatever the arm. The controller runs at every
    /// instant, so what is left is the error of the integration: 300 samples of 1e-9.
    #[test]
    fn computed_torque_gives_linear_error_dynamics(dynamics in arm(), q in vector::<3>(2.0), e in vector::<3>(0.5), r in vector::<3>(1.0)) {
        let plant = plant(&dynamics);
        let mut controller =
            TorqueController::new(dynamics, TorqueLaw::ComputedTorque, [pid(100.0, 20.0); 3], unlimited()).expect("sound");
        let desired = JointState::at_rest(q + e);
        let mut state = PlantState { qd: -r, ..PlantState::at_rest(q) };
        for _ in 0..300 {
            plant.advance(&mut state, PERIOD, &mut |x| Actuation::torque(controller.step(&desired, &x.q, &x.qd).torque)).expect("resolved");
        }
        let expected = (e + (r + e * 10.0) * state.time) * (-10.0 * state.time).exp();
        prop_assert!((desired.q - state.q - expected).amax() <= 300.0 * 1e-9, "{}", desired.q - state.q - expected);
    }

    /// The energy of arm and spring grows by no more than the work of the push: at every sample, and by `ẋᵀ D ẋ` less.
    #[test]
    fn impedance_control_is_passive_on_random_arms(
        dynamics in arm(), q in vector::<3>(3.0), qd in vector::<3>(1.0), goal in vector::<3>(3.0),
        stiffness in 0.0..300.0_f64, damping in 0.0..30.0_f64, push in prop::array::uniform3(-20.0..20.0_f64)
    ) {
        let plant = plant(&dynamics);
        let desired = ToolReference::at_rest(dynamics.arm().forward(&goal));
        let impedance = Impedance::new(
            dynamics.clone(), Task::Position, gains(stiffness, 0.0), gains(damping, 0.0), unlimited(),
        ).expect("sound");
        let push = Vector3::from(push);
        let wrench = Twist::new(push.x, push.y, push.z, 0.0, 0.0, 0.0);
        let supply = |x: &PlantState<3>| push.dot(&dynamics.arm().forward(&x.q).translation.vector);
        let stored = |x: &PlantState<3>| dynamics.kinetic_energy(&x.q, &x.qd) + impedance.energy(&desired, &x.q);
        let mut state = PlantState { qd, ..PlantState::at_rest(q) };
        for _ in 0..200 {
            let before = state;
            plant.advance(&mut state, PERIOD, &mut |x| {
                Actuation { torque: impedance.step(&desired, &x.q, &x.qd).torque, push: wrench }
            }).expect("resolved");
            let gain = stored(&state) - stored(&before) - (supply(&state) - supply(&before));
            // Speeds and positions are good to 1e-9; the energy to that times momentum and forces, and roundings of the energies.
            let momentum = (dynamics.mass_matrix(&state.q) * state.qd).norm();
            let slack = 1e-9 * (momentum + 4.0 * (stiffness + push.norm())) + 1e-12 * (1.0 + stored(&state));
            prop_assert!(gain <= slack, "{gain:e} {slack:e}");
        }
    }
}

/// Runs a sampled controller and tells each state.
fn run(
    plant: &Plant<6>,
    state: &mut PlantState<6>,
    samples: u32,
    mut control: impl FnMut(&PlantState<6>) -> JointVector<6>,
    mut seen: impl FnMut(&PlantState<6>),
) -> Result<(), MotionError> {
    for _ in 0..samples {
        let torque = control(state);
        plant.advance(state, PERIOD, &mut |_| Actuation::torque(torque))?;
        seen(state);
    }
    Ok(())
}

/// Largest distance of the tool from the straight line between two points, as a share of its length.
struct Straightness {
    from: Vector3<f64>,
    way: Vector3<f64>,
    worst: f64,
}

impl Straightness {
    fn see(&mut self, tip: &Vector3<f64>) {
        let gone = tip - self.from;
        let off = gone - self.way * (gone.dot(&self.way) / self.way.norm_squared());
        self.worst = self.worst.max(off.norm() / self.way.norm());
    }
}

#[test]
fn the_step_response_is_straight_in_operational_space_and_crooked_under_joint_pid() {
    let (arm, q) = (puma(), ready());
    let plant = plant(&arm);
    let start = arm.arm().forward(&q);
    let way = Vector3::new(0.1, -0.15, 0.15);
    let mut goal = start;
    goal.translation.vector += way;
    let settings = OperationalSettings { length: 0.3, largest_inertia: 200.0, posture_damping: 0.0 };
    let space = OperationalSpace::new(arm.clone(), Task::Pose, settings, unlimited()).expect("sound");
    let feedback = ToolFeedback { proportional: gains(100.0, 100.0), derivative: gains(20.0, 20.0) };
    let desired = ToolReference::at_rest(goal);
    let tip = |x: &PlantState<6>| arm.arm().forward(&x.q).translation.vector;
    let line = || Straightness { from: start.translation.vector, way, worst: 0.0 };
    let (mut operational, mut state) = (line(), PlantState::at_rest(q));
    run(
        &plant,
        &mut state,
        1500,
        |x| {
            let tool = ToolState::of(arm.arm(), &x.q, &x.qd);
            space.step(&x.q, &x.qd, &feedback.acceleration(&desired, &tool), &Twist::zeros()).torque
        },
        |x| operational.see(&tip(x)),
    )
    .expect("resolved");
    // (1 + 10 t) exp(-10 t) at 1.5 s is 5e-6 of the step; the sampled torque adds a share of the order of 10 T.
    let left = (tip(&state) - goal.translation.vector).norm();
    assert!(left < 1e-5, "{left}");
    assert!(operational.worst < 0.01, "{}", operational.worst);

    let ik = slideway_robot::NumericIk::new(arm.arm(), Task::Pose, slideway_robot::NumericIkSettings::default());
    let target = JointState::at_rest(ik.solve(&goal, &q).expect("in reach"));
    let law = TorqueLaw::GravityCompensation;
    let gain = |k: f64| pid(k, 0.2 * k);
    let joints = [gain(400.0), gain(400.0), gain(200.0), gain(20.0), gain(20.0), gain(20.0)];
    let mut controller = TorqueController::new(arm.clone(), law, joints, unlimited()).expect("sound");
    let (mut joint, mut state) = (line(), PlantState::at_rest(q));
    run(&plant, &mut state, 1500, |x| controller.step(&target, &x.q, &x.qd).torque, |x| joint.see(&tip(x)))
        .expect("resolved");
    assert!((tip(&state) - goal.translation.vector).norm() < 0.02, "the joints got there");
    assert!(joint.worst > 0.03, "{}", joint.worst);
}

/// A wall 2 cm before the tool that faces -x of the base, and the reference 5 cm further along x.
fn before_a_wall(arm: &Dynamics<6>, q: &JointVector<6>) -> (Plant<6>, ToolReference) {
    let mut pose = arm.arm().forward(q);
    let face = pose.translation.vector + Vector3::x() * 0.02;
    let wall = Wall::new(face, -Vector3::x(), 1e4, 100.0).expect("a wall");
    pose.translation.vector.x += 0.05;
    (plant(arm).with_wall(wall), ToolReference::at_rest(pose))
}

#[test]
fn the_contact_force_of_an_impedance_at_rest_is_that_of_two_springs_in_series() {
    let (arm, q) = (puma(), ready());
    let (plant, desired) = before_a_wall(&arm, &q);
    let (k, wall) = (800.0, 1e4);
    // The spring is stretched by 5 cm less the way to the wall and the wall's yield.
    let expected = 0.03 * k * wall / (k + wall);
    let impedance =
        Impedance::new(arm.clone(), Task::Pose, gains(k, 30.0), gains(120.0, 5.0), unlimited()).expect("sound");
    let mut state = PlantState::at_rest(q);
    run(&plant, &mut state, 2500, |x| impedance.step(&desired, &x.q, &x.qd).torque, |_| ()).expect("resolved");
    let force = -plant.contact(&state.q, &state.qd).x;
    assert!((force / expected - 1.0).abs() < 0.02, "{force} {expected}");

    // The same spring on a mass of 5 kg, with the wrench measured.
    let settings = OperationalSettings { length: 0.3, largest_inertia: 200.0, posture_damping: 0.0 };
    let space = OperationalSpace::new(arm, Task::Pose, settings, unlimited()).expect("sound");
    let law = VirtualMass::new(gains(5.0, 0.5), gains(k, 30.0), gains(120.0, 8.0)).expect("positive");
    let mut state = PlantState::at_rest(q);
    let control = |x: &PlantState<6>| law.step(&space, &desired, [&x.q, &x.qd], &plant.contact(&x.q, &x.qd)).torque;
    run(&plant, &mut state, 2500, control, |_| ()).expect("resolved");
    let force = -plant.contact(&state.q, &state.qd).x;
    assert!((force / expected - 1.0).abs() < 0.02, "{force} {expected}");
}

#[test]
fn force_control_pushes_with_the_force_asked_for_and_moves_across_it() {
    let (arm, q) = (puma(), ready());
    let (plant, desired) = before_a_wall(&arm, &q);
    let settings = OperationalSettings { length: 0.3, largest_inertia: 200.0, posture_damping: 0.0 };
    let space = OperationalSpace::new(arm.clone(), Task::Pose, settings, unlimited()).expect("sound");
    // Critical with the wall's 1e4 N/m: d = 2 sqrt(1e4 · 0.04) = 40; the approach at 0.04 · 20 / 40 = 0.02 m/s takes a second.
    let push = ForceControl::new(Vector3::x(), pid(0.04, 0.0), 40.0).expect("a direction");
    let feedback = ToolFeedback { proportional: gains(100.0, 100.0), derivative: gains(20.0, 20.0) };
    let (mut state, mut memory) = (PlantState::at_rest(q), ForceState::default());
    let mut reference = desired;
    reference.pose.translation.vector.y += 0.03;
    let control = |x: &PlantState<6>| {
        let external = plant.contact(&x.q, &x.qd);
        let tool = ToolState::of(arm.arm(), &x.q, &x.qd);
        let motion = feedback.acceleration(&reference, &tool);
        let acceleration = push.acceleration(&mut memory, 20.0, &external, &tool.twist, &motion);
        space.step(&x.q, &x.qd, &acceleration, &external).torque
    };
    run(&plant, &mut state, 3000, control, |_| ()).expect("resolved");
    let force = push.force(&plant.contact(&state.q, &state.qd));
    let across = arm.arm().forward(&state.q).translation.vector.y - reference.pose.translation.vector.y;
    // Two seconds of contact leave (1 + 40) e^-40 of the error; nothing but roundings and the sampling is left.
    assert!((force - 20.0).abs() < 1e-3 && across.abs() < 1e-4, "{force} {across}");
}

#[test]
fn without_gravity_the_arm_stays_where_it_is_put_and_goes_on_when_pushed() {
    let (arm, q) = (puma(), ready());
    let plant = plant(&arm);
    let free = Impedance::zero_gravity(arm.clone(), unlimited()).expect("sound");
    let desired = ToolReference::at_rest(arm.arm().forward(&q));
    let mut state = PlantState::at_rest(q);
    run(&plant, &mut state, 500, |x| free.step(&desired, &x.q, &x.qd).torque, |_| ()).expect("resolved");
    // Torques of about 40 N·m good to 1e-14 of it, on wrist inertias of 0.2: 1e-11 rad/s² at most.
    assert!((state.q - q).amax() < 1e-9 && state.qd.amax() < 1e-9);
    let mut pushed = PlantState { qd: JointVector::from([0.2, -0.1, 0.1, 0.0, 0.0, 0.0]), ..state };
    let energy = arm.kinetic_energy(&pushed.q, &pushed.qd);
    for _ in 0..200 {
        plant
            .advance(&mut pushed, PERIOD, &mut |x| Actuation::torque(free.step(&desired, &x.q, &x.qd).torque))
            .expect("resolved");
    }
    let left = arm.kinetic_energy(&pushed.q, &pushed.qd);
    // 200 samples of 1e-9 times a momentum of about 1.
    assert!((left - energy).abs() < 1e-6, "{left} {energy}");
}
