//! Numbers, names and texts as words.

pub(crate) use slideway_compare::{apart, apart_in, decimals, short};

/// A text as HTML.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The known name that is nearest to one that is not known: what was meant, if at most a third of its letters differ.
pub(crate) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let by_distance = known.into_iter().map(|known| (strsim::levenshtein(name, known), known));
    by_distance.min().filter(|(distance, known)| 3 * distance <= known.len()).map(|(_, known)| known)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_meant_if_a_third_of_its_letters_differ_at_most() {
        for (name, meant) in [("puma-heli", Some("puma-helix")), ("helx", Some("helix")), ("h", None), ("", None)] {
            assert_eq!(nearest(name, ["puma-helix", "helix"]), meant, "{name}");
        }
    }
}
