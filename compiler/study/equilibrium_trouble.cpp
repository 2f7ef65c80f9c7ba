#include "compiler/study/equilibrium_trouble.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/user_error.hpp"
#include "compiler/engines/engine.hpp"
#include "compiler/model/evaluate.hpp"
#include "compiler/model/tyre_sets.hpp"

namespace mbgen {
namespace {

constexpr double kLargestRadius = 5;    // m, of a tyre of any vehicle
constexpr std::size_t kMostMoved = 4;   // coordinates that are told
constexpr double kWorthTelling = 1e-3;  // rad or m
constexpr double kFalls = 0.5;          // of gravity

std::string coordinate_text(const Compilation& compilation, std::size_t i, double value, const char* per) {
  const TreeBody& body = compilation.topology.bodies[i];
  return fmt::format("{} {:.4g} {}{}", body.coordinate, value, unit_of(body.kind), per);
}

/// The coordinate with the largest acceleration at a position, -1 where none is to be had.
int fastest(const Compilation& compilation, const std::vector<double>& inputs, const GenericState& at,
            double& acceleration) {
  GenericSolver solver(compilation.model, compilation.topology, compilation.analysis);
  solver.set_inputs(inputs);
  GenericDerivative rates;
  if (!solver.accelerations(at, std::vector<double>(at.z.size(), 0.0), rates).ok() || rates.zdd.empty()) return -1;
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(rates.zdd.begin(), rates.zdd.end(), larger);
  acceleration = *largest;
  return static_cast<int>(largest - rates.zdd.begin());
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

bool has_lateral_force(const Tyre& tyre) {
  if (tyre.model == TyreModel::pac89) return true;
  return tyre.coefficients[tyre_field_index(tyre_fields(tyre.model), "PDY1")].value != 0;
}

/// Faults of a tyre or its wheel, one line each.
void add_tyre_causes(const Model& model, std::vector<std::string>& causes) {
  for (const Tyre& tyre : model.tyres) {
    const Body& wheel = model.bodies[tyre.centre.body];
    if (tyre.radius.value > kLargestRadius) {
      causes.push_back(
          fmt::format("radius of tyre {} is {:.4g} m: is it in millimetres?", tyre.name, tyre.radius.value));
    }
    if (!has_lateral_force(tyre)) {
      causes.push_back(
          fmt::format("tyre {} has no lateral force, PDY1 is 0: has its .tir file a section [LATERAL]?", tyre.name));
    }
    const bool has_inertia =
        std::any_of(wheel.inertia.begin(), wheel.inertia.end(), [](const Quantity& entry) { return entry.value != 0; });
    if (!has_inertia) causes.push_back(fmt::format("wheel {} of tyre {} has no inertia", wheel.name, tyre.name));
  }
}

/// Numbers of a model in a state at rest.
struct AtRest {
  const Compilation& compilation;
  const std::vector<double>& inputs;
  const GenericState& state;
  double parameter(int i) const { return compilation.model.parameters[static_cast<std::size_t>(i)].value; }
  double input(int i) const { return inputs[static_cast<std::size_t>(i)]; }
  double time() const { return state.t; }
  double position(const CoordinateReference& at) const {
    const int i = tree_coordinate(compilation.topology, at);
    return i < 0 ? 0 : state.z[static_cast<std::size_t>(i)];
  }
  double velocity(const CoordinateReference&) const { return 0; }
  double local(int) const { return 0; }
};

/// Joint forces on the coordinate that accelerates most, and of models with tyres forces along the road, which nothing
/// that rolls withstands, as far as they act at rest.
void add_drives(const AtRest& rest, int index, std::vector<std::string>& causes) {
  const Model& model = rest.compilation.model;
  const auto value = [&](const Quantity& quantity) { return evaluate<double>(quantity, model.expressions, rest); };
  for (const JointForce& force : model.joint_forces) {
    const double now = value(force.force);
    if (now == 0 || tree_coordinate(rest.compilation.topology, force.joint) != index) continue;
    const TreeBody& body = rest.compilation.topology.bodies[static_cast<std::size_t>(index)];
    causes.push_back(fmt::format("joint force {} drives {} by {:.4g} {} at rest", force.name, body.coordinate, now,
                                 body.kind == FreedomKind::prismatic ? "N" : "N m"));
  }
  for (const AppliedForce& force : model.forces) {
    const double along = std::hypot(value(force.force[0]), value(force.force[1]));
    if (model.tyres.empty() || !(along > 0)) continue;
    causes.push_back(fmt::format("force {} pushes body {} along the road by {:.4g} N at rest", force.name,
                                 model.bodies[static_cast<std::size_t>(force.at.body)].name, along));
  }
}

/// The usual causes whose signs are there; the coordinate with the largest acceleration is told by `index`.
std::vector<std::string> causes_of(const AtRest& rest, int index, double acceleration,
                                   const std::vector<double>& loads) {
  const Compilation& compilation = rest.compilation;
  const Model& model = compilation.model;
  std::vector<std::string> causes;
  const double up = model.gravity[2].value;
  if (up > 0) causes.push_back(fmt::format("gravity points upwards, its z is {:.4g} m/s^2", up));
  add_tyre_causes(model, causes);
  const bool none_loaded = std::none_of(loads.begin(), loads.end(), [](double load) { return load > 0; });
  if (!loads.empty() && none_loaded)
    causes.push_back("no tyre touches the road: see road_height and the start position");
  if (index < 0) return causes;
  add_drives(rest, index, causes);
  const bool falls = compilation.topology.bodies[static_cast<std::size_t>(index)].kind == FreedomKind::prismatic &&
                     std::abs(acceleration) > kFalls * std::abs(up);
  if (causes.empty() && falls) {
    causes.push_back(fmt::format("nothing holds {}: a spring, a tyre or a joint may be missing",
                                 compilation.topology.bodies[static_cast<std::size_t>(index)].coordinate));
  }
  return causes;
}

}  // namespace

std::vector<double> tyre_loads(const Compilation& compilation, const std::vector<double>& inputs,
                               const GenericState& at) {
  Model model = compilation.model;
  model.outputs.clear();
  for (std::size_t i = 0; i < model.tyres.size(); ++i) {
    model.outputs.push_back({"", {}, "", TyreOutput{TyreOutput::What::load, static_cast<int>(i)}});
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
  double acceleration = 0;
  const int index = fastest(compilation, inputs, last, acceleration);
  const std::vector<double> loads = tyre_loads(compilation, inputs, last);
  std::string message = "there is no static equilibrium near the initial state";
  if (status.code != Code::no_equilibrium) message += fmt::format(", {}", describe(compilation, status));
  if (index >= 0) {
    message += fmt::format(": {} is the largest acceleration",
                           coordinate_text(compilation, static_cast<std::size_t>(index), acceleration, "/s^2"));
  }
  message += moved_text(compilation, start, last) + loads_text(compilation.model, loads);
  const std::vector<std::string> causes = causes_of({compilation, inputs, last}, index, acceleration, loads);
  throw UserError(Diagnostics{
      {{compilation.model.file, 0, 0, ""}, message, fmt::format("{}", fmt::join(causes, "\n  hint: ")), ""}});
}

}  // namespace mbgen
