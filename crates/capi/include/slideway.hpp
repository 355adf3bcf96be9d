// Sliding-mode reference conditioners for robot controllers: a C++17 wrapper around slideway.h, header only.
//
// Objects end by themselves (RAII) and move. Nothing throws: what can fail returns a Status or a Result, and every call of a control
// loop is noexcept. `make` takes memory from the heap, `place` from you; nothing else allocates. Vectors go in as a View, which any
// std::array, std::vector or C array of double becomes by itself; their lengths are checked.
//
// Threads: an object is used by one thread at a time; different objects are independent.

#ifndef SLIDEWAY_HPP
#define SLIDEWAY_HPP

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <type_traits>
#include <utility>

#include "slideway.h"

namespace slideway {

/// A stretch of doubles that somebody else owns; it must outlive the call it is given to.
class View {
public:
    constexpr View(const double *data, std::size_t size) noexcept : data_(data), size_(size) {}
    /// Numbers in braces, good until the end of the full expression.
    constexpr View(std::initializer_list<double> numbers) noexcept : View(std::data(numbers), numbers.size()) {}
    /// Anything contiguous.
    template <class C, class = decltype(std::data(std::declval<const C &>())),
              class = std::enable_if_t<!std::is_same_v<std::decay_t<C>, View>>>
    constexpr View(const C &numbers) noexcept : data_(std::data(numbers)), size_(std::size(numbers)) {}

