/*
 * Sliding-mode reference conditioners for robot controllers: the C interface.
 *
 * Written by cbindgen from the Rust sources of slideway-capi; do not edit.
 *
 * Use of an object, here a speed regulator:
 *
 *     slideway_speed_settings settings = slideway_speed_settings_init();
 *     settings.joints = 2;                          ... and the limits, the sampling period, the bandwidth, the target rate
 *     static SLIDEWAY_ALIGNED unsigned char memory[SLIDEWAY_SPEED_SIZE_MAX];
 *     slideway_speed *regulator;
 *     slideway_status status = slideway_speed_place(memory, sizeof memory, &settings, &regulator, NULL);
 *     if (status != SLIDEWAY_STATUS_OK) puts(slideway_status_message(status));
 *
 *     slideway_speed_command command = slideway_speed_command_init();
 *     for each sample:
 *         rate = slideway_speed_requested_rate(regulator);
 *         desired = what the controller asks of the joints with the reference moving at this rate
 *         slideway_speed_step(regulator, desired, &command);
 *         send command.joint_speed to the robot; path_parameter += period * command.path_rate;
 *
 * Errors.   Every function that can refuse returns a slideway_status. No function prints, aborts, throws or longjmps.
 * NaN.      A NaN or an infinity in an input of a step is no error: the command is a standstill.
 * Memory.   `..._place` puts an object into memory of yours, `..._new` on the heap. Nothing else allocates.
 * Threads.  An object is used by one thread at a time. Different objects are independent; there is no global state.
 * Versions. Every structure begins with its size; the `..._init` functions below set it and clear the rest.
 * Arrays.   Vectors of an object with n joints are n numbers long; fixed arrays in structures use their first n elements.
 * Overlap.  Inputs may overlap outputs: all inputs are read first.
 */

#ifndef SLIDEWAY_H
#define SLIDEWAY_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
#define SLIDEWAY_ALIGNED alignas(8)
#else
#define SLIDEWAY_ALIGNED _Alignas(8)
#endif

// Version of this interface. It grows when something is added; a library serves every program that was compiled with the same or a
// smaller one.
#define SLIDEWAY_ABI_VERSION 1

// Largest number of joints or coordinates.
#define SLIDEWAY_MAX_JOINTS 12

// Largest number of constraints of a path conditioner.
#define SLIDEWAY_MAX_CONSTRAINTS 4

// Largest number of faces of a polytope.
#define SLIDEWAY_MAX_FACES 8

// Alignment of the memory that an object is placed in, bytes.
#define SLIDEWAY_ALIGNMENT 8

// Largest number of times that a constraint is evaluated in one step.
#define SLIDEWAY_MAX_EVALUATIONS 20

// Bytes that are enough for a speed regulator of any number of joints.
#define SLIDEWAY_SPEED_SIZE_MAX 288

// Bytes that are enough for an acceleration-limited regulator of any number of joints.
#define SLIDEWAY_ACCELERATION_SIZE_MAX 1280

// Bytes that are enough for a path conditioner of any size.
#define SLIDEWAY_PATH_SIZE_MAX 8192

// The index where there is none.
#define SLIDEWAY_NO_INDEX UINT32_MAX

