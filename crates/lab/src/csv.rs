//! Names in the header of a CSV file.

use std::borrow::Cow;

/// A column's name as a field (RFC 4180): in quotes where a comma, a quote or a line feed in it would end the field or the line.
#[must_use]
pub fn field(name: &str) -> Cow<'_, str> {
    if name.contains([',', '"', '\n', '\r']) {
        Cow::Owned(format!("\"{}\"", name.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(name)
    }
}

/// A header of columns, without a line feed.
#[must_use]
pub fn header(columns: &[String]) -> String {
    columns.iter().map(|name| field(name)).collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_would_break_the_header_is_quoted_and_any_other_is_left_alone() {
        let columns = ["q_left, upper_rad", "t_s", "q_the \"elbow\"_rad", "q_ellbögen_m"].map(str::to_owned);
        assert_eq!(header(&columns), "\"q_left, upper_rad\",t_s,\"q_the \"\"elbow\"\"_rad\",q_ellbögen_m");
    }
}
