use super::interval::Interval;
use super::limits::AccelerationLimits;
use crate::error::{ParameterError, positive};
use crate::limits::SpeedLimits;

/// Parameters of a look-ahead, validated by [`LookAhead::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LookAheadSettings<const N: usize> {
    /// Joint-speed limits, rad/s.
    pub speed_limits: SpeedLimits<N>,
    /// Joint-acceleration limits, rad/s².
    pub acceleration_limits: AccelerationLimits<N>,
    /// Sampling period `Ts`, s.
    pub sampling_period: f64,
    /// Target rate of the path parameter `λ̇d`, 1/s.
    pub target_rate: f64,
    /// Share of the acceleration limits in [0, 1) that the plan leaves to the position loop and the discretisation.
    pub margin: f64,
}

/// Joint speeds per unit of path rate on the path ahead, at equidistant nodes that *do not move with the robot*.
///
/// Nodes fixed to the path are what makes the guarantee exact: the plan of one sample is, cut at its front, a plan of the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preview<'a, const N: usize> {
    /// Distance of the current path parameter beyond the first node, not negative.
    pub offset: f64,
    /// Distance of the nodes in the path parameter.
    pub spacing: f64,
    /// `v = dq/dλ` at the nodes, rad. At the last one the robot must be able to stand: the end of what is known, or the path's.
    pub path_speeds: &'a [[f64; N]],
}

impl<const N: usize> Preview<'_, N> {
    /// Nodes that do not advance are no obstacle: they lie behind, where none is looked at.
    fn is_usable(&self) -> bool {
        self.offset >= 0.0 && self.spacing.is_finite()
    }
}

/// Steps of the bisection for a sample's rate: `2^-40` of the target rate is less than a millionth of a millionth of it.
const HALVINGS: usize = 40;

/// Part of the path between two nodes of a preview, places counted from the current path parameter.
#[derive(Clone, Copy)]
struct Stretch<'a, const N: usize> {
    near: &'a [f64; N],
    far: &'a [f64; N],
    /// Where the near node is; negative behind.
    node: f64,
    spacing: f64,
    /// The greatest `b` at the far node.
    allowed: f64,
}

impl<const N: usize> Stretch<'_, N> {
    /// Where it begins: at the near node, or at the current path parameter within.
    fn begin(&self) -> f64 {
        self.node.max(0.0)
    }

    fn end(&self) -> f64 {
        self.node + self.spacing
    }

    /// `q''`.
    fn turn(&self) -> [f64; N] {
        let mut turn = *self.far;
        for (t, near) in turn.iter_mut().zip(self.near) {
            *t = (*t - near) / self.spacing;
        }
        turn
    }
}

/// The largest path rate from which the path can be followed to a stop inside a window ahead.
///
/// With `b = λ̇²`, from rest at the last node backwards, one two-variable linear program an interval: the greatest `b` from which the
/// next node's range can be reached under speed and acceleration limits (the controllable sets of TOPP-RA, Pham and Pham 2018,
/// of a sliding window). `O(N)` memory; `O(N)` operations per interval times the steps of a Newton iteration, two or three as a rule and
/// `8N + 8` at most.
///
/// The rate `w` of a sample is held for `Ts`. Consecutive rates and the points `x_k = λ_k + Ts w_k / 2` are exact samples of a motion of
/// constant `λ̈`, for `x_{k+1} - x_k = Ts (w_k + w_{k+1}) / 2`; so the range is evaluated there: `w² <= b(λ + Ts w / 2)`.
///
/// Guaranteed (claim `look-ahead-tail`): if the path is piecewise as previewed (`v` linear between the nodes), one sample's rate keeps
/// the bound and the next sample lies between the same two nodes, then that one has a rate that keeps it, which changes the joint speeds `v(x) w` by no more than the
/// acceleration limits times `(1 - margin) Ts`. A longer window never lowers it. Where a turn ends at a node, a fast rate that is evaluated
/// beyond it may keep the bound while slower ones within the turn do not: what is offered ends before the first node that cannot be passed
/// from within, so that slower rates keep the bound too.
///
/// Not guaranteed: three terms of the discretisation, for which the margin is there. Where the plan's `λ̈` jumps within a sample, at a
/// node, the place is off the plan by up to `Ts² |Δλ̈| / 8`. The joints are commanded `v(λ_k) w_k`, not
/// `v(x_k) w_k`, which costs `|Δ(q'' b)| / 2` per sample, and between the nodes `q''` differs from its mean by up to
/// `spacing · |q'''| / 2`, which costs that times `b`. Nor is a tracking error part of the plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LookAhead<const N: usize> {
    settings: LookAheadSettings<N>,
}

