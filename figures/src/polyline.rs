//! Plane geometry of curves, in pixels: thinning, clipping and dashing.

/// A point of a drawing, px.
pub(crate) type Point = (f64, f64);

/// Keeps first, lowest, highest and last point of each column, `width` wide, of a curve with `x` in order.
///
/// Nothing visible is lost: a curve that oscillates inside a column still covers the same pixels.
pub(crate) fn gather(points: &[Point], width: f64) -> Vec<Point> {
    let column = |p: &Point| (p.0 / width).floor();
    // NaN equals nothing, so a gap stays a column of its own.
    points.chunk_by(|a, b| column(a) == column(b) && !a.1.is_nan() && !b.1.is_nan()).flat_map(extremes).collect()
}

fn extremes(column: &[Point]) -> Vec<Point> {
    let by_height = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
    let mut kept = vec![0, column.len() - 1];
    kept.extend((0..column.len()).min_by(by_height));
    kept.extend((0..column.len()).max_by(by_height));
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|i| column[i]).collect()
}

/// Cuts a curve to the rectangle from (0, 0) to (`width`, `height`), and at points that are not numbers.
pub(crate) fn clip(points: &[Point], width: f64, height: f64) -> Vec<Vec<Point>> {
    let mut runs: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some((from, to)) = clip_segment(pair[0], pair[1], width, height) else { continue };
        match runs.last_mut() {
            Some(run) if run.last() == Some(&from) => run.push(to),
            _ => runs.push(vec![from, to]),
        }
    }
    runs
}

/// The part of a segment inside the rectangle (Liang and Barsky).
fn clip_segment(a: Point, b: Point, width: f64, height: f64) -> Option<(Point, Point)> {
    if ![a.0, a.1, b.0, b.1].iter().all(|v| v.is_finite()) {
        return None;
    }
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (rate, room) in [(-dx, a.0), (dx, width - a.0), (-dy, a.1), (dy, height - a.1)] {
        if rate == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if rate < 0.0 {
            enter = enter.max(room / rate);
        } else {
            leave = leave.min(room / rate);
        }
    }
    let at = |s: f64| (a.0 + s * dx, a.1 + s * dy);
    let from = if enter > 0.0 { at(enter) } else { a };
    let to = if leave < 1.0 { at(leave) } else { b };
    (enter <= leave).then_some((from, to))
}

/// Drops points that lie within `tolerance` of the line through those kept (Douglas and Peucker).
pub(crate) fn simplify(points: &[Point], tolerance: f64) -> Vec<Point> {
    let mut keep = vec![false; points.len()];
    let mut spans = Vec::new();
    if let Some(last) = points.len().checked_sub(1) {
        keep[0] = true;
        keep[last] = true;
        spans.push((0, last));
    }
    while let Some((from, to)) = spans.pop() {
        let off = |i: usize| distance(points[i], points[from], points[to]);
        let farthest = (from + 1..to).max_by(|&a, &b| off(a).total_cmp(&off(b)));
        if let Some(i) = farthest.filter(|&i| off(i) > tolerance) {
            keep[i] = true;
            spans.extend([(from, i), (i, to)]);
        }
    }
    points.iter().zip(keep).filter_map(|(p, kept)| kept.then_some(*p)).collect()
}

/// Distance of a point from a segment.
fn distance(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let length2 = dx * dx + dy * dy;
    let s = if length2 > 0.0 { (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / length2).clamp(0.0, 1.0) } else { 0.0 };
    (p.0 - a.0 - s * dx).hypot(p.1 - a.1 - s * dy)
}

/// Length of a curve.
fn length(points: &[Point]) -> f64 {
    points.windows(2).map(|w| (w[1].0 - w[0].0).hypot(w[1].1 - w[0].1)).sum()
}

/// Cuts a curve into dashes: `pattern` holds lengths drawn and left out in turn, empty for an unbroken line.
///
/// A curve longer than `longest` oscillates: dashes would look like gaps in it, so it stays whole.
pub(crate) fn dash(points: &[Point], pattern: &[f64], longest: f64) -> Vec<Vec<Point>> {
    let Some(&first) = points.first().filter(|_| !pattern.is_empty() && length(points) <= longest) else {
        return vec![points.to_vec()];
    };
    let (mut phase, mut left) = (0, pattern[0]);
    let mut dashes = vec![vec![first]];
    for pair in points.windows(2) {
        let (mut a, b) = (pair[0], pair[1]);
        let mut rest = (b.0 - a.0).hypot(b.1 - a.1);
        while rest > left {
            let s = left / rest;
            a = (a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1));
            rest -= left;
            turn(&mut dashes, phase, a);
            phase = (phase + 1) % pattern.len();
            left = pattern[phase];
        }
        left -= rest;
        if let Some(dash) = dashes.last_mut().filter(|_| phase % 2 == 0) {
            dash.push(b);
        }
    }
    dashes
}

