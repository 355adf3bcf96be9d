use super::cell::Cell;
use super::error::SweepError;
use super::request::SweepRequest;
use super::setting::{Axis, overlap};
use slideway_compare::sweep::SweepRow;
use toml::Value;

/// Most runs of a sweep: their rows are kept in memory for the summary.
pub const MAX_RUNS: u64 = 10_000_000;

/// The keys that seeds set: of the random walk, and of the disturbances.
const SEED_KEYS: [&str; 2] = ["trap.seed", "disturbances.seed"];

/// The runs of a sweep, numbered: seeds change fastest, then the last axis, the first axis slowest.
#[derive(Clone, Debug)]
pub struct SweepPlan {
    request: SweepRequest,
    method: String,
    cells: Vec<Cell>,
    columns: Vec<String>,
    runs: usize,
}

impl SweepPlan {
    /// Checks the request and every cell of its grid, before anything runs.
    ///
    /// What only a run can tell, such as a path that leaves the robot's reach, is told by [`SweepPlan::run`].
    ///
    /// # Errors
    ///
    /// What [`SweepError`] lists, for the first cell that it concerns.
    pub fn new(request: SweepRequest) -> Result<Self, SweepError> {
        check_overlaps(&request)?;
        let runs = count(&request)?;
        let cells = combinations(&request.axes)
            .into_iter()
            .map(|values| Cell::new(&request, values))
            .collect::<Result<Vec<_>, _>>()?;
        let columns = cells.first().map(|cell| cell.columns.clone()).unwrap_or_default();
        if cells.iter().any(|cell| cell.columns != columns) {
            return Err(SweepError::Columns);
        }
        if request.seeds.is_some() && !cells.iter().all(Cell::is_random) {
            return Err(SweepError::NothingRandom { scenario: request.name });
        }
        let method = match (&request.method, cells.first()) {
            (Some(method), _) => method.clone(),
            (None, first) => first.map_or(Ok(""), Cell::judged_method)?.to_owned(),
        };
        Ok(Self { request, method, cells, columns, runs })
    }

    /// What was asked for.
    #[must_use]
    pub fn request(&self) -> &SweepRequest {
        &self.request
    }

    /// Name of the method that runs: the one asked for, else the one that a comparison of the first cell judges.
    #[must_use]
    pub fn method(&self) -> &str {
        &self.method
    }

    /// Names of a row's values, with their units.
    #[must_use]
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// The scenario of every cell of the grid, as a text with the settings in it.
    pub fn texts(&self) -> impl Iterator<Item = &str> {
        self.cells.iter().map(Cell::text)
    }

    /// How many runs there are.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.runs
    }

    /// How many grid cells there are; one without a grid.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// The cell of a run.
    #[must_use]
    pub fn cell_of(&self, run: usize) -> usize {
        run / (self.runs / self.cells.len())
    }

    /// Values of the axes in a cell; empty beyond the last.
    #[must_use]
    pub fn cell_values(&self, cell: usize) -> &[Value] {
        self.cells.get(cell).map_or(&[], |cell| &cell.values)
    }

    /// The seed of a run; `None` where the scenario's own is used.
    #[must_use]
    pub fn seed_of(&self, run: usize) -> Option<u64> {
        self.request.seeds.map(|seeds| run as u64 % seeds + 1)
    }

    /// Makes one run.
    ///
    /// # Errors
    ///
    /// [`SweepError::Cell`] where the robot cannot follow the path; [`SweepError::Runs`] beyond the last run.
    pub fn run(&self, run: usize) -> Result<SweepRow, SweepError> {
        match self.cells.get(self.cell_of(run)) {
            Some(cell) => cell.run(run, &self.method, self.seed_of(run)),
            None => Err(SweepError::Runs { runs: run as u64, most: self.runs as u64 }),
        }
    }
}

fn check_overlaps(request: &SweepRequest) -> Result<(), SweepError> {
    let mut keys: Vec<&str> = request.settings.iter().map(|s| s.key.as_str()).collect();
    keys.extend(request.axes.iter().map(|a| a.key.as_str()));
    keys.extend(request.seeds.map(|_| SEED_KEYS).into_iter().flatten());
    for (i, first) in keys.iter().enumerate() {
        // `trap.seed` inside a `trap` that is set as a whole is what seeds are for.
        let clash =
            |second: &&&str| overlap(first, second) && !(SEED_KEYS.contains(second) && first.len() < second.len());
        if let Some(second) = keys[i + 1..].iter().find(clash) {
            return Err(SweepError::Overlap { first: (*first).into(), second: (*second).into() });
        }
    }
    Ok(())
}

#[allow(clippy::cast_possible_truncation)]
fn count(request: &SweepRequest) -> Result<usize, SweepError> {
    let sizes = request.axes.iter().map(|axis| axis.values.len() as u64);
    let runs = sizes.fold(request.seeds.unwrap_or(1), u64::saturating_mul);
    if (1..=MAX_RUNS).contains(&runs) { Ok(runs as usize) } else { Err(SweepError::Runs { runs, most: MAX_RUNS }) }
}

/// Every combination of the axes' values, the last axis fastest.
fn combinations(axes: &[Axis]) -> Vec<Vec<Value>> {
    axes.iter().fold(vec![Vec::new()], |cells, axis| {
        let extended = |cell: &Vec<Value>, value: &Value| cell.iter().chain([value]).cloned().collect();
        cells.iter().flat_map(|cell| axis.values.iter().map(move |value| extended(cell, value))).collect()
    })
}
