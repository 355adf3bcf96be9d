//! The same input gives the same bits: between commits, on any number of threads, in debug and in release.

use slideway_lab::conditioning::{ConditionedTrace, PathMethod, run_conditioner};
use slideway_lab::{Experiment, Method, Trace, in_parallel};
use slideway_scenario::ConditioningScenario;
use slideway_scenario::{AnyScenario, BUILT_IN, BuiltIn, Scenario};
use std::collections::{BTreeMap, BTreeSet};
use std::hash::Hasher as _;
use std::io::Write as _;
use std::num::NonZeroUsize;
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

/// Hashes by scenario and method.
type Hashes = BTreeMap<String, BTreeMap<String, String>>;

/// FNV-1a over the bits of numbers.
struct Bits(fnv::FnvHasher);

impl Bits {
    fn add(&mut self, value: f64) {
        // Sign and payload of a NaN are not part of what is computed.
        let value = if value.is_nan() { f64::NAN } else { value };
        self.0.write(&value.to_bits().to_le_bytes());
    }

    fn all<'a>(&mut self, values: impl IntoIterator<Item = &'a f64>) {
        values.into_iter().for_each(|value| self.add(*value));
    }

    fn maybe(&mut self, value: Option<f64>) {
        // What is missing differs from every number.
        self.0.write(&[u8::from(value.is_some())]);
        value.into_iter().for_each(|value| self.add(value));
    }

    fn hex(&self) -> String {
        format!("{:016x}", self.0.finish())
    }
}

fn of_speed_law(trace: &Trace) -> String {
    let mut bits = Bits(fnv::FnvHasher::default());
    bits.maybe(trace.finish_s);
    bits.maybe(trace.arrival_s);
    for s in &trace.samples {
        bits.all(&[s.t, s.lambda, s.path_rate, s.factor, s.switch, s.direction_factor, s.limit_ratio]);
        bits.0.write(&[s.limiting_joint.map_or(u8::MAX, |joint| u8::try_from(joint).expect("few joints"))]);
        bits.all(s.error.iter().chain(&s.q).chain(&s.desired).chain(&s.commanded));
        for value in [s.chatter.map(|c| c.measured), s.chatter.map(|c| c.bound), s.chatter.map(|c| c.estimate)] {
            bits.maybe(value);
        }
    }
    bits.hex()
}

fn of_conditioner(trace: &ConditionedTrace) -> String {
    let mut bits = Bits(fnv::FnvHasher::default());
    bits.maybe(trace.finish_s);
    for s in &trace.samples {
        bits.all(&[s.t, s.lambda]);
        bits.all(
            s.reference.iter().chain(&s.position).chain(&s.sigma).chain(&s.phi).chain(&s.share).chain(&s.gradient),
        );
        bits.all(s.push.iter().chain(&s.walk));
        bits.0.write(s.phase.name().as_bytes());
    }
    bits.hex()
}

/// One trace to be hashed.
enum Run<'a> {
    Speed(&'a BuiltIn, Arc<Experiment>, Method),
    Conditioning(&'a BuiltIn, PathMethod),
}

impl Run<'_> {
    /// Every method of every built-in scenario that runs online.
    fn all() -> Vec<Self> {
        let of = |built_in: &'static BuiltIn| -> Vec<Self> {
            match AnyScenario::parse(built_in.name, built_in.text).expect("built in") {
                AnyScenario::Speed(scenario) => {
                    let experiment = Arc::new(scenario.experiment().expect("built in"));
                    let methods = experiment.methods().into_iter();
                    methods.map(|method| Run::Speed(built_in, Arc::clone(&experiment), method)).collect()
                }
                AnyScenario::Conditioning(_) => {
                    let forms = PathMethod::ALL.into_iter().filter(|method| method.is_conditioner());
                    forms.map(|method| Run::Conditioning(built_in, method)).collect()
                }
            }
        };
        BUILT_IN.iter().flat_map(of).collect()
    }

    fn name(&self) -> (String, String) {
        match self {
            Self::Speed(built_in, _, method) => (built_in.name.into(), method.name().into()),
            Self::Conditioning(built_in, method) => (built_in.name.into(), method.name().into()),
        }
    }

    fn hash(&self) -> String {
        match self {
            Self::Speed(_, experiment, method) => of_speed_law(&experiment.run(*method).expect("runs")),
            Self::Conditioning(built_in, method) => {
                let scenario = ConditioningScenario::parse(built_in.name, built_in.text).expect("built in");
                of_conditioner(&run_conditioner(&scenario.problem().expect("valid"), *method).expect("runs"))
            }
        }
    }
}

/// The hashes of all traces, computed on so many threads.
fn hashes(jobs: usize) -> Hashes {
    let runs = Run::all();
    let jobs = NonZeroUsize::new(jobs).expect("positive");
    let found = in_parallel(&runs, jobs, |run| Ok::<_, slideway_lab::ThreadsError>(run.hash())).expect("threads");
    let mut hashes = Hashes::new();
    for (run, hash) in runs.iter().zip(found) {
        let (scenario, method) = run.name();
        hashes.entry(scenario).or_default().insert(method, hash);
    }
    hashes
}