/// Cuts a curve where it turns by more than 100 degrees, so that its outline is well defined everywhere: a bitmap backend
/// that joins the edges of thick lines would draw spikes there.
pub(crate) fn without_reversals(points: &[Point]) -> Vec<&[Point]> {
    let turns_back = |w: &[Point]| {
        let ((ax, ay), (bx, by)) = ((w[1].0 - w[0].0, w[1].1 - w[0].1), (w[2].0 - w[1].0, w[2].1 - w[1].1));
        ax * bx + ay * by < -0.17 * ax.hypot(ay) * bx.hypot(by)
    };
    let mut pieces = Vec::new();
    let mut start = 0;
    for (i, corner) in points.windows(3).enumerate() {
        if turns_back(corner) {
            pieces.push(&points[start..i + 2]);
            start = i + 1;
        }
    }
    pieces.push(&points[start..]);
    pieces
}

/// Ends the dash being drawn, or begins the next, at `p`.
fn turn(dashes: &mut Vec<Vec<Point>>, phase: usize, p: Point) {
    match dashes.last_mut() {
        Some(dash) if phase.is_multiple_of(2) => dash.push(p),
        _ => dashes.push(vec![p]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gathering_keeps_the_extremes_of_every_column() {
        let points: Vec<Point> = (0..1000).map(|i| (f64::from(i) * 0.01, f64::from(i * 7919 % 101))).collect();
        let gathered = gather(&points, 2.0);
        for column in 0..5 {
            let inside = |p: &&Point| (p.0 / 2.0).floor() == f64::from(column);
            let span = |list: &[Point]| {
                let heights = || list.iter().filter(inside).map(|p| p.1);
                (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max))
            };
            assert_eq!(span(&gathered), span(&points));
        }
        assert!(gathered.len() <= 5 * 4);
    }

    #[test]
    fn gathering_keeps_gaps() {
        let gathered = gather(&[(0.0, 1.0), (0.1, f64::NAN), (0.2, 2.0)], 2.0);
        assert_eq!(gathered.len(), 3);
        assert!(gathered[1].1.is_nan());
    }

    #[test]
    fn clipped_curves_stay_inside_and_break_outside() {
        let runs = clip(&[(-5.0, 5.0), (5.0, 5.0), (5.0, 25.0), (8.0, 25.0), (8.0, 5.0)], 10.0, 10.0);
        assert_eq!(runs, [vec![(0.0, 5.0), (5.0, 5.0), (5.0, 10.0)], vec![(8.0, 10.0), (8.0, 5.0)]]);
    }

    #[test]
    fn clipping_breaks_at_what_is_not_a_number() {
        let runs = clip(&[(0.0, 1.0), (1.0, 1.0), (2.0, f64::NAN), (3.0, 1.0), (4.0, 1.0)], 10.0, 10.0);
        assert_eq!(runs.len(), 2);
    }

    #[test]
    fn a_simplified_curve_is_within_tolerance_of_every_point() {
        let points: Vec<Point> = (0..400).map(|i| (f64::from(i), 50.0 * (f64::from(i) * 0.02).sin())).collect();
        let simple = simplify(&points, 0.5);
        assert!(simple.len() < 60);
        for p in points {
            let off = simple.windows(2).map(|w| distance(p, w[0], w[1])).fold(f64::INFINITY, f64::min);
            assert!(off <= 0.5, "{off}");
        }
    }

    #[test]
    fn dashes_cover_their_share_of_the_length() {
        let dashes = dash(&[(0.0, 0.0), (100.0, 0.0)], &[6.0, 4.0], 1e3);
        assert_eq!(dashes.len(), 10);
        let drawn: f64 = dashes.iter().map(|d| length(d)).sum();
        // Ten sums of ten decimal steps: rounding only.
        assert!((drawn - 60.0).abs() < 1e-9);
    }

    #[test]
    fn an_oscillating_curve_stays_whole() {
        let zigzag: Vec<Point> = (0..1000).map(|i| (f64::from(i), f64::from(i % 2) * 300.0)).collect();
        assert_eq!(dash(&zigzag, &[6.0, 4.0], 1e4), [zigzag]);
    }

    #[test]
    fn pieces_turn_back_nowhere_and_cover_the_curve() {
        let points = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (10.5, 0.0), (20.0, 0.0)];
        let pieces = without_reversals(&points);
        assert_eq!(pieces, [&points[..3], &points[2..]]);
    }
}
