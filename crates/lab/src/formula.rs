use exmex::{Differentiate, Express, FlatEx, FloatOpsFactory, MatchLiteral};
use thiserror::Error;

/// Why a formula was refused.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FormulaError {
    /// It does not parse, or contains an operator without a derivative.
    #[error("cannot read `{text}`: {reason}")]
    Syntax {
        /// The formula.
        text: String,
        /// What the parser says.
        reason: String,
    },
    /// It uses a name that is neither the variable nor `pi`.
    #[error("`{text}` uses `{name}`, which means nothing here; known names: {known}")]
    UnknownName {
        /// The formula.
        text: String,
        /// The name.
        name: String,
        /// What may be used.
        known: String,
    },
    /// Its value is NaN or infinite.
    #[error("`{text}` is {value}, which is not a finite number")]
    NotFinite {
        /// The formula.
        text: String,
        /// The value.
        value: f64,
    },
}

/// Numbers as people write them: `3`, `.5`, `2.5e-3`. The parser's own matcher does not know exponents.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Literal;

impl MatchLiteral for Literal {
    fn is_literal(text: &str) -> Option<&str> {
        let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
        let whole = digits(0);
        let fraction = if text[whole..].starts_with('.') { digits(whole + 1) } else { 0 };
        if whole + fraction == 0 {
            return None;
        }
        let mut end = whole + if text[whole..].starts_with('.') { 1 + fraction } else { 0 };
        if text[end..].starts_with(['e', 'E']) {
            let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
            let exponent = digits(end + 1 + sign);
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        Some(&text[..end])
    }
}

type Expression = FlatEx<f64, FloatOpsFactory<f64>, Literal>;

/// A formula in several variables, and `pi`.
#[derive(Clone, Debug)]
pub(crate) struct MultiFormula {
    expression: Expression,
    variables: &'static [&'static str],
    text: String,
    /// For each name of the expression, in the order in which the evaluator wants them: the variable, or `None` for pi.
    slots: Vec<Option<usize>>,
}

/// Most names a formula can have: the variables and pi.
const MAX_NAMES: usize = 8;

impl MultiFormula {
    /// Parses a formula in the given variables.
    pub(crate) fn new(text: &str, variables: &'static [&'static str]) -> Result<Self, FormulaError> {
        let expression = Expression::parse(text).map_err(|error| syntax(text, &error))?;
        Self::with(expression, text, variables)
    }

    fn with(expression: Expression, text: &str, variables: &'static [&'static str]) -> Result<Self, FormulaError> {
        let slot = |name: &String| match variables.iter().position(|v| v == name) {
            Some(index) => Ok(Some(index)),
            None if name == "pi" => Ok(None),
            None => Err(FormulaError::UnknownName {
                text: text.to_owned(),
                name: name.clone(),
                known: variables.iter().chain(&["pi"]).copied().collect::<Vec<_>>().join(", "),
            }),
        };
        let slots = expression.var_names().iter().map(slot).collect::<Result<_, _>>()?;
        Ok(Self { expression, variables, text: text.to_owned(), slots })
    }

    /// The derivative by one of the variables, taken symbolically.
    pub(crate) fn derivative(&self, variable: &str) -> Result<Self, FormulaError> {
        let index = self.expression.var_names().iter().position(|name| name == variable);
        let derivative = match index {
            Some(index) => self.expression.clone().partial(index),
            None => Expression::parse("0"),
        };
        Self::with(derivative.map_err(|error| syntax(&self.text, &error))?, &self.text, self.variables)
    }

    /// The value; NaN where the formula is not defined.
    pub(crate) fn at(&self, values: &[f64]) -> f64 {
        let mut arguments = [0.0; MAX_NAMES];
        for (argument, slot) in arguments.iter_mut().zip(&self.slots) {
            *argument = slot.map_or(std::f64::consts::PI, |i| values.get(i).copied().unwrap_or(f64::NAN));
        }
        let count = self.slots.len().min(MAX_NAMES);
        self.expression.eval(&arguments[..count]).unwrap_or(f64::NAN)
    }
}

fn syntax(text: &str, error: &exmex::ExError) -> FormulaError {
    FormulaError::Syntax { text: text.to_owned(), reason: error.to_string() }
}

/// A formula in one variable with its first two derivatives.
#[derive(Clone, Debug)]
pub(crate) struct Formula {
    derivatives: [MultiFormula; 3],
}

/// The variable of a path.
const LAMBDA: &[&str] = &["lambda"];

/// Whether a text could be a formula in `lambda`, rather than a constant.
pub(crate) fn mentions_lambda(text: &str) -> bool {
    text.contains(LAMBDA[0])
}

impl Formula {
    /// Parses a formula in `lambda` (and `pi`).
    ///
    /// # Errors
    ///
    /// It does not parse, uses another name, or contains an operator whose derivative is not known.
    pub(crate) fn new(text: &str) -> Result<Self, FormulaError> {
        let value = MultiFormula::new(text, LAMBDA)?;
        let first = value.derivative("lambda")?;
        let second = first.derivative("lambda")?;
        Ok(Self { derivatives: [value, first, second] })
    }

    /// Value, first and second derivative at a path parameter; NaN where the formula is not defined.
    #[must_use]
    pub(crate) fn at(&self, lambda: f64) -> [f64; 3] {
        [0, 1, 2].map(|order: usize| self.derivatives[order].at(&[lambda]))
    }
}

/// The value of a constant expression such as `pi / 2 - 0.2`.
///
/// # Errors
///
/// It does not parse, uses a name other than `pi`, or is not finite.
pub fn constant(text: &str) -> Result<f64, FormulaError> {
    let value = MultiFormula::new(text, &[])?.at(&[]);
    if value.is_finite() { Ok(value) } else { Err(FormulaError::NotFinite { text: text.to_owned(), value }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_a_formula_are_symbolic() {
        let formula = Formula::new("0.1 * (cos(2 * pi * lambda) - 1) + lambda^3").expect("parses");
        let [value, first, second] = formula.at(0.3);
        let w = std::f64::consts::TAU;
        // A handful of roundings of numbers below 10.
        assert!((value - (0.1 * ((w * 0.3).cos() - 1.0) + 0.027)).abs() < 1e-14);
        assert!((first - (-0.1 * w * (w * 0.3).sin() + 0.27)).abs() < 1e-14);
        assert!((second - (-0.1 * w * w * (w * 0.3).cos() + 1.8)).abs() < 1e-13);
    }

    #[test]
    fn constant_formulas_have_zero_derivatives() {
        assert_eq!(Formula::new("pi").expect("parses").at(2.0), [std::f64::consts::PI, 0.0, 0.0]);
    }

    #[test]
    fn unknown_names_are_pointed_out() {
        assert!(matches!(Formula::new("sin(x)"), Err(FormulaError::UnknownName { name, .. }) if name == "x"));
        assert!(matches!(constant("2 * tau_1"), Err(FormulaError::UnknownName { .. })));
        assert!(matches!(constant("1 / 0"), Err(FormulaError::NotFinite { .. })));
        assert!(matches!(constant("2 *"), Err(FormulaError::Syntax { .. })));
    }

    #[test]
    fn constants_may_be_written_with_pi() {
        assert_eq!(constant("pi - 0.2"), Ok(std::f64::consts::PI - 0.2));
        assert_eq!(constant("-3e-2"), Ok(-0.03));
        assert_eq!(constant("2.5E+1 - .5"), Ok(24.5));
        assert_eq!(constant("1e3"), Ok(1e3));
    }
}
