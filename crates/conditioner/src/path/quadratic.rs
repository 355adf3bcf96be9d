/// The largest `t` in `[0, 1]` for which the quadratic through `(0, a)`, `(1/2, b)`, `(1, c)` stays at or below `limit`
/// from 0 on; 0 where it starts above, or on NaN.
pub(crate) fn largest_factor([a, b, c]: [f64; 3], limit: f64) -> f64 {
    // q(t) = a + slope t + curve t².
    let curve = 2.0 * (a + c) - 4.0 * b;
    let slope = c - a - curve;
    let room = limit - a;
    if room >= 0.0 { first_crossing(curve, slope, room).clamp(0.0, 1.0) } else { 0.0 }
}

/// Smallest `t > 0` with `curve t² + slope t = room`, for `room >= 0`; infinite if there is none, 0 on NaN.
fn first_crossing(curve: f64, slope: f64, room: f64) -> f64 {
    let discriminant = slope * slope + 4.0 * curve * room;
    if discriminant < 0.0 {
        return f64::INFINITY;
    }
    // The form without cancellation: both roots come from the same sum.
    let denominator = slope + libm::sqrt(discriminant);
    if denominator > 0.0 {
        2.0 * room / denominator
    } else if denominator <= 0.0 {
        f64::INFINITY
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rising_quadratic_is_cut_where_it_meets_the_limit() {
        // 1 + 16 t², limit 5: t = 1/2.
        assert!((largest_factor([1.0, 5.0, 17.0], 5.0) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn a_quadratic_that_rises_from_the_start_is_cut_where_it_meets_the_limit() {
        // 1 + 3 t + 4 t², limit 7/2: t = 1/2.
        assert!((largest_factor([1.0, 3.5, 8.0], 3.5) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn a_line_that_falls_leaves_everything_even_from_the_limit() {
        assert_eq!(largest_factor([5.0, 4.0, 3.0], 6.0), 1.0);
        assert_eq!(largest_factor([5.0, 4.0, 3.0], 5.0), 1.0);
    }

    #[test]
    fn a_quadratic_that_only_touches_the_limit_is_cut_there() {
        // t - t², limit 1/4: t = 1/2. A rounding decides whether such a one crosses; a shorter step is the safe side.
        assert_eq!(largest_factor([0.0, 0.25, 0.0], 0.25), 0.5);
    }

    #[test]
    fn a_falling_quadratic_leaves_everything() {
        assert_eq!(largest_factor([1.0, -3.0, -15.0], 5.0), 1.0);
    }

    #[test]
    fn a_quadratic_that_turns_below_the_limit_leaves_everything() {
        // Rises to 1.25 at t = 1/2 and falls again.
        assert_eq!(largest_factor([1.0, 1.25, 1.0], 2.0), 1.0);
    }

    #[test]
    fn no_room_or_no_number_stops() {
        assert_eq!(largest_factor([6.0, 7.0, 8.0], 5.0), 0.0);
        assert_eq!(largest_factor([f64::NAN, 7.0, 8.0], 5.0), 0.0);
        assert_eq!(largest_factor([1.0, f64::NAN, 8.0], 5.0), 0.0);
    }
}
