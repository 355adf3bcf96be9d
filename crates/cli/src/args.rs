use clap::{Parser, Subcommand};
use std::path::PathBuf;

/// Sliding-mode reference conditioners for robots, beside certified optima.
#[derive(Debug, Parser)]
#[command(version, about, long_about = None, arg_required_else_help = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run every method on a scenario and put it beside the offline optimum.
    ///
    /// Speed scenarios: every speed law beside the certified time optimum. Conditioning scenarios: the conditioner beside the
    /// exact projection, the QP safety filter and the potential field.
    ///
    /// Exit status: 0 the verdict holds, 1 it does not, 2 the input is wrong.
    Compare(CompareArguments),
    /// Show the built-in scenarios.
    List,
    /// Print a built-in scenario, to start your own from.
    Show {
        /// Name of a built-in scenario.
        scenario: String,
    },
    /// Write a commented scenario file that runs as it is.
    Init {
        /// The file to write; it must not exist yet.
        file: PathBuf,
        /// What the scenario is about.
        #[arg(long, value_enum, default_value_t = Kind::Speed)]
        kind: Kind,
    },
}

/// Kinds of scenario.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Kind {
    /// A robot whose speed along a path is regulated.
    Speed,
    /// A reference that is kept inside constraints.
    Conditioning,
}

#[derive(Debug, clap::Args)]
pub(crate) struct CompareArguments {
    /// Name of a built-in scenario, or path of a scenario file (TOML).
    pub(crate) scenario: String,
    /// Where to write the results [default: `out/` and the scenario's name].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// By how much the sliding mode may miss the optimum, as a fraction [default: the scenario's, else 0.02].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// Print summary.json instead of the table.
    #[arg(long)]
    pub(crate) json: bool,
}
