//! One module a claim: the negation has no model, a dropped hypothesis has one that the shipped code shares, and the
//! shipped code keeps the claim over random inputs.

mod acceleration_box;
mod acceleration_factor;
mod acceleration_recovery;
mod chattering_band;
mod command_within_limits;
mod curve_end;
mod delayed_band;
mod drifting_band;
mod energy_and_power;
mod factor_range;
mod finite_through_singularity;
mod frozen_band;
mod implicit_band;
mod ledger;
mod look_ahead_tail;
mod nan_brakes;
mod natural_speed;
mod natural_support;
mod never_slower;
mod null_vector;
mod path_band;
mod path_band_appendix;
mod path_equivalence;
mod path_gain;
mod path_implicit;
mod path_lag;
mod path_reserve;
mod path_support;
mod queue_continuity;
mod support;
mod switching;
