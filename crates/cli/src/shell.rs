//! What shells and manual pages take from the command line's own description.

use crate::args::Arguments;
use crate::say::diagnostic::CliError;
use crate::say::output::{Outcome, print, wrote};
use clap::CommandFactory;
use clap_complete::Shell;
use clap_mangen::Man;
use std::fs;
use std::path::{Path, PathBuf};

/// Prints a completion script.
pub(crate) fn completions(shell: Shell) -> Result<Outcome, CliError> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "slideway", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(Outcome::Holds)
}

/// Prints the manual page, or writes it and one for every subcommand into a folder.
pub(crate) fn man(out: Option<&Path>) -> Result<Outcome, CliError> {
    let Some(out) = out else {
        let mut page = Vec::new();
        let rendered = Man::new(Arguments::command()).render(&mut page);
        rendered.map_err(|source| failed("standard output".into(), source))?;
        print(&String::from_utf8_lossy(&page))?;
        return Ok(Outcome::Holds);
    };
    fs::create_dir_all(out).map_err(|source| failed(out.to_owned(), source))?;
    clap_mangen::generate_to(Arguments::command(), out).map_err(|source| failed(out.to_owned(), source))?;
    wrote(out);
    Ok(Outcome::Holds)
}

fn failed(path: PathBuf, source: std::io::Error) -> CliError {
    CliError::Write { path, source }
}
