// Sizes of the continuous states of an FMU, by which importers weigh their errors.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/emit/fmu_variables.hpp"

namespace mbgen {
namespace {

/// Of a tyre's radius, what its slip states reach.
constexpr double kSlipOfRadius = 0.1;

/// Diagonal of the box that holds all points of a model at its reference, m.
double extent_of(const Model& model) {
  Vector3 least{HUGE_VAL, HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    for (std::size_t p = 0; p < model.bodies[b].points.size(); ++p) {
      const Vector3 at = reference_position(model, {static_cast<int>(b), static_cast<int>(p)});
      for (std::size_t i = 0; i < 3; ++i) {
        least[i] = std::min(least[i], at[i]);
        most[i] = std::max(most[i], at[i]);
      }
    }
  }
  return most[0] < least[0] ? 0 : std::hypot(most[0] - least[0], most[1] - least[1], most[2] - least[2]);
}

/// One digit of it; 1 where no size is known.
double one_digit(double size) { return size > 0 ? std::stod(fmt::format("{:.0e}", size)) : 1; }

}  // namespace

void add_nominals(const EmitContext& context, const InitialState& initial, FmuLayout& fmu) {
  const double extent = extent_of(context.model);
  const std::size_t count = fmu.independent.size();
  for (std::size_t k = 0; k < fmu.derivatives.size(); ++k) {
    const int rate = fmu.derivatives[k].variable;
    FmuVariable& state =
        fmu.variables[static_cast<std::size_t>(fmu.variables[static_cast<std::size_t>(rate)].derivative_of)];
    double size = 0;
    if (k < 2 * count) {
      const auto coordinate = static_cast<std::size_t>(fmu.independent[k % count]);
      const bool turns = context.topology.bodies[coordinate].kind == FreedomKind::revolute;
      size = std::max(turns ? 1.0 : extent, std::abs((k < count ? initial.z : initial.zd)[coordinate]));
    } else {
      size = kSlipOfRadius * context.model.tyres[(k - 2 * count) / 2].radius.value;
    }
    if (const double nominal = one_digit(size); nominal != 1) state.shown.nominal = nominal;
  }
}

}  // namespace mbgen
