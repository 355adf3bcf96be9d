// A reference that would run into a wall and a swinging ball is bent along them.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "slideway.hpp"

int main() {
    constexpr double period = 1e-3;  // s
    // A wall of our own, x + 0.1 sin(5 y) <= 0.2 m: value, gradient, and how the gradient turns along the motion.
    const auto wavy = [](const slideway_path_motion &motion, slideway_constraint_value &wall) noexcept {
        const double x = motion.position[0], y = motion.position[1];
        wall.value = x + 0.1 * std::sin(5.0 * y) - 0.2;
        wall.gradient[0] = 1.0;
        wall.gradient[1] = 0.5 * std::cos(5.0 * y);
        wall.gradient_rate[1] = -2.5 * std::sin(5.0 * y) * motion.velocity[1];
        return 0;  // anything else would hold the reference
    };
    using slideway::Constraint;
    const Constraint constraints[] = {
        Constraint::function(wavy),
        Constraint::ball({0.0, 2.0}, 0.1, SLIDEWAY_ALLOWED_SIDE_OUTSIDE).oscillating({0.05, 0.0}, 2.0, 0.0),
    };
    slideway::PathSettings settings(2);
    settings.constrain(constraints, 0.1);  // approach time, s
    settings.form = SLIDEWAY_FORM_IMPLICIT;
    settings.sampling_period = period;
    settings.push_cutoff = 20.0;   // rad/s
    settings.recovery_rate = 0.5;  // m/s
    auto conditioner = slideway::PathConditioner::make(settings);
    if (!conditioner) {
        std::fprintf(stderr, "%s (constraint %u)\n", conditioner.status().message(), conditioner.refusal().constraint);
        return 1;
    }

    slideway::PathOutput out;
    double worst = -1.0, detour = 0.0;
    int acting = 0;
    for (int k = 0; k < 3000; ++k) {
        const double t = period * k, position[] = {0.3 * std::sin(t), t}, velocity[] = {0.3 * std::cos(t), 1.0};
        if (!conditioner->step(t, position, velocity, out)) return 1;
        acting += out.outcome == SLIDEWAY_OUTCOME_ACTING ? 1 : 0;
        worst = std::max({worst, out.sigma[0], out.sigma[1]});
        detour = std::max(detour, std::hypot(out.position[0] - position[0], out.position[1] - position[1]));
    }
    std::printf("bent in %d of 3000 samples, by %.0f mm at most; largest sigma %.1e m\n", acting, 1e3 * detour, worst);
    // The implicit form keeps every constraint at every sample, to rounding.
    return acting > 0 && worst <= 1e-12 ? 0 : 1;
}