// The answer of every function that can refuse: 0 where it did what it was asked.
//
// Numbers are never reused or renumbered. From 100 on a parameter was refused; `slideway_refusal` then says which value.
enum slideway_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // Done.
    SLIDEWAY_STATUS_OK = 0,
    // A pointer that must not be null is null.
    SLIDEWAY_STATUS_NULL = 1,
    // A pointer is not aligned for what it points to.
    SLIDEWAY_STATUS_ALIGNMENT = 2,
    // The first field `size` is of no version of this structure that the library knows.
    SLIDEWAY_STATUS_SIZE = 3,
    // The memory for an object is too small.
    SLIDEWAY_STATUS_MEMORY = 4,
    // No memory is left on the heap.
    SLIDEWAY_STATUS_OUT_OF_MEMORY = 5,
    // The pointer is no living object of this kind.
    SLIDEWAY_STATUS_OBJECT = 6,
    // The object is in use: one of its own callbacks calls it.
    SLIDEWAY_STATUS_BUSY = 7,
    // The object lies in the caller's memory and has no `free`, or on the heap and is freed, not dropped.
    SLIDEWAY_STATUS_OWNER = 8,
    // The function belongs to another law than the object's.
    SLIDEWAY_STATUS_LAW = 9,
    // A number of joints or coordinates outside of 1 to `SLIDEWAY_MAX_JOINTS`.
    SLIDEWAY_STATUS_JOINTS = 10,
    // A number of constraints outside of 1 to `SLIDEWAY_MAX_CONSTRAINTS`.
    SLIDEWAY_STATUS_CONSTRAINTS = 11,
    // A field that holds one of an enumeration's values holds none of them.
    SLIDEWAY_STATUS_CHOICE = 12,
    // A length that no array can have.
    SLIDEWAY_STATUS_LENGTH = 13,
    // An upper joint-speed limit is not positive and finite.
    SLIDEWAY_STATUS_UPPER_SPEED = 100,
    // A lower joint-speed limit is not negative and finite.
    SLIDEWAY_STATUS_LOWER_SPEED = 101,
    // An upper joint-acceleration limit is not positive and finite.
    SLIDEWAY_STATUS_UPPER_ACCELERATION = 102,
    // A lower joint-acceleration limit is not negative and finite.
    SLIDEWAY_STATUS_LOWER_ACCELERATION = 103,
    // A joint speed to start from lies outside its limits.
    SLIDEWAY_STATUS_SPEED = 104,
    // The gain of the position loop is not positive and finite.
    SLIDEWAY_STATUS_GAIN = 105,
    // Gain times sampling period exceeds one half.
    SLIDEWAY_STATUS_GAIN_STEP = 106,
    // The look-ahead's margin is not in [0, 1).
    SLIDEWAY_STATUS_ACCELERATION_MARGIN = 107,
    // The sampling period is not positive and finite.
    SLIDEWAY_STATUS_SAMPLING_PERIOD = 108,
    // The filter bandwidth is not positive and finite.
    SLIDEWAY_STATUS_BANDWIDTH = 109,
    // The target rate is not positive and finite.
    SLIDEWAY_STATUS_TARGET_RATE = 110,
    // Bandwidth times sampling period exceeds 1.
    SLIDEWAY_STATUS_FILTER_STEP = 111,
    // A speed factor outside [0, 1].
    SLIDEWAY_STATUS_FACTOR = 112,
    // The safe walk without the explicit form and its reserve.
    SLIDEWAY_STATUS_SAFE_WALK = 113,
    // The push filter's cutoff is out of range.
    SLIDEWAY_STATUS_PUSH_CUTOFF = 120,
    // An approach time is out of range.
    SLIDEWAY_STATUS_APPROACH = 121,
    // A safety margin is out of range.
    SLIDEWAY_STATUS_MARGIN = 122,
    // The push's gain or amplitude is out of range.
    SLIDEWAY_STATUS_PUSH = 123,
    // The recovery rate is out of range.
    SLIDEWAY_STATUS_RECOVERY_RATE = 124,
    // The walk filter's cutoff is out of range.
    SLIDEWAY_STATUS_WALK_CUTOFF = 125,
    // The pace filter's cutoff is out of range.
    SLIDEWAY_STATUS_PACE_CUTOFF = 126,
    // The walk speed is out of range.
    SLIDEWAY_STATUS_WALK_SPEED = 127,
    // The growth of the walk speed is out of range.
    SLIDEWAY_STATUS_WALK_GROWTH = 128,
    // The gain of the walk's return is out of range.
    SLIDEWAY_STATUS_RETURN_GAIN = 129,
    // The period of the random direction is out of range.
    SLIDEWAY_STATUS_DIRECTION_PERIOD = 130,
    // The distance threshold is out of range.
    SLIDEWAY_STATUS_DISTANCE_THRESHOLD = 131,
    // The clearance threshold is out of range.
    SLIDEWAY_STATUS_CLEARANCE_THRESHOLD = 132,
    // The activity threshold is out of range.
    SLIDEWAY_STATUS_ACTIVITY_THRESHOLD = 133,
    // The share of the push left to the walk is out of range.
    SLIDEWAY_STATUS_PUSH_SHARE = 134,
    // A coordinate to start from is not finite.
    SLIDEWAY_STATUS_START = 135,
    // A coordinate of a shape is not finite.
    SLIDEWAY_STATUS_SHAPE_COORDINATE = 150,
    // A component of a normal or an axis is not finite.
    SLIDEWAY_STATUS_SHAPE_DIRECTION = 151,
    // A normal or an axis has no length.
    SLIDEWAY_STATUS_SHAPE_DIRECTION_LENGTH = 152,
    // The offset of a plane is not finite.
    SLIDEWAY_STATUS_SHAPE_OFFSET = 153,
    // A radius is not positive and finite.
    SLIDEWAY_STATUS_SHAPE_RADIUS = 154,
    // A semi-axis or half edge is not positive and finite.
    SLIDEWAY_STATUS_SHAPE_SEMI_AXIS = 155,
    // A scale is not positive and finite.
    SLIDEWAY_STATUS_SHAPE_SCALE = 156,
    // The exponent of a box lies outside [2, 64].
    SLIDEWAY_STATUS_SHAPE_EXPONENT = 157,
    // A sharpness is not positive and finite.
    SLIDEWAY_STATUS_SHAPE_SHARPNESS = 158,
    // A number of faces outside of 1 to `SLIDEWAY_MAX_FACES`.
    SLIDEWAY_STATUS_SHAPE_FACE_COUNT = 159,
    // A weight is not positive and finite.
    SLIDEWAY_STATUS_SHAPE_WEIGHT = 160,
    // A parameter of a shape's carrier is not finite.
    SLIDEWAY_STATUS_SHAPE_CARRIER = 161,
    // A parameter that a newer core checks and this interface has no name for.
    SLIDEWAY_STATUS_PARAMETER = 199,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_status slideway_status;
#else
typedef int32_t slideway_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The law of a speed regulator.
enum slideway_speed_law
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // Explicit, as published: while a sample saturates, the reference runs ahead of the robot.
    SLIDEWAY_SPEED_LAW_PAPER = 0,
    // Explicit; the reference waits by as much as the robot is slowed.
    SLIDEWAY_SPEED_LAW_SYNCHRONISED = 1,
    // Implicit (backward Euler): no chattering. It wants the desired joint speed in two parts, see `slideway_speed_step_affine`.
    SLIDEWAY_SPEED_LAW_IMPLICIT = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_speed_law slideway_speed_law;
#else
typedef uint32_t slideway_speed_law;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Rule that brings a joint speed beyond the limits back inside them.
enum slideway_saturation_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // Each joint on its own: the tool leaves its direction of motion.
    SLIDEWAY_SATURATION_KIND_DIRECT = 0,
    // All joints by one factor: the direction of motion is kept.
    SLIDEWAY_SATURATION_KIND_DIRECTION_PRESERVING = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_saturation_kind slideway_saturation_kind;
#else
typedef uint32_t slideway_saturation_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Treatment of the part of an acceleration-limited regulator's demand that pulls the robot back to its path.
enum slideway_recovery_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // Leaves it as it is.
    SLIDEWAY_RECOVERY_KIND_AS_DEMANDED = 0,
    // Scales it so that the joints can brake from it, for a position loop of gain `gain`.
    SLIDEWAY_RECOVERY_KIND_BRAKING = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_recovery_kind slideway_recovery_kind;
