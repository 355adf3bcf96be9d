//! A naive twin of the push filter, random constraints and random references, shared by the claims about paths.

use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathSettings, Reserve, SwitchingLaw,
};
use slideway_conditioner::shapes::{Ball, HalfSpace, Side};

use crate::engine::Choices;

/// Sampling period of the claims about paths, s.
pub const PERIOD: f64 = 1.0 / 1024.0;

/// Cutoff of the push filter, rad/s.
pub const CUTOFF: f64 = 20.0;

/// Approach time, s.
pub const APPROACH: f64 = 0.1;

/// Rate at which a constraint is regained from outside, m/s.
pub const RECOVERY: f64 = 0.5;

/// Settings in which only the form varies.
pub fn settings<const M: usize>(form: PathForm) -> PathSettings<M> {
    PathSettings {
        sampling_period: PERIOD,
        push_cutoff: CUTOFF,
        approach: [APPROACH; M],
        margin: Margin::None,
        form,
        trap: None,
    }
}

/// The explicit form with a push of this length.
pub fn explicit(amplitude: f64) -> PathForm {
    PathForm::Sliding { law: SwitchingLaw::Normalised { amplitude }, reserve: Reserve::Off }
}

/// The implicit form.
pub fn implicit() -> PathForm {
    PathForm::Implicit { recovery_rate: RECOVERY }
}

/// Scalar product.
pub fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Length.
pub fn norm<const N: usize>(a: &[f64; N]) -> f64 {
    dot(a, a).sqrt()
}

/// The push filter of `[G12] eq 5` under zero-order hold, written apart from the conditioner: `x = e^(-s t) (A cos s t +
/// B sin s t) + u` with `s = α / √2`, `A = x0 - u`, `B = (ẋ0 + s A) / s`.
#[derive(Clone, Copy, Debug)]
pub struct Held {
    /// Its output, m.
    pub place: f64,
    /// The output's rate, m/s.
    pub rate: f64,
}

impl Held {
    /// At rest.
    pub const REST: Self = Self { place: 0.0, rate: 0.0 };

    /// After one sampling period under the push `u`.
    pub fn after(self, push: f64) -> Self {
        let s = CUTOFF / std::f64::consts::SQRT_2;
        let (sine, cosine) = (s * PERIOD).sin_cos();
        let decay = (-s * PERIOD).exp();
        let first = self.place - push;
        let second = (self.rate + s * first) / s;
        Self {
            place: push + decay * (first * cosine + second * sine),
            rate: s * decay * ((second - first) * cosine - (first + second) * sine),
        }
    }
}

/// `γ1 + K γ2`: how far a unit push along a unit gradient takes `φ` in one sample.
pub fn per_push() -> f64 {
    let moved = Held::REST.after(1.0);
    moved.place + APPROACH * moved.rate
}

/// A reference that swings in every coordinate: `p_i = A sin(w_i t + ψ_i)`.
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    /// `A`, m.
    pub amplitude: f64,
    /// `w`, rad/s.
    pub frequency: [f64; 3],
    /// `ψ`, rad.
    pub phase: [f64; 3],
}

impl Swing {
    /// A random one, up to half a metre and 8 rad/s.
    pub fn draw(choices: &mut Choices) -> Self {
        Self {
            amplitude: choices.between(0.1, 0.5),
            frequency: choices.numbers(1.0, 8.0),
            phase: choices.numbers(0.0, 6.3),
        }
    }

    /// The motion at a sample.
    #[must_use]
    pub fn at(&self, sample: u32) -> Motion<3> {
        let time = PERIOD * f64::from(sample);
        let angle: [f64; 3] = std::array::from_fn(|i| self.frequency[i] * time + self.phase[i]);
        Motion {
            time,
            position: angle.map(|angle| self.amplitude * angle.sin()),
            velocity: std::array::from_fn(|i| self.amplitude * self.frequency[i] * angle[i].cos()),
        }
    }

    /// The motions at the samples, one after another: each angle is turned on, which costs a tenth of asking for its sine anew and is
    /// off by some 1e-16 a sample.
    pub fn samples(self) -> impl Iterator<Item = Motion<3>> {
        let turns = self.frequency.map(|w| (w * PERIOD).sin_cos());
        let start = self.phase.map(f64::sin_cos);
        let angles = std::iter::successors(Some(start), move |angles| {
            Some(std::array::from_fn(|i| {
                let ((sine, cosine), (s, c)) = (angles[i], turns[i]);
                (sine * c + cosine * s, cosine * c - sine * s)
            }))
        });
        angles.zip(0_u32..).map(move |(angles, sample)| Motion {
            time: PERIOD * f64::from(sample),
            position: angles.map(|(sine, _)| self.amplitude * sine),
            velocity: std::array::from_fn(|i| self.amplitude * self.frequency[i] * angles[i].1),
        })
    }

    /// Bound on the length of the derivative of this order.
    pub fn derivative(&self, order: i32) -> f64 {
        self.amplitude * norm(&self.frequency.map(|w| w.powi(order)))
    }
}

