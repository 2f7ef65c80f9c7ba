#pragma once
// Units that the recursive form eliminates as one: loop blocks, runs of joints with massless bodies, and rotors.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "compiler/formulation/layout.hpp"

namespace mbgen {

/// Blocks of more joints have no quasi-velocities: they are analysed once, over joint rates.
constexpr std::size_t kLargestQuasiBlock = 40;

/// Joints that move a body against the body before it. Three revolute joints about axes through one point, or three
/// prismatic ones, are taken by quasi-velocities: components of their joint motion along the axes of the frame, in
/// place of their rates. They may be those of one ball or joints of their own over bodies that do nothing else.
struct JointStep {
  std::vector<int> joints;  ///< one, or three of a kind, in the order in which they turn or move
  bool revolute = true;
  bool quasi() const { return joints.size() == 3; }
  int body() const { return joints.back(); }
};

/// A loop block, a run of joints outside all blocks that ends at a body with an own frame, or a rotor.
struct RecursionUnit {
  int block = -1;                ///< index into Topology::blocks, -1 for a run or a rotor
  bool opened = false;           ///< a loop block that is solved on its opened tree, see recursion_opened.hpp
  bool rotor = false;            ///< a body that is symmetric about its joint's axis: its inertia is held by its base
  int base = kGround;            ///< body that it moves on
  std::vector<int> joints;       ///< ascending tree indices
  std::vector<JointStep> steps;  ///< from the base on, parents first
  int end() const { return joints.back(); }
  /// Place of a tree joint among `joints`.
  std::size_t column(int joint) const {
    return static_cast<std::size_t>(std::lower_bound(joints.begin(), joints.end(), joint) - joints.begin());
  }
};

/// Values for the bodies of one unit alone, by tree index: its storage grows with the unit, not with the model. Of the
/// unit's joints it keeps a reference.
template <class V>
class PerBody {
 public:
  PerBody() = default;
  explicit PerBody(const RecursionUnit& unit) : joints_(&unit.joints), values_(unit.joints.size()) {}
  V& operator[](int body) { return values_[place_of(body)]; }
  const V& operator[](int body) const { return values_[place_of(body)]; }
  std::size_t size() const { return values_.size(); }

 private:
  std::size_t place_of(int body) const {
    return static_cast<std::size_t>(std::lower_bound(joints_->begin(), joints_->end(), body) - joints_->begin());
  }
  const std::vector<int>* joints_ = nullptr;
  std::vector<V> values_;
};

/// Treatments that the recursive form can do without; the saving of each is counted (see RecursionChoices in
/// `inspect`).
struct RecursionChoices {
  bool rotors = true;    ///< bodies symmetric about their joint's axis are held by their base
  bool subtrees = true;  ///< bodies of blocks on others but arms hand their inertia to the body below
  bool centres = true;   ///< bodies of blocks that carry nothing are seen from their centres of mass, not their origins
  bool arms = true;      ///< the base's angular velocity acts on a block's single-joint bodies as on parts of the base
  bool outer_arms = true;  ///< the same for single-joint bodies of a block on another of its bodies, in its axes
  bool arm_runs = true;    ///< the same for single-joint bodies outside blocks
  bool in_plane = true;    ///< the same for bodies of blocks that turn against the base about a coordinate axis
};

/// Frames and order of the recursive form.
struct Recursion {
  RecursionChoices choices;
  Layout layout;                          ///< own frames for all bodies outside blocks but rotors
  std::vector<RecursionUnit> units;       ///< parents first
  std::vector<std::vector<int>> on_body;  ///< per tree body: indices of the units that move on it
};

/// Plans the recursive form. driven: per tree coordinate; a driven one is never a quasi-velocity.
Recursion plan_recursion(const Model& model, const Topology& topology, const std::vector<bool>& driven,
                         RecursionChoices choices = {});

/// Whether the unit lets its end move in every way: six quasi-velocities.
bool is_free(const RecursionUnit& unit);

}  // namespace mbgen
