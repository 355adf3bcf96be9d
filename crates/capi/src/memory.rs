//! Objects behind the pointers that cross the border, and the checks of those pointers.

use core::mem::{align_of, size_of};
use core::ptr::addr_of_mut;

use crate::status::Status;

/// Where an object lies, and so how it ends.
pub(crate) const CALLERS_MEMORY: u32 = 0;
/// See [`CALLERS_MEMORY`].
#[cfg(feature = "std")]
pub(crate) const HEAP: u32 = 1;

/// The first words of every object: they tell what follows.
#[repr(C, align(8))]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Header {
    /// The kind's own number; anything else is no object of this kind, and 0 one that has ended.
    pub(crate) kind: u32,
    /// Number of joints or coordinates, from 1 to `MAX_JOINTS`.
    pub(crate) joints: u32,
    /// Number of constraints; 0 for a regulator.
    pub(crate) constraints: u32,
    pub(crate) owner: u32,
    /// 1 while a call runs that calls back.
    pub(crate) busy: u32,
    pub(crate) reserved: u32,
}

/// An object as it lies in memory.
#[repr(C, align(8))]
pub(crate) struct Object<T> {
    header: Header,
    value: T,
}

/// A type of objects that the caller knows by an opaque pointer.
pub(crate) trait Kind {
    /// Number in the header. Four letters and the layout's version, so that neither zeros nor text pass for it.
    const NUMBER: u32;
}

/// A structure that tells its own size in its first field.
///
/// # Safety
///
/// The type is `repr(C)`, its first field is a `u32`, and every bit pattern is a value of it.
pub(crate) unsafe trait Sized32 {}

macro_rules! sized {
    ($type:ty) => {
        // SAFETY: `repr(C)`, begins with a `u32`, and holds integers, floats and nullable pointers only.
        unsafe impl $crate::memory::Sized32 for $type {}
    };
}
pub(crate) use sized;

/// Refuses what is null or not aligned.
pub(crate) fn check_pointer<T>(pointer: *const T) -> Result<(), Status> {
    if pointer.is_null() {
        return Err(Status::Null);
    }
    if pointer.is_aligned() { Ok(()) } else { Err(Status::Alignment) }
}

/// Copies a structure of the caller's; its size must be the one this library knows.
///
/// # Safety
///
/// `pointer` is null or points to a structure of at least the size that its first field says.
pub(crate) unsafe fn read_in<T: Sized32 + Copy>(pointer: *const T) -> Result<T, Status> {
    // SAFETY: the caller's promise is the same.
    unsafe { check_size(pointer) }?;
    // SAFETY: not null, aligned, as large as the type, and every bit pattern is a value.
    Ok(unsafe { pointer.read() })
}

/// The size of a structure that is to be written, if it can be.
///
/// # Safety
///
/// As [`read_in`].
pub(crate) unsafe fn check_out<T: Sized32>(pointer: *mut T) -> Result<u32, Status> {
    // SAFETY: the caller's promise is the same.
    unsafe { check_size(pointer.cast_const()) }
}

/// A structure that a call writes, and fills with safe values if the call fails.
pub(crate) trait Output: Sized32 {
    /// Fails safe.
    fn stand(&mut self);
}

/// Runs a call whose output can be written; if it fails, the output fails safe.
///
/// # Safety
///
/// `out` is null or points to a structure of at least the size that its first field says, which nothing refers to.
#[inline]
pub(crate) unsafe fn deliver<T: Output>(out: *mut T, run: impl FnOnce() -> Result<(), Status>) -> Status {
    // SAFETY: the caller's promise is the same.
    if let Err(status) = unsafe { check_size(out.cast_const()) } {
        return status;
    }
    let Err(status) = run() else { return Status::Ok };
    // SAFETY: not null, aligned, of the right size, and nothing refers to it.
    unsafe { &mut *out }.stand();
    status
}

/// # Safety
///
/// As [`read_in`].
unsafe fn check_size<T: Sized32>(pointer: *const T) -> Result<u32, Status> {
    check_pointer(pointer)?;
    // SAFETY: not null, aligned, and the type begins with a `u32`.
    let size = unsafe { pointer.cast::<u32>().read() };
    if size as usize == size_of::<T>() { Ok(size) } else { Err(Status::Size) }
}

/// Copies `N` numbers of the caller's.
///
/// # Safety
///
/// `pointer` is null or points to `N` numbers.
#[inline]
pub(crate) unsafe fn numbers<const N: usize>(pointer: *const f64) -> Result<[f64; N], Status> {
    check_pointer(pointer)?;
    // SAFETY: not null, aligned, and `N` numbers long.
    Ok(unsafe { pointer.cast::<[f64; N]>().read() })
}