#else
typedef uint32_t slideway_recovery_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Outcome of one sample of an acceleration-limited regulator: the demand is met, or not.
enum slideway_keeping
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // The demand is commanded as it is.
    SLIDEWAY_KEEPING_ON_PATH = 0,
    // No path rate makes the demand reachable: the joints do what is nearest to it, `excess` off.
    SLIDEWAY_KEEPING_LEAVES_PATH = 1,
    // The demand is not finite: the joints brake as fast as they may, the reference stands.
    SLIDEWAY_KEEPING_BRAKES = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_keeping slideway_keeping;
#else
typedef uint32_t slideway_keeping;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The form of a path conditioner's law.
enum slideway_form
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // Implicit: the smallest push that keeps every constraint at every sample. Uses `recovery_rate`.
    SLIDEWAY_FORM_IMPLICIT = 0,
    // Explicit sliding mode. Uses `law` and `push`.
    SLIDEWAY_FORM_SLIDING = 1,
    // Explicit, and where its push is not enough the smallest one that is. Uses `law`, `push` and `recovery_rate`.
    SLIDEWAY_FORM_SLIDING_WITH_RESERVE = 2,
    // The scheme of the paper's appendix: one sample of lag. Uses `law` and `push`.
    SLIDEWAY_FORM_APPENDIX = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_form slideway_form;
#else
typedef uint32_t slideway_form;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The switching law of an explicit form.
enum slideway_push_law
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // The sum of the active constraints' gradients; `push` is the switching gain.
    SLIDEWAY_PUSH_LAW_SUM = 0,
    // Their direction at a fixed length; `push` is that length, in units of the position.
    SLIDEWAY_PUSH_LAW_NORMALISED = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_push_law slideway_push_law;
#else
typedef uint32_t slideway_push_law;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Margin added to each constraint, so that chattering stays inside the allowed set.
enum slideway_margin_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // Nothing.
    SLIDEWAY_MARGIN_KIND_NONE = 0,
    // The proven upper band of the form.
    SLIDEWAY_MARGIN_KIND_BAND = 1,
    // The numbers in `margins`.
    SLIDEWAY_MARGIN_KIND_FIXED = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_margin_kind slideway_margin_kind;
#else
typedef uint32_t slideway_margin_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The trap avoidance of a path conditioner.
enum slideway_walk_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // No trap avoidance.
    SLIDEWAY_WALK_KIND_OFF = 0,
    // The walk as published; it may ask for more push than there is.
    SLIDEWAY_WALK_KIND_PAPER = 1,
    // A walk no faster than a share of the push can bend along the boundary. Needs the sliding form with its reserve.
    SLIDEWAY_WALK_KIND_SAFE = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_walk_kind slideway_walk_kind;
#else
typedef uint32_t slideway_walk_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The shape of a constraint.
enum slideway_shape_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // The caller's own function. Uses `evaluate` and `context`.
    SLIDEWAY_SHAPE_KIND_CALLBACK = 0,
    // One side of a plane, `vector . p <= offset`; the vector points out of the allowed side and may have any length.
    SLIDEWAY_SHAPE_KIND_HALF_SPACE = 1,
    // A ball: `point` is its centre, `radius`, `side`.
    SLIDEWAY_SHAPE_KIND_BALL = 2,
    // An endless cylinder: `point` on its axis, `vector` along it, `radius`, `side`.
    SLIDEWAY_SHAPE_KIND_CYLINDER = 3,
    // An ellipsoid along the axes: `point` is its centre, `vector` holds the semi-axes, `scale`, `side`.
    SLIDEWAY_SHAPE_KIND_ELLIPSOID = 4,
    // A box along the axes with smoothed edges: `point` is its centre, `vector` holds the half edges, `exponent`, `scale`, `side`.
    SLIDEWAY_SHAPE_KIND_SMOOTH_BOX = 5,
    // The oval of Booth: `vector` holds the weights, `radius`, `side`.
    SLIDEWAY_SHAPE_KIND_BOOTH_OVAL = 6,
    // A convex polytope, smoothed: `normals`, `offsets`, `face_count`, `sharpness`, `side`.
    SLIDEWAY_SHAPE_KIND_POLYTOPE = 7,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_shape_kind slideway_shape_kind;
#else
typedef uint32_t slideway_shape_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The allowed side of a closed surface.
enum slideway_allowed_side
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // Stay inside: a work space.
    SLIDEWAY_ALLOWED_SIDE_INSIDE = 0,
    // Stay outside: an obstacle.
    SLIDEWAY_ALLOWED_SIDE_OUTSIDE = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_allowed_side slideway_allowed_side;
#else
typedef uint32_t slideway_allowed_side;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Motion of a built-in shape, without turning. A callback moves by itself: it is told the time.
enum slideway_carrier_kind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // It stands still.
    SLIDEWAY_CARRIER_KIND_STILL = 0,
    // It is displaced by `velocity t + acceleration t^2 / 2`.
    SLIDEWAY_CARRIER_KIND_UNIFORM = 1,
    // It is displaced by `velocity sin(frequency t + phase)`; `velocity` holds the amplitudes, in units of the position.
    SLIDEWAY_CARRIER_KIND_OSCILLATION = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_carrier_kind slideway_carrier_kind;
#else
typedef uint32_t slideway_carrier_kind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The filter's answer to one reference.
enum slideway_outcome
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // No constraint acted.
    SLIDEWAY_OUTCOME_FREE = 0,
    // At least one constraint acted.
    SLIDEWAY_OUTCOME_ACTING = 1,
    // The push was not enough and the reserve acted.
    SLIDEWAY_OUTCOME_RESERVE = 2,
    // The reference was held, at rest, at the last position that was given out; `hold_reason` tells why.
    SLIDEWAY_OUTCOME_HELD = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_outcome slideway_outcome;
