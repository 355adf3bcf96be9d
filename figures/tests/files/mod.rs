//! Looks into the files that are written.

use std::error::Error;
use std::path::Path;

/// Width and height in a PNG file's header, and the number of bytes of the file.
pub(crate) fn png_header(path: &Path) -> Result<(u32, u32, usize), Box<dyn Error>> {
    let bytes = std::fs::read(path)?;
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let number = |at: usize| -> Result<u32, Box<dyn Error>> { Ok(u32::from_be_bytes(bytes[at..at + 4].try_into()?)) };
    Ok((number(16)?, number(20)?, bytes.len()))
}

/// True if every tag of a document without comments is closed, in order, and no bare ampersand is left.
pub(crate) fn is_well_formed(xml: &str) -> bool {
    let mut open = Vec::new();
    for part in xml.split('<').skip(1) {
        let Some((tag, text)) = part.split_once('>') else { return false };
        if let Some(name) = tag.strip_prefix('/') {
            if open.pop() != Some(name) {
                return false;
            }
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap_or_default());
        }
        if text.split('&').skip(1).any(|entity| !entity.split(' ').next().is_some_and(|e| e.contains(';'))) {
            return false;
        }
    }
    open.is_empty()
}
