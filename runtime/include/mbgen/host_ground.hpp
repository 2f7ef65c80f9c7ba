#pragma once
// Ground from a function of the host: a plane under each wheel, once per step.

#include <cmath>

#include "mbgen/status.hpp"

namespace mbgen {

/// Function for the ground at a point: x, y in m, global; t in s. It sets height (m, global z), the slopes of the
/// ground along the global x and y (1) and the factor of the tyre's friction (1), which are 0, 0, 0 and 1 on entry.
/// host: pointer of the caller. It must not throw.
using HostGround = void (*)(void* host, double x, double y, double t, double* height, double* slope_x, double* slope_y,
                            double* friction);

/// Calls the function at each point and sets the six inputs of its road: point, height, slopes, friction. place: x and
/// y of each wheel, m; t: s; first_input: of each wheel; members: of all inputs. Fails: input_not_a_number with the
/// input for a value that is not finite; no input is set then. Cost: one call per wheel.
template <class Number, int N, int K, class Inputs, int M>
Status take_ground(const Number (&place)[N], double t, HostGround ground, void* host, const int (&first_input)[K],
                   Number Inputs::*const (&members)[M], Inputs& inputs) noexcept {
  static_assert(N == 2 * K);
  Number told[K][6];
  for (int k = 0; k < K; ++k) {
    const double x = static_cast<double>(place[2 * k]), y = static_cast<double>(place[2 * k + 1]);
    double height = 0, slope_x = 0, slope_y = 0, friction = 1;
    ground(host, x, y, t, &height, &slope_x, &slope_y, &friction);
    const double values[6] = {x, y, height, slope_x, slope_y, friction};
    for (int i = 0; i < 6; ++i) {
      told[k][i] = static_cast<Number>(values[i]);
      if (!std::isfinite(told[k][i])) return {Code::input_not_a_number, first_input[k] + i};
    }
  }
  for (int k = 0; k < K; ++k)
    for (int i = 0; i < 6; ++i) inputs.*members[first_input[k] + i] = told[k][i];
  return {};
}

}  // namespace mbgen
