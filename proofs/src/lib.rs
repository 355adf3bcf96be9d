//! Claims about the conditioners, natural motion and control of an arm, and the machine-checked form of each claim.
//!
//! One module a claim: its documentation states hypotheses (with units), equations and derivation; its [`Claim`] holds
//! the scripts for z3. The tests under `proofs/tests/claims`, one file a claim, check three things:
//!
//! 1. the negated inductive step has no model (`unsat`);
//! 2. with the named hypothesis dropped it has one (`sat`), and that counterexample, replayed on the shipped code, is a
//!    violation there as well. A proof whose hypotheses contradict each other would pass the first check and fail this;
//! 3. over 10 000 random cases that meet the hypotheses (2 000 where one case is a whole run, 300 where it is a motion of an arm) the
//!    shipped code keeps the claim, with a slack for rounding that is derived where it is used.
//!
//! The third check is an [`engine::Engine`]: a function from a list of numbers in [0, 1] to the case's margin. `slideway claims` runs the
//! same engines on 100 000 cases and more, `slideway attack` searches them for the smallest margin, [`kept`] writes a case down for
//! `slideway claims --replay` and for `proofs/regressions`, whose cases the tests replay, and [`ledger`] puts the regulators of
//! [`subject::Fault`] in the shipped one's place, each of which some claim has to notice.
//!
//! The scripts over the reals (`QF_NRA`) say nothing about rounding; those over doubles (`QF_FP`) are exact to the bit.
//! Notation throughout: `a = af Ts` filter step, `f` factor, `u` switch, `g = λ̇d / λ̇*(λ)` overspeed, `m = ‖F_N q̇d‖∞`
//! largest use of a limit. All of them have unit 1. On paths: `σ <= 0` a constraint, `K` (s) its approach time,
//! `φ = σ + K σ̇`, `G` the full push of a sample and `D` the drift of `φ` over it, all in the units of `σ`.
//! In the motion queue: `Q(s)` a motion over its path time `s`, `r = ṡ` the pace, `u` and `w` place and rate of a curve.
//! In natural motion: `J` Jacobian, `t*` twist of the tool at unit path speed `q̇*`, `n̄` null vector, `b` its coefficient.
//! In control: `q` (rad) joints, `M` mass matrix, `τ` torques (N·m), `e` error from actual to desired, `K`, `D` stiffness and damping.

pub mod acceleration_box;
pub mod acceleration_factor;
pub mod acceleration_recovery;
pub mod chattering_band;
mod claim;
pub mod command_within_limits;
pub mod computed_torque;
pub mod curve_end;
pub mod delayed_band;
pub mod draw;
pub mod drift_with_feedback;
pub mod drifting_band;
pub mod energy_and_power;
pub mod engine;
pub mod factor_range;
pub mod farkas;
pub mod feedback_band;
pub mod finite_through_singularity;
pub mod frozen_band;
pub mod impedance_passivity;
pub mod implicit_band;
pub mod implicit_chattering;
pub mod joint_path;
pub mod kept;
pub mod ledger;
pub mod log_path;
pub mod look_ahead_tail;
pub mod nan_brakes;
pub mod natural_speed;
pub mod natural_world;
pub mod never_slower;
pub mod null_vector;
pub mod path_band;
pub mod path_band_appendix;
pub mod path_equivalence;
pub mod path_gain;
pub mod path_implicit;
pub mod path_lag;
pub mod path_reserve;
pub mod path_world;
pub mod projection;
pub mod queue_continuity;
pub mod random_program;
pub mod refuted;
pub mod repair_feasible;
pub mod signal_band;
pub mod subject;
pub mod switching;
pub mod synchronised_advance;
pub mod time_bracket;
pub mod time_with_feedback;
pub mod transpose_descent;
pub mod weak_duality;
pub mod z3;

pub use claim::{Claim, Script, Twin, Verdict};

/// Every claim, for the ledger.
pub const CLAIMS: &[Claim] = &[
    factor_range::CLAIM,
    switching::CLAIM,
    frozen_band::CLAIM,
    drifting_band::CLAIM,
    feedback_band::CLAIM,
    drift_with_feedback::CLAIM,
    signal_band::CLAIM,
    synchronised_advance::CLAIM,
    time_bracket::CLAIM,
    time_with_feedback::CLAIM,
    chattering_band::CLAIM,
    delayed_band::CLAIM,
    nan_brakes::CLAIM,
    implicit_band::CLAIM,
    implicit_chattering::CLAIM,
    command_within_limits::CLAIM,
    path_band::CLAIM,
    path_band_appendix::CLAIM,
    path_lag::CLAIM,
    path_gain::CLAIM,
    path_equivalence::CLAIM,
    path_implicit::CLAIM,
    path_reserve::CLAIM,
    acceleration_box::CLAIM,
    acceleration_factor::CLAIM,
    acceleration_recovery::CLAIM,
    look_ahead_tail::CLAIM,
    null_vector::CLAIM,
    natural_speed::CLAIM,
    energy_and_power::CLAIM,
    finite_through_singularity::CLAIM,
    never_slower::CLAIM,
    queue_continuity::CLAIM,
    curve_end::CLAIM,
    weak_duality::CLAIM,
    repair_feasible::CLAIM,
    farkas::CLAIM,
    projection::CLAIM,
    computed_torque::CLAIM,
    impedance_passivity::CLAIM,
    transpose_descent::CLAIM,
];