#else
typedef uint32_t slideway_outcome;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Why the conditioned reference was held.
enum slideway_hold_cause
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // It was not held.
    SLIDEWAY_HOLD_CAUSE_NONE = 0,
    // The reference contains a NaN or an infinity.
    SLIDEWAY_HOLD_CAUSE_REFERENCE_NOT_FINITE = 1,
    // A constraint's value or derivatives contain a NaN or an infinity, or its callback failed.
    SLIDEWAY_HOLD_CAUSE_CONSTRAINT_NOT_FINITE = 2,
    // A constraint acts and its gradient vanishes: there is no direction to push.
    SLIDEWAY_HOLD_CAUSE_EMPTY_GRADIENT = 3,
    // The gradients of the active constraints cancel: the explicit push has no direction.
    SLIDEWAY_HOLD_CAUSE_OPPOSED_GRADIENTS = 4,
    // A constraint cannot be met together with the others.
    SLIDEWAY_HOLD_CAUSE_CONTRADICTION = 5,
    // The smallest correction was not found within the stated number of steps.
    SLIDEWAY_HOLD_CAUSE_CORRECTION_NOT_FOUND = 6,
    // The call itself failed: see its status. The position is what the structure held before.
    SLIDEWAY_HOLD_CAUSE_CALL_FAILED = 7,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_hold_cause slideway_hold_cause;
#else
typedef uint32_t slideway_hold_cause;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The trap avoidance's doing at one sample.
enum slideway_phase
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    // The reference moves on.
    SLIDEWAY_PHASE_FOLLOWING = 0,
    // The reference waits and the walk, if any, returns to zero.
    SLIDEWAY_PHASE_RETURNING = 1,
    // The reference waits and the walk searches along the boundary.
    SLIDEWAY_PHASE_WALKING = 2,
    // As many independent constraints are active as there are dimensions: no direction is left to walk in.
    SLIDEWAY_PHASE_BLOCKED = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum slideway_phase slideway_phase;
#else
typedef uint32_t slideway_phase;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// A speed regulator under limits on joint speed and joint acceleration, with its state and its look-ahead.
//
// One object is used by one thread at a time.
typedef struct slideway_acceleration slideway_acceleration;

// A path conditioner with its constraints and its state: bends a reference along the boundary of the allowed set.
//
// One object is used by one thread at a time.
typedef struct slideway_path slideway_path;

// A speed regulator with its state: how fast the reference may go on so that every joint keeps its speed limits.
//
// One object is used by one thread at a time.
typedef struct slideway_speed slideway_speed;

// Parameters of an acceleration-limited regulator. Of an array the first `joints` elements count.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_acceleration_settings)`.
    uint32_t size;
    // Number of joints, from 1 to `SLIDEWAY_MAX_JOINTS`.
    uint32_t joints;
    // One of `slideway_recovery_kind`.
    uint32_t recovery;
    // Nothing; 0.
    uint32_t reserved;
    // Lower joint-speed limits, negative, rad/s.
    double lower_speed[SLIDEWAY_MAX_JOINTS];
    // Upper joint-speed limits, positive, rad/s.
    double upper_speed[SLIDEWAY_MAX_JOINTS];
    // Lower joint-acceleration limits, negative, rad/s^2.
    double lower_acceleration[SLIDEWAY_MAX_JOINTS];
    // Upper joint-acceleration limits, positive, rad/s^2.
    double upper_acceleration[SLIDEWAY_MAX_JOINTS];
    // Sampling period, s.
    double sampling_period;
    // Filter bandwidth, rad/s; times the sampling period at most 1.
    double bandwidth;
    // Target rate of the path parameter, 1/s: above what the limits allow.
    double target_rate;
    // Gain of the position loop, 1/s; times the sampling period at most one half. For `SLIDEWAY_RECOVERY_KIND_BRAKING`.
    double gain;
    // Share of the acceleration limits, in [0, 1), that the look-ahead leaves to the position loop and the discretisation.
    double look_ahead_margin;
} slideway_acceleration_settings;

// Which value was refused, for a message to the user.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_refusal)`.
    uint32_t size;
    // Joint, coordinate or constraint, counted from 0; `SLIDEWAY_NO_INDEX` where the parameter has none.
    uint32_t index;
    // The constraint whose shape was refused, counted from 0; `SLIDEWAY_NO_INDEX` where it is no shape.
    uint32_t constraint;
    // The same number that the function returned.
    int32_t status;
    // The value that was refused; for `GAIN_STEP` and `FILTER_STEP` the product.
    double value;
} slideway_refusal;

// Output of one sample of an acceleration-limited regulator. Of an array the first `joints` elements are written.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_acceleration_command)`.
    uint32_t size;
    // Number of joints that were written; 0 after a call that failed.
    uint32_t joints;
    // Joint speed to command, rad/s: inside the speed limits and reachable from the last one.
    double joint_speed[SLIDEWAY_MAX_JOINTS];
    // Demand at this factor, rad/s.
    double desired[SLIDEWAY_MAX_JOINTS];
    // Rate of the path parameter over this sample, 1/s: advance the path parameter by `sampling period * path_rate`.
    double path_rate;
    // The factor of this sample, in [0, 1].
    double factor;
    // The filter's input that leads to this factor: 1 where nothing limits.
    double switch_input;
    // Largest difference of a joint's demand and its command, rad/s, where the path is left; else 0.
    double excess;
    // One of `slideway_keeping`.
    uint32_t keeping;
    // Nothing; 0.
    uint32_t reserved;
} slideway_acceleration_command;

