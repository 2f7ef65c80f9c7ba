#include "workbench/start/equilibrium_trouble.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/model/auxiliary_states.hpp"
#include "compiler/model/element_access.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/engines/engine.hpp"
#include "workbench/start/equilibrium_causes.hpp"

namespace mbgen {
namespace {

constexpr std::size_t kMostMoved = 4;   // coordinates that are told
constexpr double kWorthTelling = 1e-3;  // rad or m
constexpr double kFastState = 1e-3;     // 1/s: a rate over the magnitude of its state

std::string coordinate_text(const Compilation& compilation, std::size_t i, double value, const char* per) {
  const TreeBody& body = compilation.topology.bodies[i];
  return fmt::format("{} {:.4g} {}{}", body.coordinate, value, unit_of(body.kind), per);
}

/// Accelerations and rates at a position, none if they cannot be computed.
GenericDerivative rates_at(const Compilation& compilation, const std::vector<double>& inputs, const GenericState& at) {
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  GenericDerivative rates;
  const Status status = solver.accelerations(at, std::vector<double>(at.z.size(), 0.0), rates);
  return status.ok() ? rates : GenericDerivative();
}

/// The state of the user's own that changes fastest by its magnitude.
std::string state_text(const Model& model, const GenericDerivative& rates) {
  const std::vector<AuxiliaryState> states = auxiliary_states(model);
  double fastest = kFastState;
  std::string text;
  const auto end = std::min(rates.xd.size(), static_cast<std::size_t>(first_sampled_value(model)));
  for (auto i = static_cast<std::size_t>(first_user_state(model)); i < end; ++i) {
    const double rate = std::abs(rates.xd[i]) / magnitude_of(states[i]);
    if (!(rate > fastest)) continue;
    fastest = rate;
    text = fmt::format("; state {} changes by {:.4g} a second", states[i].name, rates.xd[i]);
  }
  return text;
}

std::string loads_text(const Model& model, const std::vector<double>& loads) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < loads.size(); ++i)
    list.push_back(fmt::format("{} {:.4g} N", model.tyres[i].name, loads[i]));
  return list.empty() ? "" : fmt::format("; loads of the tyres: {}", fmt::join(list, ", "));
}

/// The coordinates that the search moved farthest.
std::string moved_text(const Compilation& compilation, const GenericState& start, const GenericState& last) {
  std::vector<std::size_t> order;
  const auto way = [&](std::size_t i) { return std::abs(last.z[i] - start.z[i]); };
  for (std::size_t i = 0; i < last.z.size(); ++i) {
    if (!(way(i) < kWorthTelling)) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return way(a) > way(b); });
  std::vector<std::string> list;
  for (std::size_t k = 0; k < std::min(order.size(), kMostMoved); ++k) {
    list.push_back(coordinate_text(compilation, order[k], last.z[order[k]], ""));
  }
  return list.empty() ? "; the search did not leave the start"
                      : fmt::format("; the search came to {}", fmt::join(list, ", "));
}

}  // namespace

std::vector<double> tyre_loads(const Compilation& compilation, const std::vector<double>& inputs,
                               const GenericState& at) {
  Model model = compilation.model;
  model.outputs.clear();
  for (std::size_t i = 0; i < model.tyres.size(); ++i) {
    model.outputs.push_back({"", {}, "", output_of<Tyre>("load", i)});
  }
  GenericSolver solver(model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  const std::vector<double> no_forces(at.z.size(), 0.0);
  GenericDerivative rates;
  if (!solver.accelerations(at, no_forces, rates).ok()) return {};
  return solver.outputs(at, no_forces, rates).y;
}

void fail_equilibrium(const Compilation& compilation, const std::vector<double>& inputs, const GenericState& start,
                      const GenericState& last, Status status) {
  const GenericDerivative rates = rates_at(compilation, inputs, last);
  const std::vector<double>& zdd = rates.zdd;
  const auto is_smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(zdd.begin(), zdd.end(), is_smaller);
  const std::vector<double> loads = tyre_loads(compilation, inputs, last);
  std::string message = "there is no static equilibrium near the initial state";
  if (status.code != Code::no_equilibrium) message += fmt::format(", {}", describe(compilation, status));
  if (largest != zdd.end()) {
    const auto index = static_cast<std::size_t>(largest - zdd.begin());
    message += fmt::format(": {} is the largest acceleration", coordinate_text(compilation, index, *largest, "/s^2"));
  }
  message += state_text(compilation.model, rates);
  message += moved_text(compilation, start, last) + loads_text(compilation.model, loads);
  const std::vector<std::string> causes = equilibrium_causes({compilation, inputs, start, last, zdd, loads});
  throw UserError(Diagnostics{
      {{compilation.model.file, 0, 0, ""}, message, fmt::format("{}", fmt::join(causes, "\n  hint: ")), ""}});
}

}  // namespace mbgen
