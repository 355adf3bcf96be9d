/* What a caller can do wrong at the border, and what is answered. Runs under the sanitizers in crates/capi/check. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "slideway.h"

#define CHECK(claim)                                                     \
    do {                                                                 \
        if (!(claim)) {                                                  \
            fprintf(stderr, "border.c:%d: not so: %s\n", __LINE__, #claim); \
            exit(1);                                                     \
        }                                                                \
    } while (0)

static SLIDEWAY_ALIGNED unsigned char memory[SLIDEWAY_PATH_SIZE_MAX + 8];

static slideway_speed_settings speed_settings(uint32_t joints) {
    slideway_speed_settings s = slideway_speed_settings_init();
    s.joints = joints;
    s.saturation = SLIDEWAY_SATURATION_KIND_DIRECTION_PRESERVING;
    for (int i = 0; i < SLIDEWAY_MAX_JOINTS; ++i) s.lower[i] = -0.5, s.upper[i] = 0.5;
    s.sampling_period = 1e-3, s.bandwidth = 20.0, s.target_rate = 5.0;
    return s;
}

static slideway_speed *speed_of(uint32_t joints) {
    slideway_speed_settings s = speed_settings(joints);
    slideway_speed *speed;
    CHECK(slideway_speed_place(memory, sizeof memory, &s, &speed, NULL) == SLIDEWAY_STATUS_OK);
    return speed;
}

static int stands(const slideway_speed_command *c) {
    for (int i = 0; i < SLIDEWAY_MAX_JOINTS; ++i)
        if (c->joint_speed[i] != 0.0) return 0;
    return c->path_rate == 0.0 && c->factor == 0.0 && c->joints == 0;
}

static void memory_is_checked(void) {
    slideway_speed_settings s = speed_settings(2);
    slideway_speed *speed = (slideway_speed *)memory;
    size_t size = slideway_speed_size(2);
    CHECK(size > 0 && size <= SLIDEWAY_SPEED_SIZE_MAX && slideway_speed_size(0) == 0 && slideway_speed_size(13) == 0);
    CHECK(slideway_path_size(2, 0) == 0 && slideway_path_size(12, SLIDEWAY_MAX_CONSTRAINTS + 1) == 0);
    CHECK(slideway_speed_place(NULL, size, &s, &speed, NULL) == SLIDEWAY_STATUS_NULL && speed == NULL);
    CHECK(slideway_speed_place(memory + 1, size, &s, &speed, NULL) == SLIDEWAY_STATUS_ALIGNMENT);
    CHECK(slideway_speed_place(memory, size - 1, &s, &speed, NULL) == SLIDEWAY_STATUS_MEMORY);
    CHECK(slideway_speed_place(memory, size, NULL, &speed, NULL) == SLIDEWAY_STATUS_NULL);
    CHECK(slideway_speed_place(memory, size, &s, NULL, NULL) == SLIDEWAY_STATUS_NULL);
    CHECK(slideway_speed_place(memory, size, &s, &speed, NULL) == SLIDEWAY_STATUS_OK && speed != NULL);
    CHECK(slideway_speed_free(speed) == SLIDEWAY_STATUS_OWNER);
    CHECK(slideway_speed_drop(speed) == SLIDEWAY_STATUS_OK && slideway_speed_drop(speed) == SLIDEWAY_STATUS_OBJECT);
    CHECK(slideway_speed_free(NULL) == SLIDEWAY_STATUS_OK && slideway_speed_drop(NULL) == SLIDEWAY_STATUS_NULL);
}

static void structures_and_numbers_are_checked(void) {
    slideway_speed *speed;
    slideway_refusal why = slideway_refusal_init();
    slideway_speed_settings s = speed_settings(2);
    s.size = 0;
    CHECK(slideway_speed_place(memory, sizeof memory, &s, &speed, &why) == SLIDEWAY_STATUS_SIZE);
    s = speed_settings(13);
    CHECK(slideway_speed_place(memory, sizeof memory, &s, &speed, &why) == SLIDEWAY_STATUS_JOINTS);
    s = speed_settings(2), s.law = 3;
    CHECK(slideway_speed_place(memory, sizeof memory, &s, &speed, &why) == SLIDEWAY_STATUS_CHOICE);
    s = speed_settings(2), s.upper[1] = NAN;
    CHECK(slideway_speed_place(memory, sizeof memory, &s, &speed, &why) == SLIDEWAY_STATUS_UPPER_SPEED);
    CHECK(why.status == SLIDEWAY_STATUS_UPPER_SPEED && why.index == 1 && isnan(why.value) && speed == NULL);
    s = speed_settings(2), s.bandwidth = 2000.0;
    CHECK(slideway_speed_place(memory, sizeof memory, &s, &speed, &why) == SLIDEWAY_STATUS_FILTER_STEP);
    CHECK(why.index == SLIDEWAY_NO_INDEX && why.value == 2.0);
    for (int32_t status = -3; status < 250; ++status) CHECK(strlen(slideway_status_message(status)) > 3);
}

static void a_step_fails_safe(void) {
    slideway_speed *speed = speed_of(2);
    slideway_speed_command c = slideway_speed_command_init();
    double desired[2] = {0.2, 0.3}, fast[2] = {NAN, 0.3};
    CHECK(slideway_speed_set_factor(speed, 1.0) == SLIDEWAY_STATUS_OK && slideway_speed_requested_rate(speed) == 5.0);
    CHECK(slideway_speed_set_factor(speed, 1.5) == SLIDEWAY_STATUS_FACTOR && slideway_speed_requested_rate(speed) == 5.0);
    CHECK(slideway_speed_step(speed, desired, &c) == SLIDEWAY_STATUS_OK && c.joint_speed[1] == 0.3 && c.path_rate == 5.0);
    CHECK(slideway_speed_step(NULL, desired, &c) == SLIDEWAY_STATUS_NULL && stands(&c));
    c.joint_speed[0] = 1.0;
    CHECK(slideway_speed_step(speed, NULL, &c) == SLIDEWAY_STATUS_NULL && stands(&c));
    CHECK(slideway_speed_step_affine(speed, desired, desired, &c) == SLIDEWAY_STATUS_LAW && stands(&c));
    CHECK(slideway_speed_step(speed, fast, &c) == SLIDEWAY_STATUS_OK && c.joint_speed[1] == 0.0 && c.path_rate == 0.0);
    CHECK(slideway_speed_step(speed, desired, NULL) == SLIDEWAY_STATUS_NULL);
    c.size = 8;
    CHECK(slideway_speed_step(speed, desired, &c) == SLIDEWAY_STATUS_SIZE);
    c = slideway_speed_command_init();
    /* An object of another kind is none of this one. */
    slideway_acceleration_command a = slideway_acceleration_command_init();
    CHECK(slideway_acceleration_step((slideway_acceleration *)speed, desired, desired, 1.0, &a) == SLIDEWAY_STATUS_OBJECT);
    CHECK(a.joint_speed[0] == 0.0 && a.keeping == SLIDEWAY_KEEPING_BRAKES);
    /* The input may be the output. */
    memcpy(c.joint_speed, desired, sizeof desired);
    CHECK(slideway_speed_step(speed, c.joint_speed, &c) == SLIDEWAY_STATUS_OK && c.joint_speed[0] == 0.2);
    CHECK(slideway_speed_drop(speed) == SLIDEWAY_STATUS_OK);
    CHECK(slideway_speed_step(speed, desired, &c) == SLIDEWAY_STATUS_OBJECT && stands(&c));
}

