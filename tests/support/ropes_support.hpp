#pragma once
// Ropes in the plane: models by their parts, quantities of spans, reference data.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/model/element_access.hpp"
#include "tests/support/dynamics.hpp"
#include "tests/support/reaction_support.hpp"

namespace mbgen::testing {

using Json = nlohmann::json;

inline constexpr double kG = 9.81;  // m/s^2

/// Closed forms and motions of an independent integrator: tests/data/reference/ropes_belts.json.
inline const Json& rope_reference() {
  static const Json file = Json::parse(std::ifstream(source_path("tests/data/reference/ropes_belts.json")));
  return file;
}

enum What { tension, length, stretch, rate, wrap };

/// A mechanism with ropes whose quantities are its outputs.
class Roped : public MechanismInState {
 public:
  explicit Roped(const std::string& text) : MechanismInState(with_outputs(text)), dynamics_{solver_} {}

  const Model& model() const { return m_.model; }
  double shown(What what, std::size_t span = 0) {
    accelerate();
    return solver_.outputs(state_, std::vector<double>(state_.z.size()), derivative_)
        .y[span * KindOf<Rope>::quantities.size() + what];
  }
  void accelerate() {
    ASSERT_TRUE(solver_.accelerations(state_, std::vector<double>(state_.z.size()), derivative_).ok());
  }
  void run(double until, double h) {
    const auto steps = static_cast<int>(std::lround((until - state_.t) / h));
    for (int k = 0; k < steps; ++k) ASSERT_TRUE(step_rk4(dynamics_, state_, h).ok()) << state_.t;
  }

 private:
  static Mechanism with_outputs(const std::string& text) {
    Model model = model_of(text);
    for (std::size_t i = 0; i < model.ropes.size(); ++i)
      for (const ElementQuantity& quantity : KindOf<Rope>::quantities)
        model.outputs.push_back({fmt::format("{}{}", quantity.name, i), {}, "", output_of<Rope>(quantity.name, i)});
    return analysed(std::move(model));
  }
  Dynamics dynamics_;
};

/// A body at a place, with a point O there, in a joint with ground.
struct HungPart {
  std::string name, joint;
  double mass, x, z;
  double inertia = 1;
};

/// Bodies in the plane x, z with ropes and elements: joint "z" or "x" slides, "plane" is free in the plane, "turn" a
/// wheel about y; grounds: further points of ground.
inline std::string plane_model(const std::vector<HungPart>& parts, const std::string& grounds,
                               const std::string& sections, double gravity = kG) {
  std::string points = grounds, bodies, joints;
  for (const HungPart& part : parts) {
    points += fmt::format(R"({}"{}": [{:.17g}, 0, {:.17g}])", points.empty() ? "" : ", ", part.name, part.x, part.z);
    bodies += fmt::format(
        R"(, "{}": {{ "mass": {:.17g}, "inertia": [1, {:.17g}, 1], "pose": {{ "origin": [{:.17g}, 0, {:.17g}] }},
      "points": {{ "O": [0, 0, 0] }} }})",
        part.name, part.mass, part.inertia, part.x, part.z);
    const char* type = part.joint == "turn" ? "revolute" : part.joint == "plane" ? "planar" : "prismatic";
    const char* axis = part.joint == "x" ? "x" : part.joint == "z" ? "z" : "y";
    joints += fmt::format(R"({}"{}": {{ "type": "{}", "from": "ground.{}", "to": "{}.O", "axis": "{}" }})",
                          joints.empty() ? "" : ", ", part.name, type, part.name, part.name, axis);
  }
  return fmt::format(R"({{ "mbgen": 1, "name": "plane", "gravity": [0, 0, {:.17g}],
    "bodies": {{ "ground": {{ "points": {{ {} }} }}{} }}, "joints": {{ {} }}, {} }})",
                     -gravity, points, bodies, joints, sections);
}

inline std::string point(const std::string& at) { return fmt::format(R"({{ "point": "{}" }})", at); }
inline std::string circle(const std::string& at, double radius, bool positive, const std::string& rest = "",
                          const char* kind = "pulley") {
  return fmt::format(R"({{ "{}": "{}", "axis": "y", "radius": {:.17g}, "sense": "{}"{} }})", kind, at, radius,
                     positive ? "positive" : "negative", rest);
}
inline std::string rope(const std::vector<std::string>& path, const std::string& law, const char* name = "rope") {
  return fmt::format(R"("{}": {{ "path": [{}], {} }})", name, fmt::join(path, ", "), law);
}
inline std::string ropes(const std::string& list) { return R"("ropes": { )" + list + " }"; }

}  // namespace mbgen::testing
