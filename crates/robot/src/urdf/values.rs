use super::{UrdfError, UrdfFault};
use crate::Pose;
use crate::xml::{Attribute, Element};
use nalgebra::{Quaternion, Rotation3, Translation3, UnitQuaternion, Vector3};
use std::ops::Range;

/// A link or joint that values belong to, for errors.
#[derive(Clone, Copy)]
pub(super) struct Owner<'a> {
    pub(super) what: &'static str,
    pub(super) name: &'a str,
    /// Its name in the text.
    pub(super) place: &'a Range<usize>,
}

impl Owner<'_> {
    /// An attribute of `element` as exactly `N` numbers, which may be infinite or NaN; `None` where it is not given.
    pub(super) fn numbers<const N: usize>(
        &self,
        element: &Element,
        key: &'static str,
    ) -> Result<Option<[f64; N]>, UrdfError> {
        let Some(attribute) = element.attribute(key) else { return Ok(None) };
        let parsed: Option<Vec<f64>> = attribute.value.split_whitespace().map(|word| word.parse().ok()).collect();
        match parsed.and_then(|numbers| <[f64; N]>::try_from(numbers).ok()) {
            Some(numbers) => Ok(Some(numbers)),
            None => Err(self.no_number(element, attribute, key, N)),
        }
    }

    fn no_number(&self, element: &Element, attribute: &Attribute, key: &'static str, expected: usize) -> UrdfError {
        let value = attribute.value.clone();
        let fault = if is_expression(&value) {
            UrdfFault::Xacro { found: format!("`{key}=\"{value}\"` of {} `{}`", self.what, self.name) }
        } else {
            let (name, element) = (self.name.to_owned(), element.name.clone());
            UrdfFault::Number { what: self.what, name, element, key, value, expected }
        };
        fault.at(&attribute.bytes)
    }

    /// A single number that must not be NaN.
    pub(super) fn number(&self, element: &Element, key: &'static str) -> Result<Option<f64>, UrdfError> {
        let number = self.numbers::<1>(element, key)?.map(|[x]| x);
        if number.is_some_and(f64::is_nan) { Err(self.not_finite(element)) } else { Ok(number) }
    }

    /// Numbers that must be finite.
    pub(super) fn finite<const N: usize>(
        &self,
        element: &Element,
        key: &'static str,
    ) -> Result<Option<[f64; N]>, UrdfError> {
        let numbers = self.numbers::<N>(element, key)?;
        if numbers.is_some_and(|n| !n.iter().all(|x| x.is_finite())) {
            return Err(self.not_finite(element));
        }
        Ok(numbers)
    }

    pub(super) fn not_finite(&self, element: &Element) -> UrdfError {
        let (name, part) = (self.name.to_owned(), element.name.clone());
        UrdfFault::NotFinite { what: self.what, name, part }.at(&element.tag)
    }

    /// The `<origin>` in an element: `xyz` in m, and `rpy` about the fixed x, y and z axes in this order, or `quat_xyzw`
    /// where the file's version has it. What is missing is zero.
    pub(super) fn origin(&self, within: &Element, quaternions: bool) -> Result<Pose, UrdfError> {
        let Some(element) = within.child("origin") else { return Ok(Pose::identity()) };
        let [x, y, z] = self.finite(element, "xyz")?.unwrap_or_default();
        let quaternion = if quaternions { self.finite::<4>(element, "quat_xyzw")? } else { None };
        let rotation = match quaternion {
            Some([i, j, k, w]) => {
                let unit = UnitQuaternion::try_new(Quaternion::new(w, i, j, k), SHORTEST);
                let zero = || UrdfFault::Quaternion { joint: self.name.to_owned() }.at(&element.tag);
                unit.ok_or_else(zero)?.to_rotation_matrix()
            }
            None => {
                let [roll, pitch, yaw] = self.finite(element, "rpy")?.unwrap_or_default();
                Rotation3::from_euler_angles(roll, pitch, yaw)
            }
        };
        Ok(Pose::from_parts(Translation3::from(Vector3::new(x, y, z)), rotation))
    }
}

/// Shortest vector that has a direction: a unit vector typed with a few digits is far from it.
pub(super) const SHORTEST: f64 = 1e-6;

/// True if a value is an expression that xacro has yet to evaluate.
pub(super) fn is_expression(value: &str) -> bool {
    value.contains("${") || value.contains("$(")
}
