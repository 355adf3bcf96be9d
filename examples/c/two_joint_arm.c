/* A speed loop around a two-joint arm that follows an ellipse: the reference goes as fast as the joints' speed limits allow. */
#include <math.h>
#include <stdio.h>

#include "slideway.h"

#define PERIOD 1e-3 /* s */
#define GAIN 10.0   /* 1/s, of the position loop */

typedef struct {
    double x, y;
} point;

/* The tool of an arm with links of 1 m and 0.8 m. */
static point tool(const double q[2]) {
    return (point){cos(q[0]) + 0.8 * cos(q[0] + q[1]), sin(q[0]) + 0.8 * sin(q[0] + q[1])};
}

/* Joint speeds that move the tool at `v`: the inverse of the arm's Jacobian, by Cramer's rule. */
static void joint_speeds(const double q[2], point v, double out[2]) {
    double j21 = 0.8 * cos(q[0] + q[1]), j11 = -0.8 * sin(q[0] + q[1]);
    double j20 = cos(q[0]) + j21, j10 = -sin(q[0]) + j11, determinant = j10 * j21 - j11 * j20;
    out[0] = (j21 * v.x - j11 * v.y) / determinant;
    out[1] = (j10 * v.y - j20 * v.x) / determinant;
}

static point path(double s) { return (point){1.2 + 0.3 * cos(s), 0.4 + 0.2 * sin(s)}; }

static point path_slope(double s) { return (point){-0.3 * sin(s), 0.2 * cos(s)}; }

int main(void) {
    slideway_speed_settings settings = slideway_speed_settings_init();
    settings.joints = 2;
    settings.law = SLIDEWAY_SPEED_LAW_IMPLICIT;
    settings.saturation = SLIDEWAY_SATURATION_KIND_DIRECTION_PRESERVING;
    for (int i = 0; i < 2; ++i) settings.lower[i] = -0.5, settings.upper[i] = 0.5; /* rad/s */
    settings.sampling_period = PERIOD;
    settings.bandwidth = 20.0;  /* rad/s */
    settings.target_rate = 5.0; /* 1/s, faster than the joints allow */

    static SLIDEWAY_ALIGNED unsigned char memory[SLIDEWAY_SPEED_SIZE_MAX]; /* no heap */
    slideway_speed *regulator;
    slideway_refusal why = slideway_refusal_init();
    slideway_status status = slideway_speed_place(memory, sizeof memory, &settings, &regulator, &why);
    if (status != SLIDEWAY_STATUS_OK) {
        fprintf(stderr, "%s; joint %u has %g\n", slideway_status_message(status), why.index, why.value);
        return 1;
    }

    slideway_speed_command command = slideway_speed_command_init();
    double q[2] = {-0.5026, 1.1958}, s = 0.0, error = 0.0, used = 0.0; /* the tool starts near the path */
    int samples = 0;
    for (; s < 6.283185307179586 && samples < 100000; ++samples) {
        /* Any controller, evaluated in two parts: what pulls the tool to the path, and what the moving reference adds. */
        point at = tool(q), aim = path(s), slope = path_slope(s);
        point back = {GAIN * (aim.x - at.x), GAIN * (aim.y - at.y)};
        point along = {settings.target_rate * slope.x, settings.target_rate * slope.y};
        double feedback[2], feedforward[2];
        joint_speeds(q, back, feedback);
        joint_speeds(q, along, feedforward);
        status = slideway_speed_step_affine(regulator, feedback, feedforward, &command);
        if (status != SLIDEWAY_STATUS_OK) return 1;
        for (int i = 0; i < 2; ++i) {
            q[i] += PERIOD * command.joint_speed[i];
            used = fmax(used, fabs(command.joint_speed[i]) / settings.upper[i]);
        }
        s += PERIOD * command.path_rate;
        if (samples > 1000) error = fmax(error, hypot(path(s).x - tool(q).x, path(s).y - tool(q).y));
    }
    printf("once round in %.3f s, %.2f mm from the path at most, %.3f of a limit used\n", samples * PERIOD, 1e3 * error, used);
    return slideway_speed_drop(regulator) == SLIDEWAY_STATUS_OK && used <= 1.0 && error < 2e-3 ? 0 : 1;
}
