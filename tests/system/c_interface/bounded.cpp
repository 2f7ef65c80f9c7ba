// C++ hosts: assemble says by its status what no model may have, alone and in lanes.

#include "bounded.hpp"

#include <cstdio>
#include <cstring>

#include "bounded_batch.hpp"
#include "bounded_quantities.hpp"

namespace {

int failures = 0;

void expect(bool holds, const char* what) {
  if (!holds) ++failures, std::printf("%s\n", what);
}

bool says(mbgen::Status status, const char* name) {
  return status.code == mbgen::kQuantityOutOfRange && !status.ok() &&
         std::strcmp(bounded::describe(status), name) == 0 &&
         std::strcmp(mbgen::text_of_any(status.code), "parameters make what no model may have") == 0;
}

}  // namespace

int main() {
  bounded::Parameters parameters;
  bounded::Inputs inputs;
  bounded::State state{};
  expect(bounded::assemble(parameters, inputs, state).ok(), "values of the model");
  parameters.a = 2;
  expect(says(bounded::assemble(parameters, inputs, state), "mass of block"), "mass");
  expect(bounded::first_impossible_quantity(parameters) >= 0, "parameters alone");
  parameters = {};
  inputs.u = -3;
  expect(bounded::first_impossible_quantity(parameters) == -1, "parameters that are right");
  expect(says(bounded::assemble(parameters, inputs, state), "damping of bar"), "damping by an input");

  bounded::batch::Parameters all{};
  bounded::batch::Inputs in{};
  bounded::batch::State states{};
  for (int lane = 0; lane < bounded::batch::kLanes; ++lane) {
    bounded::Parameters one;
    if (lane == 1) one.b = 4.5;
    set_lane(all, lane, one);
    set_lane(in, lane, bounded::Inputs{});
  }
  const bounded::batch::Statuses statuses = bounded::batch::assemble(all, in, states);
  for (int lane = 0; lane < bounded::batch::kLanes; ++lane) {
    expect(lane == 1 ? says(statuses[lane], "elastic of brake") : statuses[lane].ok(), "lanes");
  }
  return failures == 0 ? 0 : 1;
}
