//! The certified optimum of your own arrays, and its trajectory as CSV:
//! `cargo run --release -p slideway-baselines --example own_arrays > optimum.csv`.

use nalgebra::{Vector2, vector};
use slideway_baselines::path_bracket::{BracketOptions, End, JointLimits, JointPath, JointPathProblem, PathBracket};
use slideway_path::curve::{CubicSpline, Spacing, SplineEnds, Waypoints};

const SPEED: [f64; 2] = [1.5, 2.0]; // rad/s
const ACCELERATION: [f64; 2] = [4.0, 6.0]; // rad/s²
const PERIOD: f64 = 0.02; // s

/// The spline as the powers of the distance from each of its knots.
fn polynomials(spline: &CubicSpline<2>) -> Vec<Vec<Vec<f64>>> {
    let cubic = |ends: &[f64]| {
        let ([q, slope, bend], [_, _, next]) = (spline.at(ends[0]), spline.at(ends[1]));
        let cube = (next - bend) / (6.0 * (ends[1] - ends[0]));
        (0..2).map(|i| vec![q[i], slope[i], 0.5 * bend[i], cube[i]]).collect()
    };
    spline.waypoints().at().windows(2).map(cubic).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points: Vec<Vector2<f64>> = vec![vector![0.0, 0.5], vector![0.4, 1.1], vector![1.0, 0.6], vector![1.2, 0.0]];
    let spline = CubicSpline::new(Waypoints::new(points, &Spacing::Chord, 0.0..1.0)?, SplineEnds::Natural)?;
    let path = JointPath::new(spline.waypoints().at().to_vec(), polynomials(&spline))?;
    let limits = JointLimits::symmetric(SPEED.to_vec(), ACCELERATION.to_vec())?;
    let problem = JointPathProblem::new(path, limits, [End::Rest, End::Rest])?;
    let bracket = PathBracket::solve(&problem, &BracketOptions::default())?;
    eprintln!("no motion along this path is faster than {:.6} s", bracket.lower_s);
    eprintln!("the one below takes {:.6} s, {:.1e} of it more", bracket.upper_s, bracket.gap);

    println!("t,lambda,lambda_dot,q1,q2,qd1,qd2,qdd1,qdd2");
    let mut most = [0.0_f64; 2];
    let samples = (bracket.profile.duration_s() / PERIOD).ceil() as u32;
    for sample in 0..=samples {
        let time = (f64::from(sample) * PERIOD).min(bracket.profile.duration_s());
        let along = bracket.profile.at_time(time);
        let [q, slope, bend] = spline.at(along.s);
        let speed = slope * along.s_dot;
        let acceleration = slope * along.s_ddot + bend * along.s_dot.powi(2);
        println!(
            "{time:.4},{:.6},{:.6},{:.6},{:.6},{:.6},{:.6},{:.6},{:.6}",
            along.s, along.s_dot, q[0], q[1], speed[0], speed[1], acceleration[0], acceleration[1]
        );
        most = std::array::from_fn(|i| most[i].max((acceleration[i] / ACCELERATION[i]).abs()));
    }
    eprintln!("of the acceleration limits {:.4} and {:.4} were used at most", most[0], most[1]);
    Ok(())
}
