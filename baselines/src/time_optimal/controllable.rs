use super::farkas::Infeasibility;
use super::interval::{Direction, Extreme, IntervalProgram, Reason, proven_bound};
use super::piece::PieceProgram;

/// The ranges of `x` at every node from which the end (backward) or the start (forward) can be reached within all rows and
/// caps: intervals, for they are projections of convex sets.
pub(super) struct Ranges {
    pub(super) low: Vec<f64>,
    pub(super) high: Vec<f64>,
    /// Reason why each node's range ends where it does, low and high.
    pub(super) reasons: Vec<[Reason; 2]>,
}

/// Sweeps over the intervals, backward from the end (the controllable sets of TOPP-RA) or forward from the start (the
/// reachable sets); each step is a two-variable linear program for either end of the range.
pub(super) fn controllable(program: &PieceProgram, direction: Direction) -> Result<Ranges, Box<Infeasibility>> {
    let nodes = program.cap.len();
    let mut ranges = Ranges {
        low: (0..nodes).map(|k| program.floor(k)).collect(),
        high: program.cap.clone(),
        reasons: vec![[Reason::Box; 2]; nodes],
    };
    let mut interval_program = IntervalProgram::default();
    for step in 0..program.h.len() {
        let (interval, x, y) = match direction {
            Direction::Backward => (nodes - 2 - step, nodes - 2 - step, nodes - 1 - step),
            Direction::Forward => (step, step + 1, step),
        };
        let (x_box, y_range) = ([ranges.low[x], ranges.high[x]], [ranges.low[y], ranges.high[y]]);
        let solved = interval_program
            .load(program.interval(interval), program.first[interval], direction, x_box, y_range)
            .and_then(|()| {
                Ok([interval_program.extreme(Extreme::Least)?, interval_program.extreme(Extreme::Greatest)?])
            });
        match solved {
            Ok([(low, why_low), (high, why_high)]) => {
                // Where the range is a point, rounding may swap its ends.
                (ranges.low[x], ranges.high[x]) = (low.min(high), high);
                ranges.reasons[x] = [why_low, why_high];
            }
            Err(clash) => return Err(Box::new(Infeasibility::new(program, &ranges, interval, direction, clash))),
        }
    }
    Ok(ranges)
}

impl Ranges {
    /// Upper bounds that every feasible profile keeps, rounded upwards: the pair of rows behind each bound is evaluated
    /// again with outward rounding, from the proven bounds of the neighbour.
    pub(super) fn proven_upper(&self, program: &PieceProgram, direction: Direction) -> Vec<f64> {
        let nodes = program.cap.len();
        let mut cap = program.cap.clone();
        for step in 0..program.h.len() {
            let (x, y) = match direction {
                Direction::Backward => (nodes - 2 - step, nodes - 1 - step),
                Direction::Forward => (step + 1, step),
            };
            // The neighbour's least value is taken as its box's: weaker than its range, and needs no proof.
            let range = [program.floor(y), cap[y]];
            let bound = proven_bound(self.reasons[x][1], Extreme::Greatest, &program.strips, direction, range);
            if let Some(bound) = bound.filter(|b| *b >= 0.0 && program.free().contains(&x)) {
                cap[x] = cap[x].min(bound);
            }
        }
        cap
    }
}
