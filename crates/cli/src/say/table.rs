//! A table whose columns are listed once, for a terminal and for a page.

use crate::say::words::escape;
use comfy_table::{CellAlignment, ContentArrangement, LineStyle, TableStyle};
use std::ops::Range;

/// The title of a column, with lines for a terminal, and its cell for a row's thing.
pub(crate) type Column<T> = (&'static str, fn(&T) -> String);

/// A table.
pub(crate) struct Table {
    header: Vec<String>,
    rows: Vec<Row>,
    /// Columns of numbers, which stand on the right in a terminal.
    numbers: Range<usize>,
}

/// A row; on a page its first cell may be a link, and words may stand below it.
struct Row {
    cells: Vec<String>,
    link: Option<String>,
    words: Option<String>,
}

impl Table {
    /// An empty table.
    pub(crate) fn new<S: Into<String>>(header: impl IntoIterator<Item = S>) -> Self {
        Self { header: header.into_iter().map(Into::into).collect(), rows: Vec::new(), numbers: 0..0 }
    }

    /// A row for each thing, a cell for each column; all but the first column are numbers.
    pub(crate) fn of<'a, T: 'a>(columns: &[Column<T>], things: impl IntoIterator<Item = &'a T>) -> Self {
        let mut table = Self::new(columns.iter().map(|(title, _)| *title)).numbers(1..columns.len());
        for thing in things {
            table.row(columns.iter().map(|(_, cell)| cell(thing)));
        }
        table
    }

    /// The same table with these columns on the right.
    pub(crate) fn numbers(self, numbers: Range<usize>) -> Self {
        Self { numbers, ..self }
    }

    /// Adds a row.
    pub(crate) fn row<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) -> &mut Self {
        self.rows.push(Row { cells: cells.into_iter().map(Into::into).collect(), link: None, words: None });
        self
    }

    /// Makes the first cell of the last row a link, on a page.
    pub(crate) fn link(&mut self, to: String) -> &mut Self {
        self.rows.last_mut().into_iter().for_each(|row| row.link = Some(to.clone()));
        self
    }

    /// Puts words below the last row, on a page.
    pub(crate) fn words(&mut self, words: impl Into<String>) -> &mut Self {
        let words = Some(words.into()).filter(|words| !words.is_empty());
        self.rows.last_mut().into_iter().for_each(|row| row.words.clone_from(&words));
        self
    }

    /// The same table with the last column as words below each row.
    pub(crate) fn last_as_words(mut self) -> Self {
        self.header.pop();
        for row in &mut self.rows {
            row.words = row.cells.pop().filter(|words| !words.is_empty());
        }
        self
    }

    /// For a terminal: a line above and below the head, one at the foot, none between rows.
    pub(crate) fn terminal(&self) -> String {
        let line = |fill| LineStyle::none().fill(fill).junction(fill);
        let style = TableStyle::new().top_border(line('─')).header_separator(line('─')).bottom_border(line('─'));
        let mut table = comfy_table::Table::new();
        table.load_style(style).set_content_arrangement(ContentArrangement::Dynamic);
        table.set_header(&self.header);
        table.add_rows(self.rows.iter().map(|row| &row.cells));
        for column in table.column_iter_mut().take(self.numbers.end).skip(self.numbers.start) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table.to_string()
    }

    /// For a terminal, with a line feed; nothing without rows.
    pub(crate) fn terminal_if_any(&self) -> String {
        if self.rows.is_empty() { String::new() } else { self.terminal() + "\n" }
    }

    /// For a page.
    pub(crate) fn html(&self) -> String {
        let title = |(i, title): (usize, &String)| self.cell("th", i, &escape(&title.replace('\n', " ")));
        let head: String = self.header.iter().enumerate().map(title).collect();
        let rows: String = self.rows.iter().map(|row| self.row_html(row)).collect();
        format!("<div class=\"wide\"><table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n")
    }

    fn row_html(&self, row: &Row) -> String {
        let mut cells: Vec<String> = row.cells.iter().map(|cell| escape(cell)).collect();
        if let (Some(to), Some(first)) = (&row.link, cells.first_mut()) {
            *first = format!("<a href=\"{}\">{first}</a>", escape(to));
        }
        let cells: String = cells.iter().enumerate().map(|(i, cell)| self.cell("td", i, cell)).collect();
        let below = |words: &String| {
            let span = self.header.len().saturating_sub(1);
            format!("<tr class=\"words\"><td></td><td colspan=\"{span}\">{}</td></tr>\n", escape(words))
        };
        format!("<tr>{cells}</tr>\n{}", row.words.as_ref().map_or_else(String::new, below))
    }

    fn cell(&self, tag: &str, column: usize, html: &str) -> String {
        let class = if self.numbers.contains(&column) { " class=\"n\"" } else { "" };
        format!("<{tag}{class}>{html}</{tag}>")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_shows_the_cells_of_the_terminal_escaped_with_links_and_words() {
        let columns: [Column<f64>; 2] = [("a <b>\n[m]", |x| format!("<{x}>")), ("2 x", |x| (2.0 * x).to_string())];
        let mut table = Table::of(&columns, &[1.5]);
        table.row(["c", "d"]).link("c/report.html".into()).words("more & more");
        let terminal = table.terminal();
        for cell in ["a <b>", "<1.5>", "3", "c", "d"] {
            assert!(terminal.contains(cell), "{cell}: {terminal}");
        }
        let page = "<thead><tr><th>a &lt;b&gt; [m]</th><th class=\"n\">2 x</th></tr></thead>\n<tbody>\n\
                    <tr><td>&lt;1.5&gt;</td><td class=\"n\">3</td></tr>\n\
                    <tr><td><a href=\"c/report.html\">c</a></td><td class=\"n\">d</td></tr>\n\
                    <tr class=\"words\"><td></td><td colspan=\"1\">more &amp; more</td></tr>\n";
        assert!(table.html().contains(page), "{}", table.html());
    }
}