// Parameters of a speed regulator. Of an array the first `joints` elements count.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_speed_settings)`.
    uint32_t size;
    // Number of joints, from 1 to `SLIDEWAY_MAX_JOINTS`.
    uint32_t joints;
    // One of `slideway_speed_law`.
    uint32_t law;
    // One of `slideway_saturation_kind`.
    uint32_t saturation;
    // Lower joint-speed limits, negative, rad/s (m/s for a sliding joint).
    double lower[SLIDEWAY_MAX_JOINTS];
    // Upper joint-speed limits, positive, rad/s (m/s for a sliding joint).
    double upper[SLIDEWAY_MAX_JOINTS];
    // Sampling period, s.
    double sampling_period;
    // Filter bandwidth, rad/s; times the sampling period at most 1.
    double bandwidth;
    // Target rate of the path parameter, 1/s: above what the limits allow.
    double target_rate;
} slideway_speed_settings;

// A point in motion, as a callback is asked about it. Its pointers are good during the call only.
typedef struct {
    // Size of this structure as the library knows it.
    uint32_t size;
    // Number of coordinates.
    uint32_t coordinates;
    // Time of the sample, s.
    double time;
    // Position, `coordinates` numbers.
    const double *position;
    // Velocity, per second, `coordinates` numbers.
    const double *velocity;
} slideway_path_motion;

// Answer of a callback about its constraint `sigma(p, t) <= 0`. Of an array the first `coordinates` elements count.
//
// The callback finds `value` and `gradient` as NaN, which holds the reference if it does not write them, and the three rates as 0,
// which is right for a flat wall that stands still.
typedef struct {
    // Size of this structure as the library knows it.
    uint32_t size;
    // Nothing; 0.
    uint32_t reserved;
    // `sigma`: positive outside the allowed set, best a distance.
    double value;
    // Rate of `sigma` at a fixed position, per second.
    double time_rate;
    // Rate of `time_rate` along the motion.
    double time_rate_rate;
    // Derivative of `sigma` by the position.
    double gradient[SLIDEWAY_MAX_JOINTS];
    // Rate of the gradient along the motion: its Hessian times the velocity, and what it changes with time.
    double gradient_rate[SLIDEWAY_MAX_JOINTS];
} slideway_constraint_value;

// A caller's constraint: writes `sample` for `motion` and returns 0. Any other number says that it could not, and holds the reference.
//
// It is called on the thread of the step, up to `SLIDEWAY_MAX_EVALUATIONS` times a step, at places that are not given out, and gives the
// same answer to the same question. It must not throw, jump out, or call the object that calls it, which is refused.
typedef int32_t (*slideway_evaluate_constraint)(void *context,
                                                const slideway_path_motion *motion,
                                                slideway_constraint_value *sample);

// One constraint of a path conditioner. `shape` says which fields count; the others are not looked at.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_constraint)`.
    uint32_t size;
    // One of `slideway_shape_kind`.
    uint32_t shape;
    // One of `slideway_allowed_side`.
    uint32_t side;
    // One of `slideway_carrier_kind`; a callback is told the time and needs none.
    uint32_t carrier;
    // Centre, or a point on the axis.
    double point[SLIDEWAY_MAX_JOINTS];
    // Normal, axis, semi-axes, half edges or weights.
    double vector[SLIDEWAY_MAX_JOINTS];
    // The plane's `d` in `n . p = d`.
    double offset;
    // Radius, in units of the position.
    double radius;
    // Factor that turns a dimensionless distance into one comparable with lengths.
    double scale;
    // Exponent of a box, from 2 to 64: the larger, the sharper its edges.
    double exponent;
    // Sharpness of a polytope, per unit of length.
    double sharpness;
    // Number of faces, from 1 to `SLIDEWAY_MAX_FACES`.
    uint32_t face_count;
    // Nothing; 0.
    uint32_t reserved;
    // `face_count` rows of `coordinates` numbers: outward normals. Copied when the conditioner is made.
    const double *normals;
    // `face_count` numbers, `d` of each face. Copied when the conditioner is made.
    const double *offsets;
    // Velocity of a uniform carrier, per second; amplitudes of an oscillation.
    double velocity[SLIDEWAY_MAX_JOINTS];
    // Acceleration of a uniform carrier, per second squared.
    double acceleration[SLIDEWAY_MAX_JOINTS];
    // Angular frequency of an oscillation, rad/s.
    double frequency;
    // Phase of an oscillation, rad.
    double phase;
    // The caller's function of a callback.
    slideway_evaluate_constraint evaluate;
    // Handed to `evaluate`; it must stay good for as long as the conditioner lives.
    void *context;
} slideway_constraint;

// Parameters of a path conditioner. Of an array the first `constraint_count` elements count.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_path_settings)`.
    uint32_t size;
    // Number of coordinates of a position, from 1 to `SLIDEWAY_MAX_JOINTS`.
    uint32_t coordinates;
    // Number of constraints, from 1 to `SLIDEWAY_MAX_CONSTRAINTS`.
    uint32_t constraint_count;
    // One of `slideway_form`; says which of the numbers below count.
    uint32_t form;
    // One of `slideway_push_law`.
    uint32_t law;
    // One of `slideway_margin_kind`.
    uint32_t margin;
    // One of `slideway_walk_kind`; without a walk the numbers from `walk_cutoff` on do not count.
    uint32_t walk;
    // Nothing; 0.
    uint32_t reserved;
    // `constraint_count` constraints. Copied when the conditioner is made.
    const slideway_constraint *constraints;
    // Sampling period, s.
    double sampling_period;
    // Cutoff frequency of the push filter, rad/s, below pi / sampling period.
    double push_cutoff;
    // Approach time of each constraint, s: its boundary is neared with this time constant.
    double approach[SLIDEWAY_MAX_CONSTRAINTS];
    // Margin of each constraint, in units of its value.
    double margins[SLIDEWAY_MAX_CONSTRAINTS];
    // Switching gain or amplitude, see `slideway_push_law`.
    double push;
    // Rate at which the allowed set is regained from outside, in units of the constraint per second.
    double recovery_rate;
    // Share of the push that the safe walk may use, in (0, 1).
    double push_share;
    // Cutoff frequency of the walk filter, rad/s.
    double walk_cutoff;
    // Cutoff frequency of the filter that slows the reference, rad/s.
    double pace_cutoff;
    // Walk speed at first, units of position per second.
    double walk_speed;
    // Growth of the walk speed, units of position per second squared.
    double walk_growth;
    // Gain of the walk's return, 1/s.
    double return_gain;
    // Duration of one random direction, s.
    double direction_period;
    // The conditioned reference is lost when farther than this from the reference.
    double distance_threshold;
    // The reference is clearly inside when every constraint is below minus this.
    double clearance_threshold;
    // A constraint is active for the walk when it is above minus this.
    double activity_threshold;
    // Seed of the random directions: equal seeds walk equally.
    uint64_t seed;
} slideway_path_settings;

