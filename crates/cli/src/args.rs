use crate::say::loudness::Loudness;
use crate::verify::shard::MAX_TRIALS;
use crate::verify::shard::Shard;
use clap::{Parser, Subcommand};
use clap_complete::Shell;
use std::num::{NonZeroU64, NonZeroUsize};
use std::path::PathBuf;

/// Sliding-mode reference conditioners for robots, beside certified optima.
#[derive(Debug, Parser)]
#[command(version, about, long_about = None, arg_required_else_help = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
    /// Say only what failed and the verdict: no progress, no tables.
    #[arg(long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Tell on the error stream how long each stage took and which files were written.
    #[arg(long, global = true)]
    verbose: bool,
}

impl Arguments {
    /// How much to say.
    pub(crate) fn loudness(&self) -> Loudness {
        match (self.quiet, self.verbose) {
            (true, _) => Loudness::Quiet,
            (_, true) => Loudness::Verbose,
            _ => Loudness::Normal,
        }
    }
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
    /// Put the papers' tables and figures beside what comes out here: value, difference, agreement, remark.
    ///
    /// Exit status: 0 everything that is known to agree does, 1 something no longer does.
    Reproduce(ReproduceArguments),
    /// Print pose, Jacobian and dynamics of a robot at one state.
    ///
    /// The PUMA-560's base frame sits at its shoulder, as in `[G11]`; on its pedestal poses would be 0.67183 m higher.
    Robot(RobotArguments),
    /// Run one method of a scenario many times, over random seeds, a grid of parameters or both, on all cores.
    ///
    /// A sweep that was interrupted goes on where it stopped when the same command is given again. The rows do not depend on
    /// the number of jobs. Exit status: 0 no run failed, 1 some did not complete or broke a constraint, 2 the input is wrong.
    Sweep(SweepArguments),
    /// State what is guaranteed for a scenario, and hold it against random trials around it, on all cores.
    ///
    /// A campaign that was interrupted goes on where it stopped when the same command is given again. The results do not depend
    /// on the number of jobs. Exit status: 0 every hypothesis holds and every guarantee was kept, 1 one was not, 2 the input is
    /// wrong.
    Verify(VerifyArguments),
    /// Put the shards of a campaign together: the same results as if it had run in one piece.
    ///
    /// Exit status: as that of `verify`.
    Merge(MergeArguments),
    /// Propose sampling period, bandwidth, target rate (and gain or push) for a chattering amplitude and a sampling rate.
    ///
    /// The hypotheses of the bounds then hold with a margin of a fifth. Says which trade-off it made, runs the tuned scenario once and
    /// shows what is guaranteed beside what came out. Exit status: 0 proposed, 1 impossible, with the rate and the amplitude that would
    /// do, 2 the input is wrong.
    Tune(TuneArguments),
    /// Run a study of the arm controller: what it found in numbers, a figure and a report.
    ///
    /// Exit status: 0 the study found what it claims, 1 it did not, 2 the input is wrong.
    Study(StudyArguments),
    /// Print the ledger of claims: what is proven, and what a run of the property tests measures here and now.
    ///
    /// The same numbers on any number of cores. A long run can be made claim by claim: `slideway claims NAME --level nightly`.
    ///
    /// Exit status: 0 every claim holds, 1 one is violated or its proof fails, 2 the input is wrong.
    Claims(ClaimsArguments),
    /// Search for counterexamples by simulated annealing on the margin of each claim.
    ///
    /// Exit status: 0 none was found, 1 one was, with the choices that give it again, 2 the input is wrong.
    Attack(AttackArguments),
    /// Show the built-in scenarios, robots and studies.
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
    /// Print the JSON Schema of scenario files, by which editors of TOML complete and check them.
    ///
    /// A file that `slideway init` wrote names it in its first line, as `slideway-speed.schema.json` (or `-conditioning`) beside itself.
    Schema {
        /// Kind of scenario.
        #[arg(long, value_enum, default_value_t = Kind::Speed)]
        kind: Kind,
        /// Write it to this file instead.
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
    },
    /// Print a completion script for a shell.
    ///
    /// For bash: `slideway completions bash > ~/.local/share/bash-completion/completions/slideway`.
    Completions {
        /// The shell.
        #[arg(value_enum)]
        shell: Shell,
    },
    /// Print the manual page, or write it and one for every subcommand.
    Man {
        /// Where to write the pages.
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
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

/// Published tables and figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Source {
    /// Table I of `[N]`: the two-joint limb under natural motion and constant speed.
    #[value(name = "table-1")]
    Table1,
    /// Table II of `[N]`: the PA-10.
    #[value(name = "table-2")]
    Table2,
    /// Table 1 of `[G11]`: errors of the speed laws on the helix.
    #[value(name = "speed-table-1")]
    SpeedTable1,
    /// What figures and text of the papers say in numbers.
    Figures,
}

#[derive(Debug, clap::Args)]
pub(crate) struct ReproduceArguments {
    /// What to reproduce.
    #[arg(value_enum, required_unless_present = "all", conflicts_with = "all")]
    pub(crate) source: Option<Source>,
    /// Reproduce everything, and write a page with the figures.
    #[arg(long)]
    pub(crate) all: bool,
    /// Where `--all` writes.
    #[arg(long, value_name = "DIR", default_value = "out/reproduce", requires = "all")]
    pub(crate) out: PathBuf,
    /// Print JSON instead of the table.
    #[arg(long)]
    pub(crate) json: bool,
}

/// How long the property tests run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Level {
    /// 2,000 cases a property: seconds.
    Quick,
    /// 100,000: some minutes.
    Smoke,
    /// 10,000,000: a night.
    Nightly,
}

