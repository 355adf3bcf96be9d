// Replays recorded inputs through the C++ wrapper and prints every output as the bits of a double. See tests/replay.rs.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "slideway.hpp"

namespace {

void check(bool holds, const char *what) {
    if (holds) return;
    std::fprintf(stderr, "replay: %s\n", what);
    std::exit(1);
}

void check(slideway::Status status) { check(static_cast<bool>(status), status.message()); }

unsigned count() {
    unsigned value = 0;
    check(std::scanf("%u", &value) == 1, "a count is missing");
    return value;
}

double number() {
    std::uint64_t bits = 0;
    check(std::scanf("%" SCNx64, &bits) == 1, "a number is missing");
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

std::vector<double> numbers(std::size_t n) {
    std::vector<double> read(n);
    for (double &value : read) value = number();
    return read;
}

void print(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    std::printf("%016" PRIx64 " ", bits);
}

void print(slideway::View values) {
    for (double value : values) print(value);
}

void speed() {
    slideway::SpeedSettings s;
    const unsigned n = s.joints = count();
    s.law = count(), s.saturation = count();
    const unsigned steps = count();
    slideway::detail::fill(s.lower, numbers(n)), slideway::detail::fill(s.upper, numbers(n));
    s.sampling_period = number(), s.bandwidth = number(), s.target_rate = number();
    auto regulator = slideway::SpeedRegulator::make(s);
    check(regulator.status());
    slideway::SpeedCommand out;
    for (unsigned k = 0; k < steps; ++k) {
        print(regulator->requested_rate());
        const auto first = numbers(n), second = numbers(n);
        check(s.law == SLIDEWAY_SPEED_LAW_IMPLICIT ? regulator->step(first, second, out) : regulator->step(first, out));
        print(out.speeds()), print(out.path_rate), print(out.factor), print(out.switch_input);
        print(out.direction_factor), print(out.limit_ratio);
        std::putchar('\n');
    }
}

void acceleration() {
    slideway::AccelerationSettings s;
    const unsigned n = s.joints = count();
    s.recovery = count();
    const unsigned steps = count(), nodes = count();
    slideway::detail::fill(s.lower_speed, numbers(n)), slideway::detail::fill(s.upper_speed, numbers(n));
    slideway::detail::fill(s.lower_acceleration, numbers(n)), slideway::detail::fill(s.upper_acceleration, numbers(n));
    s.sampling_period = number(), s.bandwidth = number(), s.target_rate = number(), s.gain = number();
    s.look_ahead_margin = number();
    const double spacing = number();
    const auto rows = numbers(std::size_t{nodes} * n);
    auto regulator = slideway::AccelerationRegulator::make(s);
    check(regulator.status());
    std::vector<double> ranges(nodes);
    check(regulator->ranges(spacing, rows, ranges.data(), ranges.size()));
    print(ranges), std::putchar('\n');
    slideway::AccelerationCommand out;
    for (unsigned k = 0; k < steps; ++k) {
        const double offset = number();
        const auto first = numbers(n), second = numbers(n);
        const double rate = regulator->look_ahead(offset, spacing, rows);
        print(rate), print(regulator->look_ahead(offset, spacing, rows, ranges));
        check(regulator->step(first, second, rate, out));
        print(out.speeds()), print({out.desired, n}), print(out.path_rate), print(out.factor);
        print(out.switch_input), print(out.excess);
        std::printf("%u\n", out.keeping);
    }
}

void path() {
    const unsigned n = count(), m = count();
    slideway::PathSettings s(n);
    s.form = count(), s.walk = count();
    const unsigned steps = count();
    s.margin = SLIDEWAY_MARGIN_KIND_BAND, s.law = SLIDEWAY_PUSH_LAW_NORMALISED;
    s.sampling_period = number(), s.push_cutoff = number(), s.push = number(), s.recovery_rate = number();
    const auto approach = numbers(m);
    s.push_share = number(), s.walk_cutoff = number(), s.pace_cutoff = number(), s.walk_speed = number();
    s.walk_growth = number(), s.return_gain = number(), s.direction_period = number();
    s.distance_threshold = number(), s.clearance_threshold = number(), s.activity_threshold = number();
    s.seed = count();
    const auto normal = numbers(n);
    const double offset = number();
    const auto plane = [&](const slideway_path_motion &motion, slideway_constraint_value &sample) noexcept {
        double sum = 0.0;
        for (unsigned i = 0; i < motion.coordinates; ++i) {
            sum += normal[i] * motion.position[i];
            sample.gradient[i] = normal[i];
        }
        sample.value = sum - offset;
        return 0;
    };
    const auto centre = numbers(n);
    const double radius = number();
    const auto amplitude = numbers(n);
    const double frequency = number(), phase = number();
    using slideway::Constraint;
    const Constraint walls[] = {Constraint::function(plane), Constraint::ball(centre, radius, SLIDEWAY_ALLOWED_SIDE_OUTSIDE)
                                                                 .oscillating(amplitude, frequency, phase)};
    s.constrain(walls, 0.0);
    s.constraint_count = m;
    slideway::detail::fill(s.approach, approach);
    auto conditioner = slideway::PathConditioner::make(s);
    check(conditioner.status());
    slideway::PathOutput out;
    for (unsigned k = 0; k < steps; ++k) {
        const double time = number();
        const auto position = numbers(n), velocity = numbers(n);
        check(conditioner->step(time, position, velocity, out));
        print(out.time), print(conditioner->position(out)), print(conditioner->velocity(out)), print({out.sigma, m});
        print({out.phi, m}), print({out.share, m}), print({out.push, n}), print({out.reserve, n});
        print({out.correction, n}), print({out.walk, n}), print(out.pace), print(out.advance);
        std::printf("%u %u %u %u\n", out.outcome, out.hold_reason, out.hold_constraint, out.trap);
    }
}

}  // namespace

int main() {
    char word[16];
    while (std::scanf("%15s", word) == 1) {
        if (std::strcmp(word, "speed") == 0) speed();
        else if (std::strcmp(word, "acceleration") == 0) acceleration();
        else if (std::strcmp(word, "path") == 0) path();
        else check(false, "no such case");
    }
}
