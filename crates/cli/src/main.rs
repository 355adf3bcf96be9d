//! The `slideway` command.
//!
//! Exit status: 0 the verdict holds, 1 it does not, 2 the input is wrong.

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
use std::process::ExitCode;

fn main() -> ExitCode {
    match commands::run(args::Arguments::parse()) {
        Ok(outcome) => ExitCode::from(outcome.exit_status()),
        Err(error) => {
            eprintln!("{:?}", error.into_report());
            ExitCode::from(2)
        }
    }
}
