use core::ffi::c_void;

use slideway_conditioner::path::{ConstraintSample, Motion};

use crate::MAX_JOINTS;
use crate::command::put;
use crate::speed::first;

/// A point in motion, as a callback is asked about it. Its pointers are good during the call only.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct PathMotion {
    /// Size of this structure as the library knows it.
    pub size: u32,
    /// Number of coordinates.
    pub coordinates: u32,
    /// Time of the sample, s.
    pub time: f64,
    /// Position, `coordinates` numbers.
    pub position: *const f64,
    /// Velocity, per second, `coordinates` numbers.
    pub velocity: *const f64,
}

/// Answer of a callback about its constraint `sigma(p, t) <= 0`. Of an array the first `coordinates` elements count.
///
/// The callback finds `value` and `gradient` as NaN, which holds the reference if it does not write them, and the three rates as 0,
/// which is right for a flat wall that stands still.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ConstraintValue {
    /// Size of this structure as the library knows it.
    pub size: u32,
    /// Nothing; 0.
    pub reserved: u32,
    /// `sigma`: positive outside the allowed set, best a distance.
    pub value: f64,
    /// Rate of `sigma` at a fixed position, per second.
    pub time_rate: f64,
    /// Rate of `time_rate` along the motion.
    pub time_rate_rate: f64,
    /// Derivative of `sigma` by the position.
    pub gradient: [f64; MAX_JOINTS],
    /// Rate of the gradient along the motion: its Hessian times the velocity, and what it changes with time.
    pub gradient_rate: [f64; MAX_JOINTS],
}

/// A caller's constraint: writes `sample` for `motion` and returns 0. Any other number says that it could not, and holds the reference.
///
/// It is called on the thread of the step, up to `SLIDEWAY_MAX_EVALUATIONS` times a step, at places that are not given out, and gives the
/// same answer to the same question. It must not throw, jump out, or call the object that calls it, which is refused.
pub type EvaluateConstraint =
    Option<unsafe extern "C" fn(context: *mut c_void, motion: *const PathMotion, sample: *mut ConstraintValue) -> i32>;

/// A function of the caller's and what it is called with.
pub(crate) struct Callback {
    pub(crate) evaluate: unsafe extern "C" fn(*mut c_void, *const PathMotion, *mut ConstraintValue) -> i32,
    pub(crate) context: *mut c_void,
}

/// Cannot evaluate anything.
unsafe extern "C" fn fail(_: *mut c_void, _: *const PathMotion, _: *mut ConstraintValue) -> i32 {
    1
}

impl Callback {
    /// A place that is not filled yet: it would hold the reference.
    pub(crate) const FAILING: Self = Self { evaluate: fail, context: core::ptr::null_mut() };

    pub(crate) fn sample<const N: usize>(&self, motion: &Motion<N>) -> ConstraintSample<N> {
        let question = PathMotion {
            size: size_of::<PathMotion>() as u32,
            coordinates: N as u32,
            time: motion.time,
            position: motion.position.as_ptr(),
            velocity: motion.velocity.as_ptr(),
        };
        let mut answer = ConstraintValue {
            size: size_of::<ConstraintValue>() as u32,
            reserved: 0,
            value: f64::NAN,
            time_rate: 0.0,
            time_rate_rate: 0.0,
            gradient: [0.0; MAX_JOINTS],
            gradient_rate: [0.0; MAX_JOINTS],
        };
        put(&mut answer.gradient, &[f64::NAN; N]);
        // SAFETY: whoever gave the function promised that it may be called with this context, for as long as the object lives.
        let failed = unsafe { (self.evaluate)(self.context, &raw const question, &raw mut answer) };
        ConstraintSample {
            value: if failed == 0 { answer.value } else { f64::NAN },
            gradient: first(&answer.gradient),
            time_rate: answer.time_rate,
            gradient_rate: first(&answer.gradient_rate),
            time_rate_rate: answer.time_rate_rate,
        }
    }
}
