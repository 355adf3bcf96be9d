//! One file per claim: its statement and derivation, the form that z3 discharges (in `smt/`), and a property test that
//! runs the code the claim is about.
//!
//! Every SMT file ends in `unsat`: no counterexample. Each has a twin with one hypothesis dropped that ends in `sat`, so
//! that a proof of nothing would be noticed.

pub mod path_band;
pub mod path_band_appendix;
pub mod path_equivalence;
pub mod path_gain;
pub mod path_implicit;
pub mod path_lag;

#[cfg(test)]
mod smt;
