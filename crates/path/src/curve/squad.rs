use super::jet::{QuaternionJet, VectorJet, conjugate, exponential, logarithm, product, scale};
use super::rotation::{RotationPoint, RotationWaypoints};
use super::waypoints::segment;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// A smooth curve through rotations: spherical quadrangles, once continuously differentiable.
///
/// Between neighbours, with `u` in `[0, 1]`, two turns at even speed and a third between them:
///
/// ```text
/// q(u) = slerp(slerp(q_i, q_{i+1}, u), slerp(s_i, s_{i+1}, u), 2 u (1 - u))
/// s_i  = q_i exp(-(h_i L⁻_i + h_{i-1} L⁺_i) / (2 (h_{i-1} + h_i)))
/// L⁻_i = log(q_i⁻¹ q_{i-1}),   L⁺_i = log(q_i⁻¹ q_{i+1}),   h_i = λ_{i+1} - λ_i
/// ```
///
/// and `s_i = q_i` at the ends; logarithms are rotation vectors. For equal steps the `s_i` are those of `[S87]`; the weights
/// make the angular velocity at a way-point the mean `(L⁺_i - L⁻_i) / (h_{i-1} + h_i)` from both sides for unequal ones too.
/// Its derivative jumps there.
///
/// The curve passes through all rotations and meets a turn at even speed exactly. No logarithm comes near its singularity:
/// the vector in `s_i` is half a mean of two neighbouring turns, so that for turns of at most `φ < π` the two inner slerps
/// stay within the rotation angle `2 φ < 2 π` of each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Squad {
    waypoints: RotationWaypoints,
    controls: Vec<Quaternion<f64>>,
}

impl Squad {
    /// The curve through the rotations.
    #[must_use]
    pub fn new(waypoints: RotationWaypoints) -> Self {
        let (at, q) = (waypoints.at(), waypoints.rotations());
        let inner = at.windows(3).zip(q.windows(3)).map(|(at, q)| {
            let (h0, h1) = (at[1] - at[0], at[2] - at[1]);
            let (back, forth) = (half_turn(&q[1], &q[0]), half_turn(&q[1], &q[2]));
            q[1].into_inner() * turn((back * h1 + forth * h0) / (-2.0 * (h0 + h1)))
        });
        let (first, last) = (q[0].into_inner(), q[q.len() - 1].into_inner());
        let controls = std::iter::once(first).chain(inner).chain(std::iter::once(last)).collect();
        Self { waypoints, controls }
    }

    /// The rotation at a path parameter, at a way-point with the derivatives of the segment that begins there; beyond the
    /// ends the outermost quadrangles go on.
    #[must_use]
    pub fn at(&self, lambda: f64) -> RotationPoint {
        let (at, q) = (self.waypoints.at(), self.waypoints.rotations());
        let i = segment(at, lambda);
        let h = at[i + 1] - at[i];
        let u = (lambda - at[i]) / h;
        let outer = even_turn(&q[i], &q[i + 1], u, h);
        let inner = even_turn(&self.controls[i], &self.controls[i + 1], u, h);
        let share = [2.0 * u * (1.0 - u), 2.0 * (1.0 - 2.0 * u) / h, -4.0 / (h * h)];
        let between = logarithm(&product(&conjugate(&outer), &inner));
        let curve = product(&outer, &exponential(&scale(share, &between)));
        // q' = (0, ω) q / 2 and q'' = ((0, ω') - ‖ω‖² / 2) q / 2.
        let back = curve[0].conjugate();
        RotationPoint {
            rotation: UnitQuaternion::new_normalize(curve[0]),
            velocity: (curve[1] * back).imag() * 2.0,
            acceleration: (curve[2] * back).imag() * 2.0,
        }
    }

    /// The rotations.
    #[must_use]
    pub fn waypoints(&self) -> &RotationWaypoints {
        &self.waypoints
    }
}

fn constant(q: Quaternion<f64>) -> QuaternionJet {
    [q, Quaternion::default(), Quaternion::default()]
}

/// Half the rotation vector of `a⁻¹ b`, with the quaternions' signs as they are.
fn half_turn(a: &Quaternion<f64>, b: &Quaternion<f64>) -> Vector3<f64> {
    logarithm(&constant(a.conjugate() * b))[0]
}

/// The quaternion of a half rotation vector.
fn turn(half: Vector3<f64>) -> Quaternion<f64> {
    let still: VectorJet = [half, Vector3::zeros(), Vector3::zeros()];
    exponential(&still)[0]
}

/// `a exp(u log(a⁻¹ b))` and its derivatives by the path parameter, `u` running from 0 to 1 over a length `h`.
fn even_turn(a: &Quaternion<f64>, b: &Quaternion<f64>, u: f64, h: f64) -> QuaternionJet {
    let half = half_turn(a, b);
    let value = a * turn(half * u);
    let rate = Quaternion::from_imag(half / h);
    [value, value * rate, value * (-rate.norm_squared())]
}

#[cfg(test)]
mod tests {
    use super::super::rotation::{Slerp, check_derivatives};
    use super::super::waypoints::Spacing;
    use super::*;
    use proptest::prelude::*;

    const AT: [f64; 5] = [0.0, 0.5, 0.8, 1.6, 2.0];

