use super::{GroupState, Srdf, SrdfError, SrdfFault};
use crate::RobotDescription;

impl Srdf {
    /// A named configuration; the group need be given only where several groups have one of that name.
    ///
    /// # Errors
    ///
    /// There is none, or there are several.
    pub fn state(&self, name: &str, group: Option<&str>) -> Result<&GroupState, SrdfError> {
        let fits = |state: &&GroupState| state.name == name && group.is_none_or(|group| state.group == group);
        let states: Vec<&GroupState> = self.states.iter().filter(fits).collect();
        match states.as_slice() {
            [state] => Ok(state),
            [] => {
                let known = self.states.iter().map(|state| format!("`{}` of `{}`", state.name, state.group)).collect();
                let fault = SrdfFault::NoSuchState { name: name.to_owned(), group: group.map(str::to_owned), known };
                Err(fault.into())
            }
            several => {
                let groups = several.iter().map(|state| state.group.clone()).collect();
                Err(SrdfFault::SeveralStates { name: name.to_owned(), groups }.into())
            }
        }
    }
}

impl GroupState {
    /// The positions of a robot's joints in the order of its chain, rad (m). Joints of the configuration that the robot
    /// does not have are passed over.
    ///
    /// # Errors
    ///
    /// A joint of the robot is missing, or has not exactly one number.
    pub fn positions(&self, robot: &RobotDescription) -> Result<Vec<f64>, SrdfError> {
        let position = |joint: &str| {
            let state = self.joints.iter().find(|state| state.name == joint);
            match state.map(|state| state.values.as_slice()) {
                Some([value]) => Ok(*value),
                _ => Err(SrdfFault::NoPosition { state: self.name.clone(), joint: joint.to_owned() }.into()),
            }
        };
        robot.joints.iter().map(|joint| position(&joint.name)).collect()
    }
}
