use std::ops::Range;

/// Why a text is not XML, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct XmlFault {
    pub(crate) message: String,
    pub(crate) bytes: Range<usize>,
}