    fn squad(vectors: &[[f64; 3]], at: &[f64]) -> Option<Squad> {
        let rotations = vectors.iter().map(|v| UnitQuaternion::from_scaled_axis(Vector3::from(*v))).collect();
        RotationWaypoints::new(rotations, &Spacing::At(at.to_vec()), 0.0..1.0).ok().map(Squad::new)
    }

    proptest! {
        #[test]
        fn rotations_are_met_and_angular_velocity_is_continuous(
            vectors in prop::array::uniform5(prop::array::uniform3(-1.5..1.5_f64)),
        ) {
            let Some(squad) = squad(&vectors, &AT) else { return Ok(()) };
            for (i, (at, q)) in AT.iter().zip(squad.waypoints().rotations()).enumerate() {
                // One ulp below a way-point lies in the segment before; angular velocities are below 50.
                let (left, right) = (squad.at(at.next_down()), squad.at(*at));
                prop_assert!(right.rotation.angle_to(q) < 1e-13);
                if i > 0 && i < 4 {
                    prop_assert!(left.rotation.angle_to(&right.rotation) < 1e-13);
                    prop_assert!((left.velocity - right.velocity).norm() < 1e-11, "{} {}", left.velocity, right.velocity);
                }
            }
        }

        #[test]
        fn velocity_and_acceleration_are_derivatives(
            vectors in prop::array::uniform5(prop::array::uniform3(-0.8..0.8_f64)), at in 0.01..1.99_f64,
        ) {
            let Some(squad) = squad(&vectors, &AT) else { return Ok(()) };
            prop_assume!(AT.iter().all(|k| (at - k).abs() > 1e-4));
            // Turns of 2 over steps of 0.3: third derivatives of ω up to 1e4 times h² / 6, rounding 1e-15 / h.
            check_derivatives(|l| squad.at(l), at, 1e-5);
        }

        #[test]
        fn the_angular_velocity_at_a_way_point_is_the_mean_of_its_neighbours_turns(
            vectors in prop::array::uniform5(prop::array::uniform3(-1.0..1.0_f64)),
        ) {
            let Some(squad) = squad(&vectors, &AT) else { return Ok(()) };
            let q = squad.waypoints().rotations();
            for i in 1..4 {
                let forth = (q[i].inverse() * q[i + 1]).scaled_axis();
                let back = (q[i].inverse() * q[i - 1]).scaled_axis();
                let mean = q[i] * ((forth - back) / (AT[i + 1] - AT[i - 1]));
                prop_assert!((squad.at(AT[i]).velocity - mean).norm() < 1e-12);
            }
        }
    }

    #[test]
    fn a_turn_at_even_speed_is_met_exactly_whatever_the_steps() {
        let axis = Vector3::new(1.0, -2.0, 0.5).normalize();
        let vectors = AT.map(|at| (axis * (1.3 * at)).into());
        let squad = squad(&vectors, &AT).expect("valid");
        for i in 0..=40 {
            let point = squad.at(0.05 * f64::from(i));
            // Rounding of a few products, divided by steps of 0.3 once and twice.
            assert!((point.velocity - axis * 1.3).norm() < 1e-13);
            assert!(point.acceleration.norm() < 1e-12, "{}", point.acceleration);
        }
    }

    #[test]
    fn two_rotations_give_the_turn_between_them_and_equal_ones_stand() {
        let vectors = [[0.3, 0.1, 0.0], [-0.2, 1.5, 2.0]];
        let two = squad(&vectors, &[0.0, 1.0]).expect("valid");
        let slerp = Slerp::new(two.waypoints().clone());
        for i in 0..=10 {
            let lambda = 0.1 * f64::from(i);
            assert!(two.at(lambda).rotation.angle_to(&slerp.at(lambda).rotation) < 1e-14);
            assert!((two.at(lambda).velocity - slerp.at(lambda).velocity).norm() < 1e-13);
        }
        let standing = squad(&[[0.3, 0.1, 0.0]; 3], &[0.0, 0.4, 1.0]).expect("valid");
        for lambda in [0.0, 0.2, 0.4, 0.9] {
            assert!(standing.at(lambda).velocity.norm() < 1e-14);
        }
    }

    #[test]
    fn turns_close_to_the_limit_stay_smooth() {
        // Neighbours 3 rad apart, about axes at right angles.
        let q = |x: f64, y: f64, z: f64| UnitQuaternion::from_scaled_axis(Vector3::new(x, y, z));
        let steps = [q(3.0, 0.0, 0.0), q(0.0, 3.0, 0.0), q(0.0, 0.0, 3.0), q(-3.0, 0.0, 0.0)];
        let mut rotations = vec![UnitQuaternion::identity()];
        for (i, step) in steps.iter().enumerate() {
            rotations.push(rotations[i] * step);
        }
        let waypoints = RotationWaypoints::new(rotations, &Spacing::At(AT.to_vec()), 0.0..1.0).expect("valid");
        let squad = Squad::new(waypoints);
        let mut before = squad.at(0.0).rotation;
        for i in 1..=2000 {
            let point = squad.at(1e-3 * f64::from(i));
            // The mean speed is below 3 / 0.3 = 10 and a quadrangle at most triples it: 0.03 rad a step, no jump.
            assert!(point.rotation.angle_to(&before) < 0.03, "at {}", 1e-3 * f64::from(i));
            before = point.rotation;
        }
    }
}
