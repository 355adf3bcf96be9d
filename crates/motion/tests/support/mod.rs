//! Random arms.

use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use slideway_robot::{DhRow, Dynamics, JointVector, LinkInertia, SerialArm};

/// Largest distance of the tool of an [`arm`] from its base, m: three rows of at most 0.5 and 0.3 m.
#[allow(dead_code, reason = "not every test of this directory needs it")]
pub(crate) const REACH: f64 = 3.0 * 0.584;

fn row() -> impl Strategy<Value = DhRow> {
    (0.1..0.5_f64, -1.6..1.6_f64, -0.3..0.3_f64).prop_map(|(a, alpha, d)| DhRow { a, alpha, d, offset: 0.0 })
}

fn link() -> impl Strategy<Value = LinkInertia> {
    (0.5..5.0_f64, prop::array::uniform3(-0.2..0.2_f64), prop::array::uniform3(0.02..0.1_f64)).prop_map(
        |(mass, com, inertia)| LinkInertia {
            mass,
            com: Vector3::from(com),
            inertia: Matrix3::from_diagonal(&Vector3::from(inertia)),
        },
    )
}

/// Three turning joints in any arrangement, with masses, without friction.
pub(crate) fn arm() -> impl Strategy<Value = Dynamics<3>> {
    (prop::array::uniform3(row()), prop::array::uniform3(link())).prop_map(|(rows, links)| {
        Dynamics::new(SerialArm::from_dh(rows).expect("finite"), links).expect("rigid bodies")
    })
}

/// A vector with entries of at most `size`.
pub(crate) fn vector<const N: usize>(size: f64) -> impl Strategy<Value = JointVector<N>> {
    prop::collection::vec(-size..size, N).prop_map(JointVector::from_vec)
}
