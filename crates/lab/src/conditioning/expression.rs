use crate::formula::{FormulaError, MultiFormula};
use slideway_conditioner::path::{Constraint, ConstraintSample, Motion};

/// A constraint typed as a formula in `x`, `y`, `z` (m) and `t` (s), with every derivative taken symbolically.
#[derive(Clone, Debug)]
pub struct ExpressionConstraint {
    value: MultiFormula,
    first: [MultiFormula; 4],
    /// Upper triangle of the Hessian by `x, y, z, t`, row by row.
    second: [MultiFormula; 10],
}

/// Names of the variables, in the order of the derivatives.
const VARIABLES: [&str; 4] = ["x", "y", "z", "t"];

/// Index into the upper triangle of a symmetric 4×4 matrix.
fn pair(i: usize, j: usize) -> usize {
    let (i, j) = if i <= j { (i, j) } else { (j, i) };
    [0, 4, 7, 9][i] + j - i
}

impl ExpressionConstraint {
    /// Parses `σ(x, y, z, t)` and differentiates it twice.
    ///
    /// # Errors
    ///
    /// It does not parse, uses another name, or contains an operator without a derivative.
    pub fn new(text: &str) -> Result<Self, FormulaError> {
        let value = MultiFormula::new(text, &VARIABLES)?;
        let mut first = Vec::new();
        let mut second = Vec::new();
        for (i, name) in VARIABLES.iter().enumerate() {
            let derivative = value.derivative(name)?;
            for other in &VARIABLES[i..] {
                second.push(derivative.derivative(other)?);
            }
            first.push(derivative);
        }
        let wrong = |_| FormulaError::Syntax { text: text.to_owned(), reason: "derivatives missing".into() };
        Ok(Self {
            value,
            first: first.try_into().map_err(wrong)?,
            second: second.try_into().map_err(|v: Vec<MultiFormula>| wrong(v))?,
        })
    }
}

impl Constraint<3> for ExpressionConstraint {
    fn sample(&self, motion: &Motion<3>) -> ConstraintSample<3> {
        let [x, y, z] = motion.position;
        let at = [x, y, z, motion.time];
        let along = [motion.velocity[0], motion.velocity[1], motion.velocity[2], 1.0];
        let rate = |i: usize| (0..4).map(|j| self.second[pair(i, j)].at(&at) * along[j]).sum::<f64>();
        ConstraintSample {
            value: self.value.at(&at),
            gradient: std::array::from_fn(|i| self.first[i].at(&at)),
            time_rate: self.first[3].at(&at),
            gradient_rate: std::array::from_fn(rate),
            time_rate_rate: rate(3),
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
