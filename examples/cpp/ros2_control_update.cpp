// The call order of a controller of ros2_control, in plain C++ without ROS: configure (may allocate), activate, then update() in the
// real-time loop, which neither allocates nor throws nor waits.
#include <array>
#include <cmath>
#include <cstdio>

#include "slideway.hpp"

enum class Return { ok, error };

class PathSpeedController {
public:
    // on_configure(): parameters are read and checked; what is refused is told with its joint and value.
    Return on_configure(slideway::View limits, double period) {
        slideway::SpeedSettings settings;
        settings.symmetric(limits);
        settings.law = SLIDEWAY_SPEED_LAW_SYNCHRONISED;
        settings.sampling_period = period;
        settings.bandwidth = 25.0;
        settings.target_rate = 2.0;
        auto made = slideway::SpeedRegulator::make(settings);
        if (!made) {
            const slideway_refusal &why = made.refusal();
            std::fprintf(stderr, "configure: %s; joint %u has %g\n", made.status().message(), why.index, why.value);
            return Return::error;
        }
        regulator_ = std::move(*made);
        return Return::ok;
    }

    // on_activate(): from rest, wherever the path parameter stands.
    Return on_activate() { return regulator_.set_factor(0.0) ? Return::ok : Return::error; }

    // update(): state interfaces in, command interfaces out.
    Return update(const std::array<double, 2> &position, std::array<double, 2> &velocity_command, double period) noexcept {
        const double rate = regulator_.requested_rate();
        std::array<double, 2> desired{};
        for (std::size_t i = 0; i < 2; ++i) {
            const double angle = parameter_ + 0.5 * static_cast<double>(i);
            desired[i] = 0.4 * std::cos(angle) * rate + 8.0 * (0.4 * std::sin(angle) - position[i]);
        }
        // On an error the command says standstill: it is written all the same, and the manager is told.
        const slideway::Status status = regulator_.step(desired, command_);
        for (std::size_t i = 0; i < 2; ++i) velocity_command[i] = command_.joint_speed[i];
        parameter_ += period * command_.path_rate;
        return status ? Return::ok : Return::error;
    }

    double parameter() const noexcept { return parameter_; }

private:
    slideway::SpeedRegulator regulator_;
    slideway::SpeedCommand command_;
    double parameter_ = 0.0;
};

int main() {
    PathSpeedController controller;
    const double period = 1e-3;
    // A limit that is no limit is refused before anything moves, and an update without a regulator commands a standstill.
    std::array<double, 2> position{0.0, 0.19}, command{1.0, 1.0};
    if (controller.on_configure({0.3, -0.3}, period) == Return::ok) return 1;
    if (controller.update(position, command, period) == Return::ok || command[0] != 0.0) return 1;

    if (controller.on_configure({0.3, 0.3}, period) != Return::ok || controller.on_activate() != Return::ok) return 1;
    double fastest = 0.0;
    for (int k = 0; k < 5000; ++k) {
        if (controller.update(position, command, period) != Return::ok) return 1;
        for (std::size_t i = 0; i < 2; ++i) {
            position[i] += period * command[i];  // a robot that does what it is told
            fastest = std::fmax(fastest, std::fabs(command[i]));
        }
    }
    std::printf("path parameter %.3f after 5 s, fastest joint %.3f rad/s of 0.3\n", controller.parameter(), fastest);
    return controller.parameter() > 2.5 && fastest <= 0.3 ? 0 : 1;
}
