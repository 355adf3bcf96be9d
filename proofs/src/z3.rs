//! Runs the `z3` binary on a script and reads its answer.

use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, Stdio};

use thiserror::Error;

/// Seconds after which the solver gives up and answers [`Answer::Unknown`].
const TIME_LIMIT: u32 = 120;

/// Answer of the solver to a script.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// No assignment satisfies the assertions: the negated claim is impossible.
    Unsat,
    /// An assignment satisfies them.
    Sat(Model),
    /// Neither was decided; the solver's own word for it.
    Unknown(String),
}

/// The values `(get-value ...)` printed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    values: Vec<Binding>,
}

#[derive(Clone, Debug, PartialEq)]
struct Binding {
    name: String,
    value: f64,
}

impl Model {
    /// The value of a constant of the script.
    ///
    /// # Errors
    ///
    /// [`Z3Error::NoValue`] if the solver printed none, or printed it in a form that is not a number here (an algebraic
    /// number as the root of a polynomial, for one).
    pub fn value(&self, name: &str) -> Result<f64, Z3Error> {
        let found = self.values.iter().find(|binding| binding.name == name);
        found.map(|binding| binding.value).ok_or_else(|| Z3Error::NoValue { name: name.to_owned() })
    }
}

/// Reason why there is no answer. None of these may be taken for a proof.
#[derive(Debug, Error)]
pub enum Z3Error {
    /// The binary is not there.
    #[error(
        "the solver '{program}' was not found, so nothing is proven; install it with `apt-get install z3` or `pip install z3-solver`"
    )]
    Missing {
        /// The program that was looked for.
        program: String,
    },
    /// The binary is there, but talking to it failed.
    #[error("the solver could not be run")]
    Run(#[source] io::Error),
    /// The solver objects to the script.
    #[error("the solver refuses the script: {message}")]
    Script {
        /// Text that it printed.
        message: String,
    },
    /// The solver printed something that is no answer.
    #[error("the solver's answer was not understood: {output}")]
    Output {
        /// Text that it printed.
        output: String,
    },
    /// A model has no readable value under this name.
    #[error("the model gives no number for '{name}'")]
    NoValue {
        /// The constant that was asked for.
        name: String,
    },
}

/// Runs `z3`, found on the search path, on a script with one `(check-sat)`.
///
/// # Errors
///
/// See [`Z3Error`]. A missing solver is an error, never a pass.
pub fn run(script: &str) -> Result<Answer, Z3Error> {
    run_program(Path::new("z3"), script)
}

/// As [`run`], with the binary named.
///
/// # Errors
///
/// See [`Z3Error`].
pub fn run_program(program: &Path, script: &str) -> Result<Answer, Z3Error> {
    let mut child = Command::new(program)
        .args(["-in", &format!("-T:{TIME_LIMIT}")])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => Z3Error::Missing { program: program.display().to_string() },
            _ => Z3Error::Run(error),
        })?;
    let written = child.stdin.take().map_or(Ok(()), |mut input| input.write_all(script.as_bytes()));
    let output = child.wait_with_output().map_err(Z3Error::Run)?;
    written.map_err(Z3Error::Run)?;
    read_answer(&String::from_utf8_lossy(&output.stdout))
}

/// Reads `sat`, `unsat` or another word on the first line, and after `sat` the list of values.
fn read_answer(output: &str) -> Result<Answer, Z3Error> {
    if output.contains("(error") {
        return Err(Z3Error::Script { message: output.trim().to_owned() });
    }
    let (word, rest) = output.trim().split_once(char::is_whitespace).unwrap_or((output.trim(), ""));
    match word {
        "unsat" => Ok(Answer::Unsat),
        "sat" => Ok(Answer::Sat(read_model(rest))),
        "unknown" | "timeout" => Ok(Answer::Unknown(word.to_owned())),
        _ => Err(Z3Error::Output { output: output.trim().to_owned() }),
    }
}

/// The part of SMT-LIB's syntax that answers are made of.
enum Expression {
    Atom(String),
    List(Vec<Expression>),
}

/// Reads `((name value) ...)`; a value that is no number is left out, and [`Model::value`] says so when asked.
fn read_model(text: &str) -> Model {
    let mut values = Vec::new();
    for expression in read_expressions(text) {
        let Expression::List(bindings) = expression else { continue };
        for binding in &bindings {
            let Expression::List(pair) = binding else { continue };
            if let [Expression::Atom(name), value] = pair.as_slice()
                && let Some(value) = number(value)
            {
                values.push(Binding { name: name.clone(), value });
            }
        }
    }
    Model { values }
}

