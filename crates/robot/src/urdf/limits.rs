use super::file::{Joint, JointType, Version};
use super::{UrdfError, UrdfFault};
use crate::xml::Element;
use crate::{Drive, Friction, JointLimits, LimitKind, Note, PositionRange};

/// The limits of a joint that turns or slides.
///
/// Zero and infinity mean no limit. Before version 1.2 what is missing reads as zero, and acceleration and jerk are not
/// read; from then on what is missing is open. Soft limits narrow the range.
pub(super) fn limits(joint: &Joint, version: Version, notes: &mut Vec<Note>) -> Result<JointLimits, UrdfError> {
    let mut reader = LimitReader { joint, version, element: joint.element.child("limit"), notes };
    let hard = reader.range()?;
    let position = reader.narrowed(hard)?;
    let velocity = reader.bound("velocity", LimitKind::Velocity)?;
    let effort = reader.bound("effort", LimitKind::Effort)?;
    let acceleration = reader.acceleration()?;
    let jerk = reader.newer("jerk", LimitKind::Jerk)?;
    let limits = JointLimits { position, velocity, effort, acceleration, jerk };
    let place = reader.element.map_or(&joint.element.tag, |element| &element.tag);
    limits.validate(&joint.name).map_err(|fault| UrdfFault::Limits(fault).at(place))?;
    Ok(limits)
}

/// The friction of a joint; a URDF has no rotor inertia.
pub(super) fn drive(joint: &Joint) -> Result<Drive, UrdfError> {
    let Some(element) = joint.element.child("dynamics") else { return Ok(Drive::default()) };
    let value = |key| joint.owner().number(element, key).map(Option::unwrap_or_default);
    let (viscous, coulomb) = (value("damping")?, value("friction")?);
    let drive = Drive { reflected_inertia: 0.0, friction: Friction { viscous, forward: coulomb, backward: coulomb } };
    let fault = |fault| UrdfFault::Drive { joint: joint.name.clone(), fault }.at(&element.tag);
    drive.validate().map_err(fault)?;
    Ok(drive)
}

struct LimitReader<'a> {
    joint: &'a Joint,
    version: Version,
    element: Option<&'a Element>,
    notes: &'a mut Vec<Note>,
}

/// A range without ends.
const OPEN: PositionRange = PositionRange { lower: f64::NEG_INFINITY, upper: f64::INFINITY };

impl LimitReader<'_> {
    fn value(&self, key: &'static str) -> Result<Option<f64>, UrdfError> {
        self.element.map_or(Ok(None), |element| self.joint.owner().number(element, key))
    }

    /// Adds the joint to the note on this limit that other joints have called for, or makes one.
    fn note(&mut self, note: fn(Vec<String>, LimitKind) -> Note, limit: LimitKind) {
        let new = note(vec![self.joint.name.clone()], limit);
        for old in self.notes.iter_mut() {
            match (old, &new) {
                (Note::ZeroLimit { joints, limit }, Note::ZeroLimit { limit: same, .. })
                | (Note::MissingLimit { joints, limit }, Note::MissingLimit { limit: same, .. })
                    if limit == same =>
                {
                    return joints.push(self.joint.name.clone());
                }
                _ => {}
            }
        }
        self.notes.push(new);
    }

    /// The range of `lower` and `upper`, [`OPEN`] if there is none.
    fn range(&mut self) -> Result<PositionRange, UrdfError> {
        if self.joint.kind == JointType::Continuous {
            return Ok(OPEN);
        }
        let (lower, upper) = (self.value("lower")?, self.value("upper")?);
        if lower.is_none() && upper.is_none() {
            if self.version == Version::V1 {
                self.note(missing, LimitKind::Position);
            }
            return Ok(OPEN);
        }
        let otherwise = if self.version == Version::V1 { PositionRange { lower: 0.0, upper: 0.0 } } else { OPEN };
        let range = PositionRange { lower: lower.unwrap_or(otherwise.lower), upper: upper.unwrap_or(otherwise.upper) };
        if (range.lower, range.upper) == (0.0, 0.0) {
            self.notes.push(Note::NoRange { joint: self.joint.name.clone() });
            return Ok(OPEN);
        }
        Ok(range)
    }

    /// The part of a range that the soft limits leave; `None` if it has no ends. Soft limits that are not given, or both
    /// zero, narrow nothing.
    fn narrowed(&mut self, hard: PositionRange) -> Result<Option<PositionRange>, UrdfError> {
        let soft = self.joint.element.child("safety_controller").filter(|_| self.joint.kind != JointType::Continuous);
        let mut range = hard;
        if let Some(element) = soft {
            let owner = self.joint.owner();
            let (lower, upper) =
                (owner.number(element, "soft_lower_limit")?, owner.number(element, "soft_upper_limit")?);
            if (lower.unwrap_or_default(), upper.unwrap_or_default()) != (0.0, 0.0) {
                range.lower = hard.lower.max(lower.unwrap_or(OPEN.lower));
                range.upper = hard.upper.min(upper.unwrap_or(OPEN.upper));
            }
        }
        if range != hard {
            self.notes.push(Note::SoftLimits { joint: self.joint.name.clone(), range });
        }
        Ok((range != OPEN).then_some(range))
    }

    /// A limit that every version has.
    fn bound(&mut self, key: &'static str, limit: LimitKind) -> Result<Option<f64>, UrdfError> {
        let value = self.value(key)?;
        // A joint that turns without end may do without the element.
        let optional = self.joint.kind == JointType::Continuous && self.element.is_none();
        if value.is_none() && self.version == Version::V1 && !optional {
            self.note(missing, limit);
        }
        Ok(self.positive(value, limit))
    }

    /// A limit that counts from version 1.2 on.
    fn newer(&mut self, key: &'static str, limit: LimitKind) -> Result<Option<f64>, UrdfError> {
        if self.version == Version::V1 {
            if self.element.is_some_and(|element| element.attribute(key).is_some()) {
                self.notes.push(Note::NeedsVersion { joint: self.joint.name.clone(), attribute: key });
            }
            return Ok(None);
        }
        let value = self.value(key)?;
        Ok(self.positive(value, limit))
    }

    /// The same both ways here: the smaller of `acceleration` and `deceleration`.
    fn acceleration(&mut self) -> Result<Option<f64>, UrdfError> {
        let up = self.newer("acceleration", LimitKind::Acceleration)?;
        let down = self.newer("deceleration", LimitKind::Acceleration)?;
        Ok(up.into_iter().chain(down).reduce(f64::min))
    }

    fn positive(&mut self, value: Option<f64>, limit: LimitKind) -> Option<f64> {
        if value == Some(0.0) {
            self.note(zero, limit);
        }
        value.filter(|&value| value != 0.0 && value != f64::INFINITY)
    }
}

fn missing(joints: Vec<String>, limit: LimitKind) -> Note {
    Note::MissingLimit { joints, limit }
}

fn zero(joints: Vec<String>, limit: LimitKind) -> Note {
    Note::ZeroLimit { joints, limit }
}