/// A random wall or ball of which a given motion is an admissible start.
#[derive(Clone, Copy, Debug)]
pub enum Body {
    /// A half-space.
    Wall(HalfSpace<3>),
    /// With its radius, and 1 from outside, -1 from inside.
    Ball(Ball<3>, f64, f64),
}

impl Body {
    /// The constraint at a motion.
    #[must_use]
    pub fn sample(&self, motion: &Motion<3>) -> ConstraintSample<3> {
        match self {
            Self::Wall(wall) => wall.sample(motion),
            Self::Ball(ball, ..) => ball.sample(motion),
        }
    }

    /// Radius of the level set through a point with this `σ`, m: the gradient turns by one radian over that length.
    pub fn radius(&self, sigma: f64) -> f64 {
        match self {
            Self::Wall(_) => f64::INFINITY,
            Self::Ball(_, radius, side) => radius - side * sigma,
        }
    }
}

/// Numbers from which a body is built once the start is known.
#[derive(Clone, Copy, Debug)]
pub struct Sketch {
    /// 0 wall, 1 ball from outside, 2 ball from inside.
    pub kind: u8,
    /// Towards the nearest point, unit length.
    pub normal: [f64; 3],
    /// `-φ` at the start at the least, m.
    pub room: f64,
    /// Of the ball, m.
    pub radius: f64,
}

impl Sketch {
    /// A random one of a kind below `kinds`: 0 walls, 1 balls from outside, 2 balls from inside.
    pub fn draw(choices: &mut Choices, kinds: usize) -> Self {
        let kind = choices.pick([0, 1, 2].map(|kind: usize| kind % kinds.max(1)));
        Self {
            kind: u8::try_from(kind).unwrap_or(0),
            normal: direction(choices),
            room: choices.between(0.0, 0.2),
            radius: choices.between(0.1, 0.5),
        }
    }

    /// A body whose nearest point lies along `normal` and at which the start has `φ <= -room`, if there is such a body.
    pub fn around(&self, start: &Motion<3>) -> Option<Body> {
        let speed = norm(&start.velocity);
        let reach = self.room + APPROACH * speed;
        let centre = |along: f64| std::array::from_fn(|i| start.position[i] + along * self.normal[i]);
        let body = match self.kind {
            0 => {
                let offset = dot(&self.normal, &start.position) + reach;
                Body::Wall(HalfSpace::new(&self.normal, offset).ok()?)
            }
            1 => Body::Ball(Ball::new(centre(reach + self.radius), self.radius, Side::Outside).ok()?, self.radius, 1.0),
            _ => {
                let radius = reach + self.radius;
                Body::Ball(Ball::new(centre(-self.radius), radius, Side::Inside).ok()?, radius, -1.0)
            }
        };
        (body.sample(start).phi(APPROACH, &start.velocity) <= 0.0).then_some(body)
    }
}

/// Suprema of the speed, acceleration and jerk of a conditioned reference, collected sample by sample.
///
/// Between samples the filter obeys `f̈ = -√2 α ḟ - α² f + α² u` and `f⃛ = -√2 α f̈ - α² ḟ`; `f` and `ḟ` differ from their
/// values at the samples by a share of at most `2 α T = 0.04` of the sums bounded here, for which a tenth is added.
#[derive(Clone, Copy, Debug, Default)]
pub struct Suprema {
    speed: f64,
    acceleration: f64,
    jerk: f64,
}

impl Suprema {
    /// Takes a sample in.
    pub fn see(&mut self, swing: &Swing, correction: &[f64; 3], rate: &[f64; 3], push: &[f64; 3]) {
        let (f, r, u) = (norm(correction), norm(rate), norm(push));
        let pull = CUTOFF * CUTOFF * (f + u) + std::f64::consts::SQRT_2 * CUTOFF * r;
        let jerk = CUTOFF * CUTOFF * r + std::f64::consts::SQRT_2 * CUTOFF * pull;
        self.speed = self.speed.max(1.1 * r + swing.derivative(1));
        self.acceleration = self.acceleration.max(1.1 * pull + swing.derivative(2));
        self.jerk = self.jerk.max(1.1 * jerk + swing.derivative(3));
    }

    /// `T² sup |φ̈| / 8` for a boundary of curvature at most `h`: `φ = σ + K ∇σᵀv`, with `‖∇²σ‖ <= h`, `‖∇³σ‖ <= 3 h²`.
    pub fn bulge(&self, h: f64) -> f64 {
        let (v, a, j) = (self.speed, self.acceleration, self.jerk);
        let second = a + h * v * v + APPROACH * (j + 3.0 * h * v * a + 3.0 * h * h * v * v * v);
        slideway_conditioner::path::bounds::between_samples(PERIOD, second)
    }
}

/// A random direction of unit length: uniform in height and angle.
pub fn direction(choices: &mut Choices) -> [f64; 3] {
    let (height, angle) = (choices.between(-1.0, 1.0), choices.between(0.0, std::f64::consts::TAU));
    let across = (1.0 - height * height).max(0.0).sqrt();
    [across * angle.cos(), across * angle.sin(), height]
}
