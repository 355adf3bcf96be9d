/// One entry of a published table beside what this project computes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The table's name of the run, with the setting where there are two readings of it.
    pub case: &'static str,
    /// What is measured.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The published value.
    pub paper: f64,
    /// The value computed here; `None` where what is published does not suffice to compute it.
    pub ours: Option<f64>,
    /// Why there is no value, or why it differs; empty if there is nothing to say.
    pub remark: &'static str,
}

impl Row {
    /// `(ours - paper) / paper`.
    #[must_use]
    pub fn difference(&self) -> Option<f64> {
        self.ours.map(|ours| (ours - self.paper) / self.paper)
    }
}
