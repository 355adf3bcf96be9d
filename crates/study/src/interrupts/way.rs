use slideway_motion::{Interpolation, MotionError, MotionQueue};

/// A way to interrupt a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    StopAtWayPoint,
    BrakeOnPath,
    BrakeFully,
    NewTarget,
}

impl Way {
    pub(super) const ALL: [Self; 4] = [Self::StopAtWayPoint, Self::BrakeOnPath, Self::BrakeFully, Self::NewTarget];

    /// In the legend and in sentences.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::StopAtWayPoint => "stop at way-point",
            Self::BrakeOnPath => "braking on the path",
            Self::BrakeFully => "maximal braking",
            Self::NewTarget => "new target",
        }
    }

    /// In the names of numbers.
    pub(super) fn key(self) -> &'static str {
        match self {
            Self::StopAtWayPoint => "stop-at-way-point",
            Self::BrakeOnPath => "brake-on-path",
            Self::BrakeFully => "brake-fully",
            Self::NewTarget => "new-target",
        }
    }

    pub(super) fn stays_on_path(self) -> bool {
        match self {
            Self::StopAtWayPoint | Self::BrakeOnPath => true,
            Self::BrakeFully | Self::NewTarget => false,
        }
    }

    pub(super) fn interrupt<const CAPACITY: usize>(
        self,
        queue: &mut MotionQueue<2, CAPACITY>,
        target: [f64; 2],
    ) -> Result<(), MotionError> {
        match self {
            Self::StopAtWayPoint => queue.stop_at_way_point(),
            Self::BrakeOnPath => queue.brake_on_path(),
            Self::BrakeFully => queue.brake_fully(),
            Self::NewTarget => queue.interrupt_to(&target.into(), Interpolation::Trapezoid)?,
        }
        Ok(())
    }
}
