#include "compiler/linearisation/bristles.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "compiler/formulation/formulation.hpp"
#include "compiler/model/auxiliary_states.hpp"

namespace mbgen {
namespace {

/// Subtracts from a matrix the product of a state's column (by deflection), by_rate and the row of the state's rate.
/// by_rate: force per rate over force per deflection.
void take_out(Eigen::MatrixXd& matrix, const Eigen::RowVectorXd& rates, const Eigen::VectorXd& by_deflection,
              double by_rate) {
  matrix -= by_deflection * (by_rate * rates);
}

/// Derivatives of a bristle's limit that opens from zero, m or rad, by each state and input, to the side of the
/// opening, by one-sided differences of second order.
struct Opening {
  Eigen::RowVectorXd by_state, by_input;
};

double one_sided(const std::function<double(double)>& end, double value) {
  const double size = 1e-4 * std::max(1.0, std::abs(value));
  for (const double delta : {size, -size}) {
    const double slope = (4 * end(value + delta / 2) - end(value + delta)) / delta;
    if (slope != 0) return slope;
  }
  return 0;
}

/// Derivatives by the auxiliary states among the states. bristle: index among the bristles.
Opening opening_of(const Model& model, const Topology& topology, const OperatingPoint& point, std::size_t bristle,
                   const LinearSystem& system) {
  OperatingPoint moved = point;
  const auto along = [&](double& value) {
    const double kept = value;
    const double slope = one_sided(
        [&](double at) {
          value = at;
          return bristles_at(model, topology, moved)[bristle].end;
        },
        kept);
    value = kept;
    return slope;
  };
  Opening opening{Eigen::RowVectorXd::Zero(system.A.cols()), Eigen::RowVectorXd::Zero(system.B.cols())};
  for (std::size_t j = 0; j < system.states.size(); ++j) {
    const LinearState& state = system.states[j];
    const bool is_bristle = state.index >= first_bristle(model) && state.index < slip_state_count(model);
    if (state.kind == LinearState::Kind::auxiliary && !is_bristle)
      opening.by_state[static_cast<Eigen::Index>(j)] = along(moved.x[static_cast<std::size_t>(state.index)]);
  }
  for (Eigen::Index j = 0; j < system.B.cols(); ++j)
    opening.by_input[j] = along(moved.inputs[static_cast<std::size_t>(j)]);
  return opening;
}

/// opening: null for parts at rest, for which no limit changes.
void release(const BristleEnd& bristle, Eigen::Index b, const Opening* opening, LinearSystem& system) {
  const Eigen::VectorXd rates_by_deflection = system.A.col(b), outputs_by_deflection = system.C.col(b);
  const Eigen::RowVectorXd by_state = system.A.row(b), by_input = system.B.row(b);
  // force = -(stiffness b + damping db/dt): its derivative along a column is `damping` times the row's entry there.
  const double force = bristle.stiffness + bristle.damping * by_state[b];
  const double by_rate = force != 0 ? bristle.damping / force : 0.0;
  take_out(system.A, by_state, rates_by_deflection, by_rate);
  take_out(system.B, by_input, rates_by_deflection, by_rate);
  take_out(system.C, by_state, outputs_by_deflection, by_rate);
  take_out(system.D, by_input, outputs_by_deflection, by_rate);
  if (opening != nullptr && force != 0) {
    // A limit that opens acts against the motion by stiffness times its deflection.
    const double by_end = bristle.stiffness / force * std::copysign(1.0, bristle.rate);
    system.A += rates_by_deflection * (by_end * opening->by_state);
    system.B += rates_by_deflection * (by_end * opening->by_input);
    system.C += outputs_by_deflection * (by_end * opening->by_state);
    system.D += outputs_by_deflection * (by_end * opening->by_input);
  }
  system.A.row(b).setZero();
  system.B.row(b).setZero();
  system.A.col(b).setZero();
  system.C.col(b).setZero();
  system.A(b, b) = -1 / (bristle.lag > 0 ? bristle.lag : kShortestBristleLag);
  if (std::abs(system.drift[b]) <= kLeastBristle * std::abs(system.A(b, b))) system.drift[b] = 0;
}

}  // namespace

std::vector<BristleEnd> bristles_at(const Model& model, const Topology& topology, const OperatingPoint& point) {
  if (first_bristle(model) == slip_state_count(model)) return {};
  const Layout layout = choose_layout(model, topology);
  Annotator<double> annotator;
  System<double> system{model, topology, layout, {}, {}, {}, annotator};
  Environment<double>& environment = system.environment;
  environment.topology = &topology;
  environment.inputs = point.inputs;
  for (const Parameter& parameter : model.parameters) environment.parameters.push_back(parameter.value);
  environment.z.assign(topology.bodies.size(), 0.0);
  environment.zd = environment.z;
  system.constants = make_constants(model, topology, environment);
  environment.t = point.t;
  environment.z = point.z;
  environment.zd = point.zd;
  system.x = point.x;
  const Kinematics<double> k = kinematics(system);
  return bristle_ends(system, k, velocities(system, k));
}

void release_bristles(const Model& model, const Topology& topology, const OperatingPoint& point, LinearSystem& system) {
  const std::vector<BristleEnd> ends = bristles_at(model, topology, point);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].has_limit()) continue;
    const int state = first_bristle(model) + static_cast<int>(i);
    const auto is_it = [&](const LinearState& s) { return s.kind == LinearState::Kind::auxiliary && s.index == state; };
    const auto found = std::find_if(system.states.begin(), system.states.end(), is_it);
    std::optional<Opening> opening;
    if (ends[i].slides()) opening = opening_of(model, topology, point, i, system);
    release(ends[i], found - system.states.begin(), opening ? &*opening : nullptr, system);
  }
}

std::vector<BristleEnd> set_steady_bristles(const Model& model, const Topology& topology, OperatingPoint& point) {
  std::vector<BristleEnd> ends = bristles_at(model, topology, point);
  auto x = point.x.begin() + first_bristle(model);
  for (const BristleEnd& bristle : ends) {
    if (bristle.slides() || !bristle.has_limit()) *x = std::copysign(bristle.end, bristle.rate);
    ++x;
  }
  return ends;
}

}  // namespace mbgen