// Joint speeds per unit of path rate on the path ahead, `dq / d lambda`, at equidistant nodes that are fixed to the path.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_preview)`.
    uint32_t size;
    // Number of nodes; fewer than two give a rate of 0. At the last one the robot must be able to stand.
    uint32_t count;
    // Distance of the current path parameter beyond the first node, not negative.
    double offset;
    // Distance of the nodes in the path parameter.
    double spacing;
    // `count` rows of as many numbers as the regulator has joints, row after row. Only read during the call.
    const double *path_speeds;
} slideway_preview;

// Output of one sample of a path conditioner, with the audit of how it was found. Of an array over coordinates the first `coordinates`
// elements are written, of one over constraints the first `constraint_count`.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_path_output)`.
    uint32_t size;
    // One of `slideway_outcome`.
    uint32_t outcome;
    // One of `slideway_hold_cause`.
    uint32_t hold_reason;
    // The constraint that held the reference, counted from 0; `SLIDEWAY_NO_INDEX` where it is none.
    uint32_t hold_constraint;
    // One of `slideway_phase`.
    uint32_t trap;
    // Nothing; 0.
    uint32_t reserved;
    // Time of the sample, s.
    double time;
    // Conditioned position: where the reference goes.
    double position[SLIDEWAY_MAX_JOINTS];
    // Its velocity, per second.
    double velocity[SLIDEWAY_MAX_JOINTS];
    // Value of each constraint there; NaN only where the constraint itself gives NaN.
    double sigma[SLIDEWAY_MAX_CONSTRAINTS];
    // Value of each constraint one approach time ahead, without margin.
    double phi[SLIDEWAY_MAX_CONSTRAINTS];
    // Share of each constraint in the push, 0 where it does not act.
    double share[SLIDEWAY_MAX_CONSTRAINTS];
    // The push: of the coming interval in the explicit forms, of the past one in the implicit form.
    double push[SLIDEWAY_MAX_JOINTS];
    // Push that the reserve added in the past interval.
    double reserve[SLIDEWAY_MAX_JOINTS];
    // Filtered correction.
    double correction[SLIDEWAY_MAX_JOINTS];
    // Walk of the trap avoidance.
    double walk[SLIDEWAY_MAX_JOINTS];
    // Multiply the commanded path rate by this for the velocity of the next reference; 1 without trap avoidance.
    double pace;
    // Seconds by which the reference's own clock goes on until the next sample.
    double advance;
} slideway_path_output;

// Output of one sample of a speed regulator. Of an array the first `joints` elements are written.
typedef struct {
    // Size of this structure as the caller knows it: `sizeof(slideway_speed_command)`.
    uint32_t size;
    // Number of joints that were written; 0 after a call that failed.
    uint32_t joints;
    // Joint speed to command, rad/s, inside the limits to the last bit.
    double joint_speed[SLIDEWAY_MAX_JOINTS];
    // Rate of the path parameter over this sample, 1/s: advance the path parameter by `sampling period * path_rate`.
    double path_rate;
    // The factor of this sample, in [0, 1].
    double factor;
    // Input of the filter: 0 or 1 in the explicit laws; at most 1, and possibly negative, in the implicit one.
    double switch_input;
    // By how much all joints were slowed to keep their limits, in [0, 1].
    double direction_factor;
    // Largest use of a limit by the desired joint speed; above 1 it exceeds one.
    double limit_ratio;
} slideway_speed_command;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The version of the library that is linked: [`ABI_VERSION`] of its own header.
uint32_t slideway_abi_version(void);

// Bytes of memory that an acceleration-limited regulator of this many joints takes; 0 for a number of joints that there is none for.
size_t slideway_acceleration_size(uint32_t joints);

// Makes an acceleration-limited regulator, robot and reference at rest, in memory of the caller's; as `slideway_speed_place`.
//
// # Safety
//
// As `slideway_speed_place`.
slideway_status slideway_acceleration_place(uint8_t *memory,
                                            size_t bytes,
                                            const slideway_acceleration_settings *settings,
                                            slideway_acceleration **acceleration,
                                            slideway_refusal *why);

// Ends an acceleration-limited regulator in memory of the caller's, who may then use the memory for something else.
//
// # Safety
//
// `acceleration` is null or an object of this kind that no other thread uses.
slideway_status slideway_acceleration_drop(slideway_acceleration *acceleration);

// Sets the state: the factor, from 0 at rest to 1, and the joint speed that the robot has, rad/s, inside the limits. `joint_speed` may
// be null for joints at rest. Without effect on failure.
//
// # Safety
//
// `acceleration` is null or an object of this kind that no other thread uses; `joint_speed` is null or points to as many numbers as it
// has joints; `why` is null or points to a refusal.
slideway_status slideway_acceleration_set_state(slideway_acceleration *acceleration,
                                                double factor,
                                                const double *joint_speed,
                                                slideway_refusal *why);

