//! A welding cell: Go-To, a seam as fast as the joints allow, a brake half-way, recovery, Go-To.
//!
//! A PUMA-560 goes to the beginning of a seam, follows it with its tool, and goes home, under the supervisor. The seam is run under
//! sliding-mode regulation and under natural motion, each once without and once with an interruption: half-way along the seam a
//! brake on the path is asked for, and after a pause the motion is taken up again.
//!
//! The time along the seam is compared with the certified time optimum of the same curve under the same limits of joint speed and
//! acceleration. The path error is that of the tool at the set-points *and half-way between two of them*, where drives that
//! interpolate linearly put the joints.

mod cell;
mod optimum;
mod seam;

use crate::{Level, NamedNumber, Panel, Report, Role, Scales, Series, Study, StudyError};
use cell::{CellRun, Interruption, play};
use seam::Law;
use slideway_baselines::time_optimal::TimeOptimum;

/// Most that the seam may take under sliding mode, as a multiple of the optimum's time.
const SLOWER: f64 = 1.03;
/// Rounding of a joint speed over a sample, as a share of what may be added to it in one.
const ROUNDING: f64 = 1e-9;
/// Most that the tool may be off the seam, m.
const OFF_SEAM: f64 = 1e-4;

/// Both runs under one law.
struct Pair {
    law: Law,
    straight: CellRun,
    braked: CellRun,
}

pub(crate) fn run() -> Result<Report, StudyError> {
    let optimum = optimum::certified()?;
    let pair = |law| -> Result<Pair, StudyError> {
        Ok(Pair { law, straight: play(law, Interruption::None)?, braked: play(law, Interruption::HalfWay)? })
    };
    let pairs = [pair(Law::SlidingMode)?, pair(Law::Natural)?];
    let holds = holds(&pairs, &optimum);
    let mut numbers =
        vec![NamedNumber::new("optimum", optimum.duration_s, "s"), NamedNumber::new("optimum-gap", optimum.gap(), "1")];
    numbers.extend(pairs.iter().flat_map(|pair| pair.numbers(&optimum)));
    Ok(Report {
        study: Study::WeldingCell.name(),
        title: "A welding cell",
        holds,
        sentence: sentence(&pairs, &optimum, holds),
        numbers,
        panels: panels(&pairs, &optimum),
    })
}

fn holds(pairs: &[Pair; 2], optimum: &TimeOptimum) -> bool {
    let is_sound = |run: &CellRun| run.path_error <= OFF_SEAM && run.limit_use <= 1.0 + ROUNDING && run.ends_at_home;
    let is_safe = pairs.iter().all(|p| is_sound(&p.straight) && is_sound(&p.braked) && p.braked.pauses_once);
    let [sliding, _] = pairs;
    is_safe && optimum.is_certified() && sliding.ratio(optimum) <= SLOWER
}

impl Pair {
    /// Time along the seam over the proven lower bound of the optimum.
    fn ratio(&self, optimum: &TimeOptimum) -> f64 {
        self.straight.seam_time / optimum.lower_s
    }

    fn numbers(&self, optimum: &TimeOptimum) -> [NamedNumber; 7] {
        let number = |what: &str, value, unit| NamedNumber::new(format!("{}-{what}", self.law.key()), value, unit);
        [
            number("seam-time", self.straight.seam_time, "s"),
            number("over-optimum", self.ratio(optimum), "1"),
            number("cycle-time", self.straight.cycle_time, "s"),
            number("path-error", self.straight.path_error.max(self.braked.path_error), "m"),
            number("limit-use", self.straight.limit_use.max(self.braked.limit_use), "1"),
            number("brake-time", self.braked.brake_time, "s"),
            number("braked-cycle-time", self.braked.cycle_time, "s"),
        ]
    }
}

fn sentence(pairs: &[Pair; 2], optimum: &TimeOptimum, holds: bool) -> String {
    let [sliding, natural] = pairs;
    let error = pairs.iter().map(|p| p.straight.path_error.max(p.braked.path_error)).fold(0.0, f64::max);
    format!(
        "{}: the seam takes {:.3} s under sliding mode, {:.4} times the certified optimum, and {:.3} s under natural motion; braked \
         half-way to rest in {:.0} ms and taken up again; the tool is never more than {:.4} mm off it.",
        if holds { "Yes" } else { "No" },
        sliding.straight.seam_time,
        sliding.ratio(optimum),
        natural.straight.seam_time,
        1e3 * sliding.braked.brake_time,
        1e3 * error,
    )
}

fn panels(pairs: &[Pair; 2], optimum: &TimeOptimum) -> Vec<Panel> {
    let curve = |name, points: &[[f64; 2]]| Series { name, role: Role::Result, points: points.to_vec() };
    let best = optimum.pieces.iter().flat_map(|p| p.lambda.iter().zip(p.path_rate()).map(|(u, rate)| [*u, rate]));
    let mut rates = vec![Series { name: "optimum, seam", role: Role::Reference, points: best.collect() }];
    rates.extend(pairs.iter().map(|p| curve(p.law.name(), &p.straight.rates)));
    let braked = |of: fn(&CellRun) -> &[[f64; 2]]| pairs.iter().map(|p| curve(p.law.name(), of(&p.braked))).collect();
    let wanted = Series { name: "optimum, seam", role: Role::Reference, points: seam::outline() };
    let [sliding, _] = pairs;
    vec![
        Panel {
            title: "Rate along the seam, not interrupted".to_owned(),
            x: "share of the seam",
            y: "rate (1/s)",
            scales: Scales::Filling,
            series: rates,
            levels: Vec::new(),
        },
        Panel {
            title: "Largest use of a joint's limit, not interrupted".to_owned(),
            x: "time (s)",
            y: "speed or acceleration",
            scales: Scales::Filling,
            series: pairs.iter().map(|p| curve(p.law.name(), &p.straight.uses)).collect(),
            levels: vec![Level { name: "limit", value: 1.0 }],
        },
        Panel {
            title: "Speed of the tool, braked half-way along the seam".to_owned(),
            x: "time (s)",
            y: "m/s",
            scales: Scales::Filling,
            series: braked(|run| &run.speeds),
            levels: Vec::new(),
        },
        Panel {
            title: "The seam seen along x, and the tool in the braked cycle".to_owned(),
            x: "y (m)",
            y: "z (m)",
            scales: Scales::Equal,
            series: vec![wanted, curve(sliding.law.name(), &sliding.braked.places)],
            levels: Vec::new(),
        },
    ]
}