impl<const N: usize> LookAhead<N> {
    /// Validates the settings once.
    ///
    /// # Errors
    ///
    /// A sampling period or target rate that is not positive and finite, a margin outside [0, 1).
    pub fn new(settings: LookAheadSettings<N>) -> Result<Self, ParameterError> {
        positive(settings.sampling_period, ParameterError::SamplingPeriod)?;
        positive(settings.target_rate, ParameterError::TargetRate)?;
        if !(settings.margin >= 0.0 && settings.margin < 1.0) {
            return Err(ParameterError::AccelerationMargin(settings.margin));
        }
        Ok(Self { settings })
    }

    /// The largest path rate for this sample, 1/s: the ceiling for [`super::AccelerationRegulator::step_below`].
    ///
    /// 0 where the preview has fewer than two nodes, lies behind, or its offset or spacing is no usable number. At a node whose
    /// path speed is not finite the robot must be able to stand.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn greatest_rate(&self, preview: &Preview<'_, N>) -> f64 {
        if !preview.is_usable() {
            return 0.0;
        }
        let (mut allowed, mut nearest) = (0.0, None);
        let nodes = preview.path_speeds;
        for (index, (near, far)) in nodes.iter().zip(nodes.iter().skip(1)).enumerate().rev() {
            let node = index as f64 * preview.spacing - preview.offset;
            let stretch = Stretch { near, far, node, spacing: preview.spacing, allowed };
            if !(stretch.end() > 0.0) {
                break;
            }
            // The nearest end that cannot be passed counts: a faster rate may be kept by a plan that begins beyond it.
            if !self.is_passed(&stretch) {
                nearest = Some(stretch);
            }
            allowed = self.range_from(&stretch, stretch.begin());
        }
        nearest.map_or(0.0, |stretch| self.held_rate(&stretch))
    }

    /// The greatest `b` at each node from which the last one can be reached at rest, into `ranges`: what [`LookAhead::greatest_rate`] works
    /// out anew in each sample, for a path that is known as a whole.
    ///
    /// `ranges` is as long as `path_speeds`; what is missing at the end of either is left out. All are 0 unless the spacing is
    /// positive.
    pub fn ranges(&self, spacing: f64, path_speeds: &[[f64; N]], ranges: &mut [f64]) {
        ranges.fill(0.0);
        if !(spacing > 0.0) {
            return;
        }
        let count = path_speeds.len().min(ranges.len());
        // Of ranges that end before the path only the part that they cover is filled, from its own end at rest.
        let (Some(nodes), Some(ranges)) = (path_speeds.get(..count), ranges.get_mut(..count)) else { return };
        let mut allowed = 0.0;
        let nearer = nodes.iter().rev().skip(1).zip(ranges.iter_mut().rev().skip(1));
        for (far, (near, range)) in nodes.iter().rev().zip(nearer) {
            allowed = self.range_from(&Stretch { near, far, node: 0.0, spacing, allowed }, 0.0);
            *range = allowed;
        }
    }

    /// [`LookAhead::greatest_rate`] with the [`LookAhead::ranges`] of the preview's nodes: the same rate, from the few stretches that one
    /// sample reaches.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn greatest_rate_within(&self, preview: &Preview<'_, N>, ranges: &[f64]) -> f64 {
        if !preview.is_usable() {
            return 0.0;
        }
        let nodes = preview.path_speeds;
        let ends = nodes.iter().zip(nodes.iter().skip(1));
        for (index, ((near, far), &allowed)) in ends.zip(ranges.iter().skip(1)).enumerate() {
            let node = index as f64 * preview.spacing - preview.offset;
            let stretch = Stretch { near, far, node, spacing: preview.spacing, allowed };
            if !(stretch.end() > 0.0) {
                continue;
            }
            if !self.is_passed(&stretch) {
                return self.held_rate(&stretch);
            }
        }
        0.0
    }

    /// The greatest `b` at a place of a stretch from which its far end's range can be reached.
    fn range_from(&self, stretch: &Stretch<'_, N>, begin: f64) -> f64 {
        self.interval(stretch, begin).greatest(&self.settings.acceleration_limits, 1.0 - self.settings.margin)
    }

    /// True if `b` at a place of a stretch is at most [`LookAhead::range_from`] there, at a third of the cost; at the stretch's end,
    /// true if the end is passed at `b` by a plan from within.
    fn is_in_range(&self, b: f64, stretch: &Stretch<'_, N>, turn: &[f64; N], begin: f64) -> bool {
        self.interval(stretch, begin).reaches(&self.settings.acceleration_limits, 1.0 - self.settings.margin, turn, b)
    }

    /// True if the rate that is evaluated at the end of a stretch is kept there, by a plan from within.
    fn is_passed(&self, stretch: &Stretch<'_, N>) -> bool {
        let rate = self.rate_evaluated_at(stretch.end());
        rate <= self.settings.target_rate && self.is_in_range(rate * rate, stretch, &stretch.turn(), stretch.end())
    }

    /// Interval from a place of a stretch to its end.
    fn interval(&self, stretch: &Stretch<'_, N>, begin: f64) -> Interval<N> {
        let near = between(stretch.near, stretch.far, (begin - stretch.node) / stretch.spacing);
        let length = stretch.end() - begin;
        Interval { near, far: *stretch.far, length, cap: self.cap(&near), allowed: stretch.allowed }
    }

    /// The rate `w` for which `λ + Ts w / 2` is a place ahead.
    fn rate_evaluated_at(&self, ahead: f64) -> f64 {
        2.0 * ahead / self.settings.sampling_period
    }

    /// The largest `w` with `w² <= b(Ts w / 2)` whose place lies in the stretch, by bisection, to the share `2^-40` of the target rate.
    ///
    /// Every rate up to that of a plan keeps the bound: `b` of the plan is linear and not negative from `λ` on, `w²` over `Ts w / 2` a
    /// parabola from zero, below the chord up to where they meet. So bisection never ends below the plan's rate.
    fn held_rate(&self, stretch: &Stretch<'_, N>) -> f64 {
        let mut kept = self.rate_evaluated_at(stretch.begin());
        let mut refused = self.rate_evaluated_at(stretch.end()).min(self.settings.target_rate);
        let turn = stretch.turn();
        if self.is_in_range(refused * refused, stretch, &turn, 0.5 * self.settings.sampling_period * refused) {
            return refused;
        }
        for _ in 0..HALVINGS {
            let rate = 0.5 * (kept + refused);
            let place = 0.5 * self.settings.sampling_period * rate;
            if self.is_in_range(rate * rate, stretch, &turn, place) { kept = rate } else { refused = rate }
        }
        kept
    }

    /// Largest `b` under the speed limits and the target rate.
    fn cap(&self, path_speed: &[f64; N]) -> f64 {
        let limits = &self.settings.speed_limits;
        let mut rate = self.settings.target_rate;
        for (&v, (&lo, &up)) in path_speed.iter().zip(limits.lower().iter().zip(limits.upper())) {
            let most = if v > 0.0 { up / v } else { lo / v };
            if v != 0.0 {
                rate = rate.min(most);
            }
        }
        rate * rate
    }
}

/// `near + share (far - near)`.
fn between<const N: usize>(near: &[f64; N], far: &[f64; N], share: f64) -> [f64; N] {
    let mut value = *near;
    for (v, f) in value.iter_mut().zip(far) {
        *v += share * (f - *v);
    }
    value
}
