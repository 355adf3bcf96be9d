use std::path::Path;

/// Why a file gives no text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum TextFault {
    /// The file cannot be read.
    Read(String),
    /// A byte that is not of the encoding, on a line counted from 1.
    Encoding { declared: Option<String>, line: usize },
}

/// The text of an XML file: UTF-8, or Latin-1 if the file's declaration says so.
pub(crate) fn read_text(path: &Path) -> Result<String, TextFault> {
    decode(&std::fs::read(path).map_err(|error| TextFault::Read(error.to_string()))?)
}

fn decode(bytes: &[u8]) -> Result<String, TextFault> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let declared = declared_encoding(bytes);
    if declared.as_deref().is_some_and(|name| LATIN_1.contains(&name.to_ascii_lowercase().as_str())) {
        // A byte of Latin-1 is the number of its character.
        return Ok(bytes.iter().map(|&byte| char::from(byte)).collect());
    }
    std::str::from_utf8(bytes).map(str::to_owned).map_err(|error| {
        let line = 1 + bytes[..error.valid_up_to()].iter().filter(|byte| **byte == b'\n').count();
        TextFault::Encoding { declared, line }
    })
}

/// Names of ISO 8859-1 in XML declarations.
const LATIN_1: [&str; 5] = ["iso-8859-1", "iso8859-1", "iso_8859-1", "latin1", "latin-1"];

/// The encoding that `<?xml ... encoding="..."?>` names.
fn declared_encoding(bytes: &[u8]) -> Option<String> {
    let head: String = bytes.iter().take(200).map(|&byte| char::from(byte)).collect();
    let declaration = head.trim_start().strip_prefix("<?xml")?.split_once("?>")?.0;
    let value = declaration.split_once("encoding")?.1.trim_start().strip_prefix('=')?.trim_start();
    let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    Some(value[1..].split_once(quote)?.0.to_owned())
}

#[cfg(test)]
mod tests {
    use super::{TextFault, decode};

    #[test]
    fn bytes_are_read_by_their_declaration_and_else_as_utf_8() {
        assert_eq!(
            decode(b"<?xml version='1.0' encoding='ISO-8859-1'?><!--\xfc-->").expect("Latin-1").chars().nth(47),
            Some('ü')
        );
        assert_eq!(decode(b"\xef\xbb\xbf<robot/>").expect("UTF-8"), "<robot/>");
        assert_eq!(decode(b"\n<!--\xfc-->"), Err(TextFault::Encoding { declared: None, line: 2 }));
        let declared = decode(b"<?xml version=\"1.0\" encoding=\"windows-1252\"?>\n\n<!--\x93-->");
        assert_eq!(declared, Err(TextFault::Encoding { declared: Some("windows-1252".into()), line: 3 }));
    }
}
