use crate::encoding::Encoding;
use csv::{ByteRecord, ReaderBuilder, Trim};
use thiserror::Error;

/// Rows of numbers from a CSV file, all of one width.
///
/// Comma-separated, numbers with a decimal point. Lines that start with `#` and empty lines are skipped, and so is a first
/// row without a single number: the header.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberTable {
    rows: Vec<Vec<f64>>,
    lines: Vec<u64>,
}

/// What is wrong with a CSV file, and where. Lines and columns are counted from 1.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TableError {
    /// A cell that is not a finite number.
    #[error("line {line}, column {column}: `{text}` is not a finite number")]
    NotANumber {
        /// Its line.
        line: u64,
        /// Its column.
        column: usize,
        /// What is there.
        text: String,
    },
    /// A row of the wrong width.
    #[error("line {line}: {found} numbers given, {} needed", list(expected))]
    WrongWidth {
        /// Its line.
        line: u64,
        /// Numbers found.
        found: usize,
        /// Widths accepted.
        expected: Vec<usize>,
    },
    /// Numbers that something other than commas separates.
    #[error("line {line}: the numbers are separated by {}", separator.describe())]
    Separator {
        /// Its line.
        line: u64,
        /// What is there in place of commas.
        separator: Separator,
    },
    /// A file that is not UTF-8.
    #[error("it is {encoding}, not UTF-8")]
    NotUtf8 {
        /// How it is written.
        encoding: Encoding,
    },
    /// The file cannot be read.
    #[error("cannot be read: {reason}")]
    Read {
        /// What the system says.
        reason: String,
    },
    /// What the CSV reader itself refuses.
    #[error("line {line}: {reason}")]
    Unreadable {
        /// Where.
        line: u64,
        /// What it says.
        reason: String,
    },
}

/// What stands between numbers where a comma should.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// `;`, with a decimal comma or point.
    Semicolon,
    /// A tab.
    Tab,
    /// Blanks.
    Blank,
}

impl Separator {
    /// The separator of a line that cannot be read as numbers between commas.
    fn of(text: &str) -> Option<Self> {
        let numbers = |parts: &mut dyn Iterator<Item = &str>| {
            parts
                .filter(|part| !part.trim().is_empty())
                .all(|part| part.trim().replace(',', ".").parse::<f64>().is_ok())
        };
        let text = text.trim();
        match () {
            () if text.contains(';') && numbers(&mut text.split(';')) => Some(Self::Semicolon),
            () if text.contains('\t') && numbers(&mut text.split('\t')) => Some(Self::Tab),
            () if !text.contains(',') && text.contains(' ') && numbers(&mut text.split_whitespace()) => {
                Some(Self::Blank)
            }
            () => None,
        }
    }

    fn describe(self) -> &'static str {
        match self {
            Self::Semicolon => "semicolons",
            Self::Tab => "tabs",
            Self::Blank => "blanks",
        }
    }
}

impl TableError {
    /// What to do about it, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::NotANumber { .. } => {
                "write numbers with a decimal point, separated by commas; names only in the first row"
            }
            Self::WrongWidth { .. } => "give every row as many numbers as a way-point has",
            Self::Separator { .. } => "separate the numbers by commas, and write them with a decimal point",
            Self::NotUtf8 { .. } => "save the file as UTF-8",
            Self::Read { .. } => "give the path of a CSV file, relative to the scenario's folder",
            Self::Unreadable { .. } => "write one way-point a line, numbers separated by commas",
        }
    }
}

fn list(widths: &[usize]) -> String {
    widths.iter().map(ToString::to_string).collect::<Vec<_>>().join(" or ")
}

