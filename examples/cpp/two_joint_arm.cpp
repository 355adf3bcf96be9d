// A speed loop around a two-joint arm with limits on acceleration: it looks along the path and slows in time for the turns.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "slideway.hpp"

namespace {

constexpr double period = 1e-3;  // s
constexpr double target = 5.0;   // 1/s, faster than the joints allow
constexpr double spacing = 0.01; // of the nodes, in the path parameter
constexpr std::size_t window = 60;
using Joints = std::array<double, 2>;

// A path of the joints, rad, and its derivative by the path parameter.
Joints path(double s) { return {0.6 * std::sin(s), 0.4 * std::sin(2.0 * s)}; }
Joints slope(double s) { return {0.6 * std::cos(s), 0.8 * std::cos(2.0 * s)}; }

}  // namespace

int main() {
    slideway::AccelerationSettings settings;
    settings.symmetric({0.5, 0.5}, {2.0, 2.0});  // rad/s, rad/s^2
    settings.recovery = SLIDEWAY_RECOVERY_KIND_BRAKING;
    settings.gain = 10.0;  // 1/s, of the position loop
    settings.sampling_period = period;
    settings.bandwidth = 20.0;
    settings.target_rate = target;
    settings.look_ahead_margin = 0.1;
    auto regulator = slideway::AccelerationRegulator::make(settings);
    if (!regulator) {
        std::fprintf(stderr, "%s (%g)\n", regulator.status().message(), regulator.refusal().value);
        return 1;
    }

    // The whole path's nodes are known here; at the last one the robot stands. A window of them is looked at.
    const double length = 6.283185307179586;
    const auto count = static_cast<std::size_t>(length / spacing) + 1;
    std::vector<double> rows;
    for (std::size_t k = 0; k < count; ++k)
        for (double v : slope(spacing * static_cast<double>(k))) rows.push_back(v);

    slideway::AccelerationCommand command;
    Joints q = path(0.0), before{};
    double s = 0.0, error = 0.0, hardest = 0.0;
    int samples = 0;
    for (; s < length - 2.0 * spacing && samples < 100000; ++samples) {
        const auto node = static_cast<std::size_t>(s / spacing);
        const std::size_t seen = std::min(window, count - node);
        const double offset = s - spacing * static_cast<double>(node);
        const double ceiling = regulator->look_ahead(offset, spacing, slideway::View(&rows[2 * node], 2 * seen));

        const Joints aim = path(s), ahead = slope(s);
        const Joints feedback{10.0 * (aim[0] - q[0]), 10.0 * (aim[1] - q[1])};
        const Joints feedforward{target * ahead[0], target * ahead[1]};
        if (!regulator->step(feedback, feedforward, ceiling, command)) return 1;

        for (std::size_t i = 0; i < 2; ++i) {
            q[i] += period * command.joint_speed[i];
            hardest = std::max(hardest, std::abs(command.joint_speed[i] - before[i]) / (2.0 * period));
            before[i] = command.joint_speed[i];
        }
        s += period * command.path_rate;
        error = std::max(error, std::hypot(path(s)[0] - q[0], path(s)[1] - q[1]));
    }
    std::printf("along the path in %.3f s, %.2f mrad off at most, %.3f of the acceleration used\n", samples * period,
                1e3 * error, hardest);
    return samples < 100000 && error < 2e-3 && hardest < 1.0 + 1e-9 ? 0 : 1;
}
