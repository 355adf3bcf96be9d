/// A built-in scenario.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltIn {
    /// Its name on the command line.
    pub name: &'static str,
    /// Its text, the same as a user's file would hold.
    pub text: &'static str,
}

/// The built-in scenarios, tutorial first.
pub const BUILT_IN: [BuiltIn; 16] = [
    BuiltIn { name: "planar-line", text: include_str!("../scenarios/planar-line.toml") },
    BuiltIn { name: "puma-helix", text: include_str!("../scenarios/puma-helix.toml") },
    BuiltIn { name: "puma-helix-on-path", text: include_str!("../scenarios/puma-helix-on-path.toml") },
    BuiltIn { name: "puma-wrist-singularity", text: include_str!("../scenarios/puma-wrist-singularity.toml") },
    BuiltIn { name: "puma-helix-acceleration", text: include_str!("../scenarios/puma-helix-acceleration.toml") },
    BuiltIn { name: "planar-bend", text: include_str!("../scenarios/planar-bend.toml") },
    BuiltIn { name: "tiny-motion", text: include_str!("../scenarios/tiny-motion.toml") },
    BuiltIn { name: "ur5e-poses", text: include_str!("../scenarios/ur5e-poses.toml") },
    BuiltIn { name: "panda-line", text: include_str!("../scenarios/panda-line.toml") },
    BuiltIn { name: "ur20-lift", text: include_str!("../scenarios/ur20-lift.toml") },
    BuiltIn { name: "natural-2r", text: include_str!("../scenarios/natural-2r.toml") },
    BuiltIn { name: "natural-pa10", text: include_str!("../scenarios/natural-pa10.toml") },
    BuiltIn { name: "helix-plane-sphere", text: include_str!("../scenarios/helix-plane-sphere.toml") },
    BuiltIn { name: "trap-ellipsoid", text: include_str!("../scenarios/trap-ellipsoid.toml") },
    BuiltIn { name: "trap-two-ellipsoids", text: include_str!("../scenarios/trap-two-ellipsoids.toml") },
    BuiltIn { name: "trap-booth-oval", text: include_str!("../scenarios/trap-booth-oval.toml") },
];

/// The commented template that `slideway init` writes.
pub const TEMPLATE: &str = include_str!("../scenarios/template.toml");

/// The commented template of a path-conditioning scenario.
pub const CONDITIONING_TEMPLATE: &str = include_str!("../scenarios/template-conditioning.toml");
