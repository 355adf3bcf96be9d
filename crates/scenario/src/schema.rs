//! JSON Schemas of scenario files, from the very types that read them.

use crate::conditioning::ConditioningScenario;
use crate::speed::Scenario;
use crate::tables::ScenarioFile;
use crate::tables::conditioning::ConditioningFile;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

impl Scenario {
    /// The JSON Schema of scenario files of this kind, for editors: keys, kinds of values and what each is. It accepts every file that is
    /// read; one that it accepts may still be refused for what its values mean.
    #[must_use]
    pub fn schema() -> Value {
        schema_of::<ScenarioFile>("slideway scenario: a robot whose speed along a path is regulated")
    }
}

impl ConditioningScenario {
    /// As [`Scenario::schema`].
    #[must_use]
    pub fn schema() -> Value {
        schema_of::<ConditioningFile>("slideway scenario: a reference that is kept inside constraints")
    }
}

fn schema_of<T: JsonSchema>(title: &str) -> Value {
    // Draft 7 is what editors of TOML read.
    let settings = SchemaSettings::draft07().with_transform(RecursiveTransform(without_null));
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    schema.insert("title".into(), title.into());
    schema.into()
}

/// Takes null away: a key of TOML that has no value is left out.
fn without_null(schema: &mut Schema) {
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|kind| kind != "null");
        if let [only] = types.as_slice() {
            let only = only.clone();
            schema.insert("type".into(), only);
        }
    }
    let Some(Value::Array(choices)) = schema.get_mut("anyOf") else { return };
    choices.retain(|choice| choice["type"] != "null");
    if let [Value::Object(only)] = choices.as_slice() {
        let only = only.clone();
        schema.remove("anyOf");
        for (key, value) in only {
            schema.ensure_object().entry(key).or_insert(value);
        }
    }
}