// One sample: from the desired joint speed in two parts, `feedback + factor * feedforward` in rad/s, to a command that keeps the limits
// on speed and acceleration. The parts are those of `slideway_speed_step_affine`.
//
// `ceiling` is the largest path rate, 1/s, from `slideway_look_ahead_rate` or `..._within`; `INFINITY` without look-ahead. The limits
// win over the ceiling: joints that cannot slow down faster pull the reference along. A ceiling that is NaN counts as 0.
//
// A NaN or an infinity in the demand is no error: the joints brake as fast as they may. If the call fails the command, where it could be
// written, says standstill, and the state does not change.
//
// At most 2N + 1 passes over the N joints, where the demand is out of reach; a few otherwise.
//
// # Safety
//
// `acceleration` is null or an object of this kind that no other thread uses; the inputs are null or point to as many numbers as it has
// joints; `command` is null or points to a command.
slideway_status slideway_acceleration_step(slideway_acceleration *acceleration,
                                           const double *feedback,
                                           const double *feedforward,
                                           double ceiling,
                                           slideway_acceleration_command *command);

// Makes a speed regulator, reference at rest, on the heap. `*speed` becomes the object, or null on failure. `why` may be null.
//
// Not in a library built without `std`.
//
// # Safety
//
// Every pointer is null or points to what its type says.
slideway_status slideway_speed_new(const slideway_speed_settings *settings,
                                   slideway_speed **speed,
                                   slideway_refusal *why);

// Ends a speed regulator that `slideway_speed_new` made and frees its memory. Null is left alone.
//
// # Safety
//
// `speed` is null or an object of this kind that no other thread uses.
slideway_status slideway_speed_free(slideway_speed *speed);

// Makes an acceleration-limited regulator on the heap; as `slideway_speed_new`.
//
// # Safety
//
// As `slideway_speed_new`.
slideway_status slideway_acceleration_new(const slideway_acceleration_settings *settings,
                                          slideway_acceleration **acceleration,
                                          slideway_refusal *why);

// Ends an acceleration-limited regulator that `slideway_acceleration_new` made and frees its memory. Null is left alone.
//
// # Safety
//
// `acceleration` is null or an object of this kind that no other thread uses.
slideway_status slideway_acceleration_free(slideway_acceleration *acceleration);

// Makes a path conditioner on the heap; as `slideway_speed_new`, and as `slideway_path_place` for the constraints.
//
// # Safety
//
// As `slideway_path_place`.
slideway_status slideway_path_new(const slideway_path_settings *settings, slideway_path **path, slideway_refusal *why);

// Ends a path conditioner that `slideway_path_new` made and frees its memory. Null is left alone.
//
// # Safety
//
// `path` is null or an object of this kind that no other thread uses.
slideway_status slideway_path_free(slideway_path *path);

// The largest path rate, 1/s, from which the path can be followed to a stop inside the window ahead: the ceiling for
// `slideway_acceleration_step`. `*rate` is 0 on failure and for a preview of no use.
//
// At most one small linear program a stretch between two nodes (`8N + 8` Newton steps of `N` operations for N joints, two or three as
// a rule), and 40 bisections. The state of the regulator plays no part and does not change.
//
// # Safety
//
// `acceleration` is null or an object of this kind that no other thread uses; `preview` is null or points to a preview whose rows are
// there; `rate` is null or may be written.
slideway_status slideway_look_ahead_rate(const slideway_acceleration *acceleration,
                                         const slideway_preview *preview,
                                         double *rate);

// The greatest square of the path rate at each node from which the last one can be reached at rest, for a path that is known as a
// whole: computed once, then `slideway_look_ahead_rate_within` gives the rate of `slideway_look_ahead_rate` at a fraction of the cost.
// `preview.offset` plays no part.
//
// `ranges` is `preview.count` numbers long. At most one small linear program a stretch between two nodes.
//
// # Safety
//
// As [`slideway_look_ahead_rate`]; `ranges` is null or points to `preview.count` writable numbers outside of the rows.
slideway_status slideway_look_ahead_ranges(const slideway_acceleration *acceleration,
                                           const slideway_preview *preview,
                                           double *ranges);

// The rate of `slideway_look_ahead_rate`, to the last bit, from ranges that were computed before over the same nodes, or over a longer
// path: then `preview` begins at a later node and `ranges` at the same one. `ranges` is `preview.count` numbers long.
//
// At most 40 bisections and one test a node that one sample can reach.
//
// # Safety
//
// As [`slideway_look_ahead_rate`]; `ranges` is null or points to `preview.count` numbers.
slideway_status slideway_look_ahead_rate_within(const slideway_acceleration *acceleration,
                                                const slideway_preview *preview,
                                                const double *ranges,
                                                double *rate);

// Bytes of memory that a path conditioner of this size takes; 0 for a size that there is none for.
size_t slideway_path_size(uint32_t coordinates, uint32_t constraints);

// Makes a path conditioner, before its first sample, in memory of the caller's; as `slideway_speed_place`. The constraints are copied;
// what a callback's context points to is not.
//
// # Safety
//
// As `slideway_speed_place`; the settings' pointers are null or point to what their fields say, and a callback may be called for as
// long as the object lives.
slideway_status slideway_path_place(uint8_t *memory,
                                    size_t bytes,
                                    const slideway_path_settings *settings,
                                    slideway_path **path,
                                    slideway_refusal *why);

// Ends a path conditioner in memory of the caller's, who may then use the memory for something else.
//
// # Safety
//
// `path` is null or an object of this kind that no other thread uses.
slideway_status slideway_path_drop(slideway_path *path);

