use crate::csv;
use crate::joints::JointUnits;
use crate::joints::MAX_JOINTS;
use crate::method::Method;
use slideway_conditioner::AffineSpeed;
use std::fmt::Write as _;
use std::io;

/// One run: what happened at every sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// The speed law.
    pub method: Method,
    /// Number of joints; entries of the joint arrays beyond it are zero.
    pub joints: usize,
    /// Names of the joints, from base to tip.
    pub joint_names: Vec<String>,
    /// Units of the joints.
    pub units: [JointUnits; MAX_JOINTS],
    /// Sampling period that the controller counts on, s.
    pub sampling_period: f64,
    /// When the reference reached the path's end, interpolated with the last path rate, s. Exact to one sample: what is left of the path
    /// takes the share of the last period that the whole rate needs, though the joints take the whole period.
    pub finish_s: Option<f64>,
    /// When the tool was within tolerance of the path's end, the reference being there, s.
    pub arrival_s: Option<f64>,
    /// The samples, including those after the reference's end in which the robot catches up.
    pub samples: Vec<Sample>,
}

/// One sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Time, s: the true one, whatever the controller counted on.
    pub t: f64,
    /// Path parameter `λ`.
    pub lambda: f64,
    /// Path rate `λ̇` over the sample, 1/s.
    pub path_rate: f64,
    /// Factor `f`.
    pub factor: f64,
    /// Switch `u`.
    pub switch: f64,
    /// Direction factor `fdir`.
    pub direction_factor: f64,
    /// `‖F_N q̇d‖∞`.
    pub limit_ratio: f64,
    /// The joint that uses most of its limit, counted from 0.
    pub limiting_joint: Option<usize>,
    /// Pose error `p_ref - p`, m and rad: the true one, whatever the controller saw.
    pub error: [f64; 6],
    /// Joint position, rad (m): the true one.
    pub q: [f64; MAX_JOINTS],
    /// The demand `q̇d = A + f B` as the controller saw it, rad/s (m/s); `desired` differs where the path rate was cut short.
    pub split: AffineSpeed<MAX_JOINTS>,
    /// Desired joint speed `q̇d`, rad/s (m/s).
    pub desired: [f64; MAX_JOINTS],
    /// Commanded joint speed `q̇ds`, rad/s (m/s).
    pub commanded: [f64; MAX_JOINTS],
    /// Change of the desired joint speed since the sample before; `None` where it means nothing.
    pub chatter: Option<Chatter>,
}

/// Change of the desired joint speed over one sample as a share of the speed limit, largest over the joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chatter {
    /// The value measured.
    pub measured: f64,
    /// The largest value possible, to rounding: `|B_i| |Δf| + f |ΔB_i| + |ΔA_i|` (claim `chattering-band`), with the capped factor in
    /// place of `f` where the tool's speed limit caps the path rate.
    pub bound: f64,
    /// The paper's estimate `|v_i| a λ̇d`, `[G11] eq 23`.
    pub estimate: f64,
}

impl Trace {
    /// The samples up to the reference's end (all of them if it never got there).
    #[must_use]
    pub fn following(&self) -> &[Sample] {
        // Half a microsecond covers the rounding of summed sampling periods.
        let end = self.finish_s.map_or(f64::INFINITY, |finish| finish + 5e-7);
        &self.samples[..self.samples.partition_point(|s| s.t <= end)]
    }

    /// When the path parameter first moves, s.
    #[must_use]
    pub fn motion_start(&self) -> Option<f64> {
        self.samples.iter().find(|s| s.path_rate > 0.0).map(|s| s.t)
    }

    /// Writes the trace as CSV, one row per sample: names of the joints and units in the column names, `q_elbow_rad`.
    ///
    /// # Errors
    ///
    /// Any error of the writer.
    pub fn write_csv(&self, mut out: impl io::Write) -> io::Result<()> {
        writeln!(out, "{}", self.header())?;
        let mut line = String::new();
        for sample in &self.samples {
            line.clear();
            self.row(sample, &mut line);
            writeln!(out, "{line}")?;
        }
        Ok(())
    }

    fn header(&self) -> String {
        let mut columns: Vec<String> =
            ["t_s", "lambda", "lambda_rate_per_s", "f", "u", "fdir", "limit_ratio", "limiting_joint"]
                .map(str::to_owned)
                .to_vec();
        for (kind, per) in [("q", ""), ("qd_desired", "_per_s"), ("qd_commanded", "_per_s")] {
            let joints = self.joint_names.iter().zip(&self.units).take(self.joints);
            columns.extend(joints.map(|(name, unit)| format!("{kind}_{name}_{}{per}", unit.position)));
        }
        columns.extend(["x_m", "y_m", "z_m", "alpha_rad", "beta_rad", "gamma_rad"].map(|c| format!("error_{c}")));
        columns.extend(["measured", "bound", "estimate"].map(|c| format!("chattering_{c}")));
        csv::header(&columns)
    }

    fn row(&self, s: &Sample, line: &mut String) {
        // Times are sums of sampling periods: ten digits hide their rounding and nothing else.
        let _ = write!(line, "{:.10}", s.t);
        for value in [s.lambda, s.path_rate, s.factor, s.switch, s.direction_factor, s.limit_ratio] {
            push_number(line, value);
        }
        line.push(',');
        if let Some(joint) = s.limiting_joint.and_then(|joint| self.joint_names.get(joint)) {
            line.push_str(&csv::field(joint));
        }
        let joints = [&s.q, &s.desired, &s.commanded];
        let chatter = s.chatter.map_or([f64::NAN; 3], |c| [c.measured, c.bound, c.estimate]);
        let values = joints.into_iter().flat_map(|values| &values[..self.joints]).chain(&s.error).chain(&chatter);
        values.for_each(|value| push_number(line, *value));
    }
}

/// Share of a path whose remainder is rounding: of summed steps, or of an integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EndRounding {
    /// Steps that a loop sums: 1e-12.
    SummedSteps,
    /// A flow that is integrated to a tolerance: 1e-7.
    Integration,
}

/// True of a reference that has reached the path's end: nothing but rounding `remains` of a path as long as `span`. Of every method
/// this alone decides.
pub(crate) fn has_reached_end(remains: f64, span: f64, rounding: EndRounding) -> bool {
    let share = match rounding {
        EndRounding::SummedSteps => 1e-12,
        EndRounding::Integration => 1e-7,
    };
    remains <= share * span
}

/// Appends a field of a table: nothing where the number is none.
pub(crate) fn push_number(line: &mut String, value: f64) {
    line.push(',');
    if value.is_finite() {
        let _ = write!(line, "{value}");
    }
}
