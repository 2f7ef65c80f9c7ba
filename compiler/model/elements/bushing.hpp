#pragma once
// Bushings: compliant elements of six freedoms between two frames.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/elements/kind.hpp"
#include "compiler/model/elements/law.hpp"

namespace mbgen {

/// Freedoms of a bushing: displacements along its axes x, y, z, then the components of its rotation vector.
constexpr int kBushingFreedoms = 6;

/// Names in the model format, in their order.
constexpr std::array<std::string_view, kBushingFreedoms> kBushingFreedomNames = {"tx", "ty", "tz", "rx", "ry", "rz"};

/// One freedom of a bushing by itself, over its deflection q (m or rad) and rate dq/dt:
/// f = stiffness(q) + damping(dq/dt) + preload + force(q, dq/dt) + maxwell_stiffness e, de/dt = dq/dt - e/maxwell_time.
/// f acts against the deflection. e is the extension of the spring of a Maxwell branch, an auxiliary state.
struct BushingFreedom {
  std::optional<Law> stiffness;               ///< N/m or N m/rad, or a table over the deflection
  std::optional<Law> damping;                 ///< N s/m or N m s/rad, or a table over the rate
  Quantity preload;                           ///< N or N m, at no deflection
  std::optional<int> force;                   ///< expression; local 0 `deflection`, local 1 `rate`
  std::optional<Quantity> maxwell_stiffness;  ///< N/m or N m/rad; none: no branch
  Quantity maxwell_time;                      ///< s, relaxation time: damping of the branch over its stiffness, > 0
};

/// A symmetric matrix over the freedoms, row by row.
using BushingMatrix = std::array<Quantity, kBushingFreedoms * kBushingFreedoms>;

/// Compliant element between a frame on `from` and one on `to`, which have the same axes at the reference
/// configuration. Deflections q, in the axes of the frame on `from`: position of the point of `to` minus position of
/// the point of `from` (m), and the rotation vector of the frame on `to` relative to the frame on `from` (rad), zero at
/// the reference and at most kLargestBushingTurn long. The force f, and the moment with the same power on the rates of
/// the rotation vector, act on `from` with their sign and on `to` with the opposite sign, both at the point of `to`; so
/// a bushing of stiffnesses alone conserves energy at any deflection.
struct Bushing {
  std::string name;
  Where where;
  Attachment from, to;
  /// columns: its axes x, y, z, GLOBAL axes at the reference
  Matrix3 axes{1, 0, 0, 0, 1, 0, 0, 0, 1};
  /// y is mirrored too: ty, rx and rz have the opposite sense, so that equal deflections are mirror images
  bool is_mirrored = false;
  std::array<std::optional<BushingFreedom>, kBushingFreedoms> freedoms;  ///< none: free
  std::optional<BushingMatrix> stiffness;                                ///< added: N/m, N, N m/rad
  std::optional<BushingMatrix> damping;                                  ///< added: N s/m, N s, N m s/rad
};

/// rad: beyond it the rotation vector approaches its jump at half a turn, and the result is not a number.
constexpr double kLargestBushingTurn = 3;

/// 1, or -1 for a freedom with the opposite sense to the component in the bushing's axes.
constexpr double bushing_sense(const Bushing& bushing, int freedom) {
  return bushing.is_mirrored && (freedom == 1 || freedom == 3 || freedom == 5) ? -1 : 1;
}

/// Whether a matrix has an entry that is not a literal zero.
inline bool bushing_couples(const std::optional<BushingMatrix>& matrix, int row, int column) {
  if (!matrix) return false;
  const Quantity& entry = (*matrix)[static_cast<std::size_t>(kBushingFreedoms * row + column)];
  return entry.expression >= 0 || entry.value != 0;
}

/// Whether a freedom has a force.
inline bool bushing_acts(const Bushing& bushing, int freedom) {
  bool acts = bushing.freedoms[static_cast<std::size_t>(freedom)].has_value();
  for (int column = 0; column < kBushingFreedoms; ++column)
    acts = acts || bushing_couples(bushing.stiffness, freedom, column) ||
           bushing_couples(bushing.damping, freedom, column);
  return acts;
}

/// Whether a freedom has a Maxwell branch.
inline bool has_maxwell_branch(const Bushing& bushing, int freedom) {
  const auto& law = bushing.freedoms[static_cast<std::size_t>(freedom)];
  return law && law->maxwell_stiffness;
}

/// Number of Maxwell branches of a bushing.
inline int maxwell_branches(const Bushing& bushing) {
  int count = 0;
  for (int i = 0; i < kBushingFreedoms; ++i) count += has_maxwell_branch(bushing, i) ? 1 : 0;
  return count;
}

template <>
struct KindOf<Bushing> : KindDefaults {
  using Element = Bushing;
  static constexpr const char *key = "bushing", *section = "bushings", *words = "bushing";
  static constexpr bool is_elastic = true;
  static constexpr Drawing drawing = Drawing::frame;
  static constexpr std::array quantities = {
      ElementQuantity{"force", "N", 3}, ElementQuantity{"moment", "N m", 3}, ElementQuantity{"deflection", "m", 3},
      ElementQuantity{"rotation_vector", "rad", 3}, ElementQuantity{kPotentialEnergy, "J"}};
  static constexpr const char* shows =
      "bushing; the output is its force or moment on `to` at its point, its deflection or its rotation vector, in its "
      "axes on `from`, or its potential energy";
  template <class SomeModel>
  static auto& list(SomeModel& model) {
    return model.bushings;
  }
  static Connection connection(const Bushing& element) {
    BetweenFrames frames{element.from, element.to, element.axes, {}};
    for (int i = 0; i < kBushingFreedoms; ++i) frames.acts[static_cast<std::size_t>(i)] = bushing_acts(element, i);
    return frames;
  }
  template <class Words>
  static std::string sentence(const Words& words, const Bushing& element) {
    std::vector<std::string> acting, branches;
    for (int i = 0; i < kBushingFreedoms; ++i)
      if (bushing_acts(element, i)) acting.emplace_back(kBushingFreedomNames[static_cast<std::size_t>(i)]);
    states(element, [&](const HiddenState& state) { branches.push_back("x." + element.name + state.suffix); });
    const std::string what =
        element.name + " is a bushing between " + words.body(element.from) + " and " + words.body(element.to);
    if (acting.empty()) return what + " without any force.";
    const std::string text = what + "; it acts in " + words.list(acting) + ".";
    return branches.empty() ? text
                            : text + " Its Maxwell " + (branches.size() == 1 ? "branch has" : "branches have") +
                                  " the " + words.states(branches) + ".";
  }
  static constexpr StateNature nature = StateNature::relaxing;
  /// Extensions of the springs of its Maxwell branches.
  template <class Use>
  static void states(const Bushing& element, const Use& use) {
    constexpr double kExtension = 1e-3;  // m or rad
    for (int i = 0; i < kBushingFreedoms; ++i)
      if (has_maxwell_branch(element, i))
        use(HiddenState{std::string("_").append(kBushingFreedomNames[static_cast<std::size_t>(i)]), kExtension,
                        i < 3 ? "m" : "rad"});
  }
  static constexpr std::array bounds = {FieldBound{"maxwell_stiffness", QuantityBound::not_negative},
                                        FieldBound{"maxwell_time", QuantityBound::positive}};
  template <class Use>
  static void fields(const Bushing& element, const Use& use) {
    use("axes", element.axes);
    for (std::size_t i = 0; i < element.freedoms.size(); ++i) {
      const std::optional<BushingFreedom>& own = element.freedoms[i];
      if (!own) continue;
      const auto use_own = [&](const char* name, const auto& field) {
        use(std::string(kBushingFreedomNames[i]) + "." + name, field);
      };
      use_own("stiffness", own->stiffness);
      use_own("damping", own->damping);
      use_own("preload", own->preload);
      use_own("force", own->force);
      if (!own->maxwell_stiffness) continue;
      use_own("maxwell_stiffness", own->maxwell_stiffness);
      use_own("maxwell_time", own->maxwell_time);
    }
    use("stiffness", element.stiffness);
    use("damping", element.damping);
    if (element.is_mirrored) use("counts", "mirrored");
  }
};

}  // namespace mbgen
