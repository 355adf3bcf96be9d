use super::file::Link;
use super::{UrdfError, UrdfFault};
use crate::xml::Element;
use crate::{BodyFault, LinkInertia, Note};
use nalgebra::{Matrix3, Vector3};

/// Share of the largest moment that counts as rounding: descriptions are typed with a handful of digits.
const ROUNDING: f64 = 1e-6;

/// Share of the largest moment by which an eigenvalue of a matrix that has zero ones comes out negative.
const NOISE: f64 = 1e-12;

/// Mass of a link that is there as a placeholder, kg: its moments cannot matter.
const SPECK: f64 = 1e-6;

/// Mass and inertia of a link in its own frame. Missing numbers are zero, with a note; so are defects as small as rounding
/// only noted.
pub(super) fn inertia(link: &Link, quaternions: bool, notes: &mut Vec<Note>) -> Result<LinkInertia, UrdfError> {
    let Some(inertial) = link.element.child("inertial") else { return Ok(LinkInertia::default()) };
    let mass = match inertial.child("mass") {
        Some(element) => link.owner().numbers::<1>(element, "value")?.map(|[mass]| mass),
        None => None,
    };
    let matrix = inertial.child("inertia").filter(|element| !element.attributes.is_empty());
    let missing = match (mass, matrix) {
        (None, None) => Some("mass and no inertia"),
        (None, _) => Some("mass"),
        (_, None) => Some("inertia"),
        _ => None,
    };
    notes.extend(missing.map(|missing| Note::IncompleteInertial { link: link.name.clone(), missing }));
    let inertia = matrix.map_or(Ok(Matrix3::zeros()), |element| moments(link, element, notes))?;
    let body = LinkInertia { mass: mass.unwrap_or_default(), com: Vector3::zeros(), inertia };
    check(link, inertial, &body, notes)?;
    Ok(body.seen_from(&link.owner().origin(inertial, quaternions)?))
}

fn moments(link: &Link, element: &Element, notes: &mut Vec<Note>) -> Result<Matrix3<f64>, UrdfError> {
    let mut entry = |key: &'static str| -> Result<f64, UrdfError> {
        let value = link.owner().finite::<1>(element, key)?.map(|[x]| x);
        if value.is_none() {
            notes.push(Note::IncompleteInertial { link: link.name.clone(), missing: key });
        }
        Ok(value.unwrap_or_default())
    };
    let (xx, xy, xz) = (entry("ixx")?, entry("ixy")?, entry("ixz")?);
    let (yy, yz, zz) = (entry("iyy")?, entry("iyz")?, entry("izz")?);
    Ok(Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz))
}

/// Refuses what no rigid body has, notes what is as good as one.
fn check(link: &Link, inertial: &Element, body: &LinkInertia, notes: &mut Vec<Note>) -> Result<(), UrdfError> {
    let refused = |fault| Err(UrdfFault::Body { link: link.name.clone(), fault }.at(&inertial.tag));
    if !(body.mass >= 0.0 && body.mass.is_finite()) {
        return refused(BodyFault::Mass(body.mass));
    }
    let mut moments: [f64; 3] = body.inertia.symmetric_eigenvalues().into();
    moments.sort_by(f64::total_cmp);
    let [a, b, c] = moments;
    if !(a >= -ROUNDING * c || body.mass > 0.0 && body.mass <= SPECK) {
        return refused(BodyFault::NegativeMoment(a));
    }
    let name = link.name.clone();
    if a < -NOISE * c.abs() {
        notes.push(Note::NegativeMoment { link: name, moment: a });
    } else if c > (a + b) * (1.0 + ROUNDING) + NOISE * c {
        notes.push(Note::Triangle { link: name, moments });
    }
    Ok(())
}
