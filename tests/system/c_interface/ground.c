/* Ground of a host against ground by inputs, and what becomes of a number that is none. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hosted_wheel_c.h"

static union {
  double aligned;
  char bytes[1 << 14];
} memories[2];

/* Ground that counts its calls, and from one on has no slope. */
typedef struct plane {
  int calls, last;
} plane;

static void slope(void* host, double x, double y, double t, double* height, double* slope_x, double* slope_y,
                  double* friction) {
  plane* p = (plane*)host;
  if (*height != 0 || *slope_x != 0 || *slope_y != 0 || *friction != 1) p->calls = -1000;
  *height = 0.01 + 0.05 * x - 0.1 * y + 0 * t;
  *slope_x = 0.05;
  *slope_y = ++p->calls > p->last ? NAN : -0.1;
  *friction = 0.7;
}

static int check(const char* what, int is_right) {
  if (!is_right) printf("wrong: %s\n", what);
  return is_right ? 0 : 1;
}

int main(void) {
  hosted_wheel_solver* by_host = hosted_wheel_initialise(&memories[0], sizeof memories[0]);
  hosted_wheel_solver* by_inputs = hosted_wheel_initialise(&memories[1], sizeof memories[1]);
  plane p = {0, 1001};
  hosted_wheel_inputs inputs;
  hosted_wheel_outputs a, b;
  hosted_wheel_state before, after;
  hosted_wheel_status status;
  int i, faults = 0;
  hosted_wheel_get_inputs(by_inputs, &inputs);
  inputs.under_height = 0.01;
  inputs.under_slope_x = 0.05;
  inputs.under_slope_y = -0.1;
  inputs.under_friction = 0.7;
  hosted_wheel_set_inputs(by_inputs, &inputs);
  hosted_wheel_set_ground(by_host, slope, &p);
  for (i = 0; i < 1000; ++i) {
    faults += check("a step by the host's ground", hosted_wheel_step(by_host, 1e-3).code == 0);
    faults += check("a step by inputs", hosted_wheel_step(by_inputs, 1e-3).code == 0);
  }
  faults += check("outputs", hosted_wheel_get_outputs(by_host, &a).code == 0);
  faults += check("outputs", hosted_wheel_get_outputs(by_inputs, &b).code == 0);
  faults += check("the host is asked once a step and once for outputs", p.calls == 1001);
  faults += check("the wheel has moved aside", fabs(a.aside) > 0.01);
  faults += check("the load on a plane", fabs(a.load - b.load) < 1e-6 && a.load > 3000);
  faults += check("the place on a plane", fabs(a.bounce - b.bounce) < 1e-9 && fabs(a.aside - b.aside) < 1e-9);
  hosted_wheel_get_state(by_host, &before);
  status = hosted_wheel_step(by_host, 1e-3);
  hosted_wheel_get_state(by_host, &after);
  faults += check("a slope that is no number", !hosted_wheel_is_ok(status));
  faults += check("its text", strcmp(hosted_wheel_status_text(status), "input not a number") == 0);
  faults += check("its name", strcmp(hosted_wheel_status_name(status), "under_slope_y") == 0);
  faults += check("the state before", memcmp(&before, &after, sizeof before) == 0);
  hosted_wheel_set_ground(by_host, NULL, NULL);
  faults += check("inputs stay as they were", hosted_wheel_step(by_host, 1e-3).code == 0);
  return faults == 0 ? 0 : 1;
}
