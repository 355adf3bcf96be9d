//! The `slideway` command.
//!
//! Exit status: 0 the verdict holds, 1 it does not, 2 the input is wrong.

mod args;
mod attack;
mod claims;
mod commands;
mod compare;
mod compare_path;
mod compare_speed;
mod compared;
mod convergence;
mod diagnostic;
mod effort_table;
mod gallery;
mod laws;
mod loaded;
mod output;
mod path_report;
mod path_summary;
mod report;
mod reproduce;
mod robot;
mod robot_state;
mod study;
mod summary;
mod sweep;
mod sweep_error;
mod sweep_journal;
mod sweep_table;
mod table;
mod tune;
mod verdict;
mod windows;

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
