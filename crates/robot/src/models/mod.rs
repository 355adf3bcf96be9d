//! Built-in arms.

mod puma560;

pub use puma560::puma560;
