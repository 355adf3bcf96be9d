//! The sweep and both solvers of the optimum beside the crate `copp` on one random spline of 7 joints, in one run, from samples of the
//! path to the profile; ours with its certificate.

use copp::robot::Robot;
use copp::solver::copp2_socp::{ClarabelOptionsBuilder, Copp2ProblemBuilder, CoppObjective, copp2_socp};
use copp::solver::topp2_ra::{ReachSet2OptionsBuilder, Topp2ProblemBuilder, topp2_ra};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use nalgebra::DMatrix;
use slideway_baselines::time_optimal::{Solver, reachable_profile, time_optimum_by};
use slideway_path::SampledPath;
use std::hint::black_box;
use support::RandomSpline;

#[path = "../tests/support/mod.rs"]
mod support;

const JOINTS: usize = 7;

/// The rival's problem from the same samples. Its path positions are not used by these limits.
fn robot(path: &SampledPath) -> Robot<usize> {
    let nodes = &path.pieces[0].nodes;
    let s: Vec<f64> = nodes.iter().map(|node| node.s).collect();
    let first = DMatrix::from_fn(JOINTS, nodes.len(), |i, k| nodes[k].first[i]);
    let second = DMatrix::from_fn(JOINTS, nodes.len(), |i, k| nodes[k].second[i]);
    let position = DMatrix::zeros(JOINTS, nodes.len());
    let acceleration = path.acceleration.clone().unwrap_or_default();
    let lower: Vec<f64> = acceleration.iter().map(|a| -a).collect();
    let mut robot = Robot::with_capacity(JOINTS, nodes.len());
    robot.with_s(s.as_slice()).expect("valid");
    robot.with_q(&position.as_view(), &first.as_view(), &second.as_view(), None, 0).expect("valid");
    let n = nodes.len();
    robot.with_axial_velocity((path.speed_upper.as_slice(), n), (path.speed_lower.as_slice(), n), 0).expect("valid");
    robot.with_axial_acceleration((acceleration.as_slice(), n), (lower.as_slice(), n), 0).expect("valid");
    robot
}

fn reachability(robot: &Robot<usize>, last: usize) -> Vec<f64> {
    let problem = Topp2ProblemBuilder::new(robot, (0, last), (0.0, 0.0)).build().expect("valid");
    topp2_ra(&problem, &ReachSet2OptionsBuilder::new().build().expect("valid")).expect("feasible")
}

fn conic(robot: &Robot<usize>, last: usize) -> Vec<f64> {
    let objectives = [CoppObjective::Time(1.0)];
    let problem = Copp2ProblemBuilder::new(robot, (0, last), (0.0, 0.0), &objectives).build().expect("valid");
    let options = ClarabelOptionsBuilder::new().allow_almost_solved(true).build().expect("valid");
    copp2_socp(&problem, &options).expect("feasible")
}

fn rivals(c: &mut Criterion) {
    for intervals in [100, 1000, 4000] {
        let path = RandomSpline::new(1, JOINTS).sample(intervals, 0);
        let rival = robot(&path);
        let mut group = c.benchmark_group("reachability");
        group.sample_size(20);
        group.bench_with_input(BenchmarkId::new("slideway", intervals), &path, |b, path| {
            b.iter(|| reachable_profile(black_box(path)))
        });
        group.bench_with_input(BenchmarkId::new("copp", intervals), &rival, |b, rival| {
            b.iter(|| reachability(black_box(rival), intervals))
        });
        group.bench_with_input(BenchmarkId::new("copp-with-rows", intervals), &path, |b, path| {
            b.iter(|| reachability(&robot(black_box(path)), intervals))
        });
        group.finish();
        let mut group = c.benchmark_group("optimum");
        group.sample_size(10);
        for solver in [Solver::Structured, Solver::Conic] {
            let name = format!("slideway-{solver}-certified");
            group.bench_with_input(BenchmarkId::new(name, intervals), &path, |b, path| {
                b.iter(|| time_optimum_by(black_box(path), solver))
            });
        }
        group.bench_with_input(BenchmarkId::new("copp-conic", intervals), &rival, |b, rival| {
            b.iter(|| conic(black_box(rival), intervals))
        });
        group.finish();
    }
}

criterion_group!(benches, rivals);
criterion_main!(benches);
