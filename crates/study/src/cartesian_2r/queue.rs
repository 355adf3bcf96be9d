use nalgebra::Vector2;
use std::collections::VecDeque;

/// Two links in a plane, m; the elbow's angle stays positive.
pub(super) const LINKS: [f64; 2] = [0.5, 0.4];
/// Range of the shoulder, rad: its stops.
pub(super) const SHOULDER: [f64; 2] = [-1.8, 1.8];
/// Range of the elbow, rad: 0.3 from the stretched singularity, and its stop before the folded one.
pub(super) const ELBOW: [f64; 2] = [0.3, 2.6];
/// Deceleration on the path, m/s².
pub(super) const DECELERATION: f64 = 2.0;
/// Steps in which a line is looked along, m.
const LOOK: f64 = 1e-3;

/// A velocity (m/s) for a time (s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Command {
    pub(super) velocity: [f64; 2],
    pub(super) duration: f64,
}

/// The joints at a place; `None` if it is out of reach.
pub(super) fn joints_at(place: &Vector2<f64>) -> Option<Vector2<f64>> {
    let [a, b] = LINKS;
    let cosine = (place.norm_squared() - a * a - b * b) / (2.0 * a * b);
    if !(cosine.abs() <= 1.0) {
        return None;
    }
    let elbow = cosine.acos();
    let shoulder = place.y.atan2(place.x) - (b * elbow.sin()).atan2(a + b * elbow.cos());
    Some(Vector2::new(shoulder, elbow))
}

/// True if the tool can be at a place with both joints in their ranges.
pub(super) fn is_allowed(place: &Vector2<f64>) -> bool {
    joints_at(place).is_some_and(|q| q[0] >= SHOULDER[0] && q[0] <= SHOULDER[1] && q[1] >= ELBOW[0] && q[1] <= ELBOW[1])
}

/// A queue of velocities: the tool's path is piecewise straight, and ends before what is not allowed.
///
/// Each sample looks along the command's line as far as it would brake. The speed is at most what can be shed before the first
/// place that is not allowed,
///
/// ```text
/// v T + v² / (2 a) <= x          v <= -a T + sqrt((a T)² + 2 a x)
/// ```
///
/// Where the tool has been stopped the rest of the command passes by; the next one
/// is followed if it leads away.
pub(super) struct VelocityQueue {
    commands: VecDeque<Command>,
    place: Vector2<f64>,
    /// Into the present command, s.
    clock: f64,
}

impl VelocityQueue {
    pub(super) fn new(place: Vector2<f64>, commands: &[Command]) -> Self {
        Self { commands: commands.iter().copied().collect(), place, clock: 0.0 }
    }

    /// The tool's place after a sample, and its velocity in it; `None` when nothing is left.
    pub(super) fn advance(&mut self, dt: f64) -> Option<[Vector2<f64>; 2]> {
        let command = *self.commands.front()?;
        let wanted = Vector2::from(command.velocity);
        let speed = wanted.norm();
        let velocity =
            if speed > 0.0 { wanted * (self.admissible(&(wanted / speed), speed, dt) / speed) } else { wanted };
        self.place += velocity * dt;
        self.clock += dt;
        if self.clock >= command.duration - 0.5 * dt {
            self.commands.pop_front();
            self.clock = 0.0;
        }
        Some([self.place, velocity])
    }

    fn admissible(&self, direction: &Vector2<f64>, speed: f64, dt: f64) -> f64 {
        let (a, change) = (DECELERATION, DECELERATION * dt);
        let far = speed * speed / (2.0 * a) + 2.0 * speed * dt;
        let free = self.free(direction, far);
        speed.min((change * change + 2.0 * a * free).sqrt() - change)
    }

    /// Length of the line from the tool's place on which it is allowed to be, m; at most `far`.
    fn free(&self, direction: &Vector2<f64>, far: f64) -> f64 {
        let is_allowed_at = |x: f64| is_allowed(&(self.place + direction * x));
        let steps = (far / LOOK).ceil().max(1.0) as u32;
        let places = (1..=steps).map(|k| far * f64::from(k) / f64::from(steps));
        let mut below = 0.0;
        for x in places {
            if !is_allowed_at(x) {
                let mut above = x;
                for _ in 0..40 {
                    let middle = 0.5 * (below + above);
                    *(if is_allowed_at(middle) { &mut below } else { &mut above }) = middle;
                }
                return below;
            }
            below = x;
        }
        far
    }
}
