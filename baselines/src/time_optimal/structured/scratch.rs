use super::*;
use crate::time_optimal::*;
#[path = "../../../tests/support/mod.rs"]
#[allow(unused)]
mod support;
fn time<T>(name: &str, mut f: impl FnMut() -> T) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..30 { let t = Instant::now(); std::hint::black_box(f()); best = best.min(t.elapsed().as_secs_f64()); }
    println!("{name:20} {:8.1} us", best * 1e6); best
}
fn env(n: &str, d: f64) -> f64 { std::env::var(n).ok().and_then(|v| v.parse().ok()).unwrap_or(d) }
#[test]
fn parts() {
    let n = env("N", 1000.0) as usize;
    for joints in [1, 3, 7] {
    let path = support::RandomSpline::new(1, joints).sample(n, 0);
    println!("joints {joints}");
    let sweep = time("reachable_profile", || reachable_profile(&path));
    time("sampled", || PieceProgram::sampled(&path, 0, &[]));
    time("new", || PieceProgram::new(&path, 0));
    let p = PieceProgram::new(&path, 0).unwrap();
    time("forward", || forward(&p));
    let b = Beginning::new(&p, Start::Greedy);
    time("keep", || { let mut rows = KeptRows::default(); rows.keep(&p, &b.profile, b.near) });
    let mut rows = KeptRows::default(); rows.keep(&p, &b.profile, b.near);
    let t = time("solve", || b.solve(&p, &rows));
    let a = solve_structured(&p, Start::Greedy);
    println!("rows {} steps {} {:.1} us a step", rows.rows.len(), a.iterations, t / a.iterations as f64 * 1e6);
    let mut s = State::new(&p, &rows, b.profile.iter().map(|x| 0.97 * x).collect(), 0.03, 0.1);
    time("  state", || State::new(&p, &rows, b.profile.iter().map(|x| 0.97 * x).collect(), 0.03, 0.1));
    time("  assess", || s.assess());
    let m = s.assess();
    let mut c = centre::Centre::default();
    time("  direct", || c.direct(&mut s, &m, Correctors::None));
    time("  eliminate", || c.factor.eliminate(&s.diagonal, &s.blocks));
    let mut v = s.right.clone();
    time("  solve", || { v.clone_from(&s.right); c.factor.solve(&mut v) });
    time("excess", || p.largest_excess(&a.b));
    time("repair", || repair(&p, &a.b));
    let x = repair(&p, &a.b).unwrap();
    time("lower", || lower_bound(&p, &x, &a.multipliers));
    time("feasible_time", || feasible_time(&p, &x));
    time("violation", || Violation::new(&path, 0, &x));
    let o = time("optimum", || time_optimum(&path));
    println!("ratio to sweep {:.2}", o / sweep);
    }
}
#[test]
fn ratio() {
    let n = env("N", 1000.0) as usize;
    let mut r = vec![]; let mut steps = vec![];
    for seed in 0..env("COUNT", 60.0) as u64 {
        let path = support::RandomSpline::new(seed, 1 + (seed % 7) as usize).sample(n, 0);
        let best = |f: &dyn Fn()| (0..5).map(|_| { let t = Instant::now(); f(); t.elapsed().as_secs_f64() }).fold(f64::INFINITY, f64::min);
        let s = best(&|| { std::hint::black_box(reachable_profile(&path)).unwrap(); });
        let o = best(&|| { std::hint::black_box(time_optimum(&path)).unwrap(); });
        r.push(o / s); steps.push(time_optimum(&path).unwrap().iterations);
    }
    r.sort_by(f64::total_cmp); steps.sort();
    println!("ratio to sweep median {:.2} max {:.2} steps {} {}", r[r.len() / 2], r[r.len() - 1], steps[steps.len() / 2], steps[steps.len() - 1]);
}
