//! Numbers that carry derivatives through a formula.

use exmex::{BinOp, MakeOperators, Operator};
use num_dual::{DualNum, HyperDual64};
use std::num::ParseFloatError;
use std::str::FromStr;

/// A hyper-dual number: a value, its derivatives along two directions and the mixed second derivative along both.
///
/// Exact to rounding, at the cost of a few evaluations: no expression is differentiated, none grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet(HyperDual64);

impl Jet {
    /// A number that does not change.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self(HyperDual64::from_re(value))
    }

    /// A variable that changes by `along[0]` and `along[1]` in the two directions.
    #[must_use]
    pub fn variable(value: f64, along: [f64; 2]) -> Self {
        Self(HyperDual64::new(value, along[0], along[1], 0.0))
    }

    /// The value, its derivative along the first direction, and the mixed derivative along both.
    #[must_use]
    pub fn parts(&self) -> [f64; 3] {
        [self.0.re, self.0.eps1, self.0.eps1eps2]
    }

    /// A function of the number, from the function's value and first two derivatives there.
    fn chain(self, [value, first, second]: [f64; 3]) -> Self {
        let HyperDual64 { eps1, eps2, eps1eps2, .. } = self.0;
        // What does not change adds nothing, whatever the slope.
        let times = |slope: f64, change: f64| if change == 0.0 { 0.0 } else { slope * change };
        let mixed = times(first, eps1eps2) + times(second, eps1 * eps2);
        Self(HyperDual64::new(value, times(first, eps1), times(first, eps2), mixed))
    }

    /// The library's own quotient of exponentials overflows from about 355 on.
    fn tanh(self) -> Self {
        let value = self.0.re.tanh();
        let e = (-2.0 * self.0.re.abs()).exp();
        // 1 - tanh², without cancelling.
        let first = 4.0 * e / ((1.0 + e) * (1.0 + e));
        self.chain([value, first, -2.0 * value * first])
    }

    fn is_constant(&self) -> bool {
        self.0.eps1 == 0.0 && self.0.eps2 == 0.0 && self.0.eps1eps2 == 0.0
    }

    /// `self ^ exponent`; a constant exponent allows a negative base where it is a whole number.
    #[allow(clippy::cast_possible_truncation)]
    fn power(self, exponent: Self) -> Self {
        let n = exponent.0.re;
        let with_derivatives = match exponent.is_constant() {
            // A term whose factor is zero is zero, not zero times the infinity of `0^-1`.
            true if self.0.re == 0.0 => {
                let term = |factor: f64, n: f64| if factor == 0.0 { 0.0 } else { factor * 0.0_f64.powf(n) };
                return self.chain([0.0_f64.powf(n), term(n, n - 1.0), term(n * (n - 1.0), n - 2.0)]);
            }
            // The products of exponents that derivatives take fit into their integers.
            true if n.fract() == 0.0 && n.abs() <= 1000.0 => return Self(self.0.powi(n as i32)),
            true if self.is_constant() => Self::constant(n).0,
            true => self.0.powf(n),
            false => self.0.powd(exponent.0),
        };
        // The value is there where derivatives are not, as at zero.
        Self(HyperDual64 { re: self.0.re.powf(n), ..with_derivatives })
    }
}

impl Default for Jet {
    fn default() -> Self {
        Self::constant(0.0)
    }
}

impl FromStr for Jet {
    type Err = ParseFloatError;

    fn from_str(text: &str) -> Result<Self, ParseFloatError> {
        text.parse().map(Self::constant)
    }
}

/// The operators of formulas, all of them differentiable but at single points.
#[derive(Clone, Debug)]
pub(crate) struct JetOperators;

fn binary<'a>(name: &'a str, prio: i64, apply: fn(Jet, Jet) -> Jet) -> Operator<'a, Jet> {
    Operator::make_bin(name, BinOp { apply, prio, is_commutative: false })
}

impl MakeOperators<Jet> for JetOperators {
    fn make<'a>() -> Vec<Operator<'a, Jet>> {
        // Not declared commutative: the parser then sums constants of a sum first, and loses the sign in front of it, as in `-(x + 1 + 1)`.
        let sum = BinOp { apply: |a: Jet, b: Jet| Jet(a.0 + b.0), prio: 0, is_commutative: false };
        let difference = BinOp { apply: |a: Jet, b: Jet| Jet(a.0 - b.0), prio: 1, is_commutative: false };
        vec![
            Operator::make_bin_unary("+", sum, |a| a),
            Operator::make_bin_unary("-", difference, |a| Jet(-a.0)),
            binary("*", 2, |a, b| Jet(a.0 * b.0)),
            binary("/", 3, |a, b| Jet(a.0 / b.0)),
            binary("^", 4, Jet::power),
            binary("atan2", 0, |y, x| Jet(y.0.atan2(x.0))),
            // A side that is not a number stays one.
            binary("min", 0, |a, b| if a.0.re.is_nan() || a.0.re <= b.0.re { a } else { b }),
            binary("max", 0, |a, b| if a.0.re.is_nan() || a.0.re >= b.0.re { a } else { b }),
            // At zero the derivative is that to the right.
            Operator::make_unary("abs", |a| if a.0.re < 0.0 { Jet(-a.0) } else { a }),
            Operator::make_unary("sin", |a| Jet(a.0.sin())),
            Operator::make_unary("cos", |a| Jet(a.0.cos())),
            Operator::make_unary("tan", |a| Jet(a.0.tan())),
            Operator::make_unary("asin", |a| Jet(a.0.asin())),
            Operator::make_unary("acos", |a| Jet(a.0.acos())),
            Operator::make_unary("atan", |a| Jet(a.0.atan())),
            Operator::make_unary("sinh", |a| Jet(a.0.sinh())),
            Operator::make_unary("cosh", |a| Jet(a.0.cosh())),
            Operator::make_unary("tanh", Jet::tanh),
            Operator::make_unary("asinh", |a| Jet(a.0.asinh())),
            Operator::make_unary("acosh", |a| Jet(a.0.acosh())),
            Operator::make_unary("atanh", |a| Jet(a.0.atanh())),
            Operator::make_unary("exp", |a| Jet(a.0.exp())),
            Operator::make_unary("sqrt", |a| Jet(a.0.sqrt())),
            Operator::make_unary("cbrt", |a| Jet(a.0.cbrt())),
            Operator::make_unary("ln", |a| Jet(a.0.ln())),
            Operator::make_unary("log", |a| Jet(a.0.ln())),
            Operator::make_unary("log2", |a| Jet(a.0.log2())),
            Operator::make_unary("log10", |a| Jet(a.0.log10())),
            Operator::make_constant("PI", Jet::constant(std::f64::consts::PI)),
            Operator::make_constant("π", Jet::constant(std::f64::consts::PI)),
            Operator::make_constant("TAU", Jet::constant(std::f64::consts::TAU)),
            Operator::make_constant("τ", Jet::constant(std::f64::consts::TAU)),
            Operator::make_constant("E", Jet::constant(std::f64::consts::E)),
            Operator::make_constant("e", Jet::constant(std::f64::consts::E)),
        ]
    }
}
