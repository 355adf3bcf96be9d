//! Formulas as people type them, with exact derivatives.

mod jet;
mod literal;
mod powers;

use exmex::{Express, FlatEx};
pub use jet::Jet;
use jet::JetOperators;
use literal::Literal;
use powers::in_parentheses;
use thiserror::Error;

/// Reason why a formula was refused.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FormulaError {
    /// It does not parse.
    #[error("cannot read `{text}`: {reason}")]
    Syntax {
        /// The formula.
        text: String,
        /// Message of the parser.
        reason: String,
    },
    /// It uses a name that is neither the variable nor `pi`.
    #[error("`{text}` uses `{name}`, which means nothing here; known names: {known}")]
    UnknownName {
        /// The formula.
        text: String,
        /// The name.
        name: String,
        /// Names that may be used.
        known: String,
    },
    /// It is longer or more deeply nested than any formula is meant to be.
    #[error("a formula of {length} characters, nested {depth} deep; at most {MAX_LENGTH} and {MAX_DEPTH} are read")]
    TooLarge {
        /// Characters.
        length: usize,
        /// Parentheses open at once.
        depth: usize,
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

impl FormulaError {
    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        match self {
            Self::Syntax { .. } => {
                "write + - * / ^ between numbers and names, functions such as sin(...), and close every parenthesis"
                    .into()
            }
            Self::UnknownName { known, .. } => {
                format!("use the names {known} alone, and functions such as sin, cos, exp and sqrt")
            }
            Self::TooLarge { .. } => {
                format!("shorten it to {MAX_LENGTH} characters, nested {MAX_DEPTH} deep at the most")
            }
            Self::NotFinite { .. } => "change it so that its value is a finite number".into(),
        }
    }
}

type Expression = FlatEx<Jet, JetOperators, Literal>;

/// A formula in several variables, and `pi`.
#[derive(Clone, Debug)]
pub struct MultiFormula {
    expression: Expression,
    /// For each name of the expression, in the order in which the evaluator wants them: the variable, or `None` for pi.
    slots: Vec<Option<usize>>,
}

/// Most names a formula can have: the variables and pi.
const MAX_NAMES: usize = 8;
/// Longest formula that is read, in characters.
const MAX_LENGTH: usize = 4000;
/// Most parentheses open at once in a formula that is read.
const MAX_DEPTH: usize = 50;

impl MultiFormula {
    /// Parses a formula in the given variables, at most seven.
    ///
    /// # Errors
    ///
    /// It does not parse, or uses another name.
    pub fn new(text: &str, variables: &'static [&'static str]) -> Result<Self, FormulaError> {
        check_size(text)?;
        let expression = Expression::parse(&in_parentheses(text)).map_err(|error| syntax(text, &error))?;
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
        Ok(Self { expression, slots })
    }

    /// The value with its derivatives along the directions in which the variables change; NaN where it is not defined.
    #[must_use]
    pub fn at(&self, values: &[Jet]) -> Jet {
        let mut arguments = [Jet::default(); MAX_NAMES];
        for (argument, slot) in arguments.iter_mut().zip(&self.slots) {
            let pi = Jet::constant(std::f64::consts::PI);
            let unknown = Jet::constant(f64::NAN);
            *argument = slot.map_or(pi, |i| values.get(i).copied().unwrap_or(unknown));
        }
        let count = self.slots.len().min(MAX_NAMES);
        self.expression.eval(&arguments[..count]).unwrap_or(Jet::constant(f64::NAN))
    }
}

/// The parser descends once per parenthesis: what nobody types must not exhaust the stack.
fn check_size(text: &str) -> Result<(), FormulaError> {
    let mut open = 0_usize;
    let mut depth = 0;
    for character in text.chars() {
        match character {
            '(' | '[' | '{' => open += 1,
            ')' | ']' | '}' => open = open.saturating_sub(1),
            _ => {}
        }
        depth = depth.max(open);
    }
    let length = text.chars().count();
    if length <= MAX_LENGTH && depth <= MAX_DEPTH { Ok(()) } else { Err(FormulaError::TooLarge { length, depth }) }
}

fn syntax(text: &str, error: &exmex::ExError) -> FormulaError {
    FormulaError::Syntax { text: text.to_owned(), reason: error.to_string() }
}

/// A formula in one variable.
#[derive(Clone, Debug)]
pub struct Formula(MultiFormula);

/// The variable of a path.
const LAMBDA: &[&str] = &["lambda"];

/// True of a text that could be a formula in `lambda`, rather than a constant.
#[must_use]
pub fn mentions_lambda(text: &str) -> bool {
    text.contains(LAMBDA[0])
}

impl Formula {
    /// Parses a formula in `lambda` (and `pi`).
    ///
    /// # Errors
    ///
    /// It does not parse, or uses another name.
    pub fn new(text: &str) -> Result<Self, FormulaError> {
        MultiFormula::new(text, LAMBDA).map(Self)
    }

    /// Value, first and second derivative at a path parameter; NaN where the formula is not defined.
    #[must_use]
    pub fn at(&self, lambda: f64) -> [f64; 3] {
        // Both directions are the variable itself: the mixed derivative is the second.
        self.0.at(&[Jet::variable(lambda, [1.0, 1.0])]).parts()
    }
}

