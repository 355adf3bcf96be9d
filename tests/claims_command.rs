//! The commands `slideway claims` and `slideway attack`, in an empty folder.

mod support;

use std::path::Path;
use support::{json, slideway, stdout};

#[test]
fn claims_prints_the_ledger_of_one_claim_with_its_margins() {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(folder.path(), &["claims", "frozen-band", "--cases", "500", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let ledger = json(&stdout(&output));
    let claim = &ledger[0];
    assert_eq!(claim["name"], "frozen-band");
    assert_eq!(claim["proof"], "proven");
    for property in claim["properties"].as_array().expect("list") {
        assert_eq!(property["cases"], 500);
        assert!(property["smallest_margin"].as_f64().expect("a margin") >= 0.0 && property["violation"].is_null());
    }
}

#[test]
fn a_claim_that_does_not_exist_is_answered_with_the_nearest_one() {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(folder.path(), &["claims", "frozen-bend"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("did you mean `frozen-band`?"));
}

#[test]
fn claims_draws_the_counterexamples_that_the_ledger_shows() {
    let folder = tempfile::tempdir().expect("folder");
    for refutation in slideway_proofs::refuted::REFUTED {
        let output = slideway(folder.path(), &["claims", refutation.claim, "--cases", "1", "--out", "claims"]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let figure = format!("figures/{}/counterexample", refutation.claim);
        let drawn = |ending: &str| std::fs::read(folder.path().join("claims").join(format!("{figure}.{ending}")));
        let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../proofs").join(format!("{figure}.svg"));
        assert!(std::fs::read(&kept).expect("kept") == drawn("svg").expect("svg"), "{} is not current", kept.display());
        assert!(drawn("png").expect("png").starts_with(b"\x89PNG"));
        let page = std::fs::read_to_string(folder.path().join("claims/report.html")).expect("page");
        assert!(page.contains(refutation.claim) && page.contains("<svg") && page.contains("No violation"));
    }
    let claims = std::fs::read_to_string(folder.path().join("claims/claims.json")).expect("claims");
    assert_eq!(json(&claims)[0]["properties"][0]["seed"], 1);
}

#[test]
fn what_an_attack_found_can_be_seen_again() {
    let folder = tempfile::tempdir().expect("folder");
    let arguments = ["attack", "transpose-descent", "--minutes", "0.002", "--out", "found"];
    assert_eq!(slideway(folder.path(), &arguments).status.code(), Some(0));
    let file = "found/transpose-descent-the_potential_falls_by_the_square_of_the_speeds.json";
    let kept = json(&std::fs::read_to_string(folder.path().join(file)).expect("file"));
    let output = slideway(folder.path(), &["claims", "--replay", file]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let shown = stdout(&output);
    // The same bits: the margin is written and read with all its digits.
    let margin = format!("{:e}", kept["margin"].as_f64().expect("margin"));
    assert!(shown.contains("verdict   holds") && shown.contains(&margin), "{shown}");
    assert!(shown.contains("V = ½ eᵀ K e falls"), "{shown}");
}

#[test]
fn the_closest_case_can_be_seen_again_by_its_number() {
    let folder = tempfile::tempdir().expect("folder");
    let ledger = json(&stdout(&slideway(folder.path(), &["claims", "computed-torque", "--cases", "300", "--json"])));
    let property = &ledger[0]["properties"][0];
    let case = property["closest_case"].to_string();
    let shown = stdout(&slideway(folder.path(), &["claims", "computed-torque", "--case", &case]));
    let margin = format!("{:e}", property["smallest_margin"].as_f64().expect("margin"));
    assert!(shown.contains(&margin), "{shown} {margin}");
}

#[test]
fn a_case_that_cannot_be_replayed_is_an_error_with_its_remedy() {
    let folder = tempfile::tempdir().expect("folder");
    let refused = slideway(folder.path(), &["claims", "--replay", "missing.json"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("slideway attack --out DIR"));
    assert_eq!(slideway(folder.path(), &["claims", "--case", "3"]).status.code(), Some(2));
}

#[test]
fn an_attack_reports_the_smallest_margin_it_found() {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(folder.path(), &["attack", "feedback-band", "--minutes", "0.005"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(stdout(&output).contains("a_trailing_robot_keeps_the_band") && stdout(&output).contains("margin"));
    let refused = slideway(folder.path(), &["attack", "--minutes", "nan"]);
    assert_eq!(refused.status.code(), Some(2));
}
