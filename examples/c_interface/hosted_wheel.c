/* A wheel on the ground of this program, which the solver asks for: hosted_wheel [STEP]. See docs/use/roads.md. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "hosted_wheel_c.h"

/* Hills of a height and a wave number that wander, on the way up. */
typedef struct hills {
  double height, number;
} hills;

static void ground(void* host, double x, double y, double t, double* height, double* slope_x, double* slope_y,
                   double* friction) {
  const hills* h = (const hills*)host;
  const double along = h->number * x - t, across = y - 0.5;
  *height = 0.02 * x + h->height * sin(along) * cos(across);
  *slope_x = 0.02 + h->height * h->number * cos(along) * cos(across);
  *slope_y = -h->height * sin(along) * sin(across);
  *friction = 0.9 + 0.1 * sin(x);
}

static union {
  double aligned;
  char bytes[1 << 14];
} memory;

int main(int count, char** words) {
  hosted_wheel_solver* wheel = hosted_wheel_initialise(&memory, sizeof memory);
  hosted_wheel_outputs outputs;
  hosted_wheel_status status;
  hills of_country = {0.04, 1.5};
  const double step = count > 1 ? atof(words[1]) : 1e-3;
  int i;
  if (wheel == NULL) return 1;
  hosted_wheel_set_ground(wheel, ground, &of_country);
  status = hosted_wheel_assemble(wheel);
  for (i = 1; i <= (int)(2 / step + 0.5) && hosted_wheel_is_ok(status); ++i) status = hosted_wheel_step(wheel, step);
  if (hosted_wheel_is_ok(status)) status = hosted_wheel_get_outputs(wheel, &outputs);
  if (hosted_wheel_is_ok(status)) {
    printf("%.12g %.12g %.12g\n", outputs.load, outputs.bounce, outputs.aside);
    return 0;
  }
  fprintf(stderr, "step %d: %s: %s\n", i, hosted_wheel_status_text(status), hosted_wheel_status_name(status));
  return 1;
}
