//! Objects on the heap: the same objects, in memory that the library asks for.

use std::alloc::{Layout, alloc, dealloc};

use crate::acceleration::{Acceleration, AccelerationSettings, slideway_acceleration_size};
use crate::memory::{HEAP, Kind, end, read_in};
use crate::path::{Path, slideway_path_size};
use crate::path_settings::PathSettings;
use crate::refusal::{Refusal, Refused, report};
use crate::speed::{Speed, SpeedSettings, slideway_speed_size};
use crate::status::Status;
use crate::{ALIGNMENT, acceleration, path, speed};

fn layout(size: usize) -> Result<Layout, Status> {
    if size == 0 { Err(Status::Object) } else { Layout::from_size_align(size, ALIGNMENT).map_err(|_| Status::Length) }
}

/// Makes an object in fresh memory; on failure the memory is given back.
///
/// # Safety
///
/// `make` writes at most `size` bytes, and keeps no pointer to them if it fails.
unsafe fn on_heap(size: usize, make: impl FnOnce(*mut u8) -> Result<(), Refused>) -> Result<(), Refused> {
    let layout = layout(size)?;
    // SAFETY: the size is not zero.
    let memory = unsafe { alloc(layout) };
    if memory.is_null() {
        return Err(Status::OutOfMemory.into());
    }
    let made = make(memory);
    if made.is_err() {
        // SAFETY: allocated above with this layout.
        unsafe { dealloc(memory, layout) };
    }
    made
}

/// Ends an object on the heap and gives its memory back; null is no object and is left alone.
///
/// # Safety
///
/// `object` is null or an object of this kind that no other thread uses.
unsafe fn free<K: Kind>(object: *mut K, size: impl FnOnce(u32, u32) -> usize) -> Status {
    if object.is_null() {
        return Status::Ok;
    }
    // SAFETY: the caller's promise.
    let head = match unsafe { end(object, HEAP) } {
        Ok(head) => head,
        Err(status) => return status,
    };
    match layout(size(head.joints, head.constraints)) {
        Ok(layout) => {
            // SAFETY: an object on the heap was allocated with the layout of its size.
            unsafe { dealloc(object.cast(), layout) };
            Status::Ok
        }
        Err(status) => status,
    }
}

/// Makes a speed regulator, reference at rest, on the heap. `*speed` becomes the object, or null on failure. `why` may be null.
///
/// Not in a library built without `std`.
///
/// # Safety
///
/// Every pointer is null or points to what its type says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_new(
    settings: *const SpeedSettings,
    speed: *mut *mut Speed,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { read_in(settings) }.map_err(Refused::from).and_then(|given| {
        let size = known(slideway_speed_size(given.joints), Status::Joints)?;
        // SAFETY: the caller's promise; the memory is as large as the object.
        let make = |memory| unsafe { speed::make(memory, size, settings, speed, HEAP) };
        // SAFETY: `make` knows the size.
        unsafe { on_heap(size, make) }
    });
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// A size that there is an object for.
fn known(size: usize, otherwise: Status) -> Result<usize, Status> {
    if size == 0 { Err(otherwise) } else { Ok(size) }
}

/// Ends a speed regulator that `slideway_speed_new` made and frees its memory. Null is left alone.
///
/// # Safety
///
/// `speed` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_free(speed: *mut Speed) -> Status {
    // SAFETY: the caller's promise.
    unsafe { free(speed, |joints, _| slideway_speed_size(joints)) }
}

/// Makes an acceleration-limited regulator on the heap; as `slideway_speed_new`.
///
/// # Safety
///
/// As `slideway_speed_new`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_acceleration_new(
    settings: *const AccelerationSettings,
    acceleration: *mut *mut Acceleration,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { read_in(settings) }.map_err(Refused::from).and_then(|given| {
        let size = known(slideway_acceleration_size(given.joints), Status::Joints)?;
        // SAFETY: the caller's promise; the memory is as large as the object.
        let make = |memory| unsafe { acceleration::make(memory, size, settings, acceleration, HEAP) };
        // SAFETY: `make` knows the size.
        unsafe { on_heap(size, make) }
    });
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// Ends an acceleration-limited regulator that `slideway_acceleration_new` made and frees its memory. Null is left alone.
///
/// # Safety
///
/// `acceleration` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_acceleration_free(acceleration: *mut Acceleration) -> Status {
    // SAFETY: the caller's promise.
    unsafe { free(acceleration, |joints, _| slideway_acceleration_size(joints)) }
}

/// Makes a path conditioner on the heap; as `slideway_speed_new`, and as `slideway_path_place` for the constraints.
///
/// # Safety
///
/// As `slideway_path_place`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_path_new(
    settings: *const PathSettings,
    path: *mut *mut Path,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { read_in(settings) }.map_err(Refused::from).and_then(|given| {
        known(slideway_path_size(given.coordinates, 1), Status::Joints)?;
        let size = known(slideway_path_size(given.coordinates, given.constraint_count), Status::Constraints)?;
        // SAFETY: the caller's promise; the memory is as large as the object.
        let make = |memory| unsafe { path::make(memory, size, settings, path, HEAP) };
        // SAFETY: `make` knows the size.
        unsafe { on_heap(size, make) }
    });
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// Ends a path conditioner that `slideway_path_new` made and frees its memory. Null is left alone.
///
/// # Safety
///
/// `path` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_path_free(path: *mut Path) -> Status {
    // SAFETY: the caller's promise.
    unsafe { free(path, |coordinates, constraints| slideway_path_size(coordinates, constraints)) }
}
