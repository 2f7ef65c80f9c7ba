// 100 steps of each solver; those of the scalar recursive one are printed bit for bit.
#include <cmath>
#include <cstdio>

#include "by_matrix.hpp"
#include "swing_batch.hpp"

int main() {
  swing::State state{};
  swing::batch::State states{};
  by_matrix::State other{};
  state.z[swing::Coordinate::hinge] = other.z[by_matrix::Coordinate::hinge] = 0.5;
  for (int lane = 0; lane < swing::batch::kLanes; ++lane) set_lane(states, lane, state);
  for (int i = 0; i < 100; ++i) {
    if (!swing::step_rk4(swing::Parameters{}, swing::Inputs{}, state, 1e-3).ok()) return 1;
    swing::batch::step_rk4(swing::batch::Parameters{}, swing::batch::Inputs{}, states, 1e-3);
    if (!by_matrix::step_rk4(by_matrix::Parameters{}, by_matrix::Inputs{}, other, 1e-3).ok()) return 1;
  }
  std::printf("%a %a %a\n", state.z[0], state.zd[0], state.t);
  const bool same_in_lanes = swing::batch::lane_of(states, swing::batch::kLanes - 1).z[0] == state.z[0];
  return same_in_lanes && std::abs(state.z[0] - other.z[0]) < 1e-12 ? 0 : 1;
}
