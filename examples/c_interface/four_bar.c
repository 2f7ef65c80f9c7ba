/* The four-bar through its C interface: a torque on the crank, a stiffer spring on the way. See docs/use/embedding.md. */

#include <stdio.h>

#include "four_bar_c.h"

/* All memory that the solver ever uses. */
static union {
  double aligned;
  char bytes[1 << 14];
} memory;

int main(void) {
  four_bar_solver* linkage = four_bar_initialise(&memory, sizeof memory);
  four_bar_inputs inputs;
  four_bar_outputs outputs;
  four_bar_status status;
  int i;
  if (linkage == NULL) {
    fprintf(stderr, "the solver takes %lu bytes\n", (unsigned long)four_bar_size());
    return 1;
  }
  status = four_bar_assemble(linkage);
  for (i = 1; i <= 1000 && four_bar_is_ok(status); ++i) {
    four_bar_get_inputs(linkage, &inputs);
    inputs.torque = i < 500 ? 0.0 : 2.0;
    four_bar_set_inputs(linkage, &inputs);
    if (i == 750) four_bar_set_parameter(linkage, four_bar_parameter_index("k"), 1500.0);
    status = four_bar_step(linkage, 1e-3);
    if (i % 250 == 0 && four_bar_is_ok(four_bar_get_outputs(linkage, &outputs)))
      printf("%5.3f s  crank %8.4f rad  spring %8.3f N\n", i * 1e-3, outputs.crank_angle, outputs.spring_force);
  }
  if (four_bar_is_ok(status)) return 0;
  fprintf(stderr, "step %d: %s: %s\n", i, four_bar_status_text(status), four_bar_status_name(status));
  return 1;
}
