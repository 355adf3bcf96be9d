/// A thing in which two identities differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Difference {
    pub(crate) what: &'static str,
    pub(crate) was: String,
    pub(crate) now: String,
}

/// What something is called, what it was and what it is now.
pub(crate) type Thing = (&'static str, String, String);

impl Difference {
    /// The first of the things that is not the same.
    pub(crate) fn first<const N: usize>(things: [Thing; N]) -> Option<Self> {
        things.into_iter().find(|(_, was, now)| was != now).map(|(what, was, now)| Self { what, was, now })
    }

    /// Two texts by their first differing line, as a thing for [`Difference::first`].
    pub(crate) fn of_texts(what: &'static str, was: &str, now: &str) -> Thing {
        (what, differing_line(was, now), differing_line(now, was))
    }
}

/// The first line of `a` that `b` has differently, with its number; empty if there is none.
fn differing_line(a: &str, b: &str) -> String {
    let mut other = b.split('\n');
    let differing = a.split('\n').enumerate().find(|(_, line)| other.next() != Some(line));
    match differing {
        Some((i, line)) => format!("`{line}` in line {}", i + 1),
        None if a == b => String::new(),
        None => "shorter".into(),
    }
}
