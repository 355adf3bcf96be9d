use super::fault::XmlFault;
use quick_xml::events::BytesStart;
use std::ops::Range;

/// A wanted element with its wanted children.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub(crate) name: String,
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) children: Vec<Self>,
    /// Its opening tag in the text.
    pub(crate) tag: Range<usize>,
}

/// An attribute, its value unescaped.
#[derive(Clone, Debug)]
pub(crate) struct Attribute {
    pub(crate) key: String,
    pub(crate) value: String,
    /// The value in the text.
    pub(crate) bytes: Range<usize>,
}

impl Element {
    /// The first child of a name.
    pub(crate) fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.name == name)
    }

    /// All children of a name.
    pub(crate) fn children<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Self> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// An attribute by its name.
    pub(crate) fn attribute(&self, key: &str) -> Option<&Attribute> {
        self.attributes.iter().find(|attribute| attribute.key == key)
    }

    /// The value of an attribute without the blanks around it.
    pub(crate) fn value(&self, key: &str) -> Option<&str> {
        self.attribute(key).map(|attribute| attribute.value.trim())
    }
}

/// The attributes of a tag.
pub(super) fn attributes(start: &BytesStart<'_>, text: &str, tag: &Range<usize>) -> Result<Vec<Attribute>, XmlFault> {
    let fault = |message: String| XmlFault { message, bytes: tag.clone() };
    let read = |attribute: Result<quick_xml::events::attributes::Attribute<'_>, _>| {
        let attribute =
            attribute.map_err(|error: quick_xml::events::attributes::AttrError| fault(error.to_string()))?;
        let value = attribute.unescape_value().map_err(|error| fault(error.to_string()))?.into_owned();
        let key = String::from_utf8_lossy(attribute.key.as_ref()).into_owned();
        Ok(Attribute { key, value, bytes: place(&attribute.value, text).unwrap_or_else(|| tag.clone()) })
    };
    start.attributes().map(read).collect()
}

/// Where in the text a slice of it lies.
fn place(slice: &[u8], text: &str) -> Option<Range<usize>> {
    let begin = (slice.as_ptr() as usize).checked_sub(text.as_ptr() as usize)?;
    let bytes = begin..begin.checked_add(slice.len())?;
    (text.as_bytes().get(bytes.clone()) == Some(slice)).then_some(bytes)
}
