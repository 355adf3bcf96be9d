//! What a report shows of a user's text: a line is echoed up to 200 characters of it.

use miette::{MietteError, MietteSpanContents, NamedSource, SourceCode, SourceSpan, SpanContents};

/// Characters of a line, or of a quoted name, that are shown at the most.
pub(crate) const LONGEST_ECHO: usize = 200;

/// A named text whose long lines are shown in part: those that a place lies in, about it.
#[derive(Debug)]
pub(crate) struct Snippet {
    name: String,
    text: NamedSource<String>,
}

impl Snippet {
    pub(crate) fn new(name: &str, text: &str) -> Self {
        Self { name: name.to_owned(), text: NamedSource::new(name, text.to_owned()) }
    }

    /// The part of a long line about a place, in bytes; whole characters.
    fn about(&self, place: usize) -> std::ops::Range<usize> {
        let text = self.text.inner();
        let place = text.floor_char_boundary(place);
        let line = text[..place].rfind('\n').map_or(0, |end| end + 1);
        let end = text[place..].find('\n').map_or(text.len(), |length| place + length);
        // Half of what may be shown before the place, at four bytes a character at the most.
        let back: usize = text[line..place].chars().rev().take(LONGEST_ECHO / 4).map(char::len_utf8).sum();
        let ahead: usize = text[place..end].chars().take(LONGEST_ECHO / 2).map(char::len_utf8).sum();
        place - back..place + ahead
    }
}

impl SourceCode for Snippet {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let whole = self.text.read_span(span, before, after)?;
        let shown = String::from_utf8_lossy(whole.data());
        if before + after == 0 || shown.lines().all(|line| line.chars().count() <= LONGEST_ECHO) {
            return Ok(whole);
        }
        let part = self.about(span.offset());
        let at = self.text.read_span(&SourceSpan::from(part.start..part.start), 0, 0)?;
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            &self.text.inner().as_bytes()[part.clone()],
            SourceSpan::from(part),
            at.line(),
            at.column(),
            1,
        )))
    }
}

/// A message in which everything between backticks is short.
pub(crate) fn short_echo(message: &str) -> String {
    let part = |(i, part): (usize, &str)| {
        let length = part.chars().count();
        if i % 2 == 0 || length <= LONGEST_ECHO / 2 {
            return part.to_owned();
        }
        let (head, tail): (String, String) =
            (part.chars().take(LONGEST_ECHO / 4).collect(), part.chars().skip(length - LONGEST_ECHO / 8).collect());
        format!("{head} ... {tail}")
    };
    message.split('`').enumerate().map(part).collect::<Vec<_>>().join("`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_line_is_shown_about_the_place_and_a_short_one_whole() {
        let text = format!("a = 1\nb = [{}oops]\nc = 2\n", "1.5, ".repeat(1000));
        let snippet = Snippet::new("file", &text);
        let place = text.find("oops").expect("there");
        let shown = snippet.read_span(&SourceSpan::from(place..place + 4), 1, 1).expect("inside");
        let data = String::from_utf8_lossy(shown.data());
        assert!(data.contains("oops") && data.chars().count() <= LONGEST_ECHO && shown.line() == 1, "{data}");
        let short = snippet.read_span(&SourceSpan::from(0..1), 0, 0).expect("inside");
        assert_eq!(short.line(), 0);
    }

    #[test]
    fn a_long_name_is_quoted_in_part() {
        let long = "ä".repeat(10_000);
        let said = short_echo(&format!("there is no file called `{long}`, give `this`"));
        assert!(said.chars().count() < LONGEST_ECHO && said.ends_with(", give `this`"), "{said}");
        assert_eq!(short_echo("a `b` c"), "a `b` c");
    }
}
