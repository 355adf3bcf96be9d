use crate::problem::Problem;
use slideway_conditioner::acceleration::Preview;
use slideway_robot::{EulerAngles, JointVector};

/// Newton steps per node at most. From a neighbouring node two or three end at rounding.
const NEWTON_STEPS: usize = 8;

/// Joint change of a Newton step below which a node counts as found, rad.
const FOUND: f64 = 1e-12;

/// The path ahead as the controller's own kinematics predict it: joint speeds per unit of path rate at nodes fixed to the path.
///
/// Node after node: half a step and a whole step along `q' = Inv(J) f'` (the midpoint rule), then Newton's method with the position loop
/// itself, `q <- q + feedback / Kp`, until the prediction lies on the path. A node is computed once, when it comes into the
/// window. Where the inverse is damped or singular the prediction stays as near as it gets; the regulator then reports what it
/// cannot keep.
#[derive(Clone, Debug)]
pub(crate) struct PathWindow<const N: usize> {
    /// Nodes from the path's start as far as they have been needed.
    path_speeds: Vec<[f64; N]>,
    /// Intervals of the whole path, and of the window.
    intervals: usize,
    seen: usize,
    spacing: f64,
    /// Configuration and Euler triple at the last node.
    q: JointVector<N>,
    euler: EulerAngles,
}

impl<const N: usize> PathWindow<N> {
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(crate) fn new(problem: &Problem<N>) -> Self {
        let options = &problem.control.look_ahead;
        let length = problem.path.end() - problem.path.begin();
        let distance = options.distance.unwrap_or(0.25 * length).min(length);
        let intervals = (length / distance * options.nodes as f64).ceil().max(1.0);
        let mut window = Self {
            path_speeds: Vec::new(),
            intervals: intervals as usize,
            seen: (distance / length * intervals).ceil() as usize,
            spacing: length / intervals,
            q: problem.path.start,
            euler: problem.start_euler,
        };
        let first = window.found(problem, 0);
        window.path_speeds.push(first);
        window
    }

    /// The window from a path parameter on.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(crate) fn preview(&mut self, problem: &Problem<N>, lambda: f64) -> Preview<'_, N> {
        let ahead = (lambda - problem.path.begin()).max(0.0);
        let behind = ((ahead / self.spacing) as usize).min(self.intervals);
        // One more than the window holds, for the robot stands between two nodes: it never sees less.
        let last = (behind + self.seen + 1).min(self.intervals);
        while self.path_speeds.len() <= last {
            let node = self.node(problem);
            self.path_speeds.push(node);
        }
        let offset = (ahead - behind as f64 * self.spacing).max(0.0);
        Preview { offset, spacing: self.spacing, path_speeds: &self.path_speeds[behind..=last] }
    }

    /// The path speed at the next node.
    #[allow(clippy::cast_precision_loss)]
    fn node(&mut self, problem: &Problem<N>) -> [f64; N] {
        let before = self.path_speeds.len() - 1;
        let lambda = problem.path.begin() + before as f64 * self.spacing;
        let half = 0.5 * self.spacing;
        let speed = problem.demand(&self.q, &self.euler, lambda).path_speed;
        let middle = problem.demand(&(self.q + speed * half), &self.euler, lambda + half).path_speed;
        self.q += middle * self.spacing;
        self.found(problem, before + 1)
    }

    /// Brings the prediction onto the path at a node.
    #[allow(clippy::cast_precision_loss)]
    fn found(&mut self, problem: &Problem<N>, node: usize) -> [f64; N] {
        let lambda = problem.path.begin() + node as f64 * self.spacing;
        for _ in 0..NEWTON_STEPS {
            let demand = problem.demand(&self.q, &self.euler, lambda);
            let step = demand.feedback / problem.control.gain;
            self.euler = demand.euler;
            if !(step.amax() > FOUND) {
                break;
            }
            self.q += step;
        }
        problem.demand(&self.q, &self.euler, lambda).path_speed.into()
    }
}
