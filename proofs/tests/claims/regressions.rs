use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use slideway_proofs::kept::{KeptCase, KeptError};

fn written(name: &str, text: &str) -> Result<PathBuf, std::io::Error> {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, text)?;
    Ok(path)
}

/// The closest cases that attacks of a minute a claim have found, and whatever was a violation once.
#[test]
fn every_case_kept_holds() -> Result<(), Box<dyn Error>> {
    let mut kept = 0;
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("regressions"))? {
        let path = entry?.path();
        let case = KeptCase::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let replayed = case.replay().map_err(|error| format!("{}: {error}", path.display()))?;
        // A case that is skipped no longer is the one that was found.
        assert!(
            replayed.outcome.as_ref().is_ok_and(|&margin| margin >= 0.0),
            "{}: {:?}",
            path.display(),
            replayed.outcome
        );
        assert_eq!(path.file_name().and_then(|name| name.to_str()), Some(case.file_name().as_str()));
        kept += 1;
    }
    assert!(kept > 0, "no cases are kept");
    Ok(())
}

#[test]
fn a_case_without_its_property_or_with_choices_outside_is_refused() -> Result<(), Box<dyn Error>> {
    let text = |property: &str, choice: f64| {
        format!(r#"{{"claim": "frozen-band", "property": "{property}", "margin": null, "choices": [0.5, {choice}]}}"#)
    };
    let outside = KeptCase::read(&written("outside.json", &text("any", 1.0))?);
    assert!(matches!(outside, Err(KeptError::Choice { index: 1, .. })), "{outside:?}");
    let unknown = KeptCase::read(&written("unknown.json", &text("any", 0.25))?)?.replay();
    assert!(matches!(unknown, Err(KeptError::Unknown { .. })), "{unknown:?}");
    let cut = KeptCase::read(&written("cut.json", "{")?);
    assert!(matches!(cut, Err(KeptError::Text(_))), "{cut:?}");
    assert!(matches!(KeptCase::read(Path::new("no-such-case.json")), Err(KeptError::Read(_))));
    Ok(())
}
