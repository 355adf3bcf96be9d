//! From a number at run time to a type with that number in it.

/// Evaluates an expression with a constant of that value; [`crate::Status::Joints`] outside of 1 to 12.
macro_rules! with_joints {
    ($count:expr, $N:ident => $body:expr) => {
        $crate::dispatch::with_count!($count, $N => $body, $crate::status::Status::Joints;
            1 2 3 4 5 6 7 8 9 10 11 12)
    };
}

/// As [`with_joints`], for a number of constraints.
macro_rules! with_constraints {
    ($count:expr, $M:ident => $body:expr) => {
        $crate::dispatch::with_count!($count, $M => $body, $crate::status::Status::Constraints; 1 2 3 4)
    };
}

macro_rules! with_count {
    ($count:expr, $N:ident => $body:expr, $otherwise:expr; $($n:literal)*) => {
        match $count {
            $($n => {
                const $N: usize = $n;
                $body
            })*
            _ => Err($otherwise.into()),
        }
    };
}

pub(crate) use {with_constraints, with_count, with_joints};
