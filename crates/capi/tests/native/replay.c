/* Replays recorded inputs through the C interface and prints every output as the bits of a double. See tests/replay.rs. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "slideway.h"

static void fail(const char *what) {
    fprintf(stderr, "replay: %s\n", what);
    exit(1);
}

static void check(slideway_status status) {
    if (status != SLIDEWAY_STATUS_OK) fail(slideway_status_message((int32_t)status));
}

static unsigned count(void) {
    unsigned value;
    if (scanf("%u", &value) != 1) fail("a count is missing");
    return value;
}

static void read(double *numbers, size_t n) {
    for (size_t i = 0; i < n; ++i) {
        uint64_t bits;
        if (scanf("%" SCNx64, &bits) != 1) fail("a number is missing");
        memcpy(&numbers[i], &bits, sizeof bits);
    }
}

static void print(const double *numbers, size_t n) {
    for (size_t i = 0; i < n; ++i) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        printf("%016" PRIx64 " ", bits);
    }
}

static void replay_speed(void) {
    slideway_speed_settings s = slideway_speed_settings_init();
    slideway_speed_command out = slideway_speed_command_init();
    static SLIDEWAY_ALIGNED unsigned char memory[SLIDEWAY_SPEED_SIZE_MAX];
    double first[12], second[12];
    slideway_speed *speed;
    s.joints = count(), s.law = count(), s.saturation = count();
    unsigned steps = count();
    read(s.lower, s.joints), read(s.upper, s.joints);
    read(&s.sampling_period, 1), read(&s.bandwidth, 1), read(&s.target_rate, 1);
    check(slideway_speed_place(memory, sizeof memory, &s, &speed, NULL));
    for (unsigned k = 0; k < steps; ++k) {
        double rate = slideway_speed_requested_rate(speed);
        read(first, s.joints), read(second, s.joints);
        check(s.law == SLIDEWAY_SPEED_LAW_IMPLICIT ? slideway_speed_step_affine(speed, first, second, &out)
                                                   : slideway_speed_step(speed, first, &out));
        print(&rate, 1), print(out.joint_speed, s.joints), print(&out.path_rate, 1), print(&out.factor, 1);
        print(&out.switch_input, 1), print(&out.direction_factor, 1), print(&out.limit_ratio, 1);
        putchar('\n');
    }
    check(slideway_speed_drop(speed));
}

static void replay_acceleration(void) {
    slideway_acceleration_settings s = slideway_acceleration_settings_init();
    slideway_acceleration_command out = slideway_acceleration_command_init();
    slideway_preview ahead = slideway_preview_init();
    double first[12], second[12], rate, within;
    slideway_acceleration *object;
    s.joints = count(), s.recovery = count();
    unsigned steps = count();
    ahead.count = count();
    read(s.lower_speed, s.joints), read(s.upper_speed, s.joints);
    read(s.lower_acceleration, s.joints), read(s.upper_acceleration, s.joints);
    read(&s.sampling_period, 1), read(&s.bandwidth, 1), read(&s.target_rate, 1), read(&s.gain, 1);
    read(&s.look_ahead_margin, 1), read(&ahead.spacing, 1);
    double *rows = malloc(ahead.count * s.joints * sizeof *rows), *ranges = malloc(ahead.count * sizeof *ranges);
    if (rows == NULL || ranges == NULL) fail("no memory");
    read(rows, (size_t)ahead.count * s.joints);
    ahead.path_speeds = rows;
    check(slideway_acceleration_new(&s, &object, NULL));
    check(slideway_look_ahead_ranges(object, &ahead, ranges));
    print(ranges, ahead.count), putchar('\n');
    for (unsigned k = 0; k < steps; ++k) {
        read(&ahead.offset, 1), read(first, s.joints), read(second, s.joints);
        check(slideway_look_ahead_rate(object, &ahead, &rate));
        check(slideway_look_ahead_rate_within(object, &ahead, ranges, &within));
        check(slideway_acceleration_step(object, first, second, rate, &out));
        print(&rate, 1), print(&within, 1), print(out.joint_speed, s.joints), print(out.desired, s.joints);
        print(&out.path_rate, 1), print(&out.factor, 1), print(&out.switch_input, 1), print(&out.excess, 1);
        printf("%u\n", out.keeping);
    }
    check(slideway_acceleration_free(object));
    free(rows), free(ranges);
}

/* `sigma = normal . p - offset`, in the order of the recording's own function. */
static int32_t plane(void *context, const slideway_path_motion *motion, slideway_constraint_value *sample) {
    const double *numbers = context;
    double sum = 0.0;
    for (uint32_t i = 0; i < motion->coordinates; ++i) {
        sum += numbers[i] * motion->position[i];
        sample->gradient[i] = numbers[i];
    }
    sample->value = sum - numbers[12];
    return 0;
}