    constexpr const double *data() const noexcept { return data_; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr const double *begin() const noexcept { return data_; }
    constexpr const double *end() const noexcept { return data_ + size_; }
    constexpr double operator[](std::size_t i) const noexcept { return data_[i]; }

private:
    const double *data_;
    std::size_t size_;
};

/// The answer of a call: true where it did what it was asked.
class [[nodiscard]] Status {
public:
    constexpr Status(slideway_status number = SLIDEWAY_STATUS_OK) noexcept : number_(number) {}
    constexpr explicit operator bool() const noexcept { return number_ == SLIDEWAY_STATUS_OK; }
    constexpr slideway_status number() const noexcept { return number_; }
    /// One English sentence, with the remedy.
    const char *message() const noexcept { return slideway_status_message(number_); }

private:
    slideway_status number_;
};

/// An object, or why there is none.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T object) noexcept : object_(std::move(object)), refusal_(slideway_refusal_init()) {}
    explicit Result(const slideway_refusal &refusal) noexcept : refusal_(refusal) {}
    explicit operator bool() const noexcept { return refusal_.status == SLIDEWAY_STATUS_OK; }
    Status status() const noexcept { return static_cast<slideway_status>(refusal_.status); }
    /// Which value was refused.
    const slideway_refusal &refusal() const noexcept { return refusal_; }
    /// The object; of a failed result one whose every call fails.
    T &operator*() noexcept { return object_; }
    T *operator->() noexcept { return &object_; }

private:
    T object_;
    slideway_refusal refusal_;
};

namespace detail {

/// The one owner of an object of the library.
template <class T>
class Owner {
public:
    Owner() noexcept = default;
    Owner(T *object, slideway_status (*end)(T *)) noexcept : object_(object), end_(end) {}
    Owner(Owner &&other) noexcept : object_(std::exchange(other.object_, nullptr)), end_(other.end_) {}
    Owner &operator=(Owner &&other) noexcept {
        if (this != &other) {
            close();
            object_ = std::exchange(other.object_, nullptr);
            end_ = other.end_;
        }
        return *this;
    }
    ~Owner() { close(); }
    T *get() const noexcept { return object_; }

private:
    void close() noexcept {
        if (object_ != nullptr) (void)end_(object_);
        object_ = nullptr;
    }
    T *object_ = nullptr;
    slideway_status (*end_)(T *) = nullptr;
};

/// Copies a vector into a fixed array; a vector that is too long is cut, which its length then shows.
template <std::size_t S>
void fill(double (&slots)[S], View numbers, double factor = 1.0) noexcept {
    for (std::size_t i = 0; i < S && i < numbers.size(); ++i) slots[i] = factor * numbers[i];
}

}  // namespace detail

/// slideway_speed_settings, cleared, direction-preserving.
struct SpeedSettings : slideway_speed_settings {
    SpeedSettings() noexcept : slideway_speed_settings(slideway_speed_settings_init()) {
        saturation = SLIDEWAY_SATURATION_KIND_DIRECTION_PRESERVING;
    }
    /// The same limit in both directions, rad/s; sets the number of joints.
    void symmetric(View limit) noexcept {
        joints = static_cast<std::uint32_t>(limit.size());
        detail::fill(lower, limit, -1.0);
        detail::fill(upper, limit);
    }
};

/// slideway_speed_command.
struct SpeedCommand : slideway_speed_command {
    SpeedCommand() noexcept : slideway_speed_command(slideway_speed_command_init()) {}
    View speeds() const noexcept { return View(joint_speed, joints); }
};

/// A speed regulator: slideway_speed.
class SpeedRegulator {
public:
    SpeedRegulator() noexcept = default;
    static Result<SpeedRegulator> make(const SpeedSettings &settings) noexcept {
        slideway_speed *object = nullptr;
        slideway_refusal why = slideway_refusal_init();
        const slideway_status status = slideway_speed_new(&settings, &object, &why);
        if (status != SLIDEWAY_STATUS_OK) return Result<SpeedRegulator>(why);
        return SpeedRegulator({object, slideway_speed_free}, settings.joints);
    }
    /// In memory of yours, which outlives the object: no heap.
    static Result<SpeedRegulator> place(void *memory, std::size_t bytes, const SpeedSettings &settings) noexcept {
        slideway_speed *object = nullptr;
        slideway_refusal why = slideway_refusal_init();
        auto *place = static_cast<std::uint8_t *>(memory);
        const slideway_status status = slideway_speed_place(place, bytes, &settings, &object, &why);
        if (status != SLIDEWAY_STATUS_OK) return Result<SpeedRegulator>(why);
        return SpeedRegulator({object, slideway_speed_drop}, settings.joints);
    }
    std::size_t joints() const noexcept { return joints_; }
    double requested_rate() const noexcept { return slideway_speed_requested_rate(object_.get()); }
    Status set_factor(double factor) noexcept { return slideway_speed_set_factor(object_.get(), factor); }
    Status set_limits(View lower, View upper) noexcept {
        if (lower.size() != joints_ || upper.size() != joints_) return SLIDEWAY_STATUS_JOINTS;
        return slideway_speed_set_limits(object_.get(), lower.data(), upper.data(), nullptr);
    }
    /// One sample of an explicit law. After a failure the command says standstill.
    Status step(View desired, SpeedCommand &command) noexcept {
        const bool fits = desired.size() == joints_;
        const Status status = slideway_speed_step(object_.get(), fits ? desired.data() : nullptr, &command);
        return fits ? status : SLIDEWAY_STATUS_JOINTS;
    }
    /// One sample of the implicit law.
    Status step(View feedback, View feedforward, SpeedCommand &command) noexcept {
        const bool fits = feedback.size() == joints_ && feedforward.size() == joints_;
        const double *first = fits ? feedback.data() : nullptr;
        const Status status = slideway_speed_step_affine(object_.get(), first, feedforward.data(), &command);
        return fits ? status : SLIDEWAY_STATUS_JOINTS;
    }

private:
    SpeedRegulator(detail::Owner<slideway_speed> object, std::size_t joints) noexcept
        : object_(std::move(object)), joints_(joints) {}
    detail::Owner<slideway_speed> object_;
    std::size_t joints_ = 0;
};

/// slideway_acceleration_settings, cleared.
struct AccelerationSettings : slideway_acceleration_settings {
    AccelerationSettings() noexcept : slideway_acceleration_settings(slideway_acceleration_settings_init()) {}
    /// The same limits in both directions, rad/s and rad/s^2; sets the number of joints. Lengths that differ leave it 0, which is refused.
    void symmetric(View speed, View acceleration) noexcept {
        joints = speed.size() == acceleration.size() ? static_cast<std::uint32_t>(speed.size()) : 0;
        detail::fill(lower_speed, speed, -1.0);
        detail::fill(upper_speed, speed);
        detail::fill(lower_acceleration, acceleration, -1.0);
        detail::fill(upper_acceleration, acceleration);
    }
};

/// slideway_acceleration_command.
struct AccelerationCommand : slideway_acceleration_command {
    AccelerationCommand() noexcept : slideway_acceleration_command(slideway_acceleration_command_init()) {}
    View speeds() const noexcept { return View(joint_speed, joints); }
};

/// A regulator under speed and acceleration limits, with its look-ahead: slideway_acceleration.
class AccelerationRegulator {
public:
    AccelerationRegulator() noexcept = default;
    static Result<AccelerationRegulator> make(const AccelerationSettings &settings) noexcept {
        slideway_acceleration *object = nullptr;
        slideway_refusal why = slideway_refusal_init();
        const slideway_status status = slideway_acceleration_new(&settings, &object, &why);
        if (status != SLIDEWAY_STATUS_OK) return Result<AccelerationRegulator>(why);
        return AccelerationRegulator({object, slideway_acceleration_free}, settings.joints);
    }
    std::size_t joints() const noexcept { return joints_; }
    /// The ceiling for a step from a window ahead: rows of joints() numbers. 0 where it cannot be told.
    double look_ahead(double offset, double spacing, View rows) const noexcept {
        const slideway_preview preview = window(offset, spacing, rows);
        double rate = 0.0;
        (void)slideway_look_ahead_rate(object_.get(), &preview, &rate);
        return rate;
    }
    /// The same from ranges that `ranges` computed over the same rows. 0 where the lengths do not fit.
    double look_ahead(double offset, double spacing, View rows, View ranges) const noexcept {
        const slideway_preview preview = window(offset, spacing, rows);
        double rate = 0.0;
        if (ranges.size() != preview.count) return rate;
        (void)slideway_look_ahead_rate_within(object_.get(), &preview, ranges.data(), &rate);
        return rate;
    }
    /// Fills one number a row.
    Status ranges(double spacing, View rows, double *ranges, std::size_t count) const noexcept {
        const slideway_preview preview = window(0.0, spacing, rows);
        if (count != preview.count) return SLIDEWAY_STATUS_LENGTH;
        return slideway_look_ahead_ranges(object_.get(), &preview, ranges);
    }
    /// The factor and the joint speed that robot and reference have.
    Status set_state(double factor, View joint_speed) noexcept {
        if (joint_speed.size() != joints_) return SLIDEWAY_STATUS_JOINTS;
        return slideway_acceleration_set_state(object_.get(), factor, joint_speed.data(), nullptr);
    }
    /// One sample under a ceiling, INFINITY without look-ahead. After a failure the command says standstill.
    Status step(View feedback, View feedforward, double ceiling, AccelerationCommand &command) noexcept {
        const bool fits = feedback.size() == joints_ && feedforward.size() == joints_;
        const double *first = fits ? feedback.data() : nullptr;
        const Status status = slideway_acceleration_step(object_.get(), first, feedforward.data(), ceiling, &command);
        return fits ? status : SLIDEWAY_STATUS_JOINTS;
    }

private:
    AccelerationRegulator(detail::Owner<slideway_acceleration> object, std::size_t joints) noexcept
        : object_(std::move(object)), joints_(joints) {}
    slideway_preview window(double offset, double spacing, View rows) const noexcept {
        slideway_preview preview = slideway_preview_init();
        preview.count = joints_ > 0 ? static_cast<std::uint32_t>(rows.size() / joints_) : 0;
        preview.offset = offset;
        preview.spacing = spacing;
        preview.path_speeds = rows.data();
        return preview;
    }
    detail::Owner<slideway_acceleration> object_;
    std::size_t joints_ = 0;
};

/// One constraint of a path conditioner.
struct Constraint : slideway_constraint {
    Constraint() noexcept : slideway_constraint(slideway_constraint_init()) {}

