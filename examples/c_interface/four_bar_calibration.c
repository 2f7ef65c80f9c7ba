/* A cycle with a calibration tool beside it: it reads and writes the four objects of four_bar_a2l.h by four_bar.a2l,
 * through whatever protocol the application has (XCP, CCP). docs/use/embedding.md has the commands. */
#include <stdio.h>
#include <string.h>

#include "four_bar_a2l.h"

/* Objects of file scope under the names that the file's symbols link to. */
four_bar_parameters four_bar_a2l_parameters;
four_bar_inputs four_bar_a2l_inputs;
four_bar_outputs four_bar_a2l_outputs;
four_bar_state four_bar_a2l_state;

/* All memory that the solver ever uses. */
static union {
  double aligned;
  char bytes[1 << 14];
} memory;

/* One cycle: what the tool has set goes in, what it shows comes out. */
static four_bar_status cycle(four_bar_solver* solver, four_bar_parameters* taken, double h) {
  four_bar_status status;
  if (memcmp(taken, &four_bar_a2l_parameters, sizeof *taken) != 0) { /* a change only: a multistep method starts anew */
    *taken = four_bar_a2l_parameters;
    four_bar_set_parameters(solver, taken);
  }
  status = four_bar_step(solver, h);
  four_bar_get_inputs(solver, &four_bar_a2l_inputs);
  four_bar_get_state(solver, &four_bar_a2l_state);
  four_bar_get_outputs(solver, &four_bar_a2l_outputs);
  return status;
}

int main(void) {
  four_bar_solver* solver = four_bar_initialise(&memory, sizeof memory);
  four_bar_parameters taken;
  int k;
  if (solver == NULL) return 1;
  four_bar_get_parameters(solver, &taken);
  four_bar_a2l_parameters = taken;
  for (k = 0; k < 1000; ++k) {
    if (k == 500) four_bar_a2l_parameters.k = 0; /* as a tool would */
    if (!four_bar_is_ok(cycle(solver, &taken, 1e-3))) return 1;
    if (k % 250 == 249) printf("%.3f s: spring %.6f N\n", four_bar_a2l_state.t, four_bar_a2l_outputs.spring_force);
  }
  return 0;
}
