use crate::error::CompareError;
use slideway_lab::Method;
use slideway_lab::conditioning::PathMethod;
use std::fmt;
use std::ops::ControlFlow;

/// Progress of a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Steps that are done.
    pub done: usize,
    /// Steps in all.
    pub total: usize,
    /// The step that begins or goes on.
    pub stage: Stage,
}

/// A step of a comparison. Displayed, it is a few words for a progress bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// A speed law runs.
    SpeedLaw(Method),
    /// The optimum is solved, on the grid and on one twice as fine.
    Optimum,
    /// The look-ahead runs with windows of other lengths, the laws under scaled limits and with wrong masses.
    Variations,
    /// A path conditioner or one of its rivals runs.
    PathMethod(PathMethod),
    /// The sliding mode runs at shorter sampling periods.
    ShorterPeriods,
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SpeedLaw(method) => method.name(),
            Self::Optimum => "solving for the optimum",
            Self::Variations => "looking ahead, other limits, wrong masses",
            Self::PathMethod(method) => method.name(),
            Self::ShorterPeriods => "shorter sampling periods",
        })
    }
}

/// A caller's view of a comparison: called before every run of a method and every solve. With [`ControlFlow::Break`] the comparison
/// ends at once as [`CompareError::Cancelled`].
pub type Watch<'a> = dyn FnMut(Progress) -> ControlFlow<()> + 'a;

/// Lets a comparison run to its end, unseen.
pub fn unwatched(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Steps of a comparison, counted for its caller.
pub(crate) struct Steps<'a, 'w> {
    watch: &'a mut Watch<'w>,
    done: usize,
    total: usize,
    stage: Option<Stage>,
}

impl<'a, 'w> Steps<'a, 'w> {
    pub(crate) fn new(watch: &'a mut Watch<'w>, total: usize) -> Self {
        Self { watch, done: 0, total, stage: None }
    }

    /// Begins a stage, which ends the one before; the same stage again is no new step.
    pub(crate) fn at(&mut self, stage: Stage) -> Result<(), CompareError> {
        self.done += usize::from(self.stage.is_some_and(|before| before != stage));
        self.stage = Some(stage);
        match (self.watch)(Progress { done: self.done, total: self.total, stage }) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(CompareError::Cancelled),
        }
    }
}
