//! The few elements of an XML file that a reader wants, with their places; everything else is passed over unread.

mod element;
mod fault;
mod text;

pub(crate) use element::{Attribute, Element};
pub(crate) use fault::XmlFault;
pub(crate) use text::{TextFault, read_text};

use quick_xml::Reader;
use quick_xml::errors::{Error, IllFormedError};
use quick_xml::events::{BytesStart, Event};
use std::ops::Range;

/// Reads the root and those elements below it for which `wanted(depth, name)` holds, children of the root having depth 1.
/// The inside of an unwanted element is checked for matching tags and nothing else, however deep it goes.
pub(crate) fn read(text: &str, wanted: fn(usize, &str) -> bool) -> Result<Element, XmlFault> {
    let mut reader = Reader::from_str(text);
    // A loose `&` can stand in a description that no one reads.
    reader.config_mut().allow_dangling_amp = true;
    let mut tree = Growing { text, wanted, open: Vec::new(), skipped: Vec::new(), root: None };
    loop {
        let start = position(&reader, text);
        let event = reader.read_event();
        let tag = start..position(&reader, text);
        match event {
            Ok(Event::Start(element)) => tree.begin(&element, tag)?,
            Ok(Event::Empty(element)) => {
                tree.begin(&element, tag)?;
                tree.end();
            }
            Ok(Event::End(_)) => tree.end(),
            Ok(Event::Eof) => return tree.finish(),
            Ok(_) => {}
            Err(error) => return Err(tree.fault(&error, tag)),
        }
    }
}

fn position(reader: &Reader<&[u8]>, text: &str) -> usize {
    usize::try_from(reader.buffer_position()).map_or(text.len(), |at| at.min(text.len()))
}

/// A tree as far as it has been read.
struct Growing<'a> {
    text: &'a str,
    wanted: fn(usize, &str) -> bool,
    /// Wanted elements that are not closed yet, the root first.
    open: Vec<Element>,
    /// Places of unwanted elements that are not closed yet, inside the last of `open`.
    skipped: Vec<Range<usize>>,
    root: Option<Element>,
}

impl Growing<'_> {
    fn begin(&mut self, start: &BytesStart<'_>, tag: Range<usize>) -> Result<(), XmlFault> {
        let name = String::from_utf8_lossy(start.name().as_ref()).into_owned();
        let first = self.open.is_empty() && self.root.is_none();
        if !self.skipped.is_empty() || !(first || !self.open.is_empty() && (self.wanted)(self.open.len(), &name)) {
            self.skipped.push(tag);
            return Ok(());
        }
        let attributes = element::attributes(start, self.text, &tag)?;
        self.open.push(Element { name, attributes, children: Vec::new(), tag });
        Ok(())
    }

    fn end(&mut self) {
        if self.skipped.pop().is_some() {
            return;
        }
        let Some(element) = self.open.pop() else { return };
        match self.open.last_mut() {
            Some(parent) => parent.children.push(element),
            None => self.root = Some(element),
        }
    }

    /// The place of the innermost element that is not closed.
    fn unclosed(&self) -> Option<Range<usize>> {
        self.skipped.last().cloned().or_else(|| self.open.last().map(|element| element.tag.clone()))
    }

    fn finish(self) -> Result<Element, XmlFault> {
        if let Some(bytes) = self.unclosed() {
            let tag = self.text.get(bytes.clone()).unwrap_or_default();
            return Err(XmlFault { message: format!("{} is never closed", quoted(tag)), bytes });
        }
        let nothing = || XmlFault { message: "there is no element in it".into(), bytes: 0..0 };
        self.root.ok_or_else(nothing)
    }

    fn fault(&self, error: &Error, tag: Range<usize>) -> XmlFault {
        let bytes = match error {
            // Closed by the wrong name: the element that is open is where to look.
            Error::IllFormed(IllFormedError::MismatchedEndTag { .. } | IllFormedError::MissingEndTag(_)) => {
                self.unclosed().unwrap_or(tag)
            }
            _ => tag,
        };
        XmlFault { message: error.to_string(), bytes }
    }
}

/// A tag, cut if it is long.
fn quoted(tag: &str) -> String {
    const MOST: usize = 60;
    let cut: String = tag.chars().take(MOST).collect();
    if cut.len() < tag.len() { format!("`{cut}...`") } else { format!("`{cut}`") }
}

/// The line of a byte, counted from 1.
pub(crate) fn line(text: &str, at: usize) -> usize {
    1 + text.bytes().take(at).filter(|byte| *byte == b'\n').count()
}
