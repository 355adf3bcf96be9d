use super::UrdfFault;
use std::fmt;
use std::ops::Range;

/// Why a URDF gives no arm, and where in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct UrdfError {
    /// The reason.
    pub fault: Box<UrdfFault>,
    /// The place in the text, where the reason lies in one.
    pub place: Option<UrdfPlace>,
}

/// A place in the text of a URDF.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UrdfPlace {
    /// Line, counted from 1.
    pub line: usize,
    /// Bytes: a name, a value or a tag.
    pub bytes: Range<usize>,
}

impl UrdfError {
    /// A sentence on what to do about it.
    #[must_use]
    pub fn remedy(&self) -> String {
        self.fault.remedy()
    }

    /// Where the element that the error is about lies in the text it was found in, as a range of bytes.
    #[must_use]
    pub fn locate(&self, text: &str) -> Option<Range<usize>> {
        self.place.as_ref().map(|place| place.bytes.clone()).filter(|bytes| text.get(bytes.clone()).is_some())
    }
}

impl fmt::Display for UrdfError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            write!(f, "line {}: ", place.line)?;
        }
        self.fault.fmt(f)
    }
}

impl std::error::Error for UrdfError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        std::error::Error::source(&*self.fault)
    }
}

impl From<UrdfFault> for UrdfError {
    fn from(fault: UrdfFault) -> Self {
        Self { fault: Box::new(fault), place: None }
    }
}

impl UrdfFault {
    /// The fault at a place; the line is counted once the text is at hand.
    pub(super) fn at(self, bytes: &Range<usize>) -> UrdfError {
        UrdfError { fault: Box::new(self), place: Some(UrdfPlace { line: 0, bytes: bytes.clone() }) }
    }
}
