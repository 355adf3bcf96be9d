use super::*;
use crate::time_optimal::*;
#[path = "../../../tests/support/mod.rs"]
#[allow(unused)]
mod support;
use std::time::Instant;
fn env(n: &str, d: f64) -> f64 { std::env::var(n).ok().and_then(|v| v.parse().ok()).unwrap_or(d) }
#[test]
fn ipm() {
    let n = env("N", 1000.0) as usize;
    let mut steps = vec![]; let mut bad = 0; let mut times = vec![]; let mut sweep = vec![]; let mut pre = vec![]; let mut nrows = vec![]; let mut exc = 0;
    for seed in 0..env("COUNT", 60.0) as u64 {
        let path = support::RandomSpline::new(seed, 1 + (seed % 7) as usize).sample(n, 0);
        let p = PieceProgram::new(&path, 0).unwrap();
        let t = Instant::now(); let _ = std::hint::black_box(reachable_profile(&path)); sweep.push(t.elapsed().as_secs_f64());
        let t = Instant::now();
        let a = solve_structured(&p, Start::Greedy);
        times.push(t.elapsed().as_secs_f64());
        steps.push(a.iterations); nrows.push(a.multipliers.iter().filter(|m| **m != 0.0).count());
        let e = p.largest_excess(&a.b);
        if e > 0.0 { exc += 1; }
        let t = Instant::now();
        let o = time_optimum(&path).unwrap();
        pre.push(t.elapsed().as_secs_f64());
        if o.gap() > 1e-7 || o.attempts.len() > 1 || std::env::var("V").is_ok() { bad += 1; println!("seed {seed} {} {} gap {:.1e} excess {e:.1e} {:?}", a.iterations, a.status, o.gap(), o.attempts); }
    }
    let med = |v: &mut Vec<f64>| { v.sort_by(f64::total_cmp); v[v.len() / 2] };
    steps.sort(); nrows.sort();
    println!("steps {} max {} bad {bad} excess {exc} rows {} max {} ipm {:.1} us, total {:.1} us, sweep {:.1} us", steps[steps.len() / 2], steps[steps.len() - 1], nrows[nrows.len() / 2], nrows[nrows.len() - 1], med(&mut times) * 1e6, med(&mut pre) * 1e6, med(&mut sweep) * 1e6);
}
