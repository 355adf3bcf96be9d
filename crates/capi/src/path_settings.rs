use slideway_conditioner as core_laws;
use slideway_conditioner::path::{Margin, PathForm, Reserve, SwitchingLaw, TrapSettings, Walk};

use crate::MAX_CONSTRAINTS;
use crate::constraint::Constraint;
use crate::memory::sized;
use crate::speed::first;
use crate::status::Status;

/// Parameters of a path conditioner. Of an array the first `constraint_count` elements count.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct PathSettings {
    /// Size of this structure as the caller knows it: `sizeof(slideway_path_settings)`.
    pub size: u32,
    /// Number of coordinates of a position, from 1 to `SLIDEWAY_MAX_JOINTS`.
    pub coordinates: u32,
    /// Number of constraints, from 1 to `SLIDEWAY_MAX_CONSTRAINTS`.
    pub constraint_count: u32,
    /// One of `slideway_form`; says which of the numbers below count.
    pub form: u32,
    /// One of `slideway_push_law`.
    pub law: u32,
    /// One of `slideway_margin_kind`.
    pub margin: u32,
    /// One of `slideway_walk_kind`; without a walk the numbers from `walk_cutoff` on do not count.
    pub walk: u32,
    /// Nothing; 0.
    pub reserved: u32,
    /// `constraint_count` constraints. Copied when the conditioner is made.
    pub constraints: *const Constraint,
    /// Sampling period, s.
    pub sampling_period: f64,
    /// Cutoff frequency of the push filter, rad/s, below pi / sampling period.
    pub push_cutoff: f64,
    /// Approach time of each constraint, s: its boundary is neared with this time constant.
    pub approach: [f64; MAX_CONSTRAINTS],
    /// Margin of each constraint, in units of its value.
    pub margins: [f64; MAX_CONSTRAINTS],
    /// Switching gain or amplitude, see `slideway_push_law`.
    pub push: f64,
    /// Rate at which the allowed set is regained from outside, in units of the constraint per second.
    pub recovery_rate: f64,
    /// Share of the push that the safe walk may use, in (0, 1).
    pub push_share: f64,
    /// Cutoff frequency of the walk filter, rad/s.
    pub walk_cutoff: f64,
    /// Cutoff frequency of the filter that slows the reference, rad/s.
    pub pace_cutoff: f64,
    /// Walk speed at first, units of position per second.
    pub walk_speed: f64,
    /// Growth of the walk speed, units of position per second squared.
    pub walk_growth: f64,
    /// Gain of the walk's return, 1/s.
    pub return_gain: f64,
    /// Duration of one random direction, s.
    pub direction_period: f64,
    /// The conditioned reference is lost when farther than this from the reference.
    pub distance_threshold: f64,
    /// The reference is clearly inside when every constraint is below minus this.
    pub clearance_threshold: f64,
    /// A constraint is active for the walk when it is above minus this.
    pub activity_threshold: f64,
    /// Seed of the random directions: equal seeds walk equally.
    pub seed: u64,
}

sized!(PathSettings);

impl PathSettings {
    pub(crate) fn core<const M: usize>(&self) -> Result<core_laws::path::PathSettings<M>, Status> {
        Ok(core_laws::path::PathSettings {
            sampling_period: self.sampling_period,
            push_cutoff: self.push_cutoff,
            approach: first(&self.approach),
            margin: match self.margin {
                0 => Margin::None,
                1 => Margin::Band,
                2 => Margin::Fixed(first(&self.margins)),
                _ => return Err(Status::Choice),
            },
            form: self.core_form()?,
            trap: self.trap()?,
        })
    }

    fn core_form(&self) -> Result<PathForm, Status> {
        let law = match self.law {
            0 => SwitchingLaw::Sum { gain: self.push },
            1 => SwitchingLaw::Normalised { amplitude: self.push },
            _ => return Err(Status::Choice),
        };
        let recovery_rate = self.recovery_rate;
        match self.form {
            0 => Ok(PathForm::Implicit { recovery_rate }),
            1 => Ok(PathForm::Sliding { law, reserve: Reserve::Off }),
            2 => Ok(PathForm::Sliding { law, reserve: Reserve::On { recovery_rate } }),
            3 => Ok(PathForm::Appendix { law }),
            _ => Err(Status::Choice),
        }
    }

    fn trap(&self) -> Result<Option<TrapSettings>, Status> {
        let walk = match self.walk {
            0 => return Ok(None),
            1 => Walk::Paper,
            2 => Walk::Safe { push_share: self.push_share },
            _ => return Err(Status::Choice),
        };
        Ok(Some(TrapSettings {
            walk_cutoff: self.walk_cutoff,
            pace_cutoff: self.pace_cutoff,
            walk,
            walk_speed: self.walk_speed,
            walk_growth: self.walk_growth,
            return_gain: self.return_gain,
            direction_period: self.direction_period,
            distance_threshold: self.distance_threshold,
            clearance_threshold: self.clearance_threshold,
            activity_threshold: self.activity_threshold,
            seed: self.seed,
        }))
    }
}
