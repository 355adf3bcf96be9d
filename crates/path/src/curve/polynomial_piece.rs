use nalgebra::SVector;
use std::ops::Range;

/// One polynomial piece of a curve: `p(λ) = Σ_m powers[m] (λ - start)^m` from `start` to `end`.
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialPiece<const D: usize> {
    /// Path parameter at the begin.
    pub start: f64,
    /// Path parameter at the end, above `start`.
    pub end: f64,
    /// Coefficients by rising powers of the distance from `start`, in the curve's unit per power of the parameter.
    pub powers: Vec<SVector<f64, D>>,
}

/// Pieces shorter than this share of the range are rounding of where a blend ends, and go to their neighbour.
const SHORTEST: f64 = 1e-12;

impl<const D: usize> PolynomialPiece<D> {
    /// The pieces within a range, those at its ends cut there.
    pub(super) fn within(pieces: Vec<Self>, range: &Range<f64>) -> Vec<Self> {
        let shortest = SHORTEST * (range.end - range.start);
        let mut cut: Vec<Self> = Vec::new();
        for piece in pieces {
            let (start, end) = (piece.start.max(range.start), piece.end.min(range.end));
            if end - start > shortest {
                cut.push(Self { start, end, powers: moved(piece.powers, start - piece.start) });
            }
        }
        for i in 1..cut.len() {
            cut[i - 1].end = cut[i].start;
        }
        cut
    }
}

/// Powers about a point further on: Horner's scheme, again and again.
fn moved<const D: usize>(mut powers: Vec<SVector<f64, D>>, by: f64) -> Vec<SVector<f64, D>> {
    if by == 0.0 {
        return powers;
    }
    let last = powers.len() - 1;
    for i in 0..last {
        for m in (i..last).rev() {
            powers[m] = powers[m] + powers[m + 1] * by;
        }
    }
    powers
}