    /// `normal . p <= offset`.
    static Constraint half_space(View normal, double offset) noexcept {
        Constraint made;
        made.shape = SLIDEWAY_SHAPE_KIND_HALF_SPACE;
        detail::fill(made.vector, normal);
        made.offset = offset;
        return made;
    }
    static Constraint ball(View centre, double radius, slideway_allowed_side side) noexcept {
        Constraint made;
        made.shape = SLIDEWAY_SHAPE_KIND_BALL;
        made.side = static_cast<std::uint32_t>(side);
        detail::fill(made.point, centre);
        made.radius = radius;
        return made;
    }
    static Constraint cylinder(View point, View axis, double radius, slideway_allowed_side side) noexcept {
        Constraint made = ball(point, radius, side);
        made.shape = SLIDEWAY_SHAPE_KIND_CYLINDER;
        detail::fill(made.vector, axis);
        return made;
    }
    /// A function of yours, `int(const slideway_path_motion &, slideway_constraint_value &) noexcept`, which must outlive the conditioner.
    template <class F>
    static Constraint function(F &evaluate) noexcept {
        static_assert(std::is_nothrow_invocable_r_v<int, F &, const slideway_path_motion &, slideway_constraint_value &>,
                      "no exception may leave a constraint: declare it noexcept");
        Constraint made;
        made.shape = SLIDEWAY_SHAPE_KIND_CALLBACK;
        made.context = const_cast<void *>(static_cast<const void *>(&evaluate));
        made.evaluate = [](void *context, const slideway_path_motion *motion, slideway_constraint_value *value) {
            return static_cast<std::int32_t>((*static_cast<F *>(context))(*motion, *value));
        };
        return made;
    }
    /// The same shape, displaced by `velocity t + acceleration t^2 / 2`.
    Constraint uniform(View speed, View change) const noexcept {
        Constraint made = *this;
        made.carrier = SLIDEWAY_CARRIER_KIND_UNIFORM;
        detail::fill(made.velocity, speed);
        detail::fill(made.acceleration, change);
        return made;
    }
    /// The same shape, displaced by `amplitude sin(frequency t + phase)`.
    Constraint oscillating(View amplitude, double angular, double angle) const noexcept {
        Constraint made = *this;
        made.carrier = SLIDEWAY_CARRIER_KIND_OSCILLATION;
        detail::fill(made.velocity, amplitude);
        made.frequency = angular;
        made.phase = angle;
        return made;
    }
};

/// slideway_path_settings, cleared: implicit form, no margin, no trap avoidance.
struct PathSettings : slideway_path_settings {
    explicit PathSettings(std::uint32_t dimensions) noexcept : slideway_path_settings(slideway_path_settings_init()) {
        coordinates = dimensions;
    }
    /// Sets the constraints, which are copied when the conditioner is made, and one approach time for all, s.
    template <std::size_t M>
    void constrain(const Constraint (&given)[M], double time) noexcept {
        static_assert(M <= SLIDEWAY_MAX_CONSTRAINTS, "too many constraints");
        static_assert(sizeof(Constraint) == sizeof(slideway_constraint), "an array of one is an array of the other");
        constraint_count = M;
        constraints = given;
        for (std::size_t i = 0; i < M; ++i) approach[i] = time;
    }
};

/// slideway_path_output.
struct PathOutput : slideway_path_output {
    PathOutput() noexcept : slideway_path_output(slideway_path_output_init()) {}
};

/// A path conditioner: slideway_path.
class PathConditioner {
public:
    PathConditioner() noexcept = default;
    static Result<PathConditioner> make(const PathSettings &settings) noexcept {
        slideway_path *object = nullptr;
        slideway_refusal why = slideway_refusal_init();
        const slideway_status status = slideway_path_new(&settings, &object, &why);
        if (status != SLIDEWAY_STATUS_OK) return Result<PathConditioner>(why);
        return PathConditioner({object, slideway_path_free}, settings.coordinates);
    }
    std::size_t coordinates() const noexcept { return coordinates_; }
    /// Starts anew on the next reference.
    Status restart() noexcept { return slideway_path_restart(object_.get(), nullptr, nullptr); }
    /// Starts anew at rest at a position.
    Status restart(View position) noexcept {
        if (position.size() != coordinates_) return SLIDEWAY_STATUS_JOINTS;
        return slideway_path_restart(object_.get(), position.data(), nullptr);
    }
    /// One sample. After a failure the output keeps its position, at rest.
    Status step(double time, View position, View velocity, PathOutput &output) noexcept {
        const bool fits = position.size() == coordinates_ && velocity.size() == coordinates_;
        const double *first = fits ? position.data() : nullptr;
        const Status status = slideway_path_step(object_.get(), time, first, velocity.data(), &output);
        return fits ? status : SLIDEWAY_STATUS_JOINTS;
    }
    View position(const PathOutput &output) const noexcept { return View(output.position, coordinates_); }
    View velocity(const PathOutput &output) const noexcept { return View(output.velocity, coordinates_); }

private:
    PathConditioner(detail::Owner<slideway_path> object, std::size_t coordinates) noexcept
        : object_(std::move(object)), coordinates_(coordinates) {}
    detail::Owner<slideway_path> object_;
    std::size_t coordinates_ = 0;
};

}  // namespace slideway

#endif  // SLIDEWAY_HPP
