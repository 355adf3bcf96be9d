use super::constraint::ConstraintSample;
use super::vector::{add_scaled, dot, norm, scaled};

/// Share of a vector's length below which what Gram-Schmidt leaves of it is rounding: 1e-16 times the condition of a few
/// nearly dependent gradients.
const LEFT_OVER: f64 = 1e-9;

/// The unit vector along the part of `vector` that is orthogonal to the marked gradients, `[G12] eq 26` and steps 1-3 of
/// 6.3; `None` where nothing is left.
///
/// Modified Gram-Schmidt; gradients that depend on earlier ones are passed over.
#[inline]
pub(crate) fn orthogonal_direction<const N: usize, const M: usize>(
    samples: &[ConstraintSample<N>; M],
    active: &[bool; M],
    vector: &[f64; N],
) -> Option<[f64; N]> {
    let mut basis = [[0.0; N]; M];
    for i in 0..M {
        if active[i] {
            let mut left = samples[i].gradient;
            for earlier in basis.iter().take(i) {
                left = add_scaled(&left, -dot(&left, earlier), earlier);
            }
            if let Some(unit) = unit(&left, norm(&samples[i].gradient)) {
                basis[i] = unit;
            }
        }
    }
    // [G12] eq 26
    let mut left = *vector;
    // Twice is enough: the second pass removes what rounding left in the first.
    for axis in basis.iter().chain(&basis) {
        left = add_scaled(&left, -dot(&left, axis), axis);
    }
    unit(&left, norm(vector))
}

fn unit<const N: usize>(left: &[f64; N], whole: f64) -> Option<[f64; N]> {
    let length = norm(left);
    // Strictly more: of an empty vector nothing is left.
    (length > LEFT_OVER * whole).then(|| scaled(1.0 / length, left))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gradient(gradient: [f64; 3]) -> ConstraintSample<3> {
        ConstraintSample { value: 0.0, gradient, time_rate: 0.0, gradient_rate: [0.0; 3], time_rate_rate: 0.0 }
    }

    #[test]
    fn the_direction_is_orthogonal_to_every_active_gradient() {
        let samples = [gradient([1.0, 2.0, 3.0]), gradient([1.0, 2.0, 3.1])];
        let found = orthogonal_direction(&samples, &[true, true], &[0.3, -0.1, 0.2]).expect("one dimension is left");
        for sample in &samples {
            assert!(dot(&found, &sample.gradient).abs() < 1e-13);
        }
        assert!((norm(&found) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn as_many_gradients_as_dimensions_leave_nothing() {
        let samples = [gradient([1.0, 0.0, 0.0]), gradient([1.0, 1.0, 0.0]), gradient([1.0, 1.0, 1.0])];
        assert_eq!(orthogonal_direction(&samples, &[true; 3], &[0.3, -0.1, 0.2]), None);
        assert!(orthogonal_direction(&samples, &[true, true, false], &[0.3, -0.1, 0.2]).is_some());
    }

    #[test]
    fn dependent_gradients_count_once() {
        let samples = [gradient([0.0, 0.0, 1.0]), gradient([0.0, 0.0, 2.0]), gradient([0.0, 0.0, -1.0])];
        assert!(orthogonal_direction(&samples, &[true; 3], &[0.3, -0.1, 0.2]).is_some());
    }

    #[test]
    fn without_active_gradients_the_direction_is_that_of_the_vector() {
        let samples = [gradient([1.0, 2.0, 3.0])];
        let found = orthogonal_direction(&samples, &[false], &[2.0, -1.0, -2.0]).expect("a vector to follow");
        for (x, exact) in found.iter().zip([2.0 / 3.0, -1.0 / 3.0, -2.0 / 3.0]) {
            assert!((x - exact).abs() < 1e-15);
        }
    }

    #[test]
    fn an_empty_vector_leads_nowhere_and_an_empty_gradient_forbids_nothing() {
        let samples = [gradient([0.0; 3]), gradient([0.0, 0.0, 1.0])];
        assert_eq!(orthogonal_direction(&samples, &[true; 2], &[0.0; 3]), None);
        assert_eq!(orthogonal_direction(&samples, &[true; 2], &[3.0, 0.0, 5.0]), Some([1.0, 0.0, 0.0]));
    }

    /// `[G12] 5.1` asks for gradients around 1, but a walk in micrometres is a walk all the same.
    #[test]
    fn lengths_of_gradients_and_vector_do_not_matter() {
        for scale in [1e-12, 1e-6, 1e6, 1e12] {
            let samples = [gradient([scale, 0.0, 0.0]), gradient([0.0, 1.0 / scale, 0.0])];
            let found = orthogonal_direction(&samples, &[true; 2], &scaled(scale, &[1.0, 2.0, -3.0]));
            assert_eq!(found, Some([0.0, 0.0, -1.0]));
        }
    }

    /// The rounding left of a gradient that depends on another one is no gradient: it would forbid one direction more.
    #[test]
    fn a_gradient_and_its_multiples_leave_the_other_direction_of_a_plane() {
        for k in 0..100_u32 {
            let angle = 0.01 + f64::from(k);
            let normal = [libm::cos(angle), libm::sin(angle)];
            let samples = [1.0, 0.3, -1.7].map(|factor| ConstraintSample {
                value: 0.0,
                gradient: scaled(factor, &normal),
                time_rate: 0.0,
                gradient_rate: [0.0; 2],
                time_rate_rate: 0.0,
            });
            let found = orthogonal_direction(&samples, &[true; 3], &[0.3, -0.1]).expect("a plane has two directions");
            assert!(dot(&found, &normal).abs() < 1e-14, "{found:?} of {normal:?}");
        }
    }
}
