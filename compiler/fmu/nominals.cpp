// Sizes of the continuous states of an FMU, by which importers weigh their errors.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/fmu/variables.hpp"
#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/vectors.hpp"

namespace mbgen {
namespace {

/// Diagonal of the box that holds all points of a model at its reference, m.
double extent_of(const Model& model) {
  Box box;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b)
    for (int p = 0; p < static_cast<int>(model.bodies[b].points.size()); ++p)
      box.add(reference_position(model, {b, p}));
  return box.diagonal();
}

/// One digit of it; 1 where no size is known.
double one_digit(double size) { return size > 0 ? std::stod(fmt::format("{:.0e}", size)) : 1; }

}  // namespace

void add_nominals(const EmitContext& context, const InitialState& initial, FmuLayout& fmu) {
  const double extent = extent_of(context.model);
  const std::size_t count = fmu.independent.size();
  const std::vector<AuxiliaryState> states = auxiliary_states(context.model);
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
      size = magnitude_of(states[k - 2 * count]);
    }
    if (const double nominal = one_digit(size); nominal != 1) state.shown.nominal = nominal;
  }
}

}  // namespace mbgen
