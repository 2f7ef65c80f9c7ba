#pragma once
// Another spelling of a model: each joint of several freedoms as single joints over massless bodies.

#include <type_traits>

#include "tests/support/mechanism_support.hpp"

namespace mbgen::testing {

/// Rewrites every reference to a joint or coordinate of a model. joint: old index to new; coordinate: old to new.
template <class OfJoint, class OfCoordinate>
void rename_joints(Model& model, const OfJoint& joint, const OfCoordinate& coordinate) {
  for (Expression& expression : model.expressions)
    for (ExpressionNode& node : expression.nodes)
      if (node.coordinate.joint >= 0) node.coordinate = coordinate(node.coordinate);
  for (JointSpring& spring : model.joint_springs) {
    spring.joint = coordinate(spring.joint);
    if (spring.relative_to) spring.relative_to = coordinate(*spring.relative_to);
  }
  const auto of_elements = [&](auto& elements) {
    for (auto& element : elements) element.joint = coordinate(element.joint);
  };
  of_elements(model.frictions), of_elements(model.joint_forces), of_elements(model.motions);
  for (auto* values : {&model.initial.positions, &model.initial.velocities})
    for (InitialValue& value : *values) value.coordinate = coordinate(value.coordinate);
  for (Output& output : model.outputs)
    std::visit(
        [&](auto& source) {
          using Source = std::decay_t<decltype(source)>;
          if constexpr (std::is_same_v<Source, CoordinateOutput>) source.coordinate = coordinate(source.coordinate);
          if constexpr (std::is_same_v<Source, ReactionOutput> || std::is_same_v<Source, MultiplierOutput>)
            if (source.joint >= 0) source.joint = joint(source.joint);
        },
        output.source);
}

/// The mechanism with its balls, free and universal joints... in the tree written as single joints over massless
/// bodies. Coordinates keep their names and their order.
inline Mechanism spelled_by_single_joints(const Mechanism& m) {
  Model model = m.model;
  std::vector<bool> in_tree(model.joints.size(), false);
  for (const TreeJoint& tree_joint : m.topology.tree_joints) in_tree[tree_joint.joint] = true;
  model.joints.clear();
  std::vector<int> first_of;
  const auto is_split = [&](int j) { return in_tree[j] && m.model.joints[j].freedoms.size() > 1; };
  for (std::size_t j = 0; j < m.model.joints.size(); ++j) {
    const Joint& joint = m.model.joints[j];
    first_of.push_back(static_cast<int>(model.joints.size()));
    if (!is_split(static_cast<int>(j))) {
      model.joints.push_back(joint);
      continue;
    }
    const Vector3 at = reference_position(m.model, joint.from);
    Attachment from = joint.from;
    for (std::size_t c = 0; c < joint.freedoms.size(); ++c) {
      Joint single = joint;
      const bool is_last = c + 1 == joint.freedoms.size();
      const Freedom& freedom = joint.freedoms[c];
      single.name = joint.name + std::to_string(c);
      single.type = freedom.kind == FreedomKind::revolute ? JointType::revolute : JointType::prismatic;
      single.axis = freedom.axis;
      single.freedoms = {freedom};
      single.from = from;
      if (!is_last) {
        Body link;
        link.name = joint.name + "_link" + std::to_string(c);
        for (int k = 0; k < 3; ++k) link.com[k] = at[k];
        link.points = {{"joint", link.com}};
        single.to = from = {static_cast<int>(model.bodies.size()), 0};
        model.bodies.push_back(link);
      }
      model.joints.push_back(single);
    }
  }
  const auto joint = [&](int j) {
    return first_of[j] + (is_split(j) ? static_cast<int>(m.model.joints[j].freedoms.size()) - 1 : 0);
  };
  const auto coordinate = [&](const CoordinateReference& c) {
    return is_split(c.joint) ? CoordinateReference{first_of[c.joint] + c.component, 0}
                             : CoordinateReference{first_of[c.joint], c.component};
  };
  rename_joints(model, joint, coordinate);
  return analysed(model);
}

}  // namespace mbgen::testing