#[derive(Debug, clap::Args)]
pub(crate) struct ClaimsArguments {
    /// This claim alone [default: all of them].
    #[arg(conflicts_with = "markdown")]
    pub(crate) claim: Option<String>,
    /// How long to run.
    #[arg(long, value_enum, default_value_t = Level::Quick)]
    pub(crate) level: Level,
    /// Cases per property, instead of a level.
    #[arg(long, value_name = "N")]
    pub(crate) cases: Option<NonZeroU64>,
    /// Print JSON instead of the table.
    #[arg(long, conflicts_with = "markdown")]
    pub(crate) json: bool,
    /// Print the text of proofs/CLAIMS.md.
    #[arg(long)]
    pub(crate) markdown: bool,
    /// Write claims.json, a page, and figures of the statements that do not hold.
    #[arg(long, value_name = "DIR", conflicts_with = "markdown")]
    pub(crate) out: Option<PathBuf>,
    /// See one case again: of a file that `slideway attack --out DIR` has written.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["claim", "case", "json", "markdown", "out", "level", "cases"])]
    pub(crate) replay: Option<PathBuf>,
    /// See one case again: of every property of the claim, by its number.
    #[arg(long, value_name = "N", requires = "claim", conflicts_with_all = ["json", "out", "level", "cases"])]
    pub(crate) case: Option<u64>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct AttackArguments {
    /// How long to search, all claims together, in minutes.
    #[arg(long, value_name = "M", default_value_t = 1.0)]
    pub(crate) minutes: f64,
    /// This claim alone [default: all of them].
    pub(crate) claim: Option<String>,
    /// Where the random sequence begins; another one searches elsewhere.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Write the closest case of each property into this folder, for `slideway claims --replay FILE`.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub(crate) struct CompareArguments {
    /// Name of a built-in scenario, or path of a scenario file (TOML).
    #[arg(required_unless_present = "all", conflicts_with = "all")]
    pub(crate) scenario: Option<String>,
    /// Run every built-in scenario and write one page about them all; exit status 1 if a verdict is not the one expected.
    #[arg(long)]
    pub(crate) all: bool,
    /// Where to write the results [default: `out/` and the scenario's name; with --all, `out`].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// By how much the sliding mode may miss the optimum, as a fraction [default: the scenario's, else 0.02].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,
    /// Keep the optimum's limits between grid points as well, to this share of each limit, for example 1e-6.
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) inter_sample: Option<f64>,
    /// How near the bounds of the whole path's optimum are to come, relative [default: the scenario's, else 1e-5].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) gap: Option<f64>,
    /// Most cells of the path that they may take [default: the scenario's, else 20000].
    #[arg(long, value_name = "N")]
    pub(crate) cells: Option<usize>,
    /// The solver of the optimum; its bounds do not rest on it [default: the scenario's, else structured].
    #[arg(long)]
    pub(crate) solver: Option<SolverArgument>,
    /// Print summary.json instead of the table.
    #[arg(long)]
    pub(crate) json: bool,
}

