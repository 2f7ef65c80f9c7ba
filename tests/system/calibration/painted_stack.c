/* How deep steps go on a stack painted before, against the bytes given: both starting a step and passing a singular
 * position, which the four-bar stretched out has. */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "four_bar_c.h"

enum { kBytes = 1 << 20 };
static union {
  double aligned;
  char bytes[1 << 14];
} memory;
static int is_idle;

static void* work(void* solver) {
  four_bar_status status = {0, -1};
  int i;
  if (!is_idle) status = four_bar_assemble(solver);
  for (i = 0; !is_idle && i < 2000 && four_bar_is_ok(status); ++i) status = four_bar_step(solver, 1e-3);
  return NULL;
}

/* Bytes that a thread has touched. */
static long depth(unsigned char* stack, four_bar_solver* solver) {
  pthread_attr_t attributes;
  pthread_t thread;
  long untouched = 0;
  memset(stack, 0x5a, kBytes);
  if (pthread_attr_init(&attributes) != 0 || pthread_attr_setstack(&attributes, stack, kBytes) != 0) exit(2);
  if (pthread_create(&thread, &attributes, work, solver) != 0 || pthread_join(thread, NULL) != 0) exit(2);
  while (untouched < kBytes && stack[untouched] == 0x5a) ++untouched;
  return kBytes - untouched;
}

int main(int count, char** words) {
  const long bound = count > 1 ? atol(words[1]) : 0;
  unsigned char* stack = NULL;
  four_bar_solver* solver = four_bar_initialise(&memory, sizeof memory);
  long idle, used;
  if (solver == NULL || posix_memalign((void**)&stack, 4096, kBytes) != 0) return 2;
  is_idle = 1;
  idle = depth(stack, solver);
  is_idle = 0;
  used = depth(stack, solver) - idle;
  printf("calibration: steps took %ld bytes of stack, %ld at most were announced\n", used, bound);
  return used > 0 && used <= bound ? 0 : 1;
}
