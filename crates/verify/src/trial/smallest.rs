//! Making a failing case small: less of every disturbance first, then fewer kinds, then less again.

use super::Judgement;
use super::draw::Draw;
use crate::error::VerifyError;

/// Halvings of the interval between a size that keeps the guarantees and one that does not: to a part in a thousand.
const HALVINGS: usize = 10;

/// The smallest case found in which every guarantee fails that failed at first. `judge` must be a function of the draw alone.
///
/// Sizes in between need not fail even where larger and smaller ones do: what is found is a case that fails and whose neighbour, a
/// thousandth of the range smaller, does not.
pub(crate) fn smallest(
    draw: &Draw,
    violated: &[&str],
    judge: impl Fn(&Draw) -> Result<Judgement, VerifyError>,
) -> Result<Draw, VerifyError> {
    let fails = |draw: &Draw| -> Result<bool, VerifyError> {
        let found = judge(draw)?;
        Ok(violated.iter().all(|name| found.checks.iter().any(|check| check.guarantee == *name && !check.kept())))
    };
    let mut least = reduced(draw, fails)?;
    for kind in draw.kinds() {
        let without = least.with_only(|other| other != kind);
        if fails(&without)? {
            least = without;
        }
    }
    reduced(&least, fails)
}

fn reduced(draw: &Draw, fails: impl Fn(&Draw) -> Result<bool, VerifyError>) -> Result<Draw, VerifyError> {
    let nothing = draw.at(0.0);
    if fails(&nothing)? {
        return Ok(nothing);
    }
    let (mut kept, mut failing) = (0.0, draw.size());
    for _ in 0..HALVINGS {
        let middle = 0.5 * (kept + failing);
        if fails(&draw.at(middle))? {
            failing = middle;
        } else {
            kept = middle;
        }
    }
    Ok(draw.at(failing))
}