/// The value of a constant expression such as `pi / 2 - 0.2`.
///
/// # Errors
///
/// It does not parse, uses a name other than `pi`, or is not finite.
pub fn constant(text: &str) -> Result<f64, FormulaError> {
    let value = MultiFormula::new(text, &[])?.at(&[]).parts()[0];
    if value.is_finite() { Ok(value) } else { Err(FormulaError::NotFinite { text: text.to_owned(), value }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_a_formula_are_exact() {
        let formula = Formula::new("0.1 * (cos(2 * pi * lambda) - 1) + lambda^3").expect("parses");
        let [value, first, second] = formula.at(0.3);
        let w = std::f64::consts::TAU;
        // A handful of roundings of numbers below 10.
        assert!((value - (0.1 * ((w * 0.3).cos() - 1.0) + 0.027)).abs() < 1e-14);
        assert!((first - (-0.1 * w * (w * 0.3).sin() + 0.27)).abs() < 1e-14);
        assert!((second - (-0.1 * w * w * (w * 0.3).cos() + 1.8)).abs() < 1e-13);
    }

    #[test]
    fn every_operator_has_the_derivatives_that_differences_show() {
        let formulas = [
            "lambda^3 - 2^lambda + lambda^1.5 + lambda^lambda + (-lambda)^2 + (lambda - 1)^3",
            "sin(lambda) * cos(lambda) / tan(lambda + 2)",
            "asin(lambda / 2) + acos(lambda / 2) * atan(lambda) + lambda atan2 (1 + lambda)",
            "sinh(lambda) + cosh(lambda) * tanh(lambda) - asinh(lambda) + acosh(lambda + 1) + atanh(lambda / 2)",
            "exp(-lambda) + sqrt(lambda) + cbrt(lambda) + ln(lambda) * log(lambda) + log2(lambda) + log10(lambda)",
            "(lambda min 2) + (lambda max 2) * (3 min lambda) + abs(-lambda) - abs(lambda) * PI + e - τ",
        ];
        for text in formulas {
            let formula = Formula::new(text).expect("parses");
            let (x, h) = (0.7, 1e-4);
            let [before, here, after] = [x - h, x, x + h].map(|at| formula.at(at));
            // Central differences: h² / 6 times third and fourth derivatives of at most 1e2 here, plus rounding 1e-16 / h.
            assert!(((after[0] - before[0]) / (2.0 * h) - here[1]).abs() < 1e-6, "{text}");
            assert!(((after[1] - before[1]) / (2.0 * h) - here[2]).abs() < 1e-6, "{text}");
        }
    }

    #[test]
    fn smooth_functions_have_finite_derivatives_far_out_and_at_zero() {
        for x in [0.0, 1.0, 20.0, 300.0, 355.0, 400.0, 720.0, 1e4, 1e100, 1e300] {
            for x in [x, -x] {
                let [value, first, second] = Formula::new("tanh(lambda)").expect("parses").at(x);
                // To rounding: sech² = 1 / cosh², which overflows to the right value, 0.
                let slope = 1.0 / (x.cosh() * x.cosh());
                assert!(value == x.tanh() && (first - slope).abs() <= 1e-15, "{x}");
                assert!((second + 2.0 * value * slope).abs() <= 1e-15, "{x}");
                for text in
                    ["atan(lambda)", "asinh(lambda)", "exp(-abs(lambda))", "sin(lambda)", "1 / (1 + abs(lambda))"]
                {
                    let jet = Formula::new(text).expect("parses").at(x);
                    assert!(jet.iter().all(|part| part.is_finite()), "{text} at {x}: {jet:?}");
                }
            }
        }
        for (text, jet) in [
            ("lambda^0", [1.0, 0.0, 0.0]),
            ("lambda^1", [0.0, 1.0, 0.0]),
            ("lambda^2", [0.0, 0.0, 2.0]),
            ("lambda^3", [0.0, 0.0, 0.0]),
            ("lambda^2.5", [0.0, 0.0, 0.0]),
            ("lambda^2.0 + 1", [1.0, 0.0, 2.0]),
            ("(2 * lambda)^2", [0.0, 0.0, 8.0]),
            ("abs(lambda)^3", [0.0, 0.0, 0.0]),
            ("abs(lambda)", [0.0, 1.0, 0.0]),
            ("(lambda^2)^2", [0.0, 0.0, 0.0]),
            ("tanh(lambda^2)", [0.0, 0.0, 2.0]),
        ] {
            assert_eq!(Formula::new(text).expect("parses").at(0.0), jet, "{text}");
        }
        // A derivative that is infinite is not hidden.
        assert_eq!(Formula::new("lambda^1.5").expect("parses").at(0.0), [0.0, 0.0, f64::INFINITY]);
    }

    #[test]
    fn formulas_too_large_to_be_meant_are_refused_and_the_deepest_that_is_read_is_evaluated() {
        let nested = |depth: usize| format!("{}lambda{}", "sin(".repeat(depth), ")".repeat(depth));
        assert!(Formula::new(&nested(MAX_DEPTH)).expect("parses").at(0.5).iter().all(|x| x.is_finite()));
        for depth in [MAX_DEPTH + 1, 100_000] {
            assert!(matches!(Formula::new(&nested(depth)), Err(FormulaError::TooLarge { .. })));
        }
        let long = vec!["lambda"; 10_000].join("+");
        assert!(matches!(Formula::new(&long), Err(FormulaError::TooLarge { .. })));
        let unary = format!("{}lambda", "-".repeat(MAX_LENGTH - 6));
        let _ = Formula::new(&unary).map(|formula| formula.at(0.5));
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
