//! The scenario file of a path-conditioning study as it is written.

use super::CompareTable;
use super::number::Number;
use super::path::PositionTable;
use super::verify_options::PathVerifyTable;
use schemars::JsonSchema;
use serde::Deserialize;

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConditioningFile {
    /// One sentence on what it is for.
    #[serde(default)]
    pub(crate) description: String,
    /// A point that runs along a curve at a constant rate of lambda.
    pub(crate) reference: ReferenceTable,
    /// One to eight constraints sigma(p) <= 0.
    pub(crate) constraint: Vec<ConstraintTable>,
    /// The conditioner.
    pub(crate) conditioner: ConditionerTable,
    /// Trap avoidance; none without this table.
    pub(crate) trap: Option<TrapTable>,
    /// The potential field that is compared with.
    #[serde(default)]
    pub(crate) potential_field: PotentialFieldTable,
    /// The comparison and its verdict.
    #[serde(default)]
    pub(crate) compare: CompareTable,
    /// What happens in a run and the conditioner does not know of.
    #[serde(default)]
    pub(crate) disturbances: PathDisturbancesTable,
    /// Random trials around the scenario.
    #[serde(default)]
    pub(crate) verify: PathVerifyTable,
}

/// What happens in a run and the conditioner does not know of.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PathDisturbancesTable {
    /// Seed of noise and jitter.
    pub(crate) seed: Option<u64>,
    /// Where the conditioned point starts, at rest, relative to the reference, m.
    pub(crate) initial_error: Option<[Number; 3]>,
    /// Noise of the measured sigma, m, uniform up to this.
    pub(crate) distance_noise: Option<Number>,
    /// Samples by which moving constraints are seen late.
    pub(crate) delay: Option<u32>,
    /// A period lasts sampling_period * (1 +- jitter), uniform.
    pub(crate) jitter: Option<Number>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ReferenceTable {
    /// Lambda at the start.
    #[serde(default)]
    pub(crate) start: Number,
    /// Lambda at the end.
    pub(crate) end: Number,
    /// Rate of lambda, 1/s.
    pub(crate) rate: Number,
    /// The curve, m.
    pub(crate) position: PositionTable,
    /// When to give up, s (default: 20 times what the reference needs).
    pub(crate) max_duration: Option<Number>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConstraintTable {
    /// Its name.
    pub(crate) name: String,
    /// The allowed set.
    pub(crate) shape: ShapeTable,
    /// K, s: the boundary is neared with this time constant.
    pub(crate) approach: Number,
    /// How the shape is carried along.
    pub(crate) motion: Option<MotionTable>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum SideName {
    Inside,
    Outside,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
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

#[derive(Clone, Debug, Deserialize, JsonSchema)]
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

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConditionerTable {
    /// Sampling period, s.
    pub(crate) sampling_period: Number,
    /// Cutoff of the push filter, rad/s.
    pub(crate) push_cutoff: Number,
    /// The switching law.
    pub(crate) law: LawTable,
    /// Safety margin of the sliding mode (default: none).
    #[serde(default)]
    pub(crate) margin: MarginTable,
    /// Greatest speed at which the reserve comes back from outside, m/s; no reserve without it.
    pub(crate) reserve_rate: Option<Number>,
    /// The same for the implicit form, m/s (default: 1).
    pub(crate) recovery_rate: Option<Number>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum LawTable {
    Normalised { amplitude: Number },
    Sum { gain: Number },
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum MarginTable {
    #[default]
    None,
    Band,
    Fixed(Vec<Number>),
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TrapTable {
    /// How the walk searches.
    pub(crate) walk: WalkTable,
    /// Kc, m/s.
    pub(crate) walk_speed: Number,
    /// Kv, m/s² (default: as walk_speed).
    pub(crate) walk_growth: Option<Number>,
    /// Cutoff of the walk filter, rad/s.
    pub(crate) walk_cutoff: Number,
    /// Cutoff of the pace filter, rad/s.
    pub(crate) pace_cutoff: Number,
    /// Ke, 1/s.
    pub(crate) return_gain: Number,
    /// T_F, s.
    pub(crate) direction_period: Number,
    /// eps1, m.
    pub(crate) distance_threshold: Number,
    /// eps2, m.
    pub(crate) clearance_threshold: Number,
    /// eps3, m.
    pub(crate) activity_threshold: Number,
    /// Seed of the walk.
    #[serde(default)]
    pub(crate) seed: u64,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum WalkTable {
    Paper,
    Safe { push_share: Number },
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PotentialFieldTable {
    /// Gain of the attraction, 1/s.
    pub(crate) attraction: Option<Number>,
    /// Gain of the repulsion.
    pub(crate) repulsion: Option<Number>,
    /// Distance within which a constraint repels, m.
    pub(crate) influence: Option<Number>,
}