// Starts anew: at rest at `position` wherever the reference is, or, if `position` is null, on the next reference and with its velocity.
// Without effect on failure.
//
// # Safety
//
// `path` is null or an object of this kind that no other thread uses; `position` is null or points to as many numbers as it has
// coordinates; `why` is null or points to a refusal.
slideway_status slideway_path_restart(slideway_path *path,
                                      const double *position,
                                      slideway_refusal *why);

// One sample: from the reference at `time` (s), its position and velocity, to the conditioned reference.
//
// A NaN or an infinity in the reference is no error: the last position is given out again, at rest, and `hold_reason` says why. If the
// call fails the output, where it could be written, keeps its position, at rest, with the reason `CALL_FAILED`.
//
// The constraints are evaluated once where none acts, and at most `SLIDEWAY_MAX_EVALUATIONS` times (implicit form, reserve, trap
// avoidance); each time but the last few a system of as many equations as there are constraints is solved, in at most
// `2^constraints * (constraints + 1)` steps, one for each acting constraint as a rule.
//
// # Safety
//
// `path` is null or an object of this kind that no other thread uses; `position` and `velocity` are null or point to as many numbers as
// it has coordinates; `output` is null or points to an output that no callback reads or writes.
slideway_status slideway_path_step(slideway_path *path,
                                   double time,
                                   const double *position,
                                   const double *velocity,
                                   slideway_path_output *output);

// Bytes of memory that a speed regulator of this many joints takes; 0 for a number of joints that there is none for.
size_t slideway_speed_size(uint32_t joints);

// Makes a speed regulator, reference at rest, in memory of the caller's; no allocation.
//
// `memory` lies on a multiple of `SLIDEWAY_ALIGNMENT`, has `bytes` bytes, at least `slideway_speed_size`, and belongs to the object
// until `slideway_speed_drop`. `*speed` becomes the object, or null on failure. `why` may be null.
//
// # Safety
//
// Every pointer is null or points to what its type says, `memory` to `bytes` writable bytes that nobody else uses.
slideway_status slideway_speed_place(uint8_t *memory,
                                     size_t bytes,
                                     const slideway_speed_settings *settings,
                                     slideway_speed **speed,
                                     slideway_refusal *why);

// Ends a speed regulator in memory of the caller's, who may then use the memory for something else.
//
// # Safety
//
// `speed` is null or an object of this kind that no other thread uses.
slideway_status slideway_speed_drop(slideway_speed *speed);

// The path rate, 1/s, with which the controller is to compute this sample's desired joint speed: the factor times the target rate.
// For the implicit law, which decides the factor afterwards, the target rate itself. 0 for what is no object.
//
// # Safety
//
// `speed` is null or an object of this kind that no other thread uses.
double slideway_speed_requested_rate(const slideway_speed *speed);

// Sets the factor: 0 for a reference at rest, up to 1 for one that already moves. Without effect on failure.
//
// # Safety
//
// `speed` is null or an object of this kind that no other thread uses.
slideway_status slideway_speed_set_factor(slideway_speed *speed, double factor);

// Changes the speed limits, for limits that vary along the path; the state is kept. Without effect on failure.
//
// # Safety
//
// `speed` is null or an object of this kind that no other thread uses; `lower` and `upper` are null or point to as many numbers as it
// has joints; `why` is null or points to a refusal.
slideway_status slideway_speed_set_limits(slideway_speed *speed,
                                          const double *lower,
                                          const double *upper,
                                          slideway_refusal *why);

// One sample of an explicit law (paper, synchronised): from the desired joint speed, rad/s, to the command.
//
// A NaN or an infinity in `desired` is no error: it commands a standstill and holds the reference. If the call fails the command, where
// it could be written, says standstill.
//
// At most five passes over the joints, whatever the data; no loop depends on it.
//
// # Safety
//
// `speed` is null or an object of this kind that no other thread uses; `desired` is null or points to as many numbers as it has
// joints; `command` is null or points to a command.
slideway_status slideway_speed_step(slideway_speed *speed,
                                    const double *desired,
                                    slideway_speed_command *command);

// One sample of the implicit law: from the desired joint speed in two parts to the command.
//
// The controller asks for `feedback + factor * feedforward`, rad/s: `feedback` is what it wants with the reference standing still,
// `feedforward` what the reference at the target rate adds to it. Two evaluations of any controller give both:
// `feedback = at(0)`, `feedforward = at(target rate) - at(0)`.
//
// NaN and failure as in `slideway_speed_step`.
//
// # Safety
//
// As `slideway_speed_step`, for both inputs.
slideway_status slideway_speed_step_affine(slideway_speed *speed,
                                           const double *feedback,
                                           const double *feedforward,
                                           slideway_speed_command *command);

// One English sentence about a status, with the remedy. Never null; the text is static and never freed.
//
// A number that is no status gets a sentence that says so.
const char *slideway_status_message(int32_t status);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SLIDEWAY_H */

#ifndef SLIDEWAY_H_INIT
#define SLIDEWAY_H_INIT

/* A structure with its size set and all else 0. */
#define SLIDEWAY_INIT_(type)                                                                                          \
    static inline type type##_init(void) {                                                                            \
        type value;                                                                                                   \
        memset(&value, 0, sizeof value);                                                                              \
        value.size = (uint32_t)sizeof value;                                                                          \
        return value;                                                                                                 \
    }
SLIDEWAY_INIT_(slideway_refusal)
SLIDEWAY_INIT_(slideway_speed_settings)
SLIDEWAY_INIT_(slideway_speed_command)
SLIDEWAY_INIT_(slideway_acceleration_settings)
SLIDEWAY_INIT_(slideway_acceleration_command)
SLIDEWAY_INIT_(slideway_preview)
SLIDEWAY_INIT_(slideway_constraint)
SLIDEWAY_INIT_(slideway_path_settings)
SLIDEWAY_INIT_(slideway_path_output)
#undef SLIDEWAY_INIT_

#endif  /* SLIDEWAY_H_INIT */
