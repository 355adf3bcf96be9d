//! Powers as mathematics writes them: `-x^2` is `-(x^2)`, and `2^3^2` is `2^(3^2)`.
//!
//! The parser's signs take the operand next to them, so that it reads `(-x)^2`, and it reads powers from the left. Every power is
//! put into parentheses before the parser sees it.

use super::jet::{Jet, JetOperators};
use super::literal::Literal;
use exmex::{MakeOperators, MatchLiteral};

/// A piece of a formula between two parentheses.
enum Item {
    /// An operand that can be raised to a power: a number, a name, something in parentheses, a function of such.
    Operand(String),
    /// A function that waits for its operand.
    Function(String),
    /// Anything else.
    Operator(String),
}

/// The formula with every power in parentheses. What is no formula comes back as it is, for the parser to refuse.
pub(crate) fn in_parentheses(text: &str) -> String {
    if !text.contains('^') {
        return text.to_owned();
    }
    let mut rest = text;
    let read = group(&mut rest);
    if rest.is_empty() { read } else { text.to_owned() }
}

/// Reads to the end, or to a parenthesis that closes what it did not open. It descends once per parenthesis that is open.
fn group(rest: &mut &str) -> String {
    let mut items: Vec<Item> = Vec::new();
    loop {
        *rest = rest.trim_start();
        let Some(first) = rest.chars().next().filter(|&first| first != ')') else { break };
        let item = if first == '(' {
            *rest = &rest[1..];
            let inner = group(rest);
            let closed = rest.strip_prefix(')');
            *rest = closed.unwrap_or(rest);
            Item::Operand(format!("({inner}{}", if closed.is_some() { ")" } else { "" }))
        } else if let Some(number) = Literal::is_literal(rest) {
            *rest = &rest[number.len()..];
            Item::Operand(number.to_owned())
        } else if first.is_alphabetic() || first == '_' {
            let name = take(rest, |c| c.is_alphanumeric() || c == '_');
            let expected = !matches!(items.last(), Some(Item::Operand(_)));
            named(name, expected, rest.trim_start().starts_with('('))
        } else {
            *rest = &rest[first.len_utf8()..];
            Item::Operator(first.to_string())
        };
        items.push(item);
    }
    text_of(powers(applied(items)))
}

fn take(rest: &mut &str, belongs: impl Fn(char) -> bool) -> String {
    let end = rest.find(|c| !belongs(c)).unwrap_or(rest.len());
    let (name, after) = rest.split_at(end);
    *rest = after;
    name.to_owned()
}

/// A name: a function, an operator such as `min` between two operands, else a variable or a constant. `min(a, b)` is a function.
fn named(name: String, operand_expected: bool, before_parenthesis: bool) -> Item {
    let operators: Vec<exmex::Operator<'_, Jet>> = JetOperators::make();
    let Some(operator) = operators.iter().find(|o| o.repr() == name) else { return Item::Operand(name) };
    if operator.has_unary() || (operator.has_bin() && operand_expected && before_parenthesis) {
        return Item::Function(name);
    }
    if operator.has_bin() { Item::Operator(name) } else { Item::Operand(name) }
}

/// Functions with what they are of.
fn applied(items: Vec<Item>) -> Vec<Item> {
    let mut done: Vec<Item> = Vec::new();
    for item in items.into_iter().rev() {
        let joined = match (item, done.pop()) {
            (Item::Function(name), Some(Item::Operand(of))) => Item::Operand(format!("{name} {of}")),
            (item, after) => {
                done.extend(after);
                item
            }
        };
        done.push(joined);
    }
    done.reverse();
    done
}

/// Powers in parentheses, those on the right first. A sign in front of an exponent belongs to it.
fn powers(items: Vec<Item>) -> Vec<Item> {
    let mut done: Vec<Item> = Vec::new();
    let mut items = items.into_iter().rev().peekable();
    while let Some(item) = items.next() {
        let is_power = matches!(&item, Item::Operator(sign) if sign == "^");
        let based = matches!(items.peek(), Some(Item::Operand(_)));
        if !(is_power && based) {
            done.push(item);
            continue;
        }
        // Read from the right: the nearest piece was pushed last.
        let signs = done.iter().rev().take_while(|i| matches!(i, Item::Operator(s) if s == "-" || s == "+")).count();
        let whole = matches!(done.iter().rev().nth(signs), Some(Item::Operand(_)));
        match items.next() {
            Some(Item::Operand(base)) if whole => {
                let exponent = done.split_off(done.len() - signs - 1);
                let exponent = text_of(exponent.into_iter().rev().collect());
                done.push(Item::Operand(format!("({base}^({exponent}))")));
            }
            base => {
                done.push(item);
                done.extend(base);
            }
        }
    }
    done.reverse();
    done
}

