//! The results as JUnit XML: one suite, a case per hypothesis and per guarantee. Without times, so that the same trials give
//! the same bytes.

use crate::verify::results::{GuaranteeResult, HypothesisResult, Results};
use crate::verify::words::{failing, kept, needed};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};
use std::io;

type Xml = Writer<Vec<u8>>;

/// The results as the text of a JUnit file.
pub(crate) fn render(results: &Results) -> io::Result<Vec<u8>> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let (name, counts) = (format!("slideway verify {}", results.scenario), counts(results));
    let counts: Vec<(&str, &str)> = counts.iter().map(|(key, count)| (*key, count.as_str())).collect();
    xml.create_element("testsuites").with_attributes(counts.clone()).write_inner_content(|xml| {
        let suite = xml.create_element("testsuite").with_attribute(("name", name.as_str())).with_attributes(counts);
        suite.write_inner_content(|xml| cases(xml, results))?;
        Ok(())
    })?;
    let mut text = xml.into_inner();
    text.push(b'\n');
    Ok(text)
}

fn counts(results: &Results) -> [(&'static str, String); 4] {
    let nothing = usize::from(!results.checked());
    let unchecked = results.guarantees.iter().filter(|g| !g.checked()).count();
    let broken = results.guarantees.iter().filter(|g| !g.kept()).count();
    let failures = nothing + broken + results.hypotheses.iter().filter(|h| !h.holds).count();
    let tests = 1 + results.hypotheses.len() + results.guarantees.len();
    [
        ("tests", tests.to_string()),
        ("failures", failures.to_string()),
        ("errors", "0".into()),
        ("skipped", unchecked.to_string()),
    ]
}

fn cases(xml: &mut Xml, results: &Results) -> io::Result<()> {
    let class = |part: &str| format!("{}.{part}", results.scenario);
    let case = xml.create_element("testcase").with_attribute(("classname", class("campaign").as_str()));
    case.with_attribute(("name", "something-was-checked")).write_inner_content(|xml| campaign(xml, results))?;
    results.hypotheses.iter().try_for_each(|hypothesis| of_hypothesis(xml, &class("hypotheses"), hypothesis))?;
    results.guarantees.iter().try_for_each(|guarantee| of_guarantee(xml, &class("guarantees"), guarantee, results.seed))
}

/// A campaign that checked nothing proves nothing.
fn campaign(xml: &mut Xml, results: &Results) -> io::Result<()> {
    if results.checked() {
        text(xml, "system-out", &format!("{} trials from seed {}", results.trials, results.seed))
    } else {
        failure(xml, &results.verdict, "campaign", &results.verdict)
    }
}

fn of_hypothesis(xml: &mut Xml, class: &str, result: &HypothesisResult) -> io::Result<()> {
    let numbers = needed(&result.hypothesis);
    let case =
        xml.create_element("testcase").with_attributes([("classname", class), ("name", &result.hypothesis.name)]);
    if result.holds {
        return case.write_inner_content(|xml| text(xml, "system-out", &numbers)).map(drop);
    }
    let remedy = result.hypothesis.remedy.as_ref().map_or(String::new(), |remedy| format!("\n{remedy}"));
    let body = format!("{}\n{numbers}{remedy}", result.hypothesis.text);
    case.write_inner_content(|xml| failure(xml, &numbers, "hypothesis", &body)).map(drop)
}

fn of_guarantee(xml: &mut Xml, class: &str, result: &GuaranteeResult, seed: u64) -> io::Result<()> {
    let case = xml.create_element("testcase").with_attributes([("classname", class), ("name", &result.name)]);
    if !result.kept() {
        let what = failing(result, seed);
        let message = what.first().map_or("", String::as_str);
        return case.write_inner_content(|xml| failure(xml, message, "guarantee", &what.join("\n"))).map(drop);
    }
    if !result.checked() {
        let message = ("message", "never checked: no trial kept its hypotheses");
        return case
            .write_inner_content(|xml| xml.create_element("skipped").with_attribute(message).write_empty().map(drop))
            .map(drop);
    }
    case.write_inner_content(|xml| text(xml, "system-out", &kept(result))).map(drop)
}

fn failure(xml: &mut Xml, message: &str, kind: &str, body: &str) -> io::Result<()> {
    let failure = xml.create_element("failure").with_attributes([("message", message), ("type", kind)]);
    failure.write_text_content(BytesText::new(body)).map(drop)
}

fn text(xml: &mut Xml, element: &str, body: &str) -> io::Result<()> {
    xml.create_element(element).write_text_content(BytesText::new(body)).map(drop)
}
