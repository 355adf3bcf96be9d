use crate::error::VerifyError;
use crate::options::VerifyOptions;
use crate::statement::Statement;
use crate::trial::draw::Draw;
use crate::trial::path::PathSubject;
use crate::trial::smallest::smallest;
use crate::trial::speed::SpeedSubject;
use crate::trial::{Judgement, Trial};
use slideway_lab::Subject;

/// A campaign as it is asked for: with its subject everything that a trial depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CampaignRequest {
    /// Greatest disturbances.
    pub options: VerifyOptions,
    /// Grid points of the optimum; for speed laws only.
    pub grid_points: usize,
    /// Seed of the disturbances.
    pub seed: u64,
    /// Number of trials.
    pub trials: u64,
}

/// Numbered trials around a problem.
#[derive(Clone, Debug)]
pub struct Campaign {
    request: CampaignRequest,
    statement: Statement,
    runs: Runs,
}

/// A subject made ready to be run again and again.
#[derive(Clone, Debug)]
enum Runs {
    Speed(Box<SpeedSubject>),
    Path(Box<PathSubject>),
}

impl Campaign {
    /// States what is guaranteed, makes no trial.
    ///
    /// To the statement's guarantees it adds those that hold whatever disturbs the loop, under the names of their claims.
    ///
    /// # Errors
    ///
    /// A method that nothing is claimed about or that cannot be run, a path without an optimum, a greatest disturbance that no run may have.
    pub fn new(subject: Subject, request: CampaignRequest) -> Result<Self, VerifyError> {
        request.options.check()?;
        let (runs, statement) = match subject {
            Subject::Speed { experiment, method } => {
                let (runs, statement) = SpeedSubject::new(*experiment, method, request.grid_points, &request.options)?;
                (Runs::Speed(Box::new(runs)), statement)
            }
            Subject::Conditioning { problem, method } => {
                let (runs, statement) = PathSubject::new(*problem, method, &request.options)?;
                (Runs::Path(Box::new(runs)), statement)
            }
        };
        Ok(Self { request, statement, runs })
    }

    /// The same trials held against another statement: with narrower bounds, say, to see what breaks them.
    #[must_use]
    pub fn against(self, statement: Statement) -> Self {
        Self { statement, ..self }
    }

    /// The request that the campaign was made for.
    #[must_use]
    pub fn request(&self) -> CampaignRequest {
        self.request
    }

    /// The statement that every trial is held against, made before any of them.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// Makes one trial: a function of the campaign and the number alone.
    ///
    /// A trial is held against the guarantees of the statement whose hypotheses it keeps, and against those that hold whatever disturbs
    /// the loop. Beside the statement's hypotheses it may break what every statement takes for granted: `period-as-counted` (times, under
    /// jitter), `joints-as-seen` (arrival of joints that are misread), `constraints-seen-in-time` (constraints that move, seen late),
    /// `start-inside` (an initial error that leaves the allowed set) and `distances-as-they-are` (noise, where what it does to a bound is
    /// not derived).
    ///
    /// # Errors
    ///
    /// A number beyond the last; a scenario that cannot be run under the trial's disturbances.
    pub fn trial(&self, number: u64) -> Result<Trial, VerifyError> {
        if number >= self.request.trials {
            return Err(VerifyError::NoTrial { number, trials: self.request.trials });
        }
        self.made(number, &self.draw(number))
    }

    /// A failing trial made as small as it can be while every guarantee fails that it broke: less of each disturbance, fewer kinds. One
    /// that breaks nothing stays as it is.
    ///
    /// # Errors
    ///
    /// As [`Campaign::trial`].
    pub fn smallest(&self, failing: &Trial) -> Result<Trial, VerifyError> {
        let violated = failing.violated();
        if violated.is_empty() {
            return Ok(failing.clone());
        }
        let draw = self.draw(failing.number).at(failing.size).with_only(|kind| kind.is_in(&failing.disturbances));
        self.made(failing.number, &smallest(&draw, &violated, |draw| self.judge(draw))?)
    }

    fn draw(&self, number: u64) -> Draw {
        match &self.runs {
            Runs::Speed(subject) => subject.draw(self.request.seed, number),
            Runs::Path(subject) => subject.draw(self.request.seed, number),
        }
    }

    fn judge(&self, draw: &Draw) -> Result<Judgement, VerifyError> {
        match &self.runs {
            Runs::Speed(subject) => subject.judge(&draw.disturbances().for_speed(), &self.statement),
            Runs::Path(subject) => subject.judge(&draw.disturbances().for_conditioning(), &self.statement),
        }
    }

    fn made(&self, number: u64, draw: &Draw) -> Result<Trial, VerifyError> {
        let Judgement { outside, checks } = self.judge(draw)?;
        Ok(Trial { number, size: draw.size(), disturbances: draw.disturbances(), outside, checks })
    }
}