/// A solver of the optimum.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(crate) enum SolverArgument {
    /// The project's own interior points on the structure of the problem.
    Structured,
    /// The conic solver Clarabel: slower, a second opinion.
    Conic,
}

#[derive(Debug, clap::Args)]
pub(crate) struct RobotArguments {
    /// Name of a built-in robot (`slideway list` shows them), path of a URDF file, or of a scenario (TOML) for the robot in it.
    pub(crate) robot: String,
    /// Joint positions, rad or m, separated by spaces or commas; `pi / 2` and the like between commas [default: zeros].
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pub(crate) q: Option<String>,
    /// Joint speeds [default: zeros].
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pub(crate) qd: Option<String>,
    /// Joint accelerations, for the torque [default: zeros].
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pub(crate) qdd: Option<String>,
    /// Joint torques, for the acceleration.
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pub(crate) tau: Option<String>,
    /// Include the rotors' inertia behind their gears.
    #[arg(long)]
    pub(crate) rotor_inertia: bool,
    /// Include viscous and Coulomb friction.
    #[arg(long)]
    pub(crate) friction: bool,
    /// Base link of the arm in a URDF file [default: the root].
    #[arg(long, value_name = "LINK")]
    pub(crate) base: Option<String>,
    /// Tip link of the arm in a URDF file [default: as far out as a single arm leads].
    #[arg(long, value_name = "LINK")]
    pub(crate) tip: Option<String>,
    /// Print JSON instead of tables.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct SweepArguments {
    /// Name of a built-in scenario, or path of a scenario file (TOML).
    pub(crate) scenario: String,
    /// Run with the seeds 1 to N of the random walk [default: the scenario's own seed].
    #[arg(long, value_name = "N")]
    pub(crate) seeds: Option<NonZeroU64>,
    /// Threads [default: one per core].
    #[arg(long, value_name = "J")]
    pub(crate) jobs: Option<NonZeroUsize>,
    /// Replace a value of the scenario, for example trap.walk=paper or constraint.0.approach=0.1; may be repeated.
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<String>,
    /// Vary a value, for example control.bandwidth=5,10,20; repeated, every combination runs.
    #[arg(long, value_name = "KEY=V1,V2,...")]
    pub(crate) grid: Vec<String>,
    /// The method that runs [default: sliding-mode].
    #[arg(long, value_name = "NAME")]
    pub(crate) method: Option<String>,
    /// Where to write the results [default: `out/sweep-` and the scenario's name].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print summary.json instead of the table.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct TuneArguments {
    /// Name of a built-in scenario, or path of a scenario file (TOML).
    pub(crate) scenario: String,
    /// Greatest chattering: change of a desired joint speed over one sample as a share of its limit; for conditioning, change of phi
    /// over one sample in m.
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) chattering: f64,
    /// Sampling rate, Hz.
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    pub(crate) rate: f64,
    /// Method to tune for (default: the one that the scenario's verdict is about).
    #[arg(long, value_name = "NAME")]
    pub(crate) method: Option<String>,
    /// Write the scenario with the proposed values to this file.
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,
    /// Print JSON instead of words.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct StudyArguments {
    /// Name of a study (`slideway list` shows them).
    #[arg(required_unless_present = "all")]
    pub(crate) study: Option<String>,
    /// Run every study.
    #[arg(long, conflicts_with = "study")]
    pub(crate) all: bool,
    /// Where to write the results, with --all in a folder for each study [default: `out/study-` and the study's name].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Seed of the noise, in studies that have any.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: u64,
    /// Print summary.json instead of the table.
    #[arg(long)]
    pub(crate) json: bool,
}

