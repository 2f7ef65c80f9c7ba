/* The run of run.cpp through the C interface. */
#include <stdio.h>
#include <stdlib.h>

#include "swing_c.h"

int main(void) {
  swing_solver* solver = swing_initialise(malloc(swing_size()), swing_size());
  swing_state state = {{0}, {0}, {0}, 0};
  int i;
  state.z[0] = 0.5;
  swing_set_state(solver, &state);
  for (i = 0; i < 100; ++i) {
    if (!swing_is_ok(swing_step(solver, 1e-3))) return 1;
  }
  swing_get_state(solver, &state);
  printf("%a %a %a\n", state.z[0], state.zd[0], state.t);
  return 0;
}
