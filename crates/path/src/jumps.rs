//! Places where a function jumps, found by halving.

use nalgebra::SVector;

/// A function's value and derivative at a point.
pub(crate) struct Tangent<const D: usize> {
    pub(crate) at: f64,
    pub(crate) value: SVector<f64, D>,
    pub(crate) slope: SVector<f64, D>,
}

impl<const D: usize> Tangent<D> {
    /// By how much the change to a later point differs from the change that the derivatives tell of.
    fn surprise(&self, later: &Self) -> f64 {
        let told = (self.slope + later.slope) * (0.5 * (later.at - self.at));
        (later.value - self.value - told).norm()
    }
}

/// Halvings after which a smooth function's surprise has become a sixth or less: an eighth with derivatives or without.
const FIRST_LOOK: u32 = 3;

/// The jumps of a function between neighbouring points, by bisection: of an interval whose surprise is above `least` the half with the larger
/// surprise is taken, down to rounding; a jump is what then remains, and its place the first
/// number beyond it. `function` gives `None` where it has no value.
///
/// Two jumps between neighbouring points are seen as one, and two that cancel as none.
pub(crate) fn jumps<const D: usize>(
    points: &[Tangent<D>],
    least: f64,
    function: impl Fn(f64) -> Option<Tangent<D>>,
) -> Vec<f64> {
    let mut found = Vec::new();
    for pair in points.windows(2) {
        if pair[0].surprise(&pair[1]) > least {
            found.extend(jump(&pair[0], &pair[1], least, &function));
        }
    }
    found
}

fn jump<const D: usize>(
    a: &Tangent<D>,
    b: &Tangent<D>,
    least: f64,
    function: &impl Fn(f64) -> Option<Tangent<D>>,
) -> Option<f64> {
    let before = a.surprise(b);
    let (mut low, mut high) = ((a.at, None), (b.at, None));
    let mut surprise = before;
    for halving in 1.. {
        let middle = 0.5 * (low.0 + high.0);
        if !(low.0 < middle && middle < high.0) {
            break;
        }
        // A point without a value is passed by: the larger part of the interval has one beside it.
        let Some(m) = function(middle).or_else(|| function(low.0 + 0.4 * (high.0 - low.0))) else { break };
        let (left, right) = (low.1.as_ref().unwrap_or(a).surprise(&m), m.surprise(high.1.as_ref().unwrap_or(b)));
        surprise = left.max(right);
        if left >= right {
            high = (m.at, Some(m))
        } else {
            low = (m.at, Some(m))
        }
        if halving == FIRST_LOOK && 6.0 * surprise <= before {
            return None;
        }
    }
    (surprise > least && 4.0 * surprise >= before).then_some(high.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector1;

    fn found(f: impl Fn(f64) -> [f64; 2]) -> Vec<f64> {
        let tangent = |at: f64| {
            let [value, slope] = f(at);
            Some(Tangent { at, value: Vector1::new(value), slope: Vector1::new(slope) })
        };
        let points: Vec<_> = (0..=100).filter_map(|i| tangent(f64::from(i) / 100.0)).collect();
        jumps(&points, 1e-6, tangent)
    }

    #[test]
    fn jumps_are_found_to_rounding_and_steep_places_are_none() {
        let at = std::f64::consts::FRAC_1_PI;
        let step = found(|x| [if x < at { x } else { x + 0.01 }, 1.0]);
        assert!(step.len() == 1 && (step[0] - at).abs() < 1e-15, "{step:?}");
        // 100 times as steep as the points are dense; a root, whose derivative has no bound.
        assert_eq!(found(|x| [((x - at) * 1e4).tanh(), 1e4 / ((x - at) * 1e4).cosh().powi(2)]), []);
        assert_eq!(found(|x| [(x - at).abs().sqrt(), 0.0]), []);
        assert_eq!(found(|x| [(9.0 * x).sin(), 9.0 * (9.0 * x).cos()]), []);
    }
}