static void replay_path(void) {
    slideway_path_settings s = slideway_path_settings_init();
    slideway_path_output out = slideway_path_output_init();
    slideway_constraint constraints[SLIDEWAY_MAX_CONSTRAINTS];
    double normal[13], position[12], velocity[12], time;
    slideway_path *path;
    for (unsigned i = 0; i < SLIDEWAY_MAX_CONSTRAINTS; ++i) constraints[i] = slideway_constraint_init();
    s.coordinates = count(), s.constraint_count = count(), s.form = count(), s.walk = count();
    unsigned n = s.coordinates, m = s.constraint_count, steps = count();
    s.margin = SLIDEWAY_MARGIN_KIND_BAND, s.law = SLIDEWAY_PUSH_LAW_NORMALISED, s.constraints = constraints;
    read(&s.sampling_period, 1), read(&s.push_cutoff, 1), read(&s.push, 1), read(&s.recovery_rate, 1);
    read(s.approach, m), read(&s.push_share, 1), read(&s.walk_cutoff, 1), read(&s.pace_cutoff, 1);
    read(&s.walk_speed, 1), read(&s.walk_growth, 1), read(&s.return_gain, 1), read(&s.direction_period, 1);
    read(&s.distance_threshold, 1), read(&s.clearance_threshold, 1), read(&s.activity_threshold, 1);
    s.seed = count();
    constraints[0].shape = SLIDEWAY_SHAPE_KIND_CALLBACK;
    constraints[0].evaluate = plane, constraints[0].context = normal;
    read(normal, n), read(&normal[12], 1);
    constraints[1].shape = SLIDEWAY_SHAPE_KIND_BALL, constraints[1].side = SLIDEWAY_ALLOWED_SIDE_OUTSIDE;
    constraints[1].carrier = SLIDEWAY_CARRIER_KIND_OSCILLATION;
    read(constraints[1].point, n), read(&constraints[1].radius, 1);
    read(constraints[1].velocity, n), read(&constraints[1].frequency, 1), read(&constraints[1].phase, 1);
    check(slideway_path_new(&s, &path, NULL));
    for (unsigned k = 0; k < steps; ++k) {
        read(&time, 1), read(position, n), read(velocity, n);
        check(slideway_path_step(path, time, position, velocity, &out));
        print(&out.time, 1), print(out.position, n), print(out.velocity, n), print(out.sigma, m), print(out.phi, m);
        print(out.share, m), print(out.push, n), print(out.reserve, n), print(out.correction, n), print(out.walk, n);
        print(&out.pace, 1), print(&out.advance, 1);
        printf("%u %u %u %u\n", out.outcome, out.hold_reason, out.hold_constraint, out.trap);
    }
    check(slideway_path_free(path));
}

int main(void) {
    char word[16];
    while (scanf("%15s", word) == 1) {
        if (strcmp(word, "speed") == 0) replay_speed();
        else if (strcmp(word, "acceleration") == 0) replay_acceleration();
        else if (strcmp(word, "path") == 0) replay_path();
        else fail("no such case");
    }
    return 0;
}
