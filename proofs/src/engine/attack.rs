use std::time::{Duration, Instant};

use super::{Choices, Engine, Stop};
use crate::subject::Subject;

/// Simulated annealing on the margin of one claim, over the choices a case is built from.
///
/// A move changes one choice, by little or by much; a worse margin is accepted with a probability that falls as the search
/// goes on. Every `restart` moves it begins anew from the best of a few random cases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attack {
    /// Where the random sequence begins.
    pub seed: u64,
    /// Moves between two restarts.
    pub restart: u32,
    /// When to stop.
    pub limit: Duration,
}

/// Findings of an attack.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The smallest margin met.
    pub margin: f64,
    /// The choices that give it, for [`Choices::replay`].
    pub choices: Vec<f64>,
    /// Description of the violation; `None` if the claim was kept.
    pub violation: Option<String>,
    /// Cases tried.
    pub tried: u64,
}

/// A margin, and a refusal as the worst one.
fn margin_of(engine: &Engine, subject: Subject, choices: &mut Choices) -> Option<f64> {
    match (engine.trial)(choices, subject) {
        Ok(margin) if margin.is_nan() => Some(f64::NEG_INFINITY),
        Ok(margin) => Some(margin),
        Err(Stop::Skipped) => None,
        Err(Stop::Refused(_)) => Some(f64::NEG_INFINITY),
    }
}

impl Attack {
    /// Attacks a claim until the time is up or a violation is found; `progress` is told the tries and the smallest margin so far.
    pub fn run(&self, engine: &Engine, subject: Subject, mut progress: impl FnMut(u64, f64)) -> Found {
        let begun = Instant::now();
        let mut best = Found { margin: f64::INFINITY, choices: Vec::new(), violation: None, tried: 0 };
        let mut round = 0;
        while begun.elapsed() < self.limit && !(best.margin < 0.0) {
            self.round(engine, subject, round, begun, &mut best);
            progress(best.tried, best.margin);
            round += 1;
        }
        best.violation = engine.violation(&mut Choices::replay(&best.choices), subject);
        best
    }

    fn round(&self, engine: &Engine, subject: Subject, round: u64, begun: Instant, best: &mut Found) {
        let mut moves = Choices::random(self.seed, round);
        let (mut here, mut current) = self.start(engine, subject, round, best);
        for step in 0..self.restart {
            if begun.elapsed() >= self.limit || here.is_empty() {
                return;
            }
            let heat = 1.0 - f64::from(step) / f64::from(self.restart);
            let changed = neighbour(&here, heat, &mut moves);
            let mut choices = Choices::replay(&changed);
            let Some(margin) = margin_of(engine, subject, &mut choices) else { continue };
            best.see(margin, &choices);
            // Margins are shares or small numbers: a rise of a tenth of the present one is taken at once in three when hot.
            let rise = (margin - current) / (0.1 * heat * current.abs().max(1e-12));
            if !(rise > 0.0) || moves.unit() < (-rise).exp() {
                (here, current) = (choices.used().to_vec(), margin);
            }
            if margin < 0.0 {
                return;
            }
        }
    }

    /// The best of ten random cases.
    fn start(&self, engine: &Engine, subject: Subject, round: u64, best: &mut Found) -> (Vec<f64>, f64) {
        let (mut here, mut smallest) = (Vec::new(), f64::INFINITY);
        for case in 0..10 {
            let mut choices = Choices::random(!self.seed, 10 * round + case);
            let Some(margin) = margin_of(engine, subject, &mut choices) else { continue };
            best.see(margin, &choices);
            if margin <= smallest {
                (here, smallest) = (choices.used().to_vec(), margin);
            }
        }
        (here, smallest)
    }
}

impl Found {
    fn see(&mut self, margin: f64, choices: &Choices) {
        self.tried += 1;
        if margin < self.margin || self.choices.is_empty() {
            (self.margin, self.choices) = (margin, choices.used().to_vec());
        }
    }
}

/// One choice in three moves drawn anew, else shifted by an amount from 1e-6 to the heat, brought back inside.
fn neighbour(here: &[f64], heat: f64, moves: &mut Choices) -> Vec<f64> {
    let mut changed = here.to_vec();
    let place = moves.below(changed.len());
    let anew = moves.unit() < 1.0 / 3.0;
    let fresh = moves.unit();
    let shift = moves.sign() * heat * moves.decade(-6.0, 0.0);
    if let Some(choice) = changed.get_mut(place) {
        *choice = if anew { fresh } else { (*choice + shift).clamp(0.0, 1.0) };
    }
    changed
}
