use core::ffi::c_void;

use slideway_conditioner::shapes::{
    Ball, BoothOval, Cylinder, Ellipsoid, HalfSpace, Moving, Oscillation, Polytope, SmoothBox, UniformMotion,
};

use crate::callback::{Callback, EvaluateConstraint};
use crate::choices::AllowedSide;
use crate::memory::{sized, slice};
use crate::refusal::Refused;
use crate::speed::first;
use crate::status::Status;
use crate::surface::{Carrier, Surface, Wall};
use crate::{MAX_FACES, MAX_JOINTS};

/// One constraint of a path conditioner. `shape` says which fields count; the others are not looked at.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Constraint {
    /// Size of this structure as the caller knows it: `sizeof(slideway_constraint)`.
    pub size: u32,
    /// One of `slideway_shape_kind`.
    pub shape: u32,
    /// One of `slideway_allowed_side`.
    pub side: u32,
    /// One of `slideway_carrier_kind`; a callback is told the time and needs none.
    pub carrier: u32,
    /// Centre, or a point on the axis.
    pub point: [f64; MAX_JOINTS],
    /// Normal, axis, semi-axes, half edges or weights.
    pub vector: [f64; MAX_JOINTS],
    /// The plane's `d` in `n . p = d`.
    pub offset: f64,
    /// Radius, in units of the position.
    pub radius: f64,
    /// Factor that turns a dimensionless distance into one comparable with lengths.
    pub scale: f64,
    /// Exponent of a box, from 2 to 64: the larger, the sharper its edges.
    pub exponent: f64,
    /// Sharpness of a polytope, per unit of length.
    pub sharpness: f64,
    /// Number of faces, from 1 to `SLIDEWAY_MAX_FACES`.
    pub face_count: u32,
    /// Nothing; 0.
    pub reserved: u32,
    /// `face_count` rows of `coordinates` numbers: outward normals. Copied when the conditioner is made.
    pub normals: *const f64,
    /// `face_count` numbers, `d` of each face. Copied when the conditioner is made.
    pub offsets: *const f64,
    /// Velocity of a uniform carrier, per second; amplitudes of an oscillation.
    pub velocity: [f64; MAX_JOINTS],
    /// Acceleration of a uniform carrier, per second squared.
    pub acceleration: [f64; MAX_JOINTS],
    /// Angular frequency of an oscillation, rad/s.
    pub frequency: f64,
    /// Phase of an oscillation, rad.
    pub phase: f64,
    /// The caller's function of a callback.
    pub evaluate: EvaluateConstraint,
    /// Handed to `evaluate`; it must stay good for as long as the conditioner lives.
    pub context: *mut c_void,
}

sized!(Constraint);

impl Constraint {
    /// # Safety
    ///
    /// A polytope's pointers are null or point to what their fields say. A callback may be called for as long as the result lives.
    pub(crate) unsafe fn wall<const N: usize>(&self) -> Result<Wall<N>, Refused> {
        if self.shape == 0 {
            let evaluate = self.evaluate.ok_or(Status::Null)?;
            return Ok(Wall::Callback(Callback { evaluate, context: self.context }));
        }
        // SAFETY: the caller's promise.
        let shape = unsafe { self.surface() }?;
        let carrier = match self.carrier {
            0 => return Ok(Wall::Still(shape)),
            1 => Carrier::Uniform(UniformMotion {
                velocity: moving(&self.velocity)?,
                acceleration: moving(&self.acceleration)?,
            }),
            2 => {
                let [frequency, phase] = moving(&[self.frequency, self.phase])?;
                Carrier::Oscillation(Oscillation { amplitude: moving(&self.velocity)?, frequency, phase })
            }
            _ => return Err(Status::Choice.into()),
        };
        Ok(Wall::Moving(Moving { shape, trajectory: carrier }))
    }

    /// # Safety
    ///
    /// As [`Constraint::wall`].
    unsafe fn surface<const N: usize>(&self) -> Result<Surface<N>, Refused> {
        let (point, vector) = (first::<N>(&self.point), first::<N>(&self.vector));
        let side = AllowedSide::from_number(self.side)?;
        Ok(match self.shape {
            1 => Surface::HalfSpace(HalfSpace::new(&vector, self.offset)?),
            2 => Surface::Ball(Ball::new(point, self.radius, side)?),
            3 => Surface::Cylinder(Cylinder::new(point, &vector, self.radius, side)?),
            4 => Surface::Ellipsoid(Ellipsoid::new(point, &vector, self.scale, side)?),
            5 => Surface::SmoothBox(SmoothBox::new(point, vector, self.exponent, self.scale, side)?),
            6 => Surface::BoothOval(BoothOval::new(vector, self.radius, side)?),
            7 => {
                let count = self.face_count as usize;
                if count > MAX_FACES {
                    return Err(Refused::of(Status::ShapeFaceCount, f64::from(self.face_count)));
                }
                // SAFETY: the caller's promise; rows of `N` numbers lie as `[f64; N]` do.
                let normals = unsafe { slice(self.normals.cast::<[f64; N]>(), count) }?;
                // SAFETY: the caller's promise.
                let offsets = unsafe { slice(self.offsets, count) }?;
                Surface::Polytope(Polytope::with_faces(normals, offsets, self.sharpness, side)?)
            }
            _ => return Err(Status::Choice.into()),
        })
    }
}

/// The first `N` numbers of a carrier, all finite.
fn moving<const N: usize>(numbers: &[f64]) -> Result<[f64; N], Refused> {
    let numbers = first::<N>(numbers);
    match numbers.iter().find(|x| !x.is_finite()) {
        Some(&value) => Err(Refused::of(Status::ShapeCarrier, value)),
        None => Ok(numbers),
    }
}
