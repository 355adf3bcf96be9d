use crate::say::table::Table;
use crate::say::words::short;
use serde::Serialize;
use slideway_lab::{Agreement, Published};

/// What `--json` prints.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Reproduction {
    pub(super) rows: Vec<Row>,
    /// Rows that agree with what is printed.
    agreeing: usize,
    /// Rows that agreed before and no longer do.
    pub(super) lost: usize,
}

/// A published value with what follows from it.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Row {
    #[serde(flatten)]
    published: Published,
    /// `(ours - paper) / paper`; null without a value or where the paper's is 0.
    difference: Option<f64>,
    agreement: Agreement,
    /// Whether it agreed before and no longer does.
    lost: bool,
}

impl Reproduction {
    pub(super) fn new(published: Vec<Published>) -> Self {
        let row = |published: Published| Row {
            difference: published.difference().filter(|d| d.is_finite()),
            agreement: published.agreement(),
            lost: published.is_lost(),
            published,
        };
        let rows: Vec<Row> = published.into_iter().map(row).collect();
        let agreeing = rows.iter().filter(|r| r.agreement == Agreement::Agrees).count();
        let lost = rows.iter().filter(|r| r.lost).count();
        Self { rows, agreeing, lost }
    }

    pub(super) fn sentence(&self) -> String {
        let known = self.rows.len() - self.agreeing - self.lost;
        let mut text = format!("{} of {} values agree with what is printed", self.agreeing, self.rows.len());
        text += &format!("; {known} are known not to, each with its reason.");
        if self.lost > 0 {
            text += &format!(" No longer agreeing: {}.", self.lost);
        }
        text
    }

    pub(super) fn table(&self) -> Table {
        let header = ["source", "case", "quantity", "paper", "ours", "difference", "agrees", "remark"];
        let mut table = Table::new(header).numbers(3..6);
        for row in &self.rows {
            table.row(row.cells());
        }
        table
    }
}

impl Row {
    fn cells(&self) -> [String; 8] {
        let Published { source, case, quantity, unit, paper, ours, remark, .. } = &self.published;
        let agrees = match (self.agreement, self.lost) {
            (_, true) => "no longer",
            (Agreement::Agrees, _) => "yes",
            (Agreement::Differs, _) => "no, known",
            (Agreement::NotComputed, _) => "not computed",
        };
        [
            (*source).to_owned(),
            case.clone(),
            if unit.is_empty() { (*quantity).to_owned() } else { format!("{quantity} [{unit}]") },
            Some(format!("{paper}")).filter(|digits| digits.len() < 9).unwrap_or_else(|| short(*paper)),
            ours.map_or("-".to_owned(), digits),
            self.difference.filter(|_| !unit.is_empty()).map_or("-".to_owned(), |d| format!("{:+.2} %", 100.0 * d)),
            agrees.to_owned(),
            (*remark).to_owned(),
        ]
    }
}

/// Four significant digits and more, so that none of a printed value's is lost.
fn digits(value: f64) -> String {
    if (10.0..10_000.0).contains(&value) { format!("{value:.2}") } else { short(value) }
}
