/* A reference that would run into a wall and a ball is bent along them. The wall is built in, the ball is a function of our own. */
#include <math.h>
#include <stdio.h>

#include "slideway.h"

#define PERIOD 1e-3 /* s */

typedef struct {
    double centre[2], radius;
} ball;

/* sigma = radius - |p - centre|: the signed distance, to stay outside, with its gradient and how that turns along the motion. */
static int32_t outside(void *context, const slideway_path_motion *motion, slideway_constraint_value *sample) {
    const ball *b = context;
    double x = motion->position[0] - b->centre[0], y = motion->position[1] - b->centre[1], r = hypot(x, y);
    if (r == 0.0) return 1; /* no direction out of the centre: the reference is held */
    double nx = x / r, ny = y / r, along = nx * motion->velocity[0] + ny * motion->velocity[1];
    sample->value = b->radius - r;
    sample->gradient[0] = -nx;
    sample->gradient[1] = -ny;
    sample->gradient_rate[0] = -(motion->velocity[0] - along * nx) / r;
    sample->gradient_rate[1] = -(motion->velocity[1] - along * ny) / r;
    return 0;
}

int main(void) {
    ball obstacle = {{0.0, 2.2}, 0.15};
    slideway_constraint constraints[2] = {slideway_constraint_init(), slideway_constraint_init()};
    constraints[0].shape = SLIDEWAY_SHAPE_KIND_HALF_SPACE; /* x <= 0.2 m */
    constraints[0].vector[0] = 1.0;
    constraints[0].offset = 0.2;
    constraints[1].shape = SLIDEWAY_SHAPE_KIND_CALLBACK;
    constraints[1].evaluate = outside;
    constraints[1].context = &obstacle;

    slideway_path_settings settings = slideway_path_settings_init();
    settings.coordinates = 2;
    settings.constraint_count = 2;
    settings.constraints = constraints;
    settings.form = SLIDEWAY_FORM_IMPLICIT;
    settings.margin = SLIDEWAY_MARGIN_KIND_FIXED;
    settings.sampling_period = PERIOD;
    settings.push_cutoff = 20.0;  /* rad/s */
    settings.recovery_rate = 0.5; /* m/s */
    for (int i = 0; i < 2; ++i) settings.approach[i] = 0.1, settings.margins[i] = 1e-4; /* s, m */

    static SLIDEWAY_ALIGNED unsigned char memory[SLIDEWAY_PATH_SIZE_MAX]; /* no heap */
    slideway_path *path;
    slideway_refusal why = slideway_refusal_init();
    slideway_status status = slideway_path_place(memory, sizeof memory, &settings, &path, &why);
    if (status != SLIDEWAY_STATUS_OK) {
        fprintf(stderr, "%s; constraint %u, %g\n", slideway_status_message(status), why.constraint, why.value);
        return 1;
    }

    slideway_path_output out = slideway_path_output_init();
    double worst = -INFINITY, detour = 0.0;
    int acting = 0;
    for (int k = 0; k < 3000; ++k) {
        double t = PERIOD * k, position[2] = {0.3 * sin(t), t}, velocity[2] = {0.3 * cos(t), 1.0};
        if (slideway_path_step(path, t, position, velocity, &out) != SLIDEWAY_STATUS_OK) return 1;
        acting += out.outcome == SLIDEWAY_OUTCOME_ACTING;
        worst = fmax(worst, fmax(out.sigma[0], out.sigma[1]));
        detour = fmax(detour, hypot(out.position[0] - position[0], out.position[1] - position[1]));
    }
    printf("bent in %d of 3000 samples, by %.0f mm at most; nearest to a boundary %.2f mm\n", acting, 1e3 * detour, -1e3 * worst);
    return slideway_path_drop(path) == SLIDEWAY_STATUS_OK && acting > 0 && worst <= 0.0 ? 0 : 1;
}
