use crate::speed::entries::{ExcessEntry, MethodEntry, OptimumEntry};
use crate::speed::laws::{ModelErrorEntry, ScaledLimits};
use crate::speed::verdict::SpeedVerdict;
use crate::speed::windows::WindowEntry;
use serde::Serialize;
use slideway_lab::{Disturbances, Effort, Method};
use slideway_robot::RobotSummary;

/// A comparison of speed laws in numbers and words. Times in s, lengths in m, angles in rad.
#[derive(Clone, Debug, Serialize)]
pub struct SpeedSummary {
    /// Name of the scenario.
    pub scenario: String,
    /// Its description.
    pub description: String,
    /// The robot as its file or table describes it; null where the caller gave none.
    pub robot: Option<RobotSummary>,
    /// One entry per method.
    pub methods: Vec<MethodEntry>,
    /// The optimum under all limits the scenario gives.
    pub optimum: OptimumEntry,
    /// The optimum under the speed limits alone, where the scenario limits accelerations too.
    pub optimum_speed_only: Option<OptimumEntry>,
    /// What the optimum costs the drives.
    pub optimum_effort: Option<Effort>,
    /// Mean speeds under other joint-speed limits; empty unless the scenario has a `[natural]` table.
    pub scaled_limits: Vec<ScaledLimits>,
    /// What a controller with wrong masses does to each law; empty unless the scenario has a `[natural]` table and the robot masses.
    pub model_error: Vec<ModelErrorEntry>,
    /// Proven bound on the largest use of a speed limit on the path without tracking error; null where its hypotheses fail.
    pub limit_ratio_bound: Option<f64>,
    /// Joints beyond the tool coordinates of the path, moved as little as the path allows (pseudo-inverse).
    pub spare_joints: usize,
    /// Joints that leave their position ranges along the path.
    pub position_excesses: Vec<ExcessEntry>,
    /// What disturbed the methods' runs; null where nothing did. The optimum is that of the undisturbed problem.
    pub disturbances: Option<Disturbances>,
    /// Methods that the limits call for and that cannot be run on this problem, with the reason; null where there are none.
    pub left_out: Option<LeftOut>,
    /// The look-ahead with windows of several lengths; empty without acceleration limits.
    pub look_ahead: Vec<WindowEntry>,
    /// The verdict.
    pub verdict: SpeedVerdict,
}

/// Methods that were not run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LeftOut {
    /// The methods.
    pub methods: Vec<Method>,
    /// What they need.
    pub reason: &'static str,
}

impl SpeedSummary {
    /// Remarks on the joint path and the runs, in words.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let spare = (self.spare_joints > 0).then(|| {
            format!(
                "{} more than the path prescribes: of all joint motions the smallest is taken (pseudo-inverse), by every method and \
                 by the joint path of the optimum",
                if self.spare_joints == 1 { "one joint".into() } else { format!("{} joints", self.spare_joints) }
            )
        });
        let outside =
            |excess: &ExcessEntry| format!("{}; ranges of joints are reported, not enforced", excess.in_words());
        let disturbed = self.disturbances.as_ref().map(|d| format!("the runs are disturbed: {d}; the optimum is not"));
        let left_out = self.left_out.as_ref().map(|left| {
            let names: Vec<&str> = left.methods.iter().map(|method| method.name()).collect();
            format!("{} left out: {}", names.join(" and "), left.reason)
        });
        let excesses = self.position_excesses.iter().map(outside);
        spare.into_iter().chain(excesses).chain(disturbed).chain(left_out).collect()
    }
}
