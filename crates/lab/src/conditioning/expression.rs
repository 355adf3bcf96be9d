use slideway_conditioner::path::{Constraint, ConstraintSample, Motion};
use slideway_path::formula::{FormulaError, Jet, MultiFormula};

/// A constraint typed as a formula in `x`, `y`, `z` (m) and `t` (s); derivatives are exact to rounding.
#[derive(Clone, Debug)]
pub struct ExpressionConstraint(MultiFormula);

/// Names of the variables, in the order of the derivatives.
const VARIABLES: [&str; 4] = ["x", "y", "z", "t"];

impl ExpressionConstraint {
    /// Parses `σ(x, y, z, t)`.
    ///
    /// # Errors
    ///
    /// It does not parse, or uses another name.
    pub fn new(text: &str) -> Result<Self, FormulaError> {
        MultiFormula::new(text, &VARIABLES).map(Self)
    }
}

impl Constraint<3> for ExpressionConstraint {
    /// Four evaluations, one per variable: the first direction is the variable's, the second the motion's, so that the mixed
    /// derivative is the rate of that partial derivative along the motion.
    fn sample(&self, motion: &Motion<3>) -> ConstraintSample<3> {
        let [x, y, z] = motion.position;
        let at = [x, y, z, motion.time];
        let along = [motion.velocity[0], motion.velocity[1], motion.velocity[2], 1.0];
        let partial = |i: usize| {
            let variable = |j: usize| Jet::variable(at[j], [if i == j { 1.0 } else { 0.0 }, along[j]]);
            self.0.at(&std::array::from_fn::<Jet, 4, _>(variable)).parts()
        };
        let partials: [_; 4] = std::array::from_fn(partial);
        ConstraintSample {
            value: partials[0][0],
            gradient: std::array::from_fn(|i| partials[i][1]),
            time_rate: partials[3][1],
            gradient_rate: std::array::from_fn(|i| partials[i][2]),
            time_rate_rate: partials[3][2],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_a_moving_sphere_agree_with_finite_differences() {
        let sigma = ExpressionConstraint::new("0.05 - sqrt((x - 0.1 * t)^2 + y^2 + z^2)").expect("parses");
        let at = |h: f64| Motion {
            time: 0.3 + h,
            position: [0.2 + 0.4 * h, -0.1 + 0.2 * h, 0.05 - 0.3 * h],
            velocity: [0.4, 0.2, -0.3],
        };
        let here = sigma.sample(&at(0.0));
        let h = 1e-5;
        let (before, after) = (sigma.sample(&at(-h)), sigma.sample(&at(h)));
        // Central differences: h² times third derivatives of size 1e3 here, plus rounding 1e-16 / h.
        let slope = (after.value - before.value) / (2.0 * h);
        assert!((slope - here.rate(&[0.4, 0.2, -0.3])).abs() < 1e-6);
        for i in 0..3 {
            assert!(((after.gradient[i] - before.gradient[i]) / (2.0 * h) - here.gradient_rate[i]).abs() < 1e-6);
        }
        assert!(((after.time_rate - before.time_rate) / (2.0 * h) - here.time_rate_rate).abs() < 1e-6);
    }

    #[test]
    fn names_without_a_meaning_are_refused() {
        assert!(
            matches!(ExpressionConstraint::new("w - 1"), Err(FormulaError::UnknownName { name, .. }) if name == "w")
        );
    }
}
