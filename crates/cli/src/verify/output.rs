//! What a campaign leaves in its folder: `verify.json`, `junit.xml`, `report.html`, figures and failing scenarios.

use crate::keep::files;
use crate::say::diagnostic::CliError;
use crate::say::output::{create, json_text, withdraw, wrote_figures};
use crate::verify::journal::{CampaignIdentity, SmallestCase};
use crate::verify::results::{GuaranteeResult, Results, checks_of, file_of};
use crate::verify::{junit, page};
use slideway_figures::{Rendered, TrialPoint, TrialsPanel, TrialsStudy, draw_trials};
use slideway_verify::{Check, Trial};
use std::path::Path;

/// A finished campaign, or a finished share of one.
pub(crate) struct Finished<'a> {
    pub(crate) identity: &'a CampaignIdentity,
    pub(crate) trials: &'a [Trial],
    pub(crate) smallest: &'a [SmallestCase],
}

impl Finished<'_> {
    pub(crate) fn results(&self) -> Results {
        Results::new(self.identity, self.trials, self.smallest)
    }

    /// Writes the scenarios of the failing cases, with the files they name.
    pub(crate) fn write_failing(&self, out: &Path) -> Result<(), CliError> {
        if !self.smallest.is_empty() {
            files::write(&self.identity.files, out)?;
        }
        self.smallest.iter().try_for_each(|case| write(out, &file_of(&case.guarantee), case.scenario.as_bytes()))
    }

    /// Writes everything that is about the whole campaign.
    pub(crate) fn write_all(&self, results: &Results, out: &Path) -> Result<(), CliError> {
        self.write_failing(out)?;
        withdraw(&out.join("verify.json"))?;
        create(out.join("junit.xml"), |file| file.write_all(&junit::render(results)?))?;
        let figures: Vec<Rendered> = self.draw(results, out)?.into_iter().collect();
        write(out, "report.html", page::render(results, &self.identity.text, &figures).as_bytes())?;
        write(out, "verify.json", json_text(results)?.as_bytes())
    }

    /// Every check of every guarantee against the size of the trial's disturbances; nothing without checks.
    fn draw(&self, results: &Results, out: &Path) -> Result<Option<Rendered>, CliError> {
        let checked = results.guarantees.iter().filter(|g| g.trials_checked > 0);
        let panels: Vec<TrialsPanel<'_>> = checked
            .map(|g| {
                let points = checks_of(&g.name, self.trials).map(point).collect();
                TrialsPanel { name: &g.name, unit: &g.unit, bounds: bounds(g), points }
            })
            .collect();
        if panels.is_empty() {
            return Ok(None);
        }
        let study = TrialsStudy { title: &results.scenario, panels: &panels };
        let figure = draw_trials(&study, &out.join("figures"))?;
        wrote_figures(std::slice::from_ref(&figure));
        Ok(Some(figure))
    }
}

fn point((trial, check): (&Trial, &Check)) -> TrialPoint {
    TrialPoint { size: trial.size, measured: check.measured, margin: check.margin }
}

/// The bounds of a guarantee that are those of every trial.
fn bounds(result: &GuaranteeResult) -> Vec<f64> {
    result.stated.iter().flat_map(|g| [g.lower, g.upper]).flatten().collect()
}

fn write(out: &Path, file: &str, bytes: &[u8]) -> Result<(), CliError> {
    create(out.join(file), |out| out.write_all(bytes))
}
