//! The schemas that editors check scenario files by, held against what reads them.

use jsonschema::Validator;
use serde_json::Value;
use slideway_scenario::{AnyScenario, BUILT_IN, CONDITIONING_TEMPLATE, ConditioningScenario, Scenario, TEMPLATE};

/// A kind of scenario: its reader and its schema.
struct Kind {
    reads: fn(&str) -> bool,
    schema: Validator,
}

fn kinds() -> [Kind; 2] {
    let schema = |schema: Value| jsonschema::validator_for(&schema).expect("a schema");
    [
        Kind { reads: |text| Scenario::parse("mine", text).is_ok(), schema: schema(Scenario::schema()) },
        Kind {
            reads: |text| ConditioningScenario::parse("mine", text).is_ok(),
            schema: schema(ConditioningScenario::schema()),
        },
    ]
}

/// The texts of each kind: the built-in scenarios, the template, and the template with every key that it only comments.
fn texts(kind: usize) -> Vec<String> {
    let is_of_kind = |text: &&str| match AnyScenario::parse("mine", text).expect("read") {
        AnyScenario::Speed(_) => kind == 0,
        AnyScenario::Conditioning(_) => kind == 1,
    };
    let built_in = BUILT_IN.iter().map(|b| b.text).filter(is_of_kind);
    let template = [TEMPLATE, CONDITIONING_TEMPLATE][kind];
    let more = [
        "\n[natural]\nshare = 0.5\n[disturbances]\nseed = 1\njoint_noise = 1e-4\n[verify]\ntrials = 9\ndelay = 2\n",
        "\n[trap]\nwalk.safe.push_share = 0.4\nwalk_speed = 2\nwalk_cutoff = 20\npace_cutoff = 20\nreturn_gain = 5\ndirection_period = 0.1\n\
         distance_threshold = 0.05\nclearance_threshold = 0.05\nactivity_threshold = 0.01\n[disturbances]\ndelay = 1\n[verify]\nseed = 3\n",
    ][kind];
    built_in.chain([template]).map(str::to_owned).chain([template.to_owned() + more]).collect()
}

fn json(table: &toml::Table) -> Value {
    serde_json::to_value(table).expect("no dates")
}

#[test]
fn every_built_in_scenario_and_both_templates_are_valid() {
    for (number, kind) in kinds().iter().enumerate() {
        let texts = texts(number);
        assert!(texts.len() >= 6, "{number}: {}", texts.len());
        for text in texts {
            let table: toml::Table = text.parse().expect("TOML");
            assert!((kind.reads)(&text), "{text}");
            let errors: Vec<String> =
                kind.schema.iter_errors(&json(&table)).map(|e| format!("{}: {e}", e.instance_path())).collect();
            assert!(errors.is_empty(), "{errors:?}\n{text}");
        }
    }
}

/// A change of a table somewhere in a scenario.
type Change = fn(&mut toml::Table, &str);

/// The file as changed at every place of every table.
fn changed(table: &toml::Table, change: Change, at_keys: bool) -> Vec<toml::Table> {
    let mut all = Vec::new();
    visit(&table.clone().into(), &mut Vec::new(), &mut |path, found| {
        let keys: Vec<String> = if at_keys { found.keys().cloned().collect() } else { vec![String::new()] };
        for key in keys {
            let mut copy = toml::Value::from(table.clone());
            let mut place = &mut copy;
            for step in path {
                place = match step {
                    Step::Key(key) => &mut place[key.as_str()],
                    Step::Index(index) => &mut place[*index],
                };
            }
            change(place.as_table_mut().expect("a table"), &key);
            all.push(copy.as_table().expect("a table").clone());
        }
    });
    all
}

#[derive(Clone)]
enum Step {
    Key(String),
    Index(usize),
}

/// Calls for every table in a value, with the way to it.
fn visit(value: &toml::Value, path: &mut Vec<Step>, call: &mut impl FnMut(&[Step], &toml::Table)) {
    let children: Vec<(Step, &toml::Value)> = match value {
        toml::Value::Table(table) => {
            call(path, table);
            table.iter().map(|(key, value)| (Step::Key(key.clone()), value)).collect()
        }
        toml::Value::Array(list) => list.iter().enumerate().map(|(k, value)| (Step::Index(k), value)).collect(),
        _ => Vec::new(),
    };
    for (step, child) in children {
        path.push(step);
        visit(child, path, call);
        path.pop();
    }
}

/// The reader and the schema take or refuse the same of these; how many they refuse.
fn agree(kind: &Kind, tables: &[toml::Table]) -> usize {
    let mut refused = 0;
    for table in tables {
        let text = toml::to_string(table).expect("a table");
        let (reads, valid) = ((kind.reads)(&text), kind.schema.is_valid(&json(table)));
        assert_eq!(reads, valid, "read: {reads}, valid by the schema: {valid}\n{text}");
        refused += usize::from(!reads);
    }
    refused
}

#[test]
fn the_schema_refuses_what_the_reader_refuses_an_unknown_key_a_missing_key_a_value_of_no_kind() {
    let changes: [(Change, bool); 3] = [
        (|table, _| drop(table.insert("wlk".into(), 3.into())), false),
        (|table, key| drop(table.remove(key)), true),
        (|table, key| drop(table.insert(key.into(), true.into())), true),
    ];
    for (number, kind) in kinds().iter().enumerate() {
        for text in texts(number) {
            let table: toml::Table = text.parse().expect("TOML");
            for (change, at_keys) in changes {
                assert!(agree(kind, &changed(&table, change, at_keys)) > 3, "{text}");
            }
        }
    }
}

#[test]
fn every_unknown_key_that_a_test_of_the_reader_names_is_refused_by_the_schema() {
    let [speed, conditioning] = kinds();
    let with = |template: &str, from: &str, to: &str| {
        assert!(template.contains(from), "{from}");
        template.replacen(from, to, 1)
    };
    for (kind, text) in [
        (&speed, with(TEMPLATE, "gain = 10", "gian = 10")),
        (&speed, with(TEMPLATE, "[limits]", "[limit]")),
        (&speed, with(TEMPLATE, "# [disturbances]", "[disturbances]\nnoise = 1")),
        (&speed, with(TEMPLATE, "# [disturbances]", "[disturbances]\ndistance_noise = 1e-3")),
        (&speed, with(TEMPLATE, "# [verify]", "[verify]\ndistance_noise = 1e-3")),
        (&speed, with(TEMPLATE, "# [natural]", "[natural]\nspeed = 1")),
        (&conditioning, with(CONDITIONING_TEMPLATE, "push_cutoff = 20", "push_cutof = 20")),
        (&conditioning, with(CONDITIONING_TEMPLATE, "# [disturbances]", "[disturbances]\njoint_noise = 1e-3")),
    ] {
        let table: toml::Table = text.parse().expect("TOML");
        assert!(!(kind.reads)(&text) && !kind.schema.is_valid(&json(&table)), "{text}");
    }
}