/// How many trials a campaign has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum VerifyLevel {
    /// 100 trials: seconds.
    Quick,
    /// 1,000: half a minute.
    Smoke,
    /// 100,000: an hour, more for long scenarios.
    Nightly,
}

impl VerifyLevel {
    pub(crate) fn trials(self) -> u64 {
        match self {
            Self::Quick => 100,
            Self::Smoke => 1_000,
            Self::Nightly => 100_000,
        }
    }
}

#[derive(Debug, clap::Args)]
pub(crate) struct VerifyArguments {
    /// Name of a built-in scenario, or path of a scenario file (TOML).
    pub(crate) scenario: String,
    /// How many trials [default: the scenario's, else quick].
    #[arg(long, value_enum)]
    pub(crate) level: Option<VerifyLevel>,
    /// Trials, instead of a level.
    #[arg(long, value_name = "N", conflicts_with = "level", value_parser = clap::value_parser!(u64).range(1..=MAX_TRIALS))]
    pub(crate) trials: Option<u64>,
    /// Seed of the disturbances [default: the scenario's, else 1].
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// The method [default: the one that `compare` judges].
    #[arg(long, value_name = "NAME")]
    pub(crate) method: Option<String>,
    /// Threads [default: one per core].
    #[arg(long, value_name = "J")]
    pub(crate) jobs: Option<NonZeroUsize>,
    /// Run this share of the trials only, for example 2/5; `slideway merge` puts the shares together.
    #[arg(long, value_name = "I/N")]
    pub(crate) shard: Option<Shard>,
    /// Where to write the results [default: `out/verify-` and the scenario's name].
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print verify.json instead of the tables.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct MergeArguments {
    /// Folders that `slideway verify --shard I/N` wrote, or their trials.jsonl.
    #[arg(required = true, value_name = "SHARD")]
    pub(crate) shards: Vec<PathBuf>,
    /// Where to write the results.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// Print verify.json instead of the table.
    #[arg(long)]
    pub(crate) json: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the shell and the CI fill in, by something of its kind.
    const FILLED: [(&str, &str); 2] = [("${{ matrix.shard }}", "1"), ("\"$LEVEL\"", "nightly")];

    #[test]
    fn every_command_in_the_guide_to_ci_is_one_that_this_command_line_takes() {
        let guide = include_str!("../../../docs/ci.md");
        let blocks = guide.split("```").skip(1).step_by(2);
        let lines =
            blocks.flat_map(str::lines).map(|line| line.trim().trim_start_matches("- ").trim_start_matches("run: "));
        let commands: Vec<String> = lines
            .filter(|line| line.starts_with("slideway "))
            .map(|line| FILLED.iter().fold(line.to_owned(), |line, (blank, filling)| line.replace(blank, filling)))
            .collect();
        assert!(commands.len() >= 7, "{commands:?}");
        for command in &commands {
            assert!(!command.contains(['$', '"']), "a blank that the test does not fill: {command}");
            let parsed = Arguments::try_parse_from(command.split_whitespace());
            assert!(parsed.is_ok(), "{command}: {}", parsed.err().map_or(String::new(), |error| error.to_string()));
        }
        for subcommand in ["verify", "merge", "compare"] {
            assert!(commands.iter().any(|c| c.starts_with(&format!("slideway {subcommand} "))), "{subcommand}");
        }
    }
}