impl NumberTable {
    /// Reads the bytes of a CSV file whose rows have one of the given widths, the same in all rows.
    ///
    /// # Errors
    ///
    /// A cell that is not a finite number, a row of another width.
    pub fn parse(bytes: &[u8], widths: &[usize]) -> Result<Self, TableError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if Encoding::of(bytes) == Encoding::Utf16 {
            return Err(TableError::NotUtf8 { encoding: Encoding::Utf16 });
        }
        let mut table = Self { rows: Vec::new(), lines: Vec::new() };
        let mut is_first = true;
        // Line by line: of a record after comments or empty lines the CSV reader reports the line of the first of those.
        for (line, text) in (1..).zip(bytes.split(|&b| b == b'\n')).filter(|(_, text)| !text.starts_with(b"#")) {
            if let Some(separator) = std::str::from_utf8(text).ok().and_then(Separator::of) {
                return Err(TableError::Separator { line, separator });
            }
            let mut reader = ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .trim(Trim::All)
                .buffer_capacity(text.len().max(1))
                .from_reader(text);
            for record in reader.byte_records() {
                let record = record.map_err(|error| TableError::Unreadable { line, reason: error.to_string() })?;
                if !(is_first && is_header(&record)) {
                    table.push(line, &record, widths)?;
                }
                is_first = false;
            }
        }
        Ok(table)
    }

    /// The numbers, row by row.
    #[must_use]
    pub fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// The line of each row, counted from 1.
    #[must_use]
    pub fn lines(&self) -> &[u64] {
        &self.lines
    }

    fn push(&mut self, line: u64, record: &ByteRecord, widths: &[usize]) -> Result<(), TableError> {
        let width = self.rows.first().map(Vec::len);
        let expected: Vec<usize> = width.map_or_else(|| widths.to_vec(), |width| vec![width]);
        if !expected.contains(&record.len()) {
            return Err(TableError::WrongWidth { line, found: record.len(), expected });
        }
        let row: Result<Vec<f64>, TableError> = record
            .iter()
            .enumerate()
            .map(|(i, cell)| {
                let text = || String::from_utf8_lossy(cell).into_owned();
                number(cell).ok_or_else(|| TableError::NotANumber { line, column: i + 1, text: text() })
            })
            .collect();
        self.rows.push(row?);
        self.lines.push(line);
        Ok(())
    }
}

fn number(cell: &[u8]) -> Option<f64> {
    std::str::from_utf8(cell).ok()?.parse().ok().filter(|x: &f64| x.is_finite())
}

/// A row with no number in it at all: a typing error in a row of numbers is not taken for a header.
fn is_header(record: &ByteRecord) -> bool {
    record.iter().all(|cell| number(cell).is_none())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn header_comments_blank_lines_and_spaces_are_allowed() {
        let text = "\u{feff}x, y\n# a comment\n\n 1.5, -2\n3e-2,4\r\n";
        let table = NumberTable::parse(text.as_bytes(), &[2]).expect("valid");
        assert_eq!(table.rows(), [[1.5, -2.0], [0.03, 4.0]]);
        assert_eq!(table.lines(), [4, 5]);
        let bare = NumberTable::parse("\u{feff}1,2\n3,4".as_bytes(), &[2, 3]).expect("valid");
        assert_eq!((bare.rows(), bare.lines()), ([vec![1.0, 2.0], vec![3.0, 4.0]].as_slice(), [1, 2].as_slice()));
    }

    #[test]
    fn what_is_wrong_is_named_with_line_and_column() {
        let error = |text: &str| NumberTable::parse(text.as_bytes(), &[2, 3]).err().map(|e| e.to_string());
        assert_eq!(error("x,y\n1,2\n3,four\n").as_deref(), Some("line 3, column 2: `four` is not a finite number"));
        assert_eq!(error("1,2\n3,inf\n").as_deref(), Some("line 2, column 2: `inf` is not a finite number"));
        assert_eq!(error("# c\n1,2\n\n3\n").as_deref(), Some("line 4: 1 numbers given, 2 needed"));
        assert_eq!(error("1,2,3,4\n").as_deref(), Some("line 1: 4 numbers given, 2 or 3 needed"));
        // A typing error in the first row is not taken for a header.
        assert_eq!(error("1,2o\n3,4\n").as_deref(), Some("line 1, column 2: `2o` is not a finite number"));
        assert_eq!(error("x,y\nx,y\n").as_deref(), Some("line 2, column 1: `x` is not a finite number"));
    }

    proptest! {
        #[test]
        fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            check(&bytes)?;
        }

        #[test]
        fn no_text_of_numbers_and_separators_makes_the_reader_panic(text in "[0-9a-z.,#\"\n\r eE+-]{0,120}") {
            check(text.as_bytes())?;
        }
    }

    /// Either an error, or rows of one of the widths, finite, each with its line.
    fn check(bytes: &[u8]) -> Result<(), TestCaseError> {
        if let Ok(table) = NumberTable::parse(bytes, &[2, 3]) {
            prop_assert_eq!(table.rows().len(), table.lines().len());
            let width = table.rows().first().map_or(2, Vec::len);
            prop_assert!(width == 2 || width == 3);
            prop_assert!(table.rows().iter().all(|r| r.len() == width && r.iter().all(|x| x.is_finite())));
        }
        Ok(())
    }
}
