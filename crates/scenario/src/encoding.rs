use std::fmt;

/// How a file that is not UTF-8 is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Sixteen bits a character, with a byte order mark or zeros between the letters.
    Utf16,
    /// Anything else: an older code page, or no text.
    Other,
}

impl Encoding {
    /// Tells the encoding of bytes that are no UTF-8, or UTF-8 with zeros in it.
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let marked = bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff");
        let zeros = bytes.iter().take(200).filter(|&&b| b == 0).count();
        if marked || zeros > 20 { Self::Utf16 } else { Self::Other }
    }
}

impl fmt::Display for Encoding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Utf16 => "UTF-16",
            Self::Other => "an older encoding or no text",
        })
    }
}
