//! Singularity-consistent inversion `[N]`: joints and path parameter as one vector, their common speed as the unknown.
//!
//! A tool that follows a path `x(q*)` obeys `J q̇ = t* q̇*`, with the twist `t*` of the tool at unit path speed. With the
//! column-augmented Jacobian `J̄ = [J, -t*]` (`[N] eq 3`) and `q̄ = (q, q*)` this reads `J̄ q̄' = 0`. For as many joints as
//! task coordinates
//!
//! ```text
//! n̄ = [n; det J],  n = adj(J) t*        J̄ n̄ = 0 at every configuration
//! q̇ = b n,  q̇* = b det J                [N] eq 7, 8
//! ```
//!
//! Taking `b` as the independent variable divides by nothing: where `J` loses one rank and `t*` leaves its range the path
//! stands, the joints go on, and the path is run through the other way. Where `J̄` itself loses rank (codimension two)
//! `n̄` is zero.
//!
//! *Sign.* `[N] eq 5` and `eq 6` as printed differ by `(-1)^N`. Here the last entry is `det J`, as in eq 6, at every `N`.
//!
//! *Natural motion* is `b` constant. Its kinetic energy is proportional to `b²` and its power to `b³` at every place.

mod factor;
mod inversion;
mod null_vector;
mod redundant;
mod torque;

pub use factor::SpeedFactor;
pub use inversion::{Flow, PathMotion, PathTangent, SingularityConsistent};
pub use null_vector::{NullVector, null_vector, null_vector_rate};
pub use redundant::{JointMetric, redundant_null_vector};
pub use torque::{PathTorque, path_torque};