/// A hash of what the mathematical functions give here. Rust takes them from the system's library, which rounds the last bit as
/// it likes: glibc has two sines, of which it takes one where the processor can fuse a product and a sum.
fn functions() -> String {
    let mut bits = Bits(fnv::FnvHasher::default());
    // Places without order in [-1, 1], many enough that two libraries of different rounding differ at some of them.
    for i in 0..20_000_u32 {
        let x = std::hint::black_box(f64::from(i.wrapping_mul(2_654_435_761)) / f64::from(u32::MAX) * 2.0 - 1.0);
        let (wide, positive) = (20.0 * x, x.abs() + f64::MIN_POSITIVE);
        bits.all(&[wide.sin(), wide.cos(), wide.tan(), x.asin(), x.acos(), wide.atan(), x.atan2(wide + 1.0)]);
        bits.all(&[
            wide.exp(),
            x.exp_m1(),
            positive.ln(),
            positive.powf(wide),
            x.sinh(),
            x.cosh(),
            wide.tanh(),
            x.hypot(wide),
        ]);
    }
    bits.hex()
}

/// The hashes in the file, made anew if that is asked for; none where they do not hold, which is told.
fn stored() -> Option<serde_json::Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/golden/traces.json");
    if std::env::var_os("SLIDEWAY_RENEW_GOLDEN").is_some() {
        let text = serde_json::json!({ "functions": functions(), "traces": hashes(1) });
        std::fs::write(&path, format!("{text:#}\n")).expect("written");
    }
    let stored: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(&path).expect("there")).expect("JSON");
    if stored["functions"] == functions() {
        return Some(stored);
    }
    let reason = "sin, cos or another function of this machine's library rounds otherwise than where tests/golden/traces.json was made";
    assert!(std::env::var_os("SLIDEWAY_REQUIRE_GOLDEN").is_none(), "{reason}");
    // Not by a macro, whose output the test harness would keep to itself.
    writeln!(std::io::stderr(), "golden hashes NOT compared: {reason}").expect("told");
    None
}

#[test]
fn every_trace_has_the_bits_of_its_golden_hash_on_any_number_of_threads() {
    let Some(stored) = stored() else {
        assert_eq!(hashes(1), hashes(2), "threads share nothing");
        return;
    };
    // The stored ones were made on one thread.
    let found = hashes(2);
    let stored: Hashes = serde_json::from_value(stored["traces"].clone()).expect("hashes");
    let differing: Vec<String> = found
        .iter()
        .flat_map(|(scenario, methods)| methods.iter().map(move |(method, hash)| (scenario, method, hash)))
        .filter(|(scenario, method, hash)| stored.get(*scenario).and_then(|s| s.get(*method)) != Some(hash))
        .map(|(scenario, method, _)| format!("{scenario} {method}"))
        .collect();
    assert!(
        differing.is_empty(),
        "other bits than in tests/golden/traces.json (its README says how to renew it): {differing:?}"
    );
    assert_eq!(found, stored, "a scenario or method is gone");
}

#[test]
fn a_bit_anywhere_in_a_trace_changes_its_hash() {
    let scenario = Scenario::built_in("planar-line").expect("built in").expect("parses");
    let trace = scenario.experiment().expect("valid").run(Method::SlidingMode).expect("runs");
    let mut seen = BTreeSet::from([of_speed_law(&trace)]);
    let changes: [fn(&mut Trace); 6] = [
        |t| t.finish_s = None,
        |t| t.samples[7].t = t.samples[7].t.next_up(),
        |t| t.samples[7].q[0] = t.samples[7].q[0].next_up(),
        |t| t.samples[7].error[1] = -t.samples[7].error[1],
        |t| t.samples[7].limiting_joint = Some(5),
        |t| t.samples.truncate(t.samples.len() - 1),
    ];
    for (i, change) in changes.iter().enumerate() {
        let mut other = trace.clone();
        change(&mut other);
        assert!(other != trace && seen.insert(of_speed_law(&other)), "change {i}");
    }
}

/// The lines that a command leaves in its journal, whatever their order.
fn journal(arguments: &[&str], file: &str, jobs: &str) -> BTreeSet<String> {
    let folder = tempfile::tempdir().expect("folder");
    let arguments: Vec<&str> = arguments.iter().copied().chain(["--out", "out", "--jobs", jobs]).collect();
    let output =
        Command::new(env!("CARGO_BIN_EXE_slideway")).args(arguments).current_dir(folder.path()).output().expect("runs");
    assert_ne!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(folder.path().join("out").join(file)).expect("a journal");
    text.lines().map(str::to_owned).collect()
}

#[test]
fn sweeps_and_campaigns_have_the_same_bits_on_one_thread_and_on_two() {
    let sweep = ["sweep", "planar-line", "--grid", "control.bandwidth=5,10,20,40"];
    let seeds = ["sweep", "trap-ellipsoid", "--seeds", "4", "--set", "conditioner.sampling_period=1e-3"];
    let campaign = ["verify", "planar-bend", "--trials", "8"];
    for (arguments, file) in [(&sweep[..], "rows.jsonl"), (&seeds, "rows.jsonl"), (&campaign, "trials.jsonl")] {
        let one = journal(arguments, file, "1");
        assert!(one.len() > 4, "{arguments:?}: {one:?}");
        assert_eq!(one, journal(arguments, file, "2"), "{arguments:?}");
    }
}
