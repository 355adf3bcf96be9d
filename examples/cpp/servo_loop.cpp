// A velocity loop in the manner of MoveIt Servo, in plain C++: twists arrive irregularly, are integrated to a reference, bent along a
// work space's boundary, and streamed at a fixed rate. No sample waits for the operator, and a bad one holds the tool.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "slideway.hpp"

namespace {

using Vector = std::array<double, 3>;

// The operator: pushes outwards, and once sends a number that is none.
Vector twist(int k) {
    if (k == 2500) return {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
    const double t = 1e-3 * k;
    return {0.2, 0.15 * std::cos(t), 0.1 * std::sin(0.7 * t)};
}

}  // namespace

int main() {
    constexpr double period = 1e-3, stale = 0.1;  // s
    using slideway::Constraint;
    const Constraint walls[] = {
        Constraint::ball({0.0, 0.0, 0.0}, 0.5, SLIDEWAY_ALLOWED_SIDE_INSIDE),
        Constraint::cylinder({0.3, 0.2, 0.0}, {0.0, 0.0, 1.0}, 0.1, SLIDEWAY_ALLOWED_SIDE_OUTSIDE),
    };
    slideway::PathSettings settings(3);
    settings.constrain(walls, 0.1);
    settings.form = SLIDEWAY_FORM_IMPLICIT;
    settings.sampling_period = period;
    settings.push_cutoff = 20.0;
    settings.recovery_rate = 0.2;
    // Kept at every sample, a constraint may be passed by some T^2 / 8 between them: 2e-7 m here.
    settings.margin = SLIDEWAY_MARGIN_KIND_FIXED;
    settings.margins[0] = settings.margins[1] = 1e-5;  // m
    auto conditioner = slideway::PathConditioner::make(settings);
    if (!conditioner) return 1;

    slideway::PathOutput out;
    Vector reference{}, held{};
    double age = 0.0, worst = -1.0;
    int stopped = 0;
    for (int k = 0; k < 6000; ++k) {
        const double time = period * k;
        if (k % 20 == 0 && k < 5000) held = twist(k), age = 0.0;  // messages come at 50 Hz, and end after 5 s
        age += period;
        const Vector velocity = age > stale ? Vector{} : held;
        // The reference and its velocity; a NaN is passed on, for the conditioner holds the tool and says why.
        if (!conditioner->step(time, reference, velocity, out)) return 1;
        if (out.outcome == SLIDEWAY_OUTCOME_HELD) {
            ++stopped;
            held = Vector{};  // the message is dropped; the next one counts
        }
        // The stream to the robot: out.position, out.velocity. A reference that runs far ahead of it would have to come all the way back:
        // an operator who leans on a wall does not wind it up.
        double ahead = 0.0;
        for (std::size_t i = 0; i < 3; ++i) ahead = std::hypot(ahead, reference[i] - out.position[i]);
        if (ahead > 0.1) continue;
        for (std::size_t i = 0; i < 3; ++i)
            reference[i] += std::isfinite(velocity[i]) ? period * velocity[i] : 0.0;
        worst = std::max({worst, out.sigma[0], out.sigma[1]});
    }
    std::printf("largest sigma %.1e m, held in %d samples, ends at %.3f %.3f %.3f\n", worst, stopped, out.position[0],
                out.position[1], out.position[2]);
    return worst <= 0.0 && stopped == 1 ? 0 : 1;
}
