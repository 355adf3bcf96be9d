//! The `slideway` command.
//!
//! Exit status: 0 the verdict holds, 1 it does not, 2 the input is wrong.

mod args;
mod attack;
mod claims;
mod claims_json;
mod claims_report;
mod commands;
mod compare;
mod compare_path;
mod compare_speed;
mod compared;
mod convergence;
mod diagnostic;
mod effort_table;
mod gallery;
mod journal;
mod journal_error;
mod laws;
mod loaded;
mod merge;
mod obstacle;
mod output;
mod parallel;
mod path_report;
mod path_summary;
mod replay;
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
mod verify;
mod verify_error;
mod verify_files;
mod verify_journal;
mod verify_junit;
mod verify_output;
mod verify_page;
mod verify_results;
mod verify_shard;
mod verify_table;
mod verify_words;
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
