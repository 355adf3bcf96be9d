use crate::args::{Arguments, Command};
use crate::diagnostic::CliError;
use crate::{compare, sweep};
use slideway_lab::{BUILT_IN, Scenario, TEMPLATE};
use std::io::Write as _;
use std::path::Path;

/// How a command ended, short of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Done, and the verdict (if there was one) holds.
    Holds,
    /// Done, and the verdict does not hold.
    Fails,
}

impl Outcome {
    pub(crate) fn exit_status(self) -> u8 {
        match self {
            Self::Holds => 0,
            Self::Fails => 1,
        }
    }
}

pub(crate) fn run(arguments: Arguments) -> Result<Outcome, CliError> {
    match arguments.command {
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::List => Ok(list()),
        Command::Show { scenario } => show(&scenario),
        Command::Init { file } => init(&file),
    }
}

/// Prints to standard output; a reader that closes the pipe early is no error.
pub(crate) fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

fn list() -> Outcome {
    let width = BUILT_IN.iter().map(|b| b.name.len()).max().unwrap_or(0);
    let line = |b: &slideway_lab::BuiltIn| {
        let description = Scenario::parse(b.name, b.text).map(|s| s.description().to_owned()).unwrap_or_default();
        format!("{:width$}  {description}\n", b.name)
    };
    print(&BUILT_IN.iter().map(line).collect::<String>());
    Outcome::Holds
}

fn show(name: &str) -> Result<Outcome, CliError> {
    let built_in = BUILT_IN.iter().find(|b| b.name == name).ok_or_else(|| unknown(name))?;
    print(built_in.text);
    Ok(Outcome::Holds)
}

fn init(file: &Path) -> Result<Outcome, CliError> {
    let write = |source: std::io::Error| CliError::Write { path: file.to_owned(), source };
    let opened = std::fs::File::create_new(file);
    let mut out = match opened {
        Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {
            return Err(CliError::Exists { path: file.to_owned() });
        }
        opened => opened.map_err(write)?,
    };
    out.write_all(TEMPLATE.as_bytes()).map_err(write)?;
    print(&format!("wrote {0}; run it with `slideway compare {0}`\n", file.display()));
    Ok(Outcome::Holds)
}

/// A built-in scenario by name, else a file.
pub(crate) fn load(name: &str) -> Result<Scenario, CliError> {
    if let Some(scenario) = Scenario::built_in(name) {
        return scenario.map_err(|error| scenario_error(error, name, None));
    }
    let path = Path::new(name);
    if !path.exists() {
        return Err(unknown(name));
    }
    let text = Scenario::read_text(path).map_err(|error| scenario_error(error, name, None))?;
    let stem = path.file_stem().map_or_else(|| "scenario".into(), |s| s.to_string_lossy().into_owned());
    Scenario::parse(&stem, &text).map_err(|error| scenario_error(error, name, Some(text)))
}

pub(crate) fn scenario_error(error: slideway_lab::LabError, file: &str, text: Option<String>) -> CliError {
    CliError::Scenario { error: Box::new(error), file: file.to_owned(), text }
}

pub(crate) fn unknown(name: &str) -> CliError {
    let nearest = BUILT_IN
        .iter()
        .map(|b| (edit_distance(name, b.name), b.name))
        .min()
        .filter(|(distance, name)| 3 * distance <= name.len())
        .map(|(_, name)| name);
    CliError::UnknownScenario { name: name.to_owned(), nearest }
}

/// Levenshtein distance, for suggesting a name.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let substitute = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = substitute.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
