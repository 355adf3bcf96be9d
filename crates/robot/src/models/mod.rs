//! Built-in arms.

mod catalogue;
mod puma560;

pub use catalogue::Model;
pub use puma560::{puma560, puma560_dynamics};