/// Without recursion, so that no answer can exhaust the stack. Unbalanced closing brackets end the reading.
fn read_expressions(text: &str) -> Vec<Expression> {
    let spaced = text.replace('(', " ( ").replace(')', " ) ");
    let mut open = vec![Vec::new()];
    for token in spaced.split_whitespace() {
        let finished = match token {
            "(" => {
                open.push(Vec::new());
                continue;
            }
            ")" => Expression::List(open.pop().unwrap_or_default()),
            atom => Expression::Atom(atom.to_owned()),
        };
        match open.last_mut() {
            Some(parent) => parent.push(finished),
            None => break,
        }
    }
    open.into_iter().next().unwrap_or_default()
}

/// A decimal (a trailing `?` marks one cut short), a fraction, a negation, or a double.
fn number(expression: &Expression) -> Option<f64> {
    let list = match expression {
        Expression::Atom(atom) => return decimal(atom),
        Expression::List(list) => list,
    };
    match list.as_slice() {
        [Expression::Atom(minus), x] if minus == "-" => Some(-number(x)?),
        [Expression::Atom(divide), x, y] if divide == "/" => Some(number(x)? / number(y)?),
        [Expression::Atom(head), Expression::Atom(name), ..] if head == "_" => special(name),
        [Expression::Atom(head), Expression::Atom(sign), Expression::Atom(exponent), Expression::Atom(fraction)]
            if head == "fp" =>
        {
            Some(f64::from_bits(bits(sign)? << 63 | bits(exponent)? << 52 | bits(fraction)?))
        }
        _ => None,
    }
}

fn decimal(atom: &str) -> Option<f64> {
    // Rust reads "inf" and "nan" as numbers as well; the solver never means one by them.
    atom.starts_with(|c: char| c.is_ascii_digit()).then(|| atom.trim_end_matches('?').parse().ok())?
}

fn special(name: &str) -> Option<f64> {
    match name {
        "NaN" => Some(f64::NAN),
        "+oo" => Some(f64::INFINITY),
        "-oo" => Some(f64::NEG_INFINITY),
        "+zero" => Some(0.0),
        "-zero" => Some(-0.0),
        _ => None,
    }
}

fn bits(literal: &str) -> Option<u64> {
    match literal.split_at_checked(2)? {
        ("#b", digits) => u64::from_str_radix(digits, 2).ok(),
        ("#x", digits) => u64::from_str_radix(digits, 16).ok(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{Answer, Model, Z3Error, read_answer};

    fn model(output: &str) -> Model {
        match read_answer(output) {
            Ok(Answer::Sat(model)) => model,
            _ => Model::default(),
        }
    }

    #[test]
    fn every_form_of_number_is_read() -> Result<(), Z3Error> {
        let model =
            model("sat\n((a (/ 1.0 4.0))\n (b (- 2.5)) (c 0.3333?) (d (fp #b1 #b10000000000 #x8000000000000)))");
        assert_eq!(model.value("a")?, 0.25);
        assert_eq!(model.value("b")?, -2.5);
        assert_eq!(model.value("c")?, 0.3333);
        assert_eq!(model.value("d")?, -3.0);
        Ok(())
    }

    #[test]
    fn what_is_no_number_is_an_error_and_not_a_zero() {
        let model = model("sat\n((a (root-obj (+ (^ x 2) (- 2)) 2)) (b true))");
        assert!(matches!(model.value("a"), Err(Z3Error::NoValue { .. })));
        assert!(matches!(model.value("b"), Err(Z3Error::NoValue { .. })));
        assert!(matches!(model.value("c"), Err(Z3Error::NoValue { .. })));
    }

    #[test]
    fn nothing_but_unsat_is_read_as_unsat() {
        assert!(matches!(read_answer("unknown\n"), Ok(Answer::Unknown(_))));
        assert!(matches!(read_answer("timeout\n"), Ok(Answer::Unknown(_))));
        assert!(matches!(read_answer("unsat\n(error \"line 1\")\n"), Err(Z3Error::Script { .. })));
        assert!(matches!(read_answer(""), Err(Z3Error::Output { .. })));
        assert!(matches!(read_answer("unsaturated\n"), Err(Z3Error::Output { .. })));
        assert!(matches!(read_answer("unsat\n"), Ok(Answer::Unsat)));
    }
}
