//! The optimum as a motion of the joints by time.

use crate::speed::whole::WholeOptimum;
use slideway_baselines::time_optimal::TimeOptimum;
use slideway_lab::{Experiment, JointMotion, JointUnits, LimitUse, MAX_SAMPLES, csv};
use slideway_path::{JointPathPoint, ProblemError};
use std::fmt::Write as _;
use std::io;

/// The optimum's motion, sampled: of the whole path's profile where there is one, else of the grid's.
#[derive(Clone, Debug)]
pub struct OptimumMotion {
    /// Names of the joints, from base to tip.
    pub joint_names: Vec<String>,
    /// Units of the joints.
    pub units: Vec<JointUnits>,
    /// Samples, a period apart; the last one at the end of the motion.
    pub samples: Vec<OptimumSample>,
}

/// The optimum at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumSample {
    /// Time since the start of motion, s.
    pub t: f64,
    /// Its rate, `dλ/dt`, 1/s; 0 while the tool stands. Infinite under speed limits alone where the path asks nothing of the joints.
    pub path_rate: f64,
    /// The path parameter and the joints.
    pub joints: JointMotion,
    /// Torques, Nm (N for joints that slide); `None` without masses.
    pub torque: Option<Vec<f64>>,
    /// The limit that is used most, with its share.
    pub limit: Option<LimitUse>,
}

impl OptimumMotion {
    /// The motion at a sampling period, s.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub(crate) fn new(
        experiment: &Experiment,
        whole: Option<&WholeOptimum>,
        grid: &TimeOptimum,
        period: f64,
    ) -> Result<Self, ProblemError> {
        let samples = match whole {
            Some(whole) => {
                let profile = &whole.bracket.profile;
                let state = |t| {
                    let state = profile.at_time(t);
                    Ok((whole.path.polynomials.at(state.s), [state.s_dot, state.s_ddot]))
                };
                sampled(experiment, profile.duration_s(), period, state)?
            }
            None => {
                let motion = grid.motion();
                let state = |t| {
                    let state = motion.at_time(t);
                    Ok((experiment.path_point(state.piece, state.s)?, [state.s_dot, state.s_ddot]))
                };
                sampled(experiment, grid.upper_s, period, state)?
            }
        };
        Ok(Self { joint_names: experiment.joint_names().to_vec(), units: experiment.joint_units(), samples })
    }

    /// Writes it as CSV, one row a sample, joints by name and units in the column names.
    ///
    /// # Errors
    ///
    /// What the writer reports.
    pub fn write_csv(&self, mut out: impl io::Write) -> io::Result<()> {
        let has_torque = self.samples.iter().any(|sample| sample.torque.is_some());
        writeln!(out, "{}", self.header(has_torque))?;
        let mut line = String::new();
        for sample in &self.samples {
            line.clear();
            self.row(sample, &mut line);
            writeln!(out, "{line}")?;
        }
        Ok(())
    }

    fn header(&self, has_torque: bool) -> String {
        let mut columns = ["t_s", "lambda", "lambda_rate_per_s"].map(str::to_owned).to_vec();
        let joints = || self.joint_names.iter().zip(&self.units);
        for (quantity, per) in [("q", ""), ("qd", "_per_s"), ("qdd", "_per_s2")] {
            columns.extend(joints().map(|(name, unit)| format!("{quantity}_{name}_{}{per}", unit.position)));
        }
        if has_torque {
            let plain = |unit: &str| unit.replace('·', "");
            columns.extend(joints().map(|(name, unit)| format!("torque_{name}_{}", plain(unit.load))));
        }
        columns.extend(["limit", "limit_use"].map(str::to_owned));
        csv::header(&columns)
    }

    fn row(&self, sample: &OptimumSample, line: &mut String) {
        let JointMotion { lambda, q, speed, acceleration } = &sample.joints;
        // Times are products with the sampling period: ten digits hide their rounding and nothing else.
        let _ = write!(line, "{:.10},{lambda},{}", sample.t, sample.path_rate);
        for value in [q, speed, acceleration].into_iter().chain(&sample.torque).flatten() {
            let _ = write!(line, ",{value}");
        }
        let _ = match &sample.limit {
            Some(LimitUse { kind, joint: Some(joint), share, .. }) => {
                write!(line, ",{},{share}", csv::field(&format!("{kind} {joint}")))
            }
            Some(LimitUse { kind, share, .. }) => write!(line, ",{kind},{share}"),
            None => write!(line, ",,"),
        };
    }
}

/// Samples of a motion, from the point of the path and its parameter's rate and acceleration by time.
fn sampled(
    experiment: &Experiment,
    duration: f64,
    period: f64,
    state: impl Fn(f64) -> Result<(JointPathPoint, [f64; 2]), ProblemError>,
) -> Result<Vec<OptimumSample>, ProblemError> {
    // Of a motion with more samples than a trace may have, as many as that.
    let step = period.max(duration / MAX_SAMPLES as f64);
    let count = (duration / step).ceil() as usize;
    let sample = |i: usize| {
        let t = (step * i as f64).min(duration);
        let (point, [rate, acceleration]) = state(t)?;
        let speed = point.first.iter().map(|v| v * rate).collect();
        let bend = |(v, w): (&f64, &f64)| v * acceleration + w * rate * rate;
        let acceleration = point.first.iter().zip(&point.second).map(bend).collect();
        let joints = JointMotion { lambda: point.lambda, q: point.q, speed, acceleration };
        let instant = experiment.instant(&joints);
        let path_rate = point.lambda_rate * rate;
        Ok(OptimumSample { t, path_rate, joints, torque: instant.torque, limit: instant.limit })
    };
    (0..=count).map(sample).collect()
}