/// A caller's array as a slice; a length of zero goes with any pointer.
///
/// # Safety
///
/// `pointer` is null or points to `count` elements that nobody writes while the slice lives.
pub(crate) unsafe fn slice<'a, T>(pointer: *const T, count: usize) -> Result<&'a [T], Status> {
    if count == 0 {
        return Ok(&[]);
    }
    check_array(pointer, count)?;
    // SAFETY: not null, aligned, `count` elements long, and no longer than an array can be.
    Ok(unsafe { core::slice::from_raw_parts(pointer, count) })
}

/// As [`slice`], to be written.
///
/// # Safety
///
/// `pointer` is null or points to `count` writable elements that nothing else refers to while the slice lives.
pub(crate) unsafe fn slice_mut<'a, T>(pointer: *mut T, count: usize) -> Result<&'a mut [T], Status> {
    if count == 0 {
        return Ok(&mut []);
    }
    check_array(pointer.cast_const(), count)?;
    // SAFETY: as above, and writable and unshared by the caller's promise.
    Ok(unsafe { core::slice::from_raw_parts_mut(pointer, count) })
}

fn check_array<T>(pointer: *const T, count: usize) -> Result<(), Status> {
    check_pointer(pointer)?;
    if count > isize::MAX as usize / size_of::<T>().max(1) { Err(Status::Length) } else { Ok(()) }
}

/// Bytes that an object with this value takes.
pub(crate) const fn object_size<T>() -> usize {
    size_of::<Object<T>>()
}

/// Writes an object into memory.
///
/// # Safety
///
/// `memory` is null or points to `bytes` bytes that are the caller's alone.
pub(crate) unsafe fn place<T>(memory: *mut u8, bytes: usize, header: Header, value: T) -> Result<(), Status> {
    let object = memory.cast::<Object<T>>();
    check_pointer(object)?;
    if bytes < size_of::<Object<T>>() {
        return Err(Status::Memory);
    }
    // SAFETY: not null, aligned, and large enough.
    unsafe { object.write(Object { header, value }) };
    Ok(())
}

/// The header of a living object of this kind that no call of its own is using.
///
/// # Safety
///
/// `object` is null or points to memory of at least the size of a header.
#[inline]
pub(crate) unsafe fn header<K: Kind>(object: *const K) -> Result<Header, Status> {
    let header = object.cast::<Header>();
    check_pointer(header)?;
    // SAFETY: not null, aligned, and a header is readable there; it is made of integers.
    let header = unsafe { header.read() };
    if header.kind != K::NUMBER {
        return Err(Status::Object);
    }
    if header.busy == 0 { Ok(header) } else { Err(Status::Busy) }
}

/// The value of an object whose header was checked.
///
/// # Safety
///
/// `object` is living, its header says that it holds a `T`, and nobody else uses it.
#[inline]
pub(crate) unsafe fn value<'a, K: Kind, T>(object: *mut K) -> &'a mut T {
    let object = object.cast::<Object<T>>();
    // SAFETY: the header, which `place` wrote with the value, says that this type lies there.
    let value = unsafe { addr_of_mut!((*object).value) };
    // SAFETY: initialised by `place`, and no other reference to it lives.
    unsafe { &mut *value }
}

/// Marks an object as in use, or as free again.
///
/// # Safety
///
/// `object` is living. No reference to its header lives; none is ever made.
pub(crate) unsafe fn set_busy<K: Kind>(object: *mut K, busy: u32) {
    // SAFETY: the header is there.
    let flag = unsafe { addr_of_mut!((*object.cast::<Header>()).busy) };
    // SAFETY: aligned and writable.
    unsafe { flag.write(busy) };
}

/// Ends an object: its pointer is refused from now on. Values own nothing, so there is nothing else to do.
///
/// # Safety
///
/// As [`header`], and the memory may be written.
pub(crate) unsafe fn end<K: Kind>(object: *mut K, owner: u32) -> Result<Header, Status> {
    // SAFETY: the caller's promise is the same.
    let header = unsafe { header(object.cast_const()) }?;
    if header.owner != owner {
        return Err(Status::Owner);
    }
    // SAFETY: a living object begins with a header.
    unsafe { object.cast::<Header>().write(Header { kind: 0, ..header }) };
    Ok(header)
}

const _: () = assert!(align_of::<Object<f64>>() == crate::ALIGNMENT);
