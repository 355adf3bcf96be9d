use super::UrdfError;

/// Robots need five levels; the parser recurses, so a bound keeps hostile files from exhausting its stack.
const MOST: usize = 64;

/// Refuses texts whose elements are nested beyond any robot's.
pub(super) fn check(text: &str) -> Result<(), UrdfError> {
    let mut depth = 0_usize;
    let mut rest = text;
    while let Some(at) = rest.find('<') {
        rest = &rest[at + 1..];
        if let Some((_, end)) = SKIPPED.iter().find(|(begin, _)| rest.starts_with(begin)) {
            rest = rest.find(end).map_or("", |at| &rest[at + end.len()..]);
            continue;
        }
        let length = tag_length(rest);
        if rest.starts_with('/') {
            depth = depth.saturating_sub(1);
        } else if !rest[..length].ends_with('/') {
            depth += 1;
        }
        if depth > MOST {
            return Err(UrdfError::TooDeep { most: MOST });
        }
        rest = &rest[length..];
    }
    Ok(())
}

/// What begins with `<` and is no element, with its end.
const SKIPPED: [(&str, &str); 4] = [("!--", "-->"), ("![CDATA[", "]]>"), ("?", "?>"), ("!", ">")];

/// Bytes up to the `>` of a tag, the ones in quotes not counted.
fn tag_length(tag: &str) -> usize {
    let mut quote = None;
    for (at, byte) in tag.bytes().enumerate() {
        match (quote, byte) {
            (None, b'>') => return at,
            (None, b'"' | b'\'') => quote = Some(byte),
            (Some(open), close) if open == close => quote = None,
            _ => {}
        }
    }
    tag.len()
}
