//! A naive twin of the push filter, random constraints and random references, shared by the claims about paths.

use proptest::prelude::{BoxedStrategy, ProptestConfig, Strategy};
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathSettings, Reserve, SwitchingLaw,
};
use slideway_conditioner::shapes::{Ball, HalfSpace, Side};

/// Sampling period, s, push filter cutoff, rad/s, and approach time, s, of the claims about paths.
pub(crate) const PERIOD: f64 = 1.0 / 1024.0;
pub(crate) const CUTOFF: f64 = 20.0;
pub(crate) const APPROACH: f64 = 0.1;

/// How fast a constraint is regained from outside, m/s.
pub(crate) const RECOVERY: f64 = 0.5;

/// Where one case is a whole run.
pub(crate) fn runs() -> ProptestConfig {
    ProptestConfig { cases: 2_000, ..crate::support::config() }
}

pub(crate) fn settings<const M: usize>(form: PathForm) -> PathSettings<M> {
    PathSettings {
        sampling_period: PERIOD,
        push_cutoff: CUTOFF,
        approach: [APPROACH; M],
        margin: Margin::None,
        form,
        trap: None,
    }
}

pub(crate) fn explicit(amplitude: f64) -> PathForm {
    PathForm::Sliding { law: SwitchingLaw::Normalised { amplitude }, reserve: Reserve::Off }
}

pub(crate) fn implicit() -> PathForm {
    PathForm::Implicit { recovery_rate: RECOVERY }
}

pub(crate) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub(crate) fn norm<const N: usize>(a: &[f64; N]) -> f64 {
    dot(a, a).sqrt()
}

/// The push filter of `[G12] eq 5` under zero-order hold, written apart from the conditioner: `x = e^(-s t) (A cos s t +
/// B sin s t) + u` with `s = α / √2`, `A = x0 - u`, `B = (ẋ0 + s A) / s`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Held {
    pub(crate) place: f64,
    pub(crate) rate: f64,
}

impl Held {
    pub(crate) const REST: Self = Self { place: 0.0, rate: 0.0 };

    /// After one sampling period under the push `u`.
    pub(crate) fn after(self, push: f64) -> Self {
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
pub(crate) fn per_push() -> f64 {
    let moved = Held::REST.after(1.0);
    moved.place + APPROACH * moved.rate
}

/// A reference that swings in every coordinate: `p_i = A sin(w_i t + ψ_i)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Swing {
    pub(crate) amplitude: f64,
    pub(crate) frequency: [f64; 3],
    pub(crate) phase: [f64; 3],
}

impl Swing {
    pub(crate) fn at(&self, sample: u32) -> Motion<3> {
        let time = PERIOD * f64::from(sample);
        let angle: [f64; 3] = std::array::from_fn(|i| self.frequency[i] * time + self.phase[i]);
        Motion {
            time,
            position: angle.map(|angle| self.amplitude * angle.sin()),
            velocity: std::array::from_fn(|i| self.amplitude * self.frequency[i] * angle[i].cos()),
        }
    }

    /// Bound on the length of the derivative of this order.
    pub(crate) fn derivative(&self, order: i32) -> f64 {
        self.amplitude * norm(&self.frequency.map(|w| w.powi(order)))
    }
}

pub(crate) fn swing() -> impl Strategy<Value = Swing> {
    (0.1..0.5, triple(1.0..8.0), triple(0.0..6.3)).prop_map(|(amplitude, frequency, phase)| Swing {
        amplitude,
        frequency,
        phase,
    })
}

pub(crate) fn triple(range: std::ops::Range<f64>) -> BoxedStrategy<[f64; 3]> {
    crate::support::joints(range)
}

/// A direction that is not shorter than a tenth before it is brought to unit length.
pub(crate) fn direction() -> impl Strategy<Value = [f64; 3]> + Clone {
    triple(-1.0..1.0).boxed().prop_filter_map("a direction has a length", |x| {
        let length = norm(&x);
        (length > 0.1).then(|| x.map(|x| x / length))
    })
}

/// A random wall or ball of which a given motion is an admissible start.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Body {
    Wall(HalfSpace<3>),
    /// With its radius, and 1 from outside, -1 from inside.
    Ball(Ball<3>, f64, f64),
}

impl Body {
    pub(crate) fn sample(&self, motion: &Motion<3>) -> ConstraintSample<3> {
        match self {
            Self::Wall(wall) => wall.sample(motion),
            Self::Ball(ball, ..) => ball.sample(motion),
        }
    }

    /// Radius of the level set through a point with this `σ`, m: the gradient turns by one radian over that length.
    pub(crate) fn radius(&self, sigma: f64) -> f64 {
        match self {
            Self::Wall(_) => f64::INFINITY,
            Self::Ball(_, radius, side) => radius - side * sigma,
        }
    }
}

/// What a body is built from, before the start is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sketch {
    pub(crate) kind: u8,
    pub(crate) normal: [f64; 3],
    pub(crate) room: f64,
    pub(crate) radius: f64,
}

impl Sketch {
    /// A body whose nearest point lies along `normal` and at which the start has `φ <= -room`, if there is such a body.
    pub(crate) fn around(&self, start: &Motion<3>) -> Option<Body> {
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

/// Kinds below `kinds`: 0 walls, 1 balls from outside, 2 balls from inside.
pub(crate) fn sketch(kinds: u8) -> impl Strategy<Value = Sketch> + Clone {
    (0..kinds, direction(), 0.0..0.2, 0.1..0.5).prop_map(|(kind, normal, room, radius)| Sketch {
        kind,
        normal,
        room,
        radius,
    })
}

/// Suprema of the speed, acceleration and jerk of a conditioned reference, collected sample by sample.
///
/// Between samples the filter obeys `f̈ = -√2 α ḟ - α² f + α² u` and `f⃛ = -√2 α f̈ - α² ḟ`; `f` and `ḟ` differ from their
/// values at the samples by a share of at most `2 α T = 0.04` of the sums bounded here, for which a tenth is added.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Suprema {
    speed: f64,
    acceleration: f64,
    jerk: f64,
}

impl Suprema {
    pub(crate) fn see(&mut self, swing: &Swing, correction: &[f64; 3], rate: &[f64; 3], push: &[f64; 3]) {
        let (f, r, u) = (norm(correction), norm(rate), norm(push));
        let pull = CUTOFF * CUTOFF * (f + u) + std::f64::consts::SQRT_2 * CUTOFF * r;
        let jerk = CUTOFF * CUTOFF * r + std::f64::consts::SQRT_2 * CUTOFF * pull;
        self.speed = self.speed.max(1.1 * r + swing.derivative(1));
        self.acceleration = self.acceleration.max(1.1 * pull + swing.derivative(2));
        self.jerk = self.jerk.max(1.1 * jerk + swing.derivative(3));
    }

    /// `T² sup |φ̈| / 8` for a boundary of curvature at most `h`: `φ = σ + K ∇σᵀv`, with `‖∇²σ‖ <= h`, `‖∇³σ‖ <= 3 h²`.
    pub(crate) fn bulge(&self, h: f64) -> f64 {
        let (v, a, j) = (self.speed, self.acceleration, self.jerk);
        let second = a + h * v * v + APPROACH * (j + 3.0 * h * v * a + 3.0 * h * h * v * v * v);
        slideway_conditioner::path::bounds::between_samples(PERIOD, second)
    }
}
