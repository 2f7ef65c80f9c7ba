#include "workbench/kc/compliance.hpp"

#include <fmt/format.h>

#include <cmath>

#include "compiler/algebra/dense.hpp"

namespace mbgen::kc {
namespace {

constexpr int kUnitLoads = 6;  ///< force along x, y, z, moment about x, y, z
constexpr const char* kLoadNames[kUnitLoads] = {"fx", "fy", "fz", "mx", "my", "mz"};
constexpr int kVertical = 2;  ///< of them
constexpr int kRowsOfWheel = 9;
constexpr const char* kRowNames[kRowsOfWheel] = {"x",          "y",           "z",      "rotation_x", "rotation_y",
                                                 "rotation_z", "steer_angle", "camber", "wind_up"};
constexpr int kDisplacements = 3;

/// Loads at the wheels of the rig, and changes of the pads' forces in N.
struct RigLoads {
  RigInputs inputs{};
  std::array<double, 2> pads{};
};

RigLoads added(const RigLoads& a, const RigLoads& b, double factor) {
  RigLoads sum = a;
  for (std::size_t i = 0; i < sum.inputs.size(); ++i) sum.inputs[i] += factor * b.inputs[i];
  for (std::size_t i = 0; i < sum.pads.size(); ++i) sum.pads[i] += factor * b.pads[i];
  return sum;
}

/// A unit load at a wheel. A vertical force is one of the pad, which stands under the wheel centre; its arm from the
/// contact centre gives a moment, as with other forces.
RigLoads unit_load(const WheelState& wheel, int load, bool at_contact) {
  RigLoads result;
  const std::size_t first = wheel.side > 0 ? kLoadsLeft : kLoadsRight;
  Vector3 force{}, moment{};
  (load < 3 ? force : moment)[static_cast<std::size_t>(load % 3)] = 1;
  if (at_contact) {
    const Vector3 centre = value_of(wheel.centre), patch = value_of(geometry_of(wheel).patch);
    const Vector3 turning = cross({patch[0] - centre[0], patch[1] - centre[1], patch[2] - centre[2]}, force);
    for (std::size_t i = 0; i < 3; ++i) moment[i] += turning[i];
  }
  for (std::size_t i = 0; i < 2; ++i) result.inputs[first + i] = force[i];
  for (std::size_t i = 0; i < 3; ++i) result.inputs[first + 2 + i] = moment[i];
  result.pads[wheel.side > 0 ? 0 : 1] = force[2];
  return result;
}

/// The rig of free wheels: travels of the pads that give their forces.
class FreeWheels {
 public:
  FreeWheels(const Rig& rig, const AxleState& axle) : axle_(axle) {
    for (const int which : {0, 1})
      if (is_real(rig, which)) wheels_.push_back(which);
    const auto count = static_cast<Eigen::Index>(wheels_.size());
    rates_ = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        rates_(i, j) = load_of_wheel(i).slope[static_cast<std::size_t>(travel_of(j))];
  }

  /// Whether springs carry the wheels.
  bool are_carried() const {
    constexpr double kCarries = 1e-9;    // of the strongest rate
    constexpr double kLeastRate = 1e-3;  // N/m
    const Eigen::VectorXd strength = singular_values(rates_);
    return strength[0] > kLeastRate && strength[strength.size() - 1] > kCarries * strength[0];
  }

  /// The inputs of the rig at which the pads' forces change as asked.
  RigInputs inputs_for(const RigLoads& loads) const {
    Eigen::VectorXd missing(rates_.rows());
    for (Eigen::Index i = 0; i < missing.size(); ++i)
      missing[i] = loads.pads[static_cast<std::size_t>(wheels_[static_cast<std::size_t>(i)])] -
                   along(load_of_wheel(i), loads.inputs);
    const Eigen::VectorXd travels = solved(rates_, missing);
    RigInputs inputs = loads.inputs;
    for (Eigen::Index i = 0; i < travels.size(); ++i) inputs[static_cast<std::size_t>(travel_of(i))] = travels[i];
    return inputs;
  }

