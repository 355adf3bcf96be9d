//! The scenario file of a path-conditioning study as it is written.

use super::CompareTable;
use super::number::Number;
use super::path::PositionTable;
use super::verify_options::PathVerifyTable;
use serde::Deserialize;

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConditioningFile {
    #[serde(default)]
    pub(crate) description: String,
    pub(crate) reference: ReferenceTable,
    pub(crate) constraint: Vec<ConstraintTable>,
    pub(crate) conditioner: ConditionerTable,
    pub(crate) trap: Option<TrapTable>,
    #[serde(default)]
    pub(crate) potential_field: PotentialFieldTable,
    #[serde(default)]
    pub(crate) compare: CompareTable,
    #[serde(default)]
    pub(crate) disturbances: PathDisturbancesTable,
    #[serde(default)]
    pub(crate) verify: PathVerifyTable,
}

/// What happens in a run and the conditioner does not know of.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PathDisturbancesTable {
    pub(crate) seed: Option<u64>,
    pub(crate) initial_error: Option<[Number; 3]>,
    pub(crate) distance_noise: Option<Number>,
    pub(crate) delay: Option<u32>,
    pub(crate) jitter: Option<Number>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ReferenceTable {
    #[serde(default)]
    pub(crate) start: Number,
    pub(crate) end: Number,
    pub(crate) rate: Number,
    pub(crate) position: PositionTable,
    pub(crate) max_duration: Option<Number>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConstraintTable {
    pub(crate) name: String,
    pub(crate) shape: ShapeTable,
    pub(crate) approach: Number,
    pub(crate) motion: Option<MotionTable>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum SideName {
    Inside,
    Outside,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum ShapeTable {
    HalfSpace { normal: [Number; 3], offset: Number },
    Polytope { normals: Vec<[Number; 3]>, offsets: Vec<Number>, sharpness: Number, side: SideName },
    Sphere { centre: [Number; 3], radius: Number, side: SideName },
    Ellipsoid { centre: [Number; 3], semi_axes: [Number; 3], scale: Number, side: SideName },
    Cylinder { point: [Number; 3], axis: [Number; 3], radius: Number, side: SideName },
    Box { centre: [Number; 3], half_edges: [Number; 3], exponent: Number, scale: Number, side: SideName },
    BoothOval { weights: [Number; 3], radius: Number, side: SideName },
    Formula(String),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum MotionTable {
    Uniform {
        velocity: [Number; 3],
        #[serde(default)]
        acceleration: [Number; 3],
    },
    Oscillation {
        amplitude: [Number; 3],
        frequency: Number,
        #[serde(default)]
        phase: Number,
    },
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConditionerTable {
    pub(crate) sampling_period: Number,
    pub(crate) push_cutoff: Number,
    pub(crate) law: LawTable,
    #[serde(default)]
    pub(crate) margin: MarginTable,
    pub(crate) reserve_rate: Option<Number>,
    pub(crate) recovery_rate: Option<Number>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum LawTable {
    Normalised { amplitude: Number },
    Sum { gain: Number },
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum MarginTable {
    #[default]
    None,
    Band,
    Fixed(Vec<Number>),
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TrapTable {
    pub(crate) walk: WalkTable,
    pub(crate) walk_speed: Number,
    pub(crate) walk_growth: Option<Number>,
    pub(crate) walk_cutoff: Number,
    pub(crate) pace_cutoff: Number,
    pub(crate) return_gain: Number,
    pub(crate) direction_period: Number,
    pub(crate) distance_threshold: Number,
    pub(crate) clearance_threshold: Number,
    pub(crate) activity_threshold: Number,
    #[serde(default)]
    pub(crate) seed: u64,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum WalkTable {
    Paper,
    Safe { push_share: Number },
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PotentialFieldTable {
    pub(crate) attraction: Option<Number>,
    pub(crate) repulsion: Option<Number>,
    pub(crate) influence: Option<Number>,
}
