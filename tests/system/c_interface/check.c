/* The C interface of the four-bar in C99: what it promises, then 1000 steps, printed bit for bit. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "four_bar_c.h"

/* The numbers of the solver; the time is a double always. */
#ifdef SINGLE_PRECISION
typedef float number;
#else
typedef double number;
#endif

static int failures = 0;

static void expect(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "check.c: not so: %s\n", what);
  ++failures;
}

static four_bar_solver* make(void) {
  void* memory = malloc(four_bar_size());
  four_bar_solver* solver = four_bar_initialise(memory, four_bar_size());
  expect(solver != NULL, "memory of malloc is enough");
  expect((void*)solver == memory, "the solver is where its memory is");
  return solver;
}

static void check_memory(void) {
  char* memory = malloc(four_bar_size() + four_bar_alignment());
  expect(four_bar_initialise(NULL, four_bar_size()) == NULL, "no memory is refused");
  expect(four_bar_initialise(memory, four_bar_size() - 1) == NULL, "too little memory is refused");
  expect(four_bar_initialise(memory + 1, four_bar_size()) == NULL, "memory at an odd place is refused");
  free(memory);
}

static void check_tables(void) {
  expect(strcmp(four_bar_model(), "four_bar") == 0, "the model has its name");
  expect(strlen(four_bar_hash()) == 16, "the hash has 16 digits");
  expect(strcmp(four_bar_coordinate_name(0), "crank_pin") == 0, "the first coordinate is the crank's");
  expect(strcmp(four_bar_coordinate_unit(0), "rad") == 0, "it is an angle");
  expect(strcmp(four_bar_coordinate_name(FOUR_BAR_number_of_coordinates), "") == 0, "there is nothing beyond the last");
  expect(strcmp(four_bar_coordinate_name(-1), "") == 0, "there is nothing before the first");
  expect(four_bar_parameter_index("k") == 0, "k is a parameter");
  expect(four_bar_parameter_index("kk") == -1, "kk is none");
  expect(four_bar_parameter_index("") == -1, "nothing is none");
}

/* Whether two states have the same bits; floats may leave a gap before the time. */
static int are_same(const four_bar_state* one, const four_bar_state* other) {
  return memcmp(one->z, other->z, sizeof one->z) == 0 && memcmp(one->zd, other->zd, sizeof one->zd) == 0 &&
         memcmp(one->x, other->x, sizeof one->x) == 0 && memcmp(&one->t, &other->t, sizeof one->t) == 0;
}

static void check_failures(void) {
  four_bar_solver* solver = make();
  four_bar_state state, before;
  four_bar_status status = four_bar_step(solver, -1.0);
  number value = 0;
  expect(!four_bar_is_ok(status), "a step back is refused");
  expect(strcmp(four_bar_status_text(status), "step invalid") == 0, "and said to be");
  four_bar_get_state(solver, &state);
  state.zd[1] = (number)(0.0 / (state.t - state.t));
  four_bar_set_state(solver, &state);
  four_bar_get_state(solver, &before);
  status = four_bar_step(solver, 1e-3);
  expect(!four_bar_is_ok(status), "what is no number is refused");
  expect(strcmp(four_bar_status_name(status), "coupler_pin") == 0, "and the coordinate named");
  four_bar_get_state(solver, &state);
  expect(are_same(&state, &before), "the state is that before the step");
  expect(four_bar_set_parameter(solver, 1, 1) == -1, "there is no second parameter");
  expect(four_bar_get_parameter(solver, -1, &value) == -1, "nor one before the first");
  four_bar_reset(solver);
  expect(four_bar_is_ok(four_bar_step(solver, 1e-3)), "after a reset it goes on");
  free(solver);
}

/* A step in which a bar turns by more than 0.5 rad is made, and said to be too long. */
static void check_turns(void) {
  four_bar_solver* solver = make();
  four_bar_state state;
  four_bar_status status;
  int i;
  four_bar_get_state(solver, &state);
  for (i = 0; i < FOUR_BAR_number_of_coordinates; ++i) state.zd[i] *= 60;
  four_bar_set_state(solver, &state);
  status = four_bar_step(solver, 1e-3);
  expect(four_bar_is_ok(status), "a step with far turns is made");
  expect(strcmp(four_bar_status_text(status), "turns too far within a step") == 0, "and noticed");
  expect(strcmp(four_bar_status_name(status), "coupler_pin") == 0, "with the coordinate");
  free(solver);
}

/* 1000 steps; in the middle the spring becomes stiffer and a torque begins. */
static void run(four_bar_solver* solver, four_bar_solver* other) {
  int i;
  four_bar_inputs inputs;
  number value = 0;
  expect(four_bar_is_ok(four_bar_assemble(solver)), "the loop closes");
  for (i = 0; i < 1000; ++i) {
    if (i == 500) {
      expect(four_bar_set_parameter(solver, four_bar_parameter_index("k"), 1500) == 0, "k can be set");
      expect(four_bar_get_parameter(solver, 0, &value) == 0 && value == 1500, "and is set");
      four_bar_get_inputs(solver, &inputs);
      inputs.torque = 2;
      four_bar_set_inputs(solver, &inputs);
    }
    expect(four_bar_is_ok(four_bar_step(solver, 1e-3)), "a step goes well");
    if (other != NULL) four_bar_step(other, 2e-3);
  }
}

static void print(const four_bar_solver* solver) {
  int i;
  four_bar_state state;
  four_bar_outputs outputs;
  four_bar_get_state(solver, &state);
  expect(four_bar_is_ok(four_bar_get_outputs(solver, &outputs)), "there are outputs");
  for (i = 0; i < FOUR_BAR_number_of_coordinates; ++i) printf("%a %a\n", (double)state.z[i], (double)state.zd[i]);
  printf("%a %a %a\n", state.t, (double)outputs.spring_force, (double)outputs.kinetic_energy);
}

int main(void) {
  four_bar_solver* solver = make();
  four_bar_solver* other = make();
  four_bar_state start, again;
  check_memory();
  check_tables();
  check_turns();
  check_failures();
  four_bar_get_state(solver, &start);
  run(solver, other);
  print(solver);
  four_bar_reset(solver);
  four_bar_get_state(solver, &again);
  expect(are_same(&start, &again), "a reset gives the initial state");
  free(solver);
  free(other);
  return failures == 0 ? 0 : 1;
}