 private:
  const Dual& load_of_wheel(Eigen::Index i) const { return axle_.wheel(wheels_[static_cast<std::size_t>(i)]).load; }
  int travel_of(Eigen::Index i) const { return wheels_[static_cast<std::size_t>(i)] == 0 ? kTravelLeft : kTravelRight; }
  const AxleState& axle_;
  std::vector<int> wheels_;
  Eigen::MatrixXd rates_;  ///< N/m, pads' forces over travels
};

/// Displacements of a wheel along a direction of the rig's inputs, in the order of kRowNames.
std::array<double, kRowsOfWheel> displacements(const WheelState& wheel, const RigInputs& direction, bool at_contact) {
  const Vector3 way = at_contact ? carried_patch_along(wheel, direction) : along(wheel.centre, direction);
  const Vector3 turn = turn_along(wheel, direction);
  const WheelGeometry g = geometry_of(wheel);
  return {way[0],
          way[1],
          way[2],
          turn[0],
          turn[1],
          turn[2],
          along(g.steer_angle, direction),
          along(g.camber, direction),
          dot(turn, value_of(wheel.axis))};
}

/// A column of loads: its name without the load, and the factor of each wheel's load.
struct LoadCase {
  const char* name;
  double left, right;
};

/// Writes a matrix. inputs_for: inputs of the rig at loads.
template <class InputsFor>
KcMatrix matrix_of(const Rig& rig, const AxleState& axle, bool at_contact, bool is_held, const InputsFor& inputs_for) {
  KcMatrix matrix;
  const std::string point = at_contact ? "contact" : "centre";
  matrix.name = point + (is_held ? "_held" : "");
  matrix.title = fmt::format("loads at the {} centre, wheel centres {}", at_contact ? "contact" : "wheel",
                             is_held ? "held at their height" : "free");
  std::vector<LoadCase> cases;
  for (const int which : {0, 1}) {
    if (!is_real(rig, which)) continue;
    const char* side = which == 0 ? "left" : "right";
    cases.push_back({side, which == 0 ? 1.0 : 0.0, which == 0 ? 0.0 : 1.0});
    for (int i = 0; i < kRowsOfWheel; ++i)
      matrix.rows.push_back({fmt::format("{}_{}", kRowNames[i], side), i < kDisplacements ? "m" : "rad"});
  }
  if (cases.size() == 2) cases.insert(cases.end(), {{"both", 1, 1}, {"opposite", 1, -1}});
  matrix.values.resize(matrix.rows.size());
  for (const LoadCase& one : cases) {
    for (int load = 0; load < kUnitLoads; ++load) {
      if (is_held && load == kVertical) continue;
      matrix.columns.push_back({fmt::format("{}_{}", kLoadNames[load], one.name), load < 3 ? "N" : "N m"});
      RigLoads loads;
      if (one.left != 0) loads = added(loads, unit_load(axle.left, load, at_contact), one.left);
      if (one.right != 0) loads = added(loads, unit_load(axle.right, load, at_contact), one.right);
      const RigInputs direction = inputs_for(loads);
      std::size_t row = 0;
      for (const int which : {0, 1}) {
        if (!is_real(rig, which)) continue;
        for (const double value : displacements(axle.wheel(which), direction, at_contact))
          matrix.values[row++].push_back(value);
      }
    }
  }
  return matrix;
}

}  // namespace

std::vector<KcMatrix> compliance_matrices(const Rig& rig, const PointOfCurve& start) {
  std::vector<KcMatrix> matrices;
  const FreeWheels wheels(rig, start.axle);
  const bool are_carried = wheels.are_carried();
  for (const bool at_contact : {false, true}) {
    if (!are_carried) continue;
    matrices.push_back(
        matrix_of(rig, start.axle, at_contact, false, [&](const RigLoads& loads) { return wheels.inputs_for(loads); }));
  }
  for (const bool at_contact : {false, true})
    matrices.push_back(
        matrix_of(rig, start.axle, at_contact, true, [](const RigLoads& loads) { return loads.inputs; }));
  return matrices;
}

}  // namespace mbgen::kc
