//! Numbers in words: as many digits as a comparison needs, and no number that is none.

/// A number in words: three significant digits or more, without an exponent where it can be avoided; see [`apart`] for numbers that
/// are compared.
#[must_use]
pub fn short(value: f64) -> String {
    let size = value.abs();
    if let Some(word) = no_number(value) {
        word.into()
    } else if size == 0.0 {
        "0".into()
    } else if size < 1e-4 {
        format!("{value:.1e}")
    } else if size < 1e-3 {
        format!("{value:.6}")
    } else if size < 1e-2 {
        format!("{value:.5}")
    } else if size < 10.0 {
        format!("{value:.4}")
    } else if size < 1000.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.3e}")
    }
}

/// Numbers that are compared, as [`short`] has them where that tells apart those that differ, else with as many digits as it takes.
#[must_use]
pub fn apart<const N: usize>(values: [f64; N]) -> [String; N] {
    let texts = values.map(short);
    if tells_apart(&values, &texts) { texts } else { fixed(values, 4) }
}

/// Numbers that are compared, with their unit: seconds, metres and radians are scaled together to the largest.
#[must_use]
pub fn apart_in<const N: usize>(values: [f64; N], unit: &str) -> [String; N] {
    let (factor, prefix) = scale(&values, unit);
    let scaled = apart(values.map(|value| factor * value));
    // Neighbours may become equal when they are scaled.
    let (texts, prefix) = if tells_apart(&values, &scaled) { (scaled, prefix) } else { (apart(values), "") };
    let unit = if unit == "1" { String::new() } else { format!(" {prefix}{unit}") };
    texts.map(|text| (text + &unit).trim_end().to_owned())
}

/// Numbers that are compared, with at least so many decimals: more where two that differ would read alike, or one that is not zero
/// as zero; an exponent where decimals do not do.
#[must_use]
pub fn fixed<const N: usize>(values: [f64; N], decimals: usize) -> [String; N] {
    let word = |value: f64| no_number(value).map(str::to_owned);
    let plain = |digits: usize| values.map(|value| word(value).unwrap_or_else(|| format!("{value:.digits$}")));
    let scientific = |digits: usize| values.map(|value| word(value).unwrap_or_else(|| format!("{value:.digits$e}")));
    let large = values.iter().any(|value| value.is_finite() && value.abs() >= 1e9);
    let plain = (decimals..decimals + 6).filter(|_| !large).map(plain);
    // Seventeen digits tell any two numbers apart.
    let mut texts = plain.chain((3..=16).map(scientific));
    texts.find(|texts| tells_apart(&values, texts)).unwrap_or_else(|| scientific(16))
}

/// A number beside nothing, with at least so many decimals and as many more as it takes to see it.
#[must_use]
pub fn decimals(value: f64, least: usize) -> String {
    let [text] = fixed([value], least);
    text
}

/// The word for what is no number.
fn no_number(value: f64) -> Option<&'static str> {
    match value {
        v if v.is_nan() => Some("not a number"),
        f64::INFINITY => Some("unbounded"),
        f64::NEG_INFINITY => Some("unbounded below"),
        _ => None,
    }
}

/// True of texts that read differently wherever the values differ, and as zero only for zero.
fn tells_apart(values: &[f64], texts: &[String]) -> bool {
    let read = |text: &String| text.parse::<f64>();
    let zero = |(value, text): (&f64, &String)| *value != 0.0 && read(text) == Ok(0.0);
    let alike = |i: usize, j: usize| values[i] != values[j] && texts[i] == texts[j] && !values[i].is_nan();
    !values.iter().zip(texts).any(zero) && !(0..values.len()).any(|i| (0..i).any(|j| alike(i, j)))
}

/// Factor by which the values are multiplied, and the prefix of the unit that goes with it.
fn scale(values: &[f64], unit: &str) -> (f64, &'static str) {
    let largest = values.iter().filter(|v| v.is_finite()).fold(0.0_f64, |most, v| most.max(v.abs()));
    match largest {
        l if !["m", "s", "rad"].contains(&unit) || !(1e-12..0.1).contains(&l) => (1.0, ""),
        l if l >= 1e-4 => (1e3, "m"),
        l if l >= 1e-7 => (1e6, "µ"),
        _ => (1e9, "n"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pairs of numbers that differ, of any size, from far apart to the next one.
    fn pairs() -> impl Iterator<Item = [f64; 2]> {
        let sizes =
            (-320..308).step_by(4).map(|power| format!("1.2345678901234567e{power}").parse::<f64>().expect("a number"));
        let nudges = [0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 0.02, 0.5, -1.0, -2.0];
        let moved = move |size: f64| {
            nudges.map(|nudge| [size, if nudge == 0.0 { size.next_up() } else { size * (1.0 + nudge) }])
        };
        sizes.flat_map(moved).filter(|[a, b]| a != b)
    }

    #[test]
    fn two_numbers_that_differ_read_differently_however_they_are_formatted() {
        for pair in pairs() {
            let [a, b] = pair;
            for [x, y] in [apart(pair), apart_in(pair, "s"), apart_in(pair, "1/s"), fixed(pair, 2), fixed(pair, 4)] {
                assert_ne!(x, y, "{a:e} and {b:e}");
            }
            // A number that is not zero does not read as zero.
            assert!(a == 0.0 || decimals(a, 4).parse::<f64>() != Ok(0.0), "{a:e}");
        }
    }

    #[test]
    fn what_is_no_number_is_a_word() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for text in [short(value), decimals(value, 4), apart_in([value, 1.0], "m")[0].clone()] {
                assert!(!text.contains("inf") && !text.contains("NaN"), "{text}");
            }
        }
        assert_ne!(short(f64::INFINITY), short(f64::NEG_INFINITY));
    }

    #[test]
    fn what_is_equal_reads_alike_and_units_are_scaled_together() {
        assert_eq!(apart([0.25, 0.25]), ["0.2500", "0.2500"]);
        assert_eq!(apart_in([1.5e-4, 2.0e-4], "m"), ["0.1500 mm", "0.2000 mm"]);
        assert_eq!(apart_in([0.5, 0.25], "1"), ["0.5000", "0.2500"]);
        assert_eq!(fixed([4.599, 4.521], 2), ["4.60", "4.52"]);
        assert_eq!(fixed([2.004, 2.0], 2), ["2.004", "2.000"]);
    }
}