fn text_of(items: Vec<Item>) -> String {
    let pieces: Vec<String> = items
        .into_iter()
        .map(|item| match item {
            Item::Operand(text) | Item::Function(text) | Item::Operator(text) => text,
        })
        .collect();
    pieces.join(" ")
}

#[cfg(test)]
mod tests {
    use crate::formula::Formula;
    use proptest::prelude::*;

    fn at(text: &str, lambda: f64) -> f64 {
        Formula::new(text).unwrap_or_else(|error| panic!("{text}: {error}")).at(lambda)[0]
    }

    #[test]
    fn signs_and_chains_of_powers_are_read_as_mathematics_reads_them() {
        for (text, value) in [
            ("-lambda^2", -9.0),
            ("-(lambda + 1 + 1)", -5.0),
            ("1 - -lambda^2", 10.0),
            ("2^3^2", 512.0),
            ("2^-lambda", 0.125),
            ("-2^-2", -0.25),
            ("+lambda^2", 9.0),
            ("2 * -lambda^2 / 3", -6.0),
            ("(-lambda)^2", 9.0),
            ("-(lambda - 1)^2 * 2", -8.0),
            ("-sqrt(lambda + 1)^3", -8.0),
            ("(lambda max 5)^2 - 2^2", 21.0),
            ("lambda max 2^2", 4.0),
            ("exp(-(lambda - 3)^2)", 1.0),
            ("2^lambda^-1 - 2^(1 / lambda)", 0.0),
        ] {
            // Powers of small numbers, right to a few units in the last place.
            assert!((at(text, 3.0) - value).abs() < 1e-12, "{text}: {} instead of {value}", at(text, 3.0));
        }
    }

    #[test]
    fn what_is_no_formula_is_still_refused_with_its_own_text() {
        for text in ["^2", "lambda^", "lambda^*2", "(lambda^2", "lambda)^2", "2^^2", "lambda ^ 2)"] {
            let error = Formula::new(text).expect_err(text).to_string();
            assert!(error.contains(text), "{error}");
        }
    }

    /// A formula as it is meant, with how tightly it binds when written: 0 sums, 1 products, 2 signs, 3 powers, 4 the rest.
    #[derive(Clone, Debug)]
    struct Meant {
        text: String,
        binds: u8,
        value: f64,
        /// The largest number on the way.
        size: f64,
    }

    /// A formula made of one or two others, with the value meant.
    fn made(text: String, binds: u8, value: f64, of: [&Meant; 2]) -> Meant {
        let size = value.abs().max(of[0].size).max(of[1].size);
        Meant { text, binds, value, size: if value.is_finite() { size } else { f64::INFINITY } }
    }

    impl Meant {
        fn at_least(&self, binds: u8) -> String {
            if self.binds >= binds { self.text.clone() } else { format!("({})", self.text) }
        }
    }

    fn meant() -> impl Strategy<Value = Meant> {
        let number = (1..6_u8).prop_map(|n| Meant { text: n.to_string(), binds: 4, value: n.into(), size: n.into() });
        let variable = Just(Meant { text: "lambda".into(), binds: 4, value: 0.7, size: 0.7 });
        prop_oneof![number, variable].prop_recursive(4, 24, 2, |inner| {
            (inner.clone(), inner, 0..6_u8).prop_map(|(a, b, kind)| {
                let (text, binds, value) = match kind {
                    0 => (format!("{} + {}", a.text, b.at_least(1)), 0, a.value + b.value),
                    1 => (format!("{} - {}", a.text, b.at_least(1)), 0, a.value - b.value),
                    2 => (format!("{} * {}", a.at_least(1), b.at_least(2)), 1, a.value * b.value),
                    3 => (format!("-{}", a.at_least(2)), 2, -a.value),
                    4 => (format!("cos({})", a.text), 4, a.value.cos()),
                    // Next to a whole exponent a negative base has no power, and rounding decides.
                    _ if a.value <= 0.0 && b.text.parse::<u8>().is_err() => (a.text.clone(), a.binds, f64::NAN),
                    _ => (format!("{}^{}", a.at_least(4), b.at_least(2)), 3, a.value.powf(b.value)),
                };
                made(text, binds, value, [&a, &b])
            })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, max_global_rejects: u32::MAX, ..ProptestConfig::default() })]

        // A few dozen roundings of 1e-16, of numbers up to 1e3, each made at most 1e6 times larger by what is done with its result.
        #[test]
        fn formulas_mean_what_they_are_written_as(meant in meant()) {
            prop_assume!(meant.size < 1e3);
            let found = at(&meant.text, 0.7);
            prop_assert!((found - meant.value).abs() <= 1e-6 * (1.0 + meant.value.abs()), "{}: {found}", meant.text);
        }
    }
}
