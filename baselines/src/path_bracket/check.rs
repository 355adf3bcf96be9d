//! Claims about the parts of the bracket that need the inside: enclosures against plain arithmetic, bounds for any multipliers, gaps that add up.

use super::caps;
use super::cells::{Cell, pieces};
use super::enclosure::CellDual;
use super::hats::{self, Evidence, Hat, Hats};
use super::minimise::Minimiser;
use super::path::{End, JointLimits, JointPath, JointPathProblem, Sense};
use super::polish::{self, Aim};
use super::rows::{cell_rows, excess, value};
use super::{BracketOptions, PathBracket, Solver};
use super::{refine, upper};

/// xorshift64*.
struct Numbers(u64);

impl Numbers {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// A random cubic of three joints in two segments that meet with the same slope.
fn problem(seed: u64, ends: [End; 2]) -> JointPathProblem {
    let mut n = Numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let first: Vec<Vec<f64>> = (0..3).map(|_| (0..4).map(|_| n.between(-1.0, 1.0)).collect()).collect();
    let second = first.iter().map(|c| {
        let (q, p) = (c.iter().sum::<f64>(), c[1] + 2.0 * c[2] + 3.0 * c[3]);
        vec![q, p, n.between(-1.0, 1.0), n.between(-0.5, 0.5)]
    });
    let segments = vec![first.clone(), second.collect()];
    let path = JointPath::new(vec![0.0, 1.0, 2.2], segments).expect("a path");
    let mut list = |a: f64, b: f64| (0..3).map(|_| n.between(a, b)).collect::<Vec<f64>>();
    let limits = JointLimits::new(list(0.5, 2.0), list(-5.0, -1.0), list(1.0, 5.0)).expect("limits");
    JointPathProblem::new(path, limits, ends).expect("a problem")
}

fn cells_of(problem: &JointPathProblem, count: usize) -> Vec<Cell> {
    let mut pieces = pieces(problem, count).expect("pieces");
    assert_eq!(pieces.len(), 1);
    pieces.remove(0).cells
}

/// `q_x` and `q_xx` of a joint by plain arithmetic.
fn plain(cell: &Cell, joint: usize, t: f64) -> (f64, f64) {
    let q = &cell.derivative[joint];
    (q.at(t), caps::slope_at(q, t) / cell.length)
}

#[test]
fn rows_and_their_check_bound_the_limited_quantities_at_every_sample() {
    for seed in 0..20 {
        let problem = problem(seed, [End::Rest; 2]);
        let limits = problem.limits();
        let mut n = Numbers(seed + 77);
        for cell in cells_of(&problem, 12) {
            let b = [n.between(0.1, 2.0), n.between(0.1, 2.0), n.between(0.1, 2.0)];
            let (bound, _) = excess(&cell, limits, b);
            let rows = cell_rows(&cell, limits, 1.0);
            let by_rows = rows.rows.iter().map(|r| value(r, &b)).fold(0.0, f64::max);
            // The rows leave out joints that others dominate, and the check of a speed ends with a coarse bound below its limit; otherwise both are the
            // same coefficients, the check rounded outwards.
            assert!(by_rows <= bound && bound <= by_rows.max(1.0) * (1.0 + 1e-9), "{by_rows} {bound}");
            for i in 0..=50 {
                let t = f64::from(i) / 50.0;
                let b_at = b[0] * (1.0 - t) * (1.0 - t) + 2.0 * b[1] * t * (1.0 - t) + b[2] * t * t;
                let u = ((b[1] - b[0]) * (1.0 - t) + (b[2] - b[1]) * t) / cell.length;
                for joint in 0..3 {
                    let (a, c) = plain(&cell, joint, t);
                    let e = a * u + c * b_at;
                    let used = [
                        e / limits.acceleration(joint, Sense::Upper),
                        -e / limits.acceleration(joint, Sense::Lower),
                        a * a * b_at / limits.speed(joint).powi(2),
                    ];
                    assert!(used.iter().all(|used| *used <= bound * (1.0 + 1e-12)), "{used:?} above {bound}");
                }
            }
        }
    }
}

#[test]
fn caps_of_an_interval_are_above_those_at_its_points() {
    for seed in 0..20 {
        let problem = problem(seed, [End::Rest; 2]);
        let limits = problem.limits();
        for cell in cells_of(&problem, 40) {
            let speed = caps::slowness(&cell.derivative, limits);
            let cap = caps::pair(&cell.derivative, cell.length, limits);
            for i in 0..=20 {
                let t = f64::from(i) / 20.0;
                let slowness = (0..3).map(|j| plain(&cell, j, t).0.abs() / limits.speed(j)).fold(0.0, f64::max);
                assert!(speed.least <= slowness * (1.0 + 1e-12) && slowness <= speed.most * (1.0 + 1e-12));
                let joint_cap = caps::at(&cell, limits, t).min(1.0 / (slowness * slowness));
                assert!(joint_cap <= cap.min(1.0 / (speed.least * speed.least)) * (1.0 + 1e-9) || joint_cap > 1e12);
            }
        }
    }
}

/// Plain `∫ g` by Simpson's rule on many parts, with caps at points.
fn plain_integral(dual: &CellDual<'_>) -> f64 {
    let parts = 2000;
    let cell = dual.cell;
    let g = |t: f64| {
        let mut w = 0.0;
        for (side, hats) in dual.hats.iter().enumerate() {
            for hat in *hats {
                let (a, c) = plain(cell, hat.joint, t);
                let (value, slope) = if side == 0 { (1.0 - t, -1.0) } else { (t, 1.0) };
                // w = mu c - (mu a)'/2 with a' = c.
                w += 0.5 * hat.sense.sign() * hat.multiplier() * (value * c - slope * a / cell.length);
            }
        }
        super::polish::least(w, caps::at(cell, dual.limits, t))
    };
    let h = 1.0 / f64::from(parts);
    let part = |i: i32| {
        let t = f64::from(i) * h;
        (g(t) + 4.0 * g(t + 0.5 * h) + g(t + h)) * h / 6.0
    };
    (0..parts).map(part).sum::<f64>() * cell.length
}

/// A hat of random size; at times nonsense.
fn random_hat(n: &mut Numbers, wild: f64) -> Hat {
    let sense = Sense::BOTH[usize::from(n.unit() < 0.5)];
    let seconds = match (n.unit() * 20.0) as u32 {
        0 => f64::NAN,
        1 => -1.0,
        _ => n.unit() * 10.0_f64.powf(n.between(-wild, 0.0)),
    };
    Hat { joint: (n.unit() * 3.0) as usize % 3, sense, seconds, scale: 1.0 }
}

#[test]
fn the_enclosed_integral_is_below_the_plain_one_and_near_it() {
    let mut n = Numbers(5);
    for seed in 0..12 {
        let problem = problem(seed, [End::Free; 2]);
        for cell in cells_of(&problem, 6) {
            let hats: Vec<Vec<Hat>> = (0..2).map(|_| vec![random_hat(&mut n, 2.0), random_hat(&mut n, 2.0)]).collect();
            let mut dual = CellDual {
                cell: &cell,
                limits: problem.limits(),
                hats: [&hats[0], &hats[1]],
                kinematic: f64::INFINITY,
                guide: f64::INFINITY,
                allowed: 0.0,
            };
            let (plain, price) = (plain_integral(&dual), dual.price().lo);
            dual.guide = plain;
            let enclosed = dual.lower().lo - price;
            assert!(enclosed <= plain + 1e-6 * plain.abs(), "{enclosed} above {plain}");
            // 64 parts: the loss is of the first order where w is negative below a cap that varies.
            assert!(enclosed >= plain - 0.05 * plain.abs().max(cell.length), "{enclosed} far below {plain}");
        }
    }
}

/// The lower bound of given hats.
fn lower(cells: &[Cell], ends: [End; 2], limits: &JointLimits, hats: &Hats) -> f64 {
    let cells: Vec<&Cell> = cells.iter().collect();
    let kinematic = caps::kinematic(&cells, ends, limits);
    let bound = |k: usize| {
        let (guide, allowed) = (f64::INFINITY, 0.0);
        let hats = [&hats.nodes[k][..], &hats.nodes[k + 1][..]];
        CellDual { cell: cells[k], limits, hats, kinematic: kinematic[k], guide, allowed }.lower().lo
    };
    (0..cells.len()).map(bound).sum()
}

#[test]
fn no_multipliers_lift_the_bound_above_a_feasible_time() {
    for (seed, ends) in (0..16).map(|seed| (seed, if seed % 2 == 0 { [End::Rest; 2] } else { [End::Free; 2] })) {
        let problem = problem(seed, ends);
        let options = BracketOptions { gap: 1e-3, ..BracketOptions::default() };
        let upper = PathBracket::solve(&problem, &options).expect("a bracket").upper_s;
        let cells = cells_of(&problem, 12);
        let mut n = Numbers(seed + 1234);
        for _ in 0..40 {
            let wild = n.between(0.0, 8.0);
            let node = |k: usize, n: &mut Numbers| {
                let is_free = ends[0] == End::Free && (k == 0 || k == cells.len());
                if is_free { Vec::new() } else { vec![random_hat(n, wild), random_hat(n, wild)] }
            };
            let hats = Hats { nodes: (0..=cells.len()).map(|k| node(k, &mut n)).collect() };
            let bound = lower(&cells, ends, problem.limits(), &hats);
            // The sum of cells' bounds is in plain arithmetic here.
            assert!(bound <= upper * (1.0 + 1e-12), "seed {seed}: {bound} above {upper}");
        }
    }
}

#[test]
fn both_solvers_give_brackets_that_overlap() {
    for seed in 0..4 {
        let problem = problem(seed, [End::Rest; 2]);
        let with = |solver| {
            let options = BracketOptions { gap: 1e-4, solver, ..BracketOptions::default() };
            PathBracket::solve(&problem, &options).expect("a bracket")
        };
        let (own, conic) = (with(Solver::InteriorPoint), with(Solver::Conic));
        assert!(own.certified && conic.certified, "{} {}", own.gap, conic.gap);
        assert!(own.lower_s <= conic.upper_s && conic.lower_s <= own.upper_s);
    }
}

#[test]
fn warm_starts_take_few_steps_in_the_median() {
    let (mut own, mut polish) = (Vec::new(), Vec::new());
    for seed in 0..9 {
        let problem = problem(seed, [End::Rest; 2]);
        let limits = problem.limits();
        let mut minimiser = Minimiser::new(cells_of(&problem, 150), limits, Solver::InteriorPoint);
        minimiser.minimise(1e-5);
        minimiser.cut(&vec![true; minimiser.cells.len()]);
        minimiser.minimise(1e-5);
        own.push(minimiser.steps);
        polish.push(polish_steps(&minimiser, limits));
    }
    own.sort_unstable();
    polish.sort_unstable();
    assert!(own[4] <= 12 && polish[4] <= 12, "{own:?} {polish:?}");
}

fn polish_steps(minimiser: &Minimiser<'_>, limits: &JointLimits) -> usize {
    let cells: Vec<&Cell> = minimiser.cells.iter().map(|c| &c.cell).collect();
    let b = upper::within_limits(cells.iter().copied(), limits, minimiser.profile()).expect("a profile");
    let times = upper::times(cells.iter().copied(), &b);
    let mut time = vec![0.0; cells.len() + 1];
    for (k, t) in times.iter().enumerate() {
        time[k] += 0.5 * t.lo;
        time[k + 1] += 0.5 * t.lo;
    }
    let evidence = Evidence { mass: &minimiser.masses(), time: &time, before: &[] };
    let mut hats = hats::choose(&cells, [End::Rest; 2], limits, &evidence);
    let aim = Aim { tolerance: 1e-5, start: 2e-4 };
    polish::polish(&cells, limits, &mut hats, refine::at_points(&b), aim).steps
}

#[test]
fn the_gaps_of_the_cells_add_up_to_the_gap() {
    for (seed, ends) in [(1, [End::Rest; 2]), (2, [End::Free; 2]), (3, [End::Rest, End::Free])] {
        let problem = problem(seed, ends);
        let mut minimiser = Minimiser::new(cells_of(&problem, 120), problem.limits(), Solver::InteriorPoint);
        minimiser.minimise(1e-5);
        let (bounds, gaps) = refine::bounds_and_gaps(&minimiser, ends, problem.limits());
        let (lower, upper) = bounds;
        // Telescoping sums in plain arithmetic: an epsilon of the largest p b a cell.
        let sum: f64 = gaps.iter().sum();
        assert!((sum - (upper - lower)).abs() < 1e-11 * upper, "{sum} {}", upper - lower);
        assert!(gaps.iter().all(|gap| *gap >= -1e-12 * upper), "{gaps:?}");
        assert!(upper > lower && upper / lower < 1.01);
    }
}
