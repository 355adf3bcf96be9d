//! The `slideway` command.
//!
//! Exit status: 0 the verdict holds, 1 it does not, 2 the input is wrong or the output cannot be written.

mod args;
mod claims;
mod commands;
mod compare;
mod keep;
mod reproduce;
mod robot;
mod say;
mod shell;
mod study;
mod sweep;
mod tune;
mod verify;

use clap::Parser;
use say::diagnostic::CliError;
use say::output::print_error;
use std::process::ExitCode;

fn main() -> ExitCode {
    let done = match args::Arguments::try_parse() {
        Ok(arguments) => commands::run(arguments).map(say::output::Outcome::exit_status),
        // Help and version are no errors, unless they cannot be printed.
        Err(said) => said.print().map_err(CliError::Print).map(|()| if said.use_stderr() { 2 } else { 0 }),
    };
    match done {
        Ok(status) => ExitCode::from(status),
        Err(error) => {
            print_error(&format!("{:?}", error.into_report()));
            ExitCode::from(2)
        }
    }
}