typedef struct {
    slideway_path *path;
    slideway_status inner;
    int calls, fails, forgets;
} meddler;

static int32_t meddle(void *context, const slideway_path_motion *motion, slideway_constraint_value *sample) {
    meddler *m = context;
    slideway_path_output out = slideway_path_output_init();
    ++m->calls;
    m->inner = slideway_path_step(m->path, 0.0, motion->position, motion->velocity, &out);
    if (m->forgets) return 0;
    sample->value = motion->position[0] - 0.2;
    sample->gradient[0] = 1.0, sample->gradient[1] = 0.0;
    return m->fails;
}

static void a_callback_is_contained(void) {
    meddler m = {NULL, SLIDEWAY_STATUS_OK, 0, 0, 0};
    slideway_constraint wall = slideway_constraint_init();
    slideway_path_settings s = slideway_path_settings_init();
    slideway_path_output out = slideway_path_output_init();
    slideway_refusal why = slideway_refusal_init();
    double inside[2] = {0.1, 0.0}, beyond[2] = {0.3, 0.0}, speed[2] = {0.0, 1.0};
    s.coordinates = 2, s.constraint_count = 1, s.constraints = &wall;
    s.sampling_period = 1e-3, s.push_cutoff = 20.0, s.recovery_rate = 0.5, s.approach[0] = 0.1, s.push = 1.0;
    CHECK(slideway_path_new(&s, &m.path, &why) == SLIDEWAY_STATUS_NULL && why.constraint == 0);
    wall.shape = SLIDEWAY_SHAPE_KIND_BALL, wall.radius = -1.0;
    CHECK(slideway_path_new(&s, &m.path, &why) == SLIDEWAY_STATUS_SHAPE_RADIUS && why.value == -1.0 && why.constraint == 0);
    wall.shape = SLIDEWAY_SHAPE_KIND_POLYTOPE, wall.face_count = 3;
    CHECK(slideway_path_new(&s, &m.path, &why) == SLIDEWAY_STATUS_NULL);
    wall.shape = SLIDEWAY_SHAPE_KIND_CALLBACK, wall.evaluate = meddle, wall.context = &m;
    CHECK(slideway_path_new(&s, &m.path, &why) == SLIDEWAY_STATUS_OK);
    CHECK(slideway_path_step(m.path, 0.0, inside, speed, &out) == SLIDEWAY_STATUS_OK && out.outcome == SLIDEWAY_OUTCOME_FREE);
    CHECK(m.inner == SLIDEWAY_STATUS_BUSY && m.calls == 1);
    CHECK(slideway_path_step(m.path, 1e-3, beyond, speed, &out) == SLIDEWAY_STATUS_OK);
    CHECK(out.outcome == SLIDEWAY_OUTCOME_ACTING && out.phi[0] <= 1e-12 && m.calls <= 1 + SLIDEWAY_MAX_EVALUATIONS);
    double x = out.position[0];
    m.fails = 1;
    CHECK(slideway_path_step(m.path, 2e-3, beyond, speed, &out) == SLIDEWAY_STATUS_OK && out.outcome == SLIDEWAY_OUTCOME_HELD);
    CHECK(out.hold_reason == SLIDEWAY_HOLD_CAUSE_CONSTRAINT_NOT_FINITE && out.hold_constraint == 0 && out.position[0] == x);
    m.fails = 0, m.forgets = 1;
    CHECK(slideway_path_step(m.path, 3e-3, beyond, speed, &out) == SLIDEWAY_STATUS_OK && out.outcome == SLIDEWAY_OUTCOME_HELD);
    CHECK(slideway_path_step(NULL, 4e-3, beyond, speed, &out) == SLIDEWAY_STATUS_NULL && out.position[0] == x);
    CHECK(out.velocity[1] == 0.0 && out.hold_reason == SLIDEWAY_HOLD_CAUSE_CALL_FAILED);
    CHECK(slideway_path_drop(m.path) == SLIDEWAY_STATUS_OWNER && slideway_path_free(m.path) == SLIDEWAY_STATUS_OK);
}

int main(void) {
    CHECK(slideway_abi_version() == SLIDEWAY_ABI_VERSION);
    memory_is_checked();
    structures_and_numbers_are_checked();
    a_step_fails_safe();
    a_callback_is_contained();
    puts("every misuse is answered");
    return 0;
}
