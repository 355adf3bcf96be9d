/// A number in words: four significant digits, without an exponent where it can be avoided.
#[must_use]
pub fn short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        "0".into()
    } else if size < 1e-4 {
        format!("{value:.1e}")
    } else if size < 10.0 {
        format!("{value:.4}")
    } else if size < 1000.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.3e}")
    }
}
