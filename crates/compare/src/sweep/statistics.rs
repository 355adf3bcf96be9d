use serde::{Deserialize, Serialize};

/// Median, 95th percentile and maximum of the values that exist.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    /// Number of values: runs without the value, such as the escape time of a run that met no trap, do not count.
    pub count: usize,
    /// [`quantile`] at 0.5; null without values.
    pub median: Option<f64>,
    /// [`quantile`] at 0.95; null without values.
    pub p95: Option<f64>,
    /// Largest value; null without values.
    pub max: Option<f64>,
}

impl Statistics {
    /// Of the finite values among those given.
    #[must_use]
    pub fn new(values: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = values.into_iter().filter(|v| v.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        Self {
            count: sorted.len(),
            median: quantile(&sorted, 0.5),
            p95: quantile(&sorted, 0.95),
            max: sorted.last().copied(),
        }
    }
}

/// The `p`-quantile of sorted values by linear interpolation between order statistics (definition 7 of Hyndman and Fan
/// 1996, the default of NumPy and R): with `h = (n - 1) p`,
///
/// ```text
/// Q(p) = x[⌊h⌋] + (h - ⌊h⌋) (x[⌊h⌋ + 1] - x[⌊h⌋])
/// ```
///
/// `None` without values; `p` is held to [0, 1], and a NaN counts as 0.
#[must_use]
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub fn quantile(sorted: &[f64], p: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    let h = last as f64 * if p > 0.0 { p.min(1.0) } else { 0.0 };
    let below = (h.floor() as usize).min(last);
    let (low, high) = (sorted[below], sorted[(below + 1).min(last)]);
    Some(low + (h - h.floor()) * (high - low))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_interpolate_between_order_statistics() {
        let values = [1.0, 2.0, 4.0, 8.0, 16.0];
        // h = 4 p: 2 and 3.8. The second is 8 + 0.8 · 8, right to two roundings.
        assert_eq!(quantile(&values, 0.5), Some(4.0));
        assert!((quantile(&values, 0.95).expect("there") - 14.4).abs() < 1e-14);
        assert_eq!((quantile(&values, 0.0), quantile(&values, 1.0)), (Some(1.0), Some(16.0)));
        assert_eq!(quantile(&values[..2], 0.5), Some(1.5));
        assert_eq!(quantile(&[], 0.5), None);
    }

    #[test]
    fn values_that_do_not_exist_do_not_count_and_order_does_not_matter() {
        let found = Statistics::new([3.0, f64::NAN, 1.0, f64::INFINITY, 2.0]);
        assert_eq!(
            found,
            Statistics { count: 3, median: Some(2.0), p95: quantile(&[1.0, 2.0, 3.0], 0.95), max: Some(3.0) }
        );
        assert_eq!(Statistics::new([]).max, None);
    }
}
