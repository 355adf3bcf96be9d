use crate::engine::Engine;

/// Verdict on the source's own statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as it stands.
    Holds,
    /// It holds once a hypothesis or a term is added.
    HoldsWithCorrection,
    /// It does not hold, and nothing close to it does.
    Refuted,
    /// The source makes no such statement; this project does.
    Ours,
}

/// A script in SMT-LIB 2, and where it is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Script {
    /// File name under `proofs/smt`.
    pub file: &'static str,
    /// The text handed to the solver.
    pub text: &'static str,
}

/// The claim with one hypothesis dropped. Its script has a model: the counterexample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Twin {
    /// The hypothesis that was dropped.
    pub without: &'static str,
    /// The script, expected to be satisfiable.
    pub script: Script,
}

/// One claim, as the ledger shows it.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// Name by which code and documentation refer to it.
    pub name: &'static str,
    /// Statement of the claim, in one or two sentences.
    pub statement: &'static str,
    /// Where the statement, or the one it corrects, comes from.
    pub source: &'static str,
    /// Verdict on the source's statement.
    pub verdict: Verdict,
    /// Negations of the claim, each expected to be unsatisfiable.
    pub negations: &'static [Script],
    /// The claim with one hypothesis dropped, and counterexamples to it.
    pub twins: &'static [Twin],
    /// Property tests of the shipped code.
    pub engines: &'static [Engine],
}
