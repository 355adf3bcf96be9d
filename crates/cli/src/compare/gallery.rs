//! Every built-in scenario, one page.

use crate::compare::compared::{CompareOptions, Compared, KeyFigures};
use crate::compare::one::compare;
use crate::say::diagnostic::CliError;
use crate::say::loaded::scenario_error;
use crate::say::output::{Outcome, create, print_answer, print_json, progress, tell_verbose, withdraw, write_summary};
use crate::say::page::page_head;
use crate::say::table::Table;
use crate::say::words::decimals;
use serde::Serialize;
use slideway_compare::CertifiedFor;
use slideway_scenario::{AnyScenario, BUILT_IN, Expectation};
use std::path::Path;

/// One scenario of the gallery.
#[derive(Clone, Debug, Serialize)]
struct Entry {
    scenario: &'static str,
    description: String,
    #[serde(flatten)]
    key: KeyFigures,
    holds: bool,
    expected: Expectation,
    as_expected: bool,
    verdict: String,
}

/// What `--all` writes as `summary.json`.
#[derive(Clone, Debug, Serialize)]
struct Gallery {
    scenarios: Vec<Entry>,
    all_as_expected: bool,
}

/// Compares on every built-in scenario, into a folder each, and writes `index.html` and `summary.json` about them all.
pub(crate) fn run(options: &CompareOptions, out: &Path, json: bool) -> Result<Outcome, CliError> {
    withdraw(&out.join("summary.json"))?;
    let bar = progress(BUILT_IN.len() as u64);
    let mut scenarios = Vec::new();
    for built_in in &BUILT_IN {
        bar.println(built_in.name);
        tell_verbose(|| built_in.name.to_owned());
        let loaded = AnyScenario::parse(built_in.name, built_in.text)
            .map_err(|error| scenario_error(error, built_in.name, Some(built_in.text.to_owned())))?;
        let compared = compare(&loaded, built_in.name, options, &out.join(built_in.name))?;
        scenarios.push(Entry::new(built_in.name, &loaded, compared));
        bar.inc(1);
    }
    bar.finish_and_clear();
    let gallery = Gallery { all_as_expected: scenarios.iter().all(|s| s.as_expected), scenarios };
    create(out.join("index.html"), |file| file.write_all(gallery.page().as_bytes()))?;
    write_summary(out, &gallery)?;
    gallery.show(json, out)?;
    Ok(if gallery.all_as_expected { Outcome::Holds } else { Outcome::Fails })
}

impl Entry {
    fn new(scenario: &'static str, loaded: &AnyScenario, compared: Compared) -> Self {
        let expected = loaded.expectation();
        Self {
            scenario,
            description: loaded.description().to_owned(),
            key: compared.key,
            holds: compared.holds,
            expected,
            as_expected: compared.holds == (expected == Expectation::Holds),
            verdict: compared.sentence,
        }
    }

    fn cells(&self) -> [String; 6] {
        let number = |value: Option<f64>| value.map_or("-".into(), |v| decimals(v, 4));
        let verdict = match (self.holds, self.as_expected) {
            (true, true) => "yes",
            (false, true) => "no, as expected",
            (true, false) => "yes, against expectation",
            (false, false) => "no",
        };
        [
            self.scenario.to_owned(),
            number(self.key.optimum_s),
            self.key.gap.map_or("-".into(), |gap| format!("{gap:.1e}")),
            self.key.certified_for.map_or("-", CertifiedFor::short).to_owned(),
            number(self.key.ratio),
            verdict.to_owned(),
        ]
    }
}

impl Gallery {
    fn show(&self, json: bool, out: &Path) -> Result<(), CliError> {
        if json {
            return print_json(self);
        }
        let (table, sentence) = (self.table().terminal(), self.sentence());
        let unexpected = self.scenarios.iter().filter(|s| !s.as_expected);
        let failed: String = unexpected.map(|s| format!("{}: {}\n", s.scenario, s.verdict)).collect();
        let whole = format!("{table}\n{sentence}\nwrote {}\n", out.join("index.html").display());
        print_answer(&whole, &format!("{failed}{sentence}\n"))
    }

    fn table(&self) -> Table {
        let mut table = Table::new(["scenario", "T* [s]", "gap", "holds for", "ratio", "verdict"]).numbers(1..5);
        for entry in &self.scenarios {
            let words = format!("{}. {}", entry.description, entry.verdict);
            table.row(entry.cells()).link(format!("{}/report.html", entry.scenario)).words(words);
        }
        table
    }

    fn sentence(&self) -> String {
        let unexpected = self.scenarios.iter().filter(|s| !s.as_expected).count();
        match unexpected {
            0 => format!("All {} verdicts are as expected.", self.scenarios.len()),
            n => format!("{n} of {} verdicts are not as expected.", self.scenarios.len()),
        }
    }

    fn page(&self) -> String {
        format!(
            "{}<h1>Gallery</h1>\n<p class=\"verdict {}\">{}</p>\n{}\
             <p class=\"note\">T* is the certified time optimum, gap the relative distance of its bounds; they hold for the whole path, for the whole of the \
             spline that stands for a path of the tool, or at the nodes of a grid alone. The ratio is the judged \
             method's time over T*; for conditioning its mean deviation over that of the projection.</p>\n</main>\n</body>\n</html>\n",
            page_head("Gallery"),
            if self.all_as_expected { "holds" } else { "fails" },
            self.sentence(),
            self.table().html(),
        )
    }
}
